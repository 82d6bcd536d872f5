//! Files read, written and refused.

#[path = "io/axiom.rs"]
mod axiom;
#[path = "io/blueprint.rs"]
mod blueprint;
#[path = "io/data.rs"]
mod data;
#[path = "common/examples/mod.rs"]
mod examples;
#[path = "io/hanging.rs"]
mod hanging;
#[path = "io/hostile.rs"]
mod hostile;
#[path = "io/litematic.rs"]
mod litematic;
#[path = "io/losses.rs"]
mod losses;
#[path = "io/magica.rs"]
mod magica;
#[path = "io/mcedit.rs"]
mod mcedit;
#[path = "io/mcstructure.rs"]
mod mcstructure;
#[path = "io/mesh.rs"]
mod mesh;
#[path = "io/obj.rs"]
mod obj;
#[path = "common/real.rs"]
mod real;
#[path = "io/region.rs"]
mod region;
#[path = "io/round_trip.rs"]
mod round_trip;
#[path = "io/sniff.rs"]
mod sniff;
#[path = "io/structure.rs"]
mod structure;
#[path = "io/wild.rs"]
mod wild;

use examples::tags;
use vox::grid::Grid;
use vox::io::{Content, Decoded, Limits, ReadError, decode};
use vox::nbt::{self, Compound, Tag};

fn read(bytes: &[u8]) -> Result<Decoded, ReadError> {
    decode(bytes, &Limits::default())
}

fn read_grid(bytes: &[u8]) -> Grid {
    match read(bytes).unwrap().content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => panic!("expected a grid"),
    }
}

/// A schematic of 2 x 1 x 2 blocks that every reader takes.
fn small() -> Compound {
    tags([
        ("Version", Tag::Int(2)),
        ("DataVersion", Tag::Int(3465)),
        ("Width", Tag::Short(2)),
        ("Height", Tag::Short(1)),
        ("Length", Tag::Short(2)),
        ("PaletteMax", Tag::Int(2)),
        ("Palette", Tag::Compound(tags([("minecraft:air", Tag::Int(0)), ("minecraft:stone", Tag::Int(1))]))),
        ("BlockData", Tag::ByteArray(vec![1, 0, 0, 1])),
    ])
}

fn file(root: &Compound) -> Vec<u8> {
    nbt::write("Schematic", root).unwrap()
}
