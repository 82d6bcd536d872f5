//! Files that are refused, and the words they are refused with.

use super::{file, read, small, tags};
use vox::nbt::{Compound, Tag};

fn bytes(numbers: &[u8]) -> Tag {
    Tag::ByteArray(numbers.iter().map(|n| n.cast_signed()).collect())
}

fn palette<const N: usize>(entries: [(&str, i32); N]) -> Tag {
    Tag::Compound(tags(entries.map(|(name, index)| (name, Tag::Int(index)))))
}

/// What is put into a good file (or taken out), and the start of the message.
fn cases() -> Vec<(&'static str, Option<Tag>, &'static str)> {
    vec![
        ("Version", Some(Tag::Int(4)), "the tag `Version` is 4: vox knows the versions 1 to 3"),
        ("Width", None, "the tag `Width` is missing: expected a Short (unsigned: 0 to 65,535)"),
        ("Width", Some(Tag::Short(0)), "the tag `Width` is 0: a schematic is at least one block wide"),
        ("Width", Some(Tag::Int(-5)), "the tag `Width` is an Int (-5): expected a Short"),
        ("Width", Some(Tag::String("2".into())), "the tag `Width` is a String: expected a Short"),
        (
            "Height",
            Some(Tag::Short(-1)),
            "the size 2 x 65535 x 2 makes 262140 blocks, but `BlockData` holds only 4 bytes",
        ),
        (
            "Height",
            Some(Tag::Short(3)),
            "the size 2 x 3 x 2 makes 12 blocks, but `BlockData` holds only 4 bytes",
        ),
        (
            "BlockData",
            Some(Tag::IntArray(vec![0; 4])),
            "the tag `BlockData` is an Int Array of 4: expected a Byte Array",
        ),
        ("BlockData", Some(bytes(&[0, 0, 0, 0, 0])), "`BlockData` goes on after all 4 blocks"),
        ("BlockData", Some(bytes(&[0, 0x81, 0, 0])), "`BlockData` ends after 3 of 4 blocks"),
        (
            "BlockData",
            Some(bytes(&[0, 0, 0, 0x80])),
            "`BlockData`, byte 3, block (1, 0, 1): the varint breaks off at the end of the data",
        ),
        (
            "BlockData",
            Some(bytes(&[0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1, 0])),
            "`BlockData`, byte 1, block (1, 0, 0): the varint does not end within 32 bits",
        ),
        (
            "BlockData",
            Some(bytes(&[0, 0, 2, 0])),
            "`BlockData`, block (0, 0, 1): index 2 is not in the palette of 2 entries",
        ),
        ("Palette", None, "the tag `Palette` is missing: expected a Compound"),
        (
            "Palette",
            Some(palette([])),
            "`BlockData`, block (0, 0, 0): index 1 is not in the palette of 0 entries",
        ),
        (
            "Palette",
            Some(palette([("stone", 0), ("air", 2)])),
            "`BlockData`, block (0, 0, 0): index 1 is not in the palette of 2 entries",
        ),
        (
            "Palette",
            Some(palette([("stone", 1), ("air", 0), ("dirt", 1)])),
            "the entries `dirt` and `stone` of `Palette` have the same index 1",
        ),
        (
            "Palette",
            Some(palette([("stone", -1)])),
            "the entry `stone` of `Palette` has the index -1: expected 0 to",
        ),
        (
            "Palette",
            Some(palette([("stone", i32::MAX)])),
            "the entry `stone` of `Palette` has the index 2147483647: expected 0 to",
        ),
        (
            "Palette",
            Some(palette([("Oak Stairs", 0)])),
            "the entry `Oak Stairs` of `Palette` is no block state: `Oak Stairs` is not a block name",
        ),
        (
            "Palette",
            Some(palette([("oak_log[axis", 0)])),
            "the entry `oak_log[axis` of `Palette` is no block state: the properties of",
        ),
        (
            "Palette",
            Some(Tag::Compound(tags([("air", Tag::String("0".into()))]))),
            "the tag `Palette.air` is a String: expected an Int",
        ),
        (
            "Offset",
            Some(Tag::IntArray(vec![1, 2])),
            "the tag `Offset` is an Int Array of 2: expected an Int Array of 3",
        ),
        ("Metadata", Some(Tag::Int(0)), "the tag `Metadata` is an Int (0): expected a Compound"),
        (
            "BlockEntities",
            Some(Tag::List(vec![Tag::Int(7)])),
            "the tag `BlockEntities[0]` is an Int (7): expected a Compound",
        ),
        (
            "BlockEntities",
            Some(Tag::List(vec![Tag::Compound(Compound::new())])),
            "the tag `BlockEntities[0].Pos` is missing: expected an Int Array of 3",
        ),
    ]
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    for (name, tag, message) in cases() {
        let mut root = small();
        root.remove(name);
        root.extend(tag.map(|tag| (name.to_owned(), tag)));
        let found = match read(&file(&root)) {
            Ok(_) => panic!("`{name}` is taken, expected: {message}"),
            Err(error) => error.to_string(),
        };
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
}

#[test]
fn more_states_than_a_grid_holds() {
    let entries = (0..65_536).map(|n| (format!("a:b{n}"), Tag::Int(n)));
    let mut root = small();
    root.insert("Palette", Tag::Compound(entries.collect()));
    let error = read(&file(&root)).unwrap_err().to_string();
    assert_eq!(error, "`Palette`: more than 65,536 distinct block states");
}
