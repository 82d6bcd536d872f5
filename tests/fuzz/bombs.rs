//! Files that ask for more than they have.

use super::{bytes, check};
use vox::nbt::{self, Compound, Tag};

fn compound(tags: Vec<(&str, Tag)>) -> Compound {
    tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect()
}

/// A schematic of one block with `tags` beside.
fn schem(tags: Vec<(&str, Tag)>) -> Vec<u8> {
    let palette = compound(vec![("air", Tag::Int(0))]);
    let mut root = compound(vec![
        ("Width", Tag::Short(1)),
        ("Height", Tag::Short(1)),
        ("Length", Tag::Short(1)),
        ("Palette", Tag::Compound(palette)),
        ("BlockData", Tag::ByteArray(vec![0])),
    ]);
    root.extend(compound(tags));
    nbt::write("Schematic", &root).unwrap()
}

/// A schematic that breaks off within an array that announces all that can be announced.
fn announcing(kind: u8, name: &str) -> Vec<u8> {
    let mut bytes = schem(vec![]);
    bytes.pop();
    bytes.extend([kind, 0, name.len() as u8]);
    bytes.extend(name.bytes());
    bytes.extend(if kind == 9 { vec![10] } else { vec![] });
    bytes.extend(i32::MAX.to_be_bytes());
    bytes.extend([0; 99]);
    bytes
}

fn cases() -> Vec<(&'static str, Vec<u8>)> {
    let list = |entry: Tag, count| schem(vec![("List", Tag::List(vec![entry; count]))]);
    let one = || compound(vec![("", Tag::Byte(0))]);
    let chest = || compound(vec![("Pos", Tag::IntArray(vec![0, 0, 0])), ("id", Tag::String(String::new()))]);
    let properties: Vec<String> = (0..7_000).map(|n| format!("{n}=")).collect();
    let states = (0..3).map(|n| (format!("a{n}[{}]", properties.join(",")), Tag::Int(n)));
    let long = |len| schem(vec![("Width", Tag::Short(-1)), ("BlockData", Tag::ByteArray(vec![0; len]))]);
    vec![
        ("a long array", long(1 << 18)),
        ("an endless array", bytes::packed(&long(1 << 24))),
        ("zeros", bytes::packed(&bytes::packed(&vec![0; 1 << 26]))),
        ("lists", list(Tag::List(vec![]), 1 << 15)),
        ("bytes in a list", list(Tag::Byte(0), 1 << 17)),
        ("compounds", list(Tag::Compound(one()), 1 << 15)),
        ("block entities", schem(vec![("BlockEntities", Tag::List(vec![Tag::Compound(chest()); 300]))])),
        ("long states", schem(vec![("Palette", Tag::Compound(states.collect()))])),
        ("many blocks announced", announcing(7, "BlockData")),
        ("many bytes announced", announcing(7, "Bytes")),
        ("many numbers announced", announcing(12, "Longs")),
        ("many compounds announced", announcing(9, "List")),
    ]
}

#[test]
fn bombs_keep_to_the_limits() {
    for (name, file) in cases() {
        for file in [bytes::packed(&file), file] {
            match check(&file) {
                Ok(checked) => println!("{name}: {} bytes of memory", checked.used),
                Err(problem) => panic!("{name}: {problem}"),
            }
        }
    }
}
