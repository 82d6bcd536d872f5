//! Regions of chunks as the game wrote them before 1.18.

use super::tags;
use std::io::Write;
use vox::nbt::{self, Compound, Tag};

pub const KINDS: [u8; 4] = [1, 2, 3, 4];

pub fn pack(plain: &[u8], kind: u8) -> Vec<u8> {
    let level = flate2::Compression::default();
    match kind {
        1 => {
            let mut encoder = flate2::write::GzEncoder::new(Vec::new(), level);
            encoder.write_all(plain).unwrap();
            encoder.finish().unwrap()
        }
        2 => {
            let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), level);
            encoder.write_all(plain).unwrap();
            encoder.finish().unwrap()
        }
        4 => {
            let mut packed = Vec::new();
            let mut encoder = lz4_java_wrc::Lz4BlockOutput::new(&mut packed);
            encoder.write_all(plain).unwrap();
            encoder.flush().unwrap();
            drop(encoder);
            packed
        }
        _ => plain.to_vec(),
    }
}

/// A region of the given chunks, by their slots.
pub fn region(chunks: &[([usize; 2], &Compound)], kind: u8) -> Vec<u8> {
    let mut bytes = vec![0; 8192];
    for ([x, z], root) in chunks {
        let packed = pack(&nbt::write("", root).unwrap(), kind);
        let sector = (bytes.len() / 4096) as u32;
        bytes.extend((packed.len() as u32 + 1).to_be_bytes());
        bytes.push(kind);
        bytes.extend(packed);
        bytes.resize(bytes.len().next_multiple_of(4096), 0);
        let sectors = (bytes.len() / 4096) as u32 - sector;
        let entry = 4 * (z * 32 + x);
        bytes[entry..entry + 4].copy_from_slice(&(sector << 8 | sectors).to_be_bytes());
    }
    bytes
}

pub fn compound<const N: usize>(entries: [(&str, Tag); N]) -> Tag {
    Tag::Compound(tags(entries))
}

/// Air, and 17 kinds of note blocks: five bits an index, which do not divide a long.
pub fn old_palette() -> Tag {
    let note = |n: i32| {
        let properties = compound([("note", Tag::String(n.to_string()))]);
        compound([("Name", Tag::String("minecraft:note_block".into())), ("Properties", properties)])
    };
    let air = compound([("Name", Tag::String("minecraft:air".into()))]);
    Tag::List(std::iter::once(air).chain((1..18).map(note)).collect())
}

pub fn old_index(at: usize) -> u64 {
    (at * 7 % 18) as u64
}

pub fn old_chunk([x, z]: [i32; 2], data_version: i32, longs: Vec<i64>) -> Compound {
    let chest = compound([
        ("id", Tag::String("minecraft:chest".into())),
        ("x", Tag::Int(16 * x + 3)),
        ("y", Tag::Int(17)),
        ("z", Tag::Int(16 * z + 15)),
        ("keepPacked", Tag::Byte(0)),
    ]);
    let place = [16 * x, 20, 16 * z].map(|n| Tag::Double(f64::from(n) + 0.5)).to_vec();
    let cow = compound([("id", Tag::String("minecraft:cow".into())), ("Pos", Tag::List(place))]);
    let light = compound([("Y", Tag::Byte(-1)), ("SkyLight", Tag::ByteArray(vec![0; 2048]))]);
    let section =
        compound([("Y", Tag::Byte(1)), ("Palette", old_palette()), ("BlockStates", Tag::LongArray(longs))]);
    let level = compound([
        ("xPos", Tag::Int(x)),
        ("zPos", Tag::Int(z)),
        ("Status", Tag::String("full".into())),
        ("Biomes", Tag::IntArray(vec![1; 256])),
        ("Sections", Tag::List(vec![light, section])),
        ("TileEntities", Tag::List(vec![chest])),
        ("Entities", Tag::List(vec![cow])),
    ]);
    tags([("DataVersion", Tag::Int(data_version)), ("Level", level)])
}

pub fn chunk_1_13(place: [i32; 2]) -> Compound {
    let mut longs = vec![0_u64; 5 * 64];
    for at in 0..4096 {
        for bit in (0..5).filter(|bit| old_index(at) >> bit & 1 == 1) {
            longs[(5 * at + bit) / 64] |= 1 << ((5 * at + bit) % 64);
        }
    }
    old_chunk(place, 1631, longs.into_iter().map(u64::cast_signed).collect())
}

pub fn chunk_1_16(place: [i32; 2]) -> Compound {
    let mut longs = vec![0_u64; 4096_usize.div_ceil(12)];
    for at in 0..4096 {
        longs[at / 12] |= old_index(at) << (at % 12 * 5);
    }
    old_chunk(place, 2586, longs.into_iter().map(u64::cast_signed).collect())
}
