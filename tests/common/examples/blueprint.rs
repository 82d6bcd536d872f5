//! Blueprints of Structurize.

use super::tags;
use vox::nbt::{self, Compound, Tag};

pub fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

pub fn state(name: &str, properties: Compound) -> Tag {
    let mut entry = tags([("Name", text(name))]);
    if !properties.is_empty() {
        entry.insert("Properties".to_owned(), Tag::Compound(properties));
    }
    Tag::Compound(entry)
}

/// 3 x 1 x 1: a log, air, and nothing to build.
pub fn small() -> Compound {
    tags([
        ("version", Tag::Byte(1)),
        ("size_x", Tag::Short(3)),
        ("size_y", Tag::Short(1)),
        ("size_z", Tag::Short(1)),
        (
            "palette",
            Tag::List(vec![
                state("minecraft:air", Compound::new()),
                state("minecraft:oak_log", tags([("axis", text("x"))])),
                state("structurize:blocksubstitution", Compound::new()),
            ]),
        ),
        ("blocks", Tag::IntArray(vec![1 << 16, 2 << 16])),
        ("tile_entities", Tag::List(Vec::new())),
        ("entities", Tag::List(Vec::new())),
        ("required_mods", Tag::List(Vec::new())),
        ("mcversion", Tag::Int(2586)),
    ])
}

pub fn with<const N: usize>(mut root: Compound, more: [(&str, Tag); N]) -> Compound {
    root.extend(tags(more));
    root
}

pub fn file(root: &Compound) -> Vec<u8> {
    nbt::write("", root).unwrap()
}

pub fn example() -> Vec<u8> {
    file(&small())
}
