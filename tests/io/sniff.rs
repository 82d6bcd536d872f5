//! What files are by their content, whatever they are called.

use super::{file, read, small, tags};
use vox::io::{Format, Limits, sniff};
use vox::nbt::{self, Compound, Tag};

fn nbt_file<const N: usize>(root: [(&str, Tag); N]) -> Vec<u8> {
    nbt::write("", &tags(root)).unwrap()
}

fn region() -> Vec<u8> {
    let mut bytes = vec![0; 3 * 4096];
    bytes[..4].copy_from_slice(&[0, 0, 2, 1]);
    bytes
}

#[test]
fn known_formats() {
    let empty = || Tag::Compound(Compound::new());
    let none = || Tag::List(Vec::new());
    let cases = [
        (Format::Schem, file(&small())),
        (Format::Obj, b"o rect\nv 0 0 0\n".to_vec()),
        (Format::Obj, b"\xef\xbb\xbf# caf\xe9\r\n\r\nv -1 0 0\r\n".to_vec()),
        (Format::Litematic, nbt_file([("Regions", empty()), ("Version", Tag::Int(6))])),
        (Format::Structure, nbt_file([("size", none()), ("palette", none()), ("blocks", none())])),
        (Format::Mcedit, nbt_file([("Blocks", Tag::ByteArray(vec![])), ("Data", Tag::ByteArray(vec![]))])),
        (Format::Blueprint, nbt_file([("size_x", Tag::Short(1)), ("palette", none())])),
        (Format::Mcstructure, b"\x0a\0\0\x03\x0e\0format_version\x01\0\0\0".to_vec()),
        (Format::Axiom, b"\x0a\xe5\xbb\x36\0\0\0\0".to_vec()),
        (Format::MagicaVoxel, b"VOX \x96\0\0\0".to_vec()),
        (Format::Region, region()),
        (Format::Png, b"\x89PNG\r\n\x1a\n".to_vec()),
        (Format::Zip, b"PK\x03\x04\x14\0".to_vec()),
        (Format::Xml, b"<?xml version=\"1.0\"?>".to_vec()),
        (Format::Json, b"{\"a\": 1}".to_vec()),
        (Format::Text, b"plot --> split(x){ ~1 : f }\nf = 4\n".to_vec()),
        (Format::Text, b"\n\n".to_vec()),
    ];
    for (format, bytes) in cases {
        let found = sniff(&bytes, &Limits::default()).unwrap_or_else(|error| panic!("{format}: {error}"));
        assert_eq!(found, format);
    }
}

#[test]
fn refusals_say_what_the_file_is() {
    let cases = [
        (b"\x89PNG\r\n\x1a\n".to_vec(), "this is a PNG picture"),
        (b"hello".to_vec(), "this is a text without the vertices"),
        (Vec::new(), "the file is empty"),
        (vec![1, 2, 3], "this is no format that vox knows: it starts with the bytes 01 02 03"),
        (
            nbt_file([("Level", Tag::Int(1))]),
            "this is NBT, but no schematic: expected `Palette` and `BlockData`",
        ),
        (vec![10, 0, 0], "broken NBT at byte 3: a Compound takes 1 bytes, but only 0 are left"),
        (vec![0x1f, 0x8b, 8, 0], "the gzip data break off"),
    ];
    for (bytes, message) in cases {
        let found = read(&bytes).unwrap_err().to_string();
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
}
