//! Structures of the game.

use super::real::folder;
use super::round_trip::{complete, grid, near, varied};
use super::{read, read_grid, tags};
use proptest::prelude::*;
use std::collections::BTreeMap;
use vox::block::{self, BlockState};
use vox::grid::{Dialect, Entity, Grid, Metadata, Own};
use vox::io::{
    Content, Decoded, Jigsaws, Limits, Lost, Options, Warning, decode, decode_with, encode_structure,
};
use vox::nbt::{self, Compound, Tag};
use vox::space::{Bounds, Cell};

fn write(grid: &Grid) -> Vec<u8> {
    encode_structure(grid).unwrap().bytes
}

fn state(text: &str) -> BlockState {
    text.parse().unwrap()
}

fn string(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

fn ints(numbers: &[i32]) -> Tag {
    Tag::List(numbers.iter().copied().map(Tag::Int).collect())
}

fn palette(names: &[&str]) -> Tag {
    Tag::List(names.iter().map(|name| Tag::Compound(tags([("Name", string(name))]))).collect())
}

fn placed(x: i32, state: i32) -> Tag {
    Tag::Compound(tags([("pos", ints(&[x, 0, 0])), ("state", Tag::Int(state))]))
}

fn placed_with(x: i32, state: i32, nbt: Compound) -> Tag {
    let Tag::Compound(mut block) = placed(x, state) else { unreachable!() };
    block.insert("nbt", Tag::Compound(nbt));
    Tag::Compound(block)
}

/// Three cells in a row: stone, nothing, dirt.
fn small() -> Compound {
    tags([
        ("DataVersion", Tag::Int(3465)),
        ("size", ints(&[3, 1, 1])),
        ("palette", palette(&["stone", "dirt"])),
        ("blocks", Tag::List(vec![placed(0, 0), placed(2, 1)])),
        ("entities", Tag::List(Vec::new())),
    ])
}

fn with<const N: usize>(extra: [(&str, Tag); N]) -> Vec<u8> {
    let mut root = small();
    root.extend(tags(extra));
    nbt::write("", &root).unwrap()
}

fn read_with(bytes: &[u8], jigsaws: Jigsaws) -> Decoded {
    decode_with(bytes, &Limits::default(), &Options { jigsaws, ..Options::default() }).unwrap()
}

fn blocks(grid: &Grid) -> Vec<String> {
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

/// The blocks with their cells shuffled, but for those left alone: what another palette could make of them.
fn variant(grid: &Grid, by: usize) -> Grid {
    let mut variant = Grid::new(grid.size());
    let states = grid.palette().states();
    for cell in grid.bounds().cells() {
        let other = &states[(usize::from(grid.id(cell)) + by) % states.len()];
        let is_void = |state: &BlockState| *state == BlockState::structure_void();
        let state = match (is_void(grid.get(cell)), is_void(other)) {
            (true, _) => BlockState::structure_void(),
            (false, true) => BlockState::air(),
            (false, false) => other.clone(),
        };
        let id = variant.intern(&state).unwrap();
        variant.set(cell, id);
    }
    variant.block_entities = grid.block_entities.clone();
    variant
}

proptest! {
    #[test]
    fn what_is_written_is_read(grid in grid(), variants in 0..3usize) {
        let mut grid = complete(grid);
        grid.metadata.offset = Cell::ZERO;
        grid.metadata.tags.retain(|_, tag| *tag != string(""));
        grid.metadata.own = Some(Own { dialect: Dialect::Structure, tags: tags([("mod", Tag::Byte(1))]) });
        grid.variants = (0..variants).map(|by| variant(&grid, by)).collect();
        let encoded = encode_structure(&grid).unwrap();
        prop_assert_eq!(&encoded.lost, &[]);
        prop_assert_eq!(&read(&encoded.bytes).unwrap().warnings, &[]);
        let back = read_grid(&encoded.bytes);
        prop_assert!(back.same_blocks(&grid));
        prop_assert_eq!(&back.block_entities, &grid.block_entities);
        prop_assert!(near(&back.metadata.entities, &grid.metadata.entities));
        let rest = |metadata: &Metadata| Metadata { entities: Vec::new(), ..metadata.clone() };
        prop_assert_eq!(rest(&back.metadata), rest(&grid.metadata));
        prop_assert_eq!(back.variants.len(), variants);
        for (back, variant) in back.variants.iter().zip(&grid.variants) {
            prop_assert!(back.same_blocks(variant));
            prop_assert_eq!(&back.block_entities, &variant.block_entities);
        }
        prop_assert_eq!(write(&back), encoded.bytes);
    }

    #[test]
    fn damaged_files_are_read_or_refused(grid in grid(), at: prop::sample::Index, byte: u8) {
        let mut plain = Vec::new();
        std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(&write(&grid)[..]), &mut plain).unwrap();
        let at = at.index(plain.len());
        plain[at] = byte;
        let _ = read(&plain);
    }
}

#[test]
fn what_only_some_looks_leave_alone_is_air_in_them() {
    let row = |names: [&str; 4]| {
        let mut grid = Grid::new(Cell::new(4, 1, 1));
        for (x, name) in (0..).zip(names) {
            let id = grid.intern(&state(name)).unwrap();
            grid.set(Cell::new(x, 0, 0), id);
        }
        grid
    };
    let mut grid = row(["stone", "structure_void", "structure_void", "structure_void"]);
    grid.variants = vec![row(["structure_void", "dirt", "structure_void", "structure_void"])];
    let chest = Compound::from([("id".to_owned(), string("minecraft:chest"))]);
    grid.block_entities.insert([3, 0, 0], chest.clone());
    grid.variants[0].block_entities.insert([3, 0, 0], chest);
    let encoded = encode_structure(&grid).unwrap();
    assert_eq!(encoded.lost, [Lost::LeftAlone(3)]);
    let back = read_grid(&encoded.bytes);
    assert_eq!(blocks(&back), ["stone", "air", "structure_void", "air"]);
    assert_eq!(blocks(&back.variants[0]), ["air", "dirt", "structure_void", "air"]);
    assert_eq!(back.block_entities, grid.block_entities);
}

#[test]
fn palettes_of_every_size() {
    for count in [1, 2, 3, 4, 5, 16, 17, 127, 128, 129, 16_384] {
        let grid = complete(varied(Cell::new(32, 17, 32), count));
        assert!(read_grid(&write(&grid)).same_blocks(&grid), "{count} states");
    }
    for size in [[1, 1, 1], [49, 1, 1], [1, 1000, 1]] {
        let grid = complete(varied(Cell::from_array(size), 5));
        assert!(read_grid(&write(&grid)).same_blocks(&grid), "{size:?}");
    }
}

#[test]
fn what_is_not_there_is_left_alone() {
    let grid = read_grid(&with([]));
    assert_eq!(blocks(&grid), ["stone", "structure_void", "dirt"]);
    let Tag::List(written) = &nbt_root(&write(&grid))["blocks"] else { panic!("no blocks") };
    assert_eq!(written, &[placed(0, 0), placed(2, 1)]);
}

pub fn nbt_root(bytes: &[u8]) -> Compound {
    let mut plain = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(bytes), &mut plain).unwrap();
    nbt::read(&plain, &nbt::Limits::default()).unwrap().1
}

#[test]
fn several_palettes_are_variants() {
    let palettes = Tag::List(vec![palette(&["stone", "dirt"]), palette(&["oak_planks", "sand"])]);
    let mut root = small();
    root.remove("palette");
    root.insert("palettes", palettes);
    let grid = read_grid(&nbt::write("", &root).unwrap());
    assert_eq!(blocks(&grid), ["stone", "structure_void", "dirt"]);
    let [variant] = &grid.variants[..] else { panic!("one variant") };
    assert_eq!(blocks(variant), ["oak_planks", "structure_void", "sand"]);
    assert_eq!(nbt_root(&write(&grid))["palettes"].kind(), "a List");
    let again = read_grid(&write(&grid));
    assert!(again.variants[0].same_blocks(variant));
    let limits = Limits { max_cells: 5, ..Limits::default() };
    let error = decode(&nbt::write("", &root).unwrap(), &limits).unwrap_err().to_string();
    assert_eq!(
        error,
        "the size 3 x 1 x 1 makes 3 blocks in each of 2 palettes, more than 5 in all, the limit"
    );
}

#[test]
fn jigsaws_become_what_they_leave_behind() {
    let jigsaw = |text: &str| tags([("id", string("minecraft:jigsaw")), ("final_state", string(text))]);
    let root = |data: Compound| {
        with([
            ("palette", palette(&["jigsaw"])),
            ("size", ints(&[1, 1, 1])),
            ("blocks", Tag::List(vec![placed_with(0, 0, data)])),
        ])
    };
    let cases = [
        (jigsaw("minecraft:oak_stairs[facing=east,half=top]"), "oak_stairs[facing=east,half=top]"),
        (jigsaw("minecraft:structure_void"), "structure_void"),
        (jigsaw("air"), "air"),
        (jigsaw("minecraft:chest[facing=west]{Lock:\"a\"}"), "chest[facing=west]"),
        (tags([("id", string("minecraft:jigsaw"))]), "air"),
    ];
    for (data, expected) in cases {
        let decoded = read_with(&root(data.clone()), Jigsaws::Final);
        assert_eq!(decoded.warnings, [Warning::Jigsaws(1)]);
        let Content::Grid(grid) = decoded.content else { panic!("no grid") };
        assert_eq!(blocks(&grid), [expected]);
        assert!(grid.block_entities.is_empty(), "the data go with the jigsaw");

        let decoded = read_with(&root(data.clone()), Jigsaws::Keep);
        assert_eq!(decoded.warnings, []);
        let Content::Grid(grid) = decoded.content else { panic!("no grid") };
        assert_eq!(blocks(&grid), ["jigsaw"]);
        assert_eq!(grid.block_entities[&[0; 3]], data);
        let again = read_with(&write(&grid), Jigsaws::Keep);
        assert!(matches!(again.content, Content::Grid(again) if again.block_entities == grid.block_entities));
    }
    let error = read(&root(jigsaw("Oak Stairs"))).unwrap_err().to_string();
    assert!(
        error.starts_with("the entry `Oak Stairs` of `blocks[0].nbt.final_state` is no block state"),
        "{error}"
    );
    let bare = with([("palette", palette(&["jigsaw", "dirt"]))]);
    assert_eq!(blocks(&read_grid(&bare)), ["jigsaw", "structure_void", "dirt"], "without data it stays");
}

/// What is put into a good file (or taken out), and the start of the message.
fn cases() -> Vec<(&'static str, Option<Tag>, &'static str)> {
    let list = |tag| Some(Tag::List(vec![tag]));
    vec![
        ("size", Some(ints(&[3, 1])), "the tag `size` is a List of 2: expected an Int Array of 3"),
        (
            "size",
            Some(ints(&[3, 0, 1])),
            "the tag `size` is 3 x 0 x 1: expected at least one block along each axis",
        ),
        ("size", Some(ints(&[-3, 1, 1])), "the tag `size` is -3 x 1 x 1: expected at least one block"),
        (
            "size",
            Some(ints(&[i32::MAX, i32::MAX, i32::MAX])),
            "the size 2147483647 x 2147483647 x 2147483647 makes 18446744073709551615 blocks,",
        ),
        (
            "size",
            Some(ints(&[10_000, 1, 100_000])),
            "the size 10000 x 1 x 100000 makes 1000000000 blocks, more than",
        ),
        ("palette", Some(Tag::Int(1)), "the tag `palette` is an Int (1): expected a List"),
        (
            "palette",
            Some(palette(&["stone"])),
            "`blocks[1].state`, block (2, 0, 0): index 1 is not in the palette of 1",
        ),
        (
            "palette",
            Some(palette(&["stone", ""])),
            "the entry `` of `palette[1].Name` is no block state: a block name",
        ),
        ("palettes", list(Tag::Int(1)), "the tag `palettes[0]` is an Int (1): expected a List"),
        (
            "palettes",
            list(palette(&[])),
            "`blocks[0].state`, block (0, 0, 0): index 0 is not in the palette of 0",
        ),
        ("blocks", None, "the tag `blocks` is missing: expected a List"),
        ("blocks", list(Tag::Int(1)), "the tag `blocks[0]` is an Int (1): expected a Compound"),
        ("blocks", list(placed(0, -1)), "the tag `blocks[0].state` is -1: expected an index of the palette"),
        (
            "blocks",
            list(placed(0, 2)),
            "`blocks[0].state`, block (0, 0, 0): index 2 is not in the palette of 2",
        ),
        (
            "blocks",
            list(Tag::Compound(tags([("state", Tag::Int(0))]))),
            "the tag `blocks[0].pos` is missing: expected an Int Array of 3",
        ),
        (
            "entities",
            list(Tag::Compound(Compound::new())),
            "the tag `entities[0].pos` is missing: expected a List",
        ),
        ("DataVersion", Some(string("7")), "the tag `DataVersion` is a String: expected an Int"),
    ]
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    for (name, tag, message) in cases() {
        let mut root = small();
        root.remove(name);
        root.extend(tag.map(|tag| (name.to_owned(), tag)));
        let found = match read(&nbt::write("", &root).unwrap()) {
            Ok(_) => panic!("`{name}` is taken, expected: {message}"),
            Err(error) => error.to_string(),
        };
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
}

#[test]
fn leniencies_are_told_of() {
    let chest = |id: &str| tags([("id", string(id)), ("x", Tag::Int(700))]);
    let list = vec![
        placed(3, 0),
        placed(-1, 0),
        placed_with(0, 0, chest("first")),
        placed_with(0, 1, chest("second")),
        placed_with(1, 1, chest("third")),
        placed(1, 0),
    ];
    let bytes = with([("blocks", Tag::List(list))]);
    let grid = read_grid(&bytes);
    assert_eq!(blocks(&grid), ["dirt", "stone", "structure_void"]);
    assert_eq!(grid.block_entities, [([0; 3], tags([("id", string("second"))]))].into());
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::BlocksOutside(2), Warning::BlocksReplaced(2)]);

    let pos = Tag::List([0.0; 3].map(Tag::Double).to_vec());
    let entity = |nbt| Tag::Compound(tags([("pos", pos.clone()), ("nbt", Tag::Compound(nbt))]));
    let unnamed = [Compound::new(), tags([("id", Tag::Int(7))])].map(entity);
    let bytes = with([("entities", Tag::List(unnamed.to_vec()))]);
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::EntitiesUnnamed(2)]);
}

#[test]
fn hanging_entities_say_where_they_hang() {
    let mut grid = Grid::new(Cell::new(2, 2, 2));
    let data = tags([("id", string("minecraft:painting"))]);
    let painting = |block| Entity { place: [1.0, 1.5, 0.03125], block: Some(block), data: data.clone() };
    let block_pos = |grid: &Grid| {
        let root = nbt_root(&write(grid));
        let Tag::List(entities) = &root["entities"] else { panic!("no entities") };
        let Tag::Compound(entity) = &entities[0] else { panic!("no entity") };
        entity["blockPos"].clone()
    };
    grid.metadata.entities = vec![painting(Cell::Y)];
    assert_eq!(block_pos(&grid), ints(&[0, 1, 0]));
    assert_eq!(read_grid(&write(&grid)).metadata.entities, [painting(Cell::Y)]);
    grid.metadata.entities = vec![painting(Cell::new(5000, 64, -300))];
    let found = read_grid(&write(&grid)).metadata.entities;
    assert_eq!(found, [painting(Cell::new(1, 1, 0))], "the place in the world says nothing");
}

#[test]
fn what_has_no_place_is_told_of() {
    let mut grid = Grid::new(Cell::ONE);
    grid.metadata.offset = Cell::new(1, 2, 3);
    grid.metadata.tags = tags([("Author", string("me")), ("Name", string("Hut"))]);
    grid.metadata.own = Some(Own { dialect: Dialect::Litematica, tags: tags([("Mod", Tag::Int(1))]) });
    let mut same = Grid::new(Cell::ONE);
    same.block_entities.insert([0; 3], tags([("id", string("minecraft:chest"))]));
    grid.variants = vec![same, Grid::new(Cell::splat(2))];
    let encoded = encode_structure(&grid).unwrap();
    let expected = [
        Lost::BlockEntities(1),
        Lost::Offset(Cell::new(1, 2, 3)),
        Lost::Metadata(vec!["Name".into()]),
        Lost::Own(vec!["Mod".into()]),
        Lost::Variants(1),
    ];
    assert_eq!(encoded.lost, expected);
    assert_eq!(read_grid(&encoded.bytes).metadata.tags, tags([("Author", string("me"))]));
    assert!(encode_structure(&Grid::new(Cell::new(1, 0, 1))).is_err());
}

/// How often each state is there that is something.
fn counts(grid: &Grid) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for cell in grid.bounds().cells() {
        let text = block::complete(grid.get(cell)).short();
        if !["air", "cave_air", "structure_void"].contains(&&*text) {
            *counts.entry(text).or_insert(0) += 1;
        }
    }
    counts
}

/// Beside every structure stands a schematic that another program made of it, with the final states of
/// jigsaws, and air where the structure leaves the world alone.
#[test]
fn real_houses_are_the_schematics_that_others_made_of_them() {
    let Some(folder) = folder() else { return };
    let mut houses = 0;
    for path in glob::glob(&folder.join("houses/*/*.nbt").to_string_lossy()).unwrap() {
        let path = path.unwrap();
        let grid = read_grid(&std::fs::read(&path).unwrap());
        let schematic = read_grid(&std::fs::read(path.with_extension("schem")).unwrap());
        assert_eq!(grid.size(), schematic.size(), "{}", path.display());
        assert_eq!(counts(&grid), counts(&schematic), "{}", path.display());

        let encoded = encode_structure(&grid).unwrap();
        assert_eq!(encoded.lost, [], "{}", path.display());
        let back = read_grid(&encoded.bytes);
        assert!(back.same_blocks(&complete(grid.clone())), "{}", path.display());
        assert_eq!(back.block_entities, grid.block_entities, "{}", path.display());
        assert_eq!(back.metadata, grid.metadata, "{}", path.display());
        houses += 1;
    }
    assert!(houses > 0, "no structures in {}", folder.display());
}

#[test]
fn jigsaws_of_real_houses_stay_where_they_are_wanted() {
    let Some(folder) = folder() else { return };
    let bytes = std::fs::read(folder.join("houses/village-oak/house5.nbt")).unwrap();
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::Jigsaws(5)]);
    let Content::Grid(grid) = read_with(&bytes, Jigsaws::Keep).content else { panic!("no grid") };
    let jigsaws = grid.bounds().cells().filter(|&cell| grid.get(cell).short_name() == "jigsaw");
    assert_eq!(jigsaws.filter(|cell| grid.block_entities.contains_key(&cell.to_array())).count(), 5);
}

#[test]
fn bounds_of_a_region_are_told_of_only_where_there_are_more() {
    let mut grid = Grid::new(Cell::ONE);
    let region =
        vox::grid::Region { name: "a".into(), bounds: Bounds::of_size(Cell::ONE), tags: Compound::new() };
    grid.metadata.regions = vec![region.clone()];
    assert_eq!(encode_structure(&grid).unwrap().lost, []);
    grid.metadata.regions.push(region);
    assert_eq!(encode_structure(&grid).unwrap().lost, [Lost::Regions { count: 2, tags: Vec::new() }]);
}

#[test]
fn blocks_take_no_more_memory_than_their_file() {
    let grid = Grid::new(Cell::new(50, 20, 20));
    let limits = Limits { max_bytes: 2 << 20, ..Limits::default() };
    assert!(decode(&encode_structure(&grid).unwrap().bytes, &limits).is_ok(), "20,000 blocks");
}
