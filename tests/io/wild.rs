//! What tools write that the specification does not foresee, and vox reads all the same.

use super::{file, read, read_grid, small, tags};
use vox::io::{Limits, SchemVersion, Warning, decode, encode_schem};
use vox::nbt::{self, Compound, Tag};
use vox::space::Cell;

fn blocks(extra: Compound) -> Compound {
    let mut blocks = tags([("Palette", small()["Palette"].clone()), ("Data", small()["BlockData"].clone())]);
    blocks.extend(extra);
    blocks
}

/// Version 3 around the same blocks.
fn small_3(extra: Compound) -> Compound {
    let mut body = small();
    body.retain(|name, _| !name.contains("Palette") && name != "BlockData");
    body.insert("Version", Tag::Int(3));
    body.insert("Blocks", Tag::Compound(blocks(extra)));
    body
}

fn with(mut root: Compound, extra: Compound) -> Compound {
    root.extend(extra);
    root
}

fn without(mut root: Compound, name: &str) -> Compound {
    root.remove(name).unwrap();
    root
}

fn nested(body: Compound) -> Compound {
    tags([("Schematic", Tag::Compound(body))])
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut packed = Vec::new();
    std::io::Read::read_to_end(
        &mut flate2::read::GzEncoder::new(bytes, flate2::Compression::default()),
        &mut packed,
    )
    .unwrap();
    packed
}

#[test]
fn layouts_of_the_same_blocks() {
    let expected = read_grid(&file(&small()));
    let plain = file(&small());
    let (head, tail) = plain.split_at(20);
    let cases = [
        ("packed", gzip(&plain)),
        ("packed twice", gzip(&gzip(&plain))),
        ("two gzip members", [gzip(head), gzip(tail)].concat()),
        ("no version", file(&without(small(), "Version"))),
        ("version 1", file(&with(without(small(), "DataVersion"), tags([("Version", Tag::Int(1))])))),
        ("nested version 2", nbt::write("", &nested(small())).unwrap()),
        ("nested version 3", nbt::write("", &nested(small_3(Compound::new()))).unwrap()),
        ("version 3 at the root", file(&small_3(Compound::new()))),
        ("sizes as Int", file(&with(small(), tags([("Width", Tag::Int(2)), ("Length", Tag::Int(2))])))),
    ];
    for (name, bytes) in cases {
        let decoded = read(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(decoded.warnings, [], "{name}");
        assert!(read_grid(&bytes).same_blocks(&expected), "{name}");
    }
}

#[test]
fn what_follows_after_the_end_is_left_out() {
    let (plain, expected) = (file(&small()), read_grid(&file(&small())));
    let twice = [gzip(&plain), gzip(&plain)].concat();
    let more = [plain.clone(), b"more".to_vec()].concat();
    for (bytes, left) in [(twice, plain.len() as u64), (gzip(&more), 4), (more, 4)] {
        let decoded = read(&bytes).unwrap();
        assert_eq!(decoded.warnings, [Warning::Trailing(left)]);
        assert!(read_grid(&bytes).same_blocks(&expected));
    }
}

#[test]
fn widths_are_unsigned() {
    let long = tags([
        ("Width", Tag::Short(-1)),
        ("Length", Tag::Short(1)),
        ("BlockData", Tag::ByteArray(vec![1; 65_535])),
    ]);
    assert_eq!(read_grid(&file(&with(small(), long))).size(), Cell::new(65_535, 1, 1));
}

#[test]
fn a_wrong_palette_max_is_a_warning() {
    let decoded = read(&file(&with(small(), tags([("PaletteMax", Tag::Int(7))])))).unwrap();
    assert_eq!(decoded.warnings, [Warning::PaletteMax { said: 7, found: 2 }]);
}

#[test]
fn biomes_that_do_not_fit_are_a_warning() {
    let palette = || Tag::Compound(tags([("plains", Tag::Int(0))]));
    let data = |len| Tag::ByteArray(vec![0; len]);
    let flat = |len| file(&with(small(), tags([("BiomePalette", palette()), ("BiomeData", data(len))])));
    let biomes = |len| Tag::Compound(tags([("Palette", palette()), ("Data", data(len))]));
    let nested_3 = |len| file(&with(small_3(Compound::new()), tags([("Biomes", biomes(len))])));
    let half = file(&with(small(), tags([("BiomeData", data(4))])));
    for (bytes, warnings) in [
        (flat(4), vec![]),
        (nested_3(4), vec![]),
        (flat(3), vec![Warning::Biomes]),
        (nested_3(5), vec![Warning::Biomes]),
        (half, vec![Warning::Biomes]),
    ] {
        assert_eq!(read(&bytes).unwrap().warnings, warnings);
        assert_eq!(read_grid(&bytes).metadata.biomes.is_some(), warnings.is_empty());
    }
}

#[test]
fn palettes_may_have_gaps_and_bare_names() {
    let palette = tags([("stone", Tag::Int(1)), ("air", Tag::Int(0)), ("dirt", Tag::Int(300))]);
    let root = with(small(), tags([("Palette", Tag::Compound(palette)), ("PaletteMax", Tag::Int(3))]));
    assert!(read_grid(&file(&root)).same_blocks(&read_grid(&file(&small()))));
}

fn chest(place: Tag, extra: Compound) -> Tag {
    let chest = with(tags([("Id", Tag::String("minecraft:chest".into())), ("Pos", place)]), extra);
    Tag::List(vec![Tag::Compound(chest)])
}

#[test]
fn block_entities_in_every_layout() {
    let lock = || tags([("Lock", Tag::String("key".into()))]);
    let data = || tags([("Data", Tag::Compound(lock()))]);
    let ints = |place: [i32; 3]| Tag::IntArray(place.to_vec());
    let list = Tag::List([1, 0, 1].map(Tag::Int).to_vec());
    let in_2 = |name, list| file(&with(small(), tags([(name, list)])));
    let in_3 = |list| file(&small_3(tags([("BlockEntities", list)])));
    let world = tags([
        ("Offset", Tag::IntArray(vec![100, 64, -200])),
        ("BlockEntities", chest(ints([101, 64, -199]), lock())),
    ]);
    let cases = [
        ("version 1", in_2("TileEntities", chest(ints([1, 0, 1]), lock()))),
        ("version 2", in_2("BlockEntities", chest(ints([1, 0, 1]), lock()))),
        ("version 3", in_3(chest(ints([1, 0, 1]), data()))),
        ("version 3, flat", in_3(chest(ints([1, 0, 1]), lock()))),
        ("place as a list", in_2("BlockEntities", chest(list, lock()))),
        ("place in the world", file(&with(small(), world))),
    ];
    let expected = with(lock(), tags([("id", Tag::String("minecraft:chest".into()))]));
    for (name, bytes) in cases {
        assert_eq!(read_grid(&bytes).block_entities, [([1, 0, 1], expected.clone())].into(), "{name}");
    }
    let outside = read(&in_2("BlockEntities", chest(ints([2, 0, 0]), lock()))).unwrap();
    assert_eq!(outside.warnings, [Warning::BlockEntitiesOutside(1)]);
}

#[test]
fn of_lists_of_one_name_the_last_one_counts() {
    let place = Tag::IntArray(vec![1, 0, 1]);
    let first = ("BlockEntitieX", chest(place, Compound::new()));
    let empty = ("BlockEntities", Tag::List(Vec::new()));
    let mut bytes = nbt::write("Schematic", &with(small(), tags([first, empty]))).unwrap();
    let at = bytes.windows(13).position(|name| name == b"BlockEntitieX").unwrap();
    bytes[at + 12] = b's';
    assert!(read_grid(&bytes).block_entities.is_empty());
}

#[test]
fn damage_to_block_entities_counts_inside_the_build_only() {
    let nameless = |x| {
        let place = ("Pos", Tag::IntArray(vec![x, 0, 0]));
        let entry = Tag::Compound(tags([place, ("Id", Tag::Int(5))]));
        file(&with(small(), tags([("BlockEntities", Tag::List(vec![entry]))])))
    };
    assert_eq!(read(&nameless(9)).unwrap().warnings, [Warning::BlockEntitiesOutside(1)]);
    let inside = read(&nameless(0)).unwrap_err().to_string();
    assert_eq!(inside, "the tag `BlockEntities[0].Id` is an Int (5): expected a String");
}

/// A list of bytes costs 32 times its length, and the next one is read before it is known to be equal.
#[test]
fn equal_block_entities_take_the_memory_of_one() {
    let entry = |x| {
        let pages = Tag::List(vec![Tag::Byte(0); 1000]);
        let place = Tag::IntArray(vec![x, 0, 0]);
        Tag::Compound(tags([
            ("Id", Tag::String("minecraft:lectern".into())),
            ("Pos", place),
            ("Pages", pages),
        ]))
    };
    let list = Tag::List([0, 1, 0, 1].map(entry).to_vec());
    let bytes = file(&with(small(), tags([("BlockEntities", list)])));
    let limits = Limits { max_bytes: 100_000, ..Limits::default() };
    assert!(decode(&bytes, &limits).is_ok());
}

#[test]
fn a_tag_of_the_game_s_own_called_data_is_kept() {
    let own = || tags([("Data", Tag::ByteArray(vec![1])), ("Lock", Tag::String("key".into()))]);
    let flat = chest(Tag::IntArray(vec![1, 0, 1]), own());
    let nested = chest(Tag::IntArray(vec![1, 0, 1]), tags([("Data", Tag::Compound(own()))]));
    let expected = with(own(), tags([("id", Tag::String("minecraft:chest".into()))]));
    for bytes in [
        file(&with(small(), tags([("BlockEntities", flat)]))),
        file(&small_3(tags([("BlockEntities", nested)]))),
    ] {
        let grid = read_grid(&bytes);
        assert_eq!(grid.block_entities, [([1, 0, 1], expected.clone())].into());
        for version in [SchemVersion::V2, SchemVersion::V3] {
            let back = read_grid(&encode_schem(&grid, version).unwrap().bytes);
            assert_eq!(back.block_entities, grid.block_entities);
        }
    }
}

#[test]
fn the_offset_of_worldedit_comes_before_world_coordinates() {
    let offset = || tags([("Offset", Tag::IntArray(vec![1000, 64, -2000]))]);
    let worldedit =
        tags([("WEOffsetX", Tag::Int(-1)), ("WEOffsetY", Tag::Int(2)), ("WEOffsetZ", Tag::Int(-3))]);
    let root = with(with(small(), offset()), tags([("Metadata", Tag::Compound(worldedit))]));
    let metadata = read_grid(&file(&root)).metadata;
    assert_eq!(metadata.offset, Cell::new(-1, 2, -3));
    assert!(metadata.tags.is_empty(), "the offset is told once");
    assert_eq!(read_grid(&file(&with(small(), offset()))).metadata.offset, Cell::new(1000, 64, -2000));
    assert_eq!(read_grid(&file(&small())).metadata.offset, Cell::ZERO);
}

#[test]
fn entities_count_from_the_low_corner() {
    let pig = |place: [f64; 3]| {
        let pos = Tag::List(place.map(Tag::Double).to_vec());
        Tag::List(vec![Tag::Compound(tags([("Id", Tag::String("minecraft:pig".into())), ("Pos", pos)]))])
    };
    let offset = Tag::IntArray(vec![10, 20, 30]);
    let extra = |place| tags([("Entities", pig(place)), ("Offset", offset.clone())]);
    let cases = [
        ("version 2", file(&with(small(), extra([10.5, 20.0, 31.5])))),
        ("version 3", file(&with(small_3(Compound::new()), extra([0.5, 0.0, 1.5])))),
    ];
    for (name, bytes) in cases {
        assert_eq!(read_grid(&bytes).metadata.entities[0].place, [0.5, 0.0, 1.5], "{name}");
    }
}
