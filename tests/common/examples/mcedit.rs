//! Schematics of MCEdit.

use super::tags;
use vox::nbt::{self, Compound, Tag};

pub fn bytes(numbers: &[u8]) -> Tag {
    Tag::ByteArray(numbers.iter().map(|n| n.cast_signed()).collect())
}

pub fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

/// A row of blocks along x.
pub fn row(blocks: &[(u8, u8)]) -> Compound {
    let (ids, data): (Vec<u8>, Vec<u8>) = blocks.iter().copied().unzip();
    tags([
        ("Width", Tag::Short(blocks.len() as i16)),
        ("Height", Tag::Short(1)),
        ("Length", Tag::Short(1)),
        ("Materials", text("Alpha")),
        ("Blocks", bytes(&ids)),
        ("Data", bytes(&data)),
        ("TileEntities", Tag::List(Vec::new())),
        ("Entities", Tag::List(Vec::new())),
    ])
}

pub fn with<const N: usize>(mut root: Compound, more: [(&str, Tag); N]) -> Compound {
    root.extend(tags(more));
    root
}

pub fn file(root: &Compound) -> Vec<u8> {
    nbt::write("Schematic", root).unwrap()
}

/// A file with something of everything.
pub fn example() -> Vec<u8> {
    let chest = tags([("x", Tag::Int(0)), ("y", Tag::Int(0)), ("z", Tag::Int(0)), ("id", text("Chest"))]);
    file(&with(
        row(&[(54, 2), (53, 4), (175, 8)]),
        [
            ("AddBlocks", bytes(&[0, 0])),
            ("SchematicaMapping", Tag::Compound(tags([("mod:thing", Tag::Short(1))]))),
            ("TileEntities", Tag::List(vec![Tag::Compound(chest)])),
            ("WEOffsetX", Tag::Int(3)),
        ],
    ))
}
