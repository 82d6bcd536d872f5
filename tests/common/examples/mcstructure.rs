//! Structures of Bedrock Edition, written by hand: the low byte first.

use super::tags;
use vox::nbt::{Compound, Tag};

pub fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

pub fn ints(numbers: &[i32]) -> Tag {
    Tag::List(numbers.iter().map(|&n| Tag::Int(n)).collect())
}

pub fn compound<const N: usize>(entries: [(&str, Tag); N]) -> Tag {
    Tag::Compound(tags(entries))
}

/// The types of tags that the files here hold, by number.
pub fn kind(tag: &Tag) -> u8 {
    match tag {
        Tag::Byte(_) => 1,
        Tag::Int(_) => 3,
        Tag::Float(_) => 5,
        Tag::String(_) => 8,
        Tag::List(_) => 9,
        Tag::Compound(_) => 10,
        _ => panic!("not in these files: {tag:?}"),
    }
}

pub fn put_text(out: &mut Vec<u8>, text: &str) {
    out.extend((text.len() as u16).to_le_bytes());
    out.extend(text.as_bytes());
}

pub fn put(out: &mut Vec<u8>, tag: &Tag) {
    match tag {
        Tag::Byte(n) => out.extend(n.to_le_bytes()),
        Tag::Int(n) => out.extend(n.to_le_bytes()),
        Tag::Float(n) => out.extend(n.to_le_bytes()),
        Tag::String(text) => put_text(out, text),
        Tag::List(entries) => {
            out.push(entries.first().map_or(0, kind));
            out.extend((entries.len() as i32).to_le_bytes());
            entries.iter().for_each(|entry| put(out, entry));
        }
        Tag::Compound(tags) => put_compound(out, tags),
        _ => panic!("not in these files: {tag:?}"),
    }
}

pub fn put_compound(out: &mut Vec<u8>, tags: &Compound) {
    for (name, tag) in tags {
        out.push(kind(tag));
        put_text(out, name);
        put(out, tag);
    }
    out.push(0);
}

pub fn file(root: &Compound) -> Vec<u8> {
    let mut out = vec![10, 0, 0];
    put_compound(&mut out, root);
    out
}

pub fn block<const N: usize>(name: &str, states: [(&str, Tag); N]) -> Tag {
    compound([("name", text(name)), ("states", compound(states)), ("version", Tag::Int(17_959_425))])
}

/// What is in the `structure` of a file.
pub struct Structure {
    pub size: Tag,
    pub layers: Tag,
    pub palette: Vec<Tag>,
    pub data: Compound,
    pub entities: Tag,
}

impl Structure {
    pub fn of(size: [i32; 3], layers: [&[i32]; 2], palette: Vec<Tag>) -> Structure {
        let layers = Tag::List(layers.map(ints).to_vec());
        let entities = Tag::List(Vec::new());
        Structure { size: ints(&size), layers, palette, data: Compound::new(), entities }
    }

    /// One block with a block entity.
    pub fn with_entity(block: Tag, data: Compound) -> Structure {
        let mut structure = Structure::of([1, 1, 1], [&[0], &[-1]], vec![block]);
        structure.data = tags([("0", compound([("block_entity_data", Tag::Compound(data))]))]);
        structure
    }

    pub fn file(self) -> Vec<u8> {
        let default = compound([
            ("block_palette", Tag::List(self.palette)),
            ("block_position_data", Tag::Compound(self.data)),
        ]);
        file(&tags([
            ("format_version", Tag::Int(1)),
            ("size", self.size),
            (
                "structure",
                compound([
                    ("block_indices", self.layers),
                    ("entities", self.entities),
                    ("palette", compound([("default", default)])),
                ]),
            ),
            ("structure_world_origin", ints(&[100, 64, -7])),
        ]))
    }
}

/// A file with something of everything.
pub fn example() -> Vec<u8> {
    let stairs =
        block("minecraft:oak_stairs", [("weirdo_direction", Tag::Int(1)), ("upside_down_bit", Tag::Byte(1))]);
    let water = block("minecraft:water", [("liquid_depth", Tag::Int(0))]);
    let mut structure = Structure::of([2, 1, 2], [&[0, 0, 0, -1], &[1, -1, -1, -1]], vec![stairs, water]);
    let sign = compound([("id", text("Sign")), ("Text", text("Inn"))]);
    structure.data = tags([("2", compound([("block_entity_data", sign)]))]);
    structure.file()
}
