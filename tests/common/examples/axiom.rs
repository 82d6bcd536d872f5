//! Blueprints of Axiom.

use super::tags;
use vox::nbt::{self, Compound, Tag};

pub fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

pub fn part(bytes: &[u8]) -> Vec<u8> {
    [&(bytes.len() as u32).to_be_bytes(), bytes].concat()
}

pub fn file(header: &Compound, picture: &[u8], blocks: &Compound) -> Vec<u8> {
    let header = nbt::write("", header).unwrap();
    let blocks = nbt::write("", blocks).unwrap();
    [vec![0x0a, 0xe5, 0xbb, 0x36], part(&header), part(picture), part(&blocks)].concat()
}

pub fn header() -> Compound {
    tags([
        ("Version", Tag::Int(2)),
        ("Name", text("hut")),
        ("Author", text("Ann")),
        ("BlockCount", Tag::Int(2)),
    ])
}

/// A section at `place`, whose cells are those of the given indices and else 0.
pub fn section(place: [i32; 3], palette: &[&str], cells: &[(usize, u64)]) -> Tag {
    let mut longs = vec![0u64; 256];
    for &(at, index) in cells {
        longs[at / 16] |= index << (at % 16 * 4);
    }
    let palette = palette.iter().map(|name| Tag::Compound(tags([("Name", text(name))])));
    let mut states = tags([("palette", Tag::List(palette.collect()))]);
    if !cells.is_empty() {
        states.insert("data", Tag::LongArray(longs.iter().map(|long| long.cast_signed()).collect()));
    }
    let [x, y, z] = place.map(Tag::Int);
    Tag::Compound(tags([("X", x), ("Y", y), ("Z", z), ("BlockStates", Tag::Compound(states))]))
}

pub fn blocks(sections: Vec<Tag>) -> Compound {
    tags([
        ("DataVersion", Tag::Int(3700)),
        ("BlockRegion", Tag::List(sections)),
        ("BlockEntities", Tag::List(Vec::new())),
    ])
}

pub fn example() -> Vec<u8> {
    let sections = vec![section([0; 3], &["minecraft:void_air", "minecraft:stone"], &[(7, 1)])];
    file(&header(), b"png", &blocks(sections))
}
