//! Litematica schematics.

use super::real::folder;
use super::round_trip::{complete, grid, near, varied};
use super::{read, read_grid, tags};
use proptest::collection::{btree_set, vec};
use proptest::prelude::*;
use vox::block::BlockState;
use vox::grid::{BiomeMap, Biomes, Dialect, Entity, Grid, Metadata, Own, Region};
use vox::io::{
    Content, Limits, LitematicVersion, Lost, Options, Warning, WriteError, decode, decode_with,
    encode_litematic,
};
use vox::nbt::{self, Compound, Tag};
use vox::space::{Bounds, Cell};

const VERSIONS: [LitematicVersion; 2] = [LitematicVersion::V6, LitematicVersion::V7];

fn write(grid: &Grid) -> Vec<u8> {
    encode_litematic(grid, LitematicVersion::V6).unwrap().bytes
}

fn state(text: &str) -> BlockState {
    text.parse().unwrap()
}

fn string(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

fn xyz(x: i32, y: i32, z: i32) -> Tag {
    Tag::Compound(tags([("x", Tag::Int(x)), ("y", Tag::Int(y)), ("z", Tag::Int(z))]))
}

fn palette<const N: usize>(names: [&str; N]) -> Tag {
    Tag::List(names.map(|name| Tag::Compound(tags([("Name", string(name))]))).to_vec())
}

fn region<const N: usize>(extra: [(&str, Tag); N]) -> Compound {
    let mut region = tags([
        ("Position", xyz(0, 0, 0)),
        ("Size", xyz(2, 1, 2)),
        ("BlockStatePalette", palette(["minecraft:air", "minecraft:stone"])),
        ("BlockStates", Tag::LongArray(vec![0b01_00_00_01])),
    ]);
    region.extend(tags(extra));
    region
}

fn file<const N: usize>(regions: [(&str, Compound); N]) -> Vec<u8> {
    let regions = regions.map(|(name, region)| (name, Tag::Compound(region)));
    nbt::write("", &tags([("Version", Tag::Int(6)), ("Regions", Tag::Compound(tags(regions)))])).unwrap()
}

fn blocks(grid: &Grid) -> Vec<String> {
    grid.bounds().cells().map(|cell| grid.get(cell).short()).collect()
}

/// Cuts the grid into as many regions as it has places to cut at.
fn cut(grid: &Grid, cuts: &std::collections::BTreeSet<i32>) -> Vec<Region> {
    let size = grid.size();
    let inner = cuts.iter().copied().filter(|cut| (1..size.x).contains(cut));
    let ends: Vec<i32> = [0].into_iter().chain(inner).chain([size.x]).collect();
    let bounds = |pair: &[i32]| Bounds::new(Cell::new(pair[0], 0, 0), Cell::new(pair[1], size.y, size.z));
    let regions = ends.windows(2).enumerate().map(|(at, pair)| Region {
        name: format!("part {at}"),
        bounds: bounds(pair),
        tags: tags([("Note", Tag::Int(at as i32))]),
    });
    regions.collect()
}

fn cell(numbers: std::ops::Range<i32>) -> impl Strategy<Value = Cell> {
    [numbers.clone(), numbers.clone(), numbers].prop_map(Cell::from_array)
}

proptest! {
    #[test]
    fn what_is_written_is_read(grid in grid(), cuts in btree_set(1..9i32, 0..4), date in 1..i64::MAX) {
        let mut grid = complete(grid);
        grid.metadata.tags.insert("Date", Tag::Long(date));
        grid.metadata.tags.retain(|_, tag| *tag != string(""));
        grid.metadata.own = Some(Own { dialect: Dialect::Litematica, tags: tags([("Mod", Tag::Byte(1))]) });
        grid.metadata.regions = cut(&grid, &cuts);
        for version in VERSIONS {
            let encoded = encode_litematic(&grid, version).unwrap();
            prop_assert_eq!(&encoded.lost, &[]);
            prop_assert_eq!(&read(&encoded.bytes).unwrap().warnings, &[]);
            let back = read_grid(&encoded.bytes);
            prop_assert!(back.same_blocks(&grid));
            prop_assert_eq!(&back.block_entities, &grid.block_entities);
            let sorted = |grid: &Grid| {
                let mut entities = grid.metadata.entities.clone();
                entities.sort_by_key(|entity| format!("{:.6?} {:?}", entity.place, entity.data));
                entities
            };
            prop_assert!(near(&sorted(&back), &sorted(&grid)));
            let rest = |metadata: &Metadata| Metadata { entities: Vec::new(), ..metadata.clone() };
            prop_assert_eq!(rest(&back.metadata), rest(&grid.metadata));
        }
    }

    #[test]
    fn regions_anywhere_keep_what_is_in_them(grid in grid(), boxes in vec((cell(0..8), cell(1..5)), 0..4)) {
        let mut grid = complete(grid);
        let size = grid.size();
        // Both ends are in regions, so that the box around all is the grid.
        let boxes = boxes.into_iter().chain([(Cell::ZERO, Cell::ONE), (size - 1, Cell::ONE)]);
        let boxes = boxes.map(|(low, size)| Bounds::new(low, low + size).intersect(&grid.bounds()));
        let bounds: Vec<Bounds> = boxes.filter(|bounds| !bounds.is_empty()).collect();
        let void = grid.intern(&state("structure_void")).unwrap();
        let is_covered = |cell: &Cell| bounds.iter().any(|bounds| bounds.contains(*cell));
        for cell in grid.bounds().cells().filter(|cell| !is_covered(cell)) {
            grid.set(cell, void);
            grid.block_entities.remove(&cell.to_array());
        }
        let region = |(at, bounds): (usize, Bounds)| Region {
            name: at.to_string(),
            bounds,
            tags: Compound::new(),
        };
        grid.metadata.regions = bounds.into_iter().enumerate().map(region).collect();
        let encoded = encode_litematic(&grid, LitematicVersion::V6).unwrap();
        prop_assert_eq!(&encoded.lost, &[]);
        prop_assert_eq!(&read(&encoded.bytes).unwrap().warnings, &[]);
        let back = read_grid(&encoded.bytes);
        prop_assert!(back.same_blocks(&grid));
        prop_assert_eq!(&back.block_entities, &grid.block_entities);
        prop_assert_eq!(&back.metadata.regions, &grid.metadata.regions);
        prop_assert_eq!(back.metadata.offset, grid.metadata.offset);
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
fn palettes_of_every_width() {
    for count in [1, 2, 3, 4, 5, 8, 9, 16, 17, 127, 128, 129, 256, 257, 16_384, 16_385, 65_536] {
        let grid = complete(varied(Cell::new(64, 17, 64), count));
        let back = read_grid(&write(&grid));
        assert!(back.same_blocks(&grid), "{count} states");
        assert_eq!(back.palette().states().len(), count, "{count} states");
    }
}

#[test]
fn sizes_that_fill_words_and_do_not() {
    for size in [[1, 1, 1], [32, 1, 1], [33, 1, 1], [1, 4000, 1], [1, 1, 70_000], [100_000, 1, 2], [64, 1, 1]]
    {
        for count in [2, 7, 40] {
            let grid = complete(varied(Cell::from_array(size), count));
            assert!(read_grid(&write(&grid)).same_blocks(&grid), "{size:?}, {count} states");
        }
    }
}

#[test]
fn the_same_grid_gives_the_same_bytes() {
    let mut plain = Grid::new(Cell::ONE);
    let mut wasteful = plain.clone();
    wasteful.intern(&state("dirt")).unwrap();
    for (grid, text) in [(&mut plain, "oak_slab"), (&mut wasteful, "oak_slab[type=bottom,waterlogged=false]")]
    {
        let id = grid.intern(&state(text)).unwrap();
        grid.set(Cell::ZERO, id);
    }
    assert_eq!(write(&plain), write(&wasteful));
}

#[test]
fn states_that_differ_only_in_what_they_leave_out_are_one() {
    let mut grid = Grid::new(Cell::new(2, 1, 1));
    for (x, text) in [(0, "oak_slab"), (1, "oak_slab[type=bottom]")] {
        let id = grid.intern(&state(text)).unwrap();
        grid.set(Cell::new(x, 0, 0), id);
    }
    let back = read_grid(&write(&grid));
    assert_eq!(blocks(&back), ["oak_slab[type=bottom,waterlogged=false]"; 2]);
    assert_eq!(back.palette().states().len(), 2, "air and the slab");
}

#[test]
fn negative_sizes_reach_to_the_other_side() {
    let plain = read_grid(&file([("a", region([]))]));
    assert_eq!(blocks(&plain), ["stone", "air", "air", "stone"]);
    let chest = Tag::Compound(tags([
        ("id", string("minecraft:chest")),
        ("x", Tag::Int(1)),
        ("y", Tag::Int(0)),
        ("z", Tag::Int(0)),
    ]));
    let pos = Tag::List([0.5, 0.0, 0.25].map(Tag::Double).to_vec());
    let frame = tags([
        ("id", string("minecraft:item_frame")),
        ("Pos", pos),
        ("TileX", Tag::Int(0)),
        ("TileY", Tag::Int(0)),
        ("TileZ", Tag::Int(0)),
    ]);
    let turned = region([
        ("Position", xyz(10, 5, -3)),
        ("Size", xyz(-2, -1, 2)),
        ("TileEntities", Tag::List(vec![chest])),
        ("Entities", Tag::List(vec![Tag::Compound(frame)])),
    ]);
    let grid = read_grid(&file([("a", turned)]));
    assert_eq!(grid.metadata.offset, Cell::new(9, 5, -3));
    assert!(grid.same_blocks(&plain), "blocks count from the low corner");
    let places: Vec<_> = grid.block_entities.keys().collect();
    assert_eq!(places, [&[1, 0, 0]], "block entities count from the low corner");
    let [frame] = &grid.metadata.entities[..] else { panic!("one entity") };
    assert_eq!(frame.place, [1.5, 0.0, 0.25], "entities count from the position");
    assert_eq!(frame.block, Some(Cell::X));
    let again = read_grid(&write(&grid));
    assert_eq!(
        (again.metadata.offset, &again.metadata.entities),
        (grid.metadata.offset, &grid.metadata.entities)
    );
}

#[test]
fn regions_are_merged_and_what_is_in_none_is_left_alone() {
    let bytes = file([
        (
            "east",
            region([
                ("Position", xyz(2, 0, 0)),
                ("Size", xyz(1, 1, 2)),
                ("PendingBlockTicks", palette(["t"])),
            ]),
        ),
        ("west", region([("Position", xyz(-1, 0, 0)), ("Size", xyz(2, 1, 1))])),
    ]);
    let decoded = read(&bytes).unwrap();
    assert_eq!(decoded.warnings, []);
    let grid = read_grid(&bytes);
    let void = "structure_void";
    assert_eq!(blocks(&grid), ["stone", "air", void, "stone", void, void, void, "air"]);
    assert_eq!(grid.metadata.offset, Cell::new(-1, 0, 0));
    let names: Vec<_> = grid.metadata.regions.iter().map(|region| (&*region.name, region.bounds)).collect();
    let bounds = |low: [i32; 3], high: [i32; 3]| Bounds::new(Cell::from_array(low), Cell::from_array(high));
    assert_eq!(names, [("east", bounds([3, 0, 0], [4, 1, 2])), ("west", bounds([0, 0, 0], [2, 1, 1]))]);
    assert_eq!(grid.metadata.regions[0].tags, tags([("PendingBlockTicks", palette(["t"]))]));

    let again = read_grid(&write(&grid));
    assert!(again.same_blocks(&grid));
    assert_eq!(again.metadata.regions, grid.metadata.regions);
}

#[test]
fn the_last_block_counts_where_regions_overlap() {
    let chest = |id: &str| {
        Tag::List(vec![Tag::Compound(tags([
            ("id", string(id)),
            ("x", Tag::Int(0)),
            ("y", Tag::Int(0)),
            ("z", Tag::Int(0)),
        ]))])
    };
    let dirt = [
        ("BlockStatePalette", palette(["minecraft:air", "minecraft:dirt"])),
        ("TileEntities", chest("second")),
    ];
    let bytes = file([("a", region([("TileEntities", chest("first"))])), ("b", region(dirt))]);
    let grid = read_grid(&bytes);
    assert_eq!(blocks(&grid), ["dirt", "air", "air", "dirt"]);
    assert_eq!(grid.block_entities[&[0, 0, 0]], tags([("id", string("second"))]));
    let region_b = || "b".to_owned();
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::RegionsOverlap { region: region_b(), blocks: 2 }]);

    let air = region([("BlockStates", Tag::LongArray(vec![0]))]);
    let bytes = file([("a", region([])), ("b", air)]);
    assert_eq!(blocks(&read_grid(&bytes)), ["stone", "air", "air", "stone"], "air replaces nothing");
    assert_eq!(read(&bytes).unwrap().warnings, []);
}

#[test]
fn one_region_of_several() {
    let far = region([("Position", xyz(1_000_000, 0, 0))]);
    let bytes = file([("far", far), ("near", region([]))]);
    let limits = Limits { max_cells: 1000, ..Limits::default() };
    let error = decode(&bytes, &limits).unwrap_err().to_string();
    assert_eq!(
        error,
        "the regions `near` and `far` lie 999998 blocks apart along x: the box around all regions, \
         1000002 x 1 x 2, makes 2000004 blocks, more than 1000, the limit; read the regions one by one"
    );
    let options = Options { region: Some("far".into()), ..Options::default() };
    let Content::Grid(grid) = decode_with(&bytes, &limits, &options).unwrap().content else {
        panic!("no grid")
    };
    assert_eq!(blocks(&grid), ["stone", "air", "air", "stone"]);
    assert_eq!(grid.metadata.offset, Cell::new(1_000_000, 0, 0));
    assert_eq!(grid.metadata.regions.len(), 1);
}

#[test]
fn a_name_that_no_region_has() {
    let with = |name: &str| {
        let options = Options { region: Some(name.into()), ..Options::default() };
        decode_with(&file([("far", region([])), ("near", region([]))]), &Limits::default(), &options)
    };
    assert!(with("far").is_ok());
    assert_eq!(with("fa").unwrap_err().to_string(), "the file has no region `fa`: it has `far`, `near`");
}

/// What is put into a good region (or taken out), and the start of the message.
fn cases() -> Vec<(&'static str, Option<Tag>, &'static str)> {
    let words = |count| Some(Tag::LongArray(vec![0; count]));
    vec![
        ("Position", None, "the tag `Regions.a.Position` is missing: expected a Compound"),
        ("Size", Some(Tag::Int(3)), "the tag `Regions.a.Size` is an Int (3): expected a Compound"),
        ("Size", Some(xyz(2, 0, 2)), "the tag `Regions.a.Size` is 2 x 0 x 2: expected at least one block"),
        (
            "Size",
            Some(xyz(2, 1, 2000)),
            "`Regions.a.BlockStates` holds 1 words: expected 125 for the size 2 x 1 x 2000 and 2 bits",
        ),
        (
            "Size",
            Some(xyz(i32::MAX, i32::MAX, i32::MIN + 1)),
            "`Regions.a.BlockStates` holds 1 words: expected 576460752303423488 for the size 2147483647 x",
        ),
        (
            "Size",
            Some(xyz(i32::MIN, 1, 1)),
            "`Regions.a.Position` is (0, 0, 0) and the size -2147483648 x 1 x 1: no number reaches so far",
        ),
        (
            "Position",
            Some(xyz(0, i32::MAX, 0)),
            "`Regions.a.Position` is (0, 2147483647, 0) and the size 2 x 1 x 2: no number reaches so far",
        ),
        ("BlockStatePalette", None, "the tag `Regions.a.BlockStatePalette` is missing: expected a List"),
        (
            "BlockStatePalette",
            Some(palette([])),
            "`Regions.a.BlockStates`, block (0, 0, 0): index 1 is not in the palette of 0 entries",
        ),
        (
            "BlockStatePalette",
            Some(Tag::List(vec![Tag::Int(1)])),
            "the tag `Regions.a.BlockStatePalette[0]` is an Int (1): expected a Compound",
        ),
        (
            "BlockStatePalette",
            Some(palette(["minecraft:air", "Stone"])),
            "the entry `Stone` of `Regions.a.BlockStatePalette[1].Name` is no block state: `Stone` is",
        ),
        ("BlockStates", None, "the tag `Regions.a.BlockStates` is missing: expected a Long Array"),
        (
            "BlockStates",
            Some(Tag::IntArray(vec![1, 0])),
            "the tag `Regions.a.BlockStates` is an Int Array of 2: expected a Long Array",
        ),
        ("BlockStates", words(0), "`Regions.a.BlockStates` holds 0 words: expected 1 for the size 2 x 1 x 2"),
        ("BlockStates", words(2), "`Regions.a.BlockStates` holds 2 words: expected 1 for the size 2 x 1 x 2"),
        (
            "BlockStates",
            Some(Tag::LongArray(vec![0b00_11_00_00])),
            "`Regions.a.BlockStates`, block (0, 0, 1): index 3 is not in the palette of 2 entries",
        ),
        (
            "TileEntities",
            Some(palette(["chest"])),
            "the tag `Regions.a.TileEntities[0].x` is missing: expected an Int",
        ),
        (
            "Entities",
            Some(palette(["pig"])),
            "the tag `Regions.a.Entities[0].Pos` is missing: expected a List of 3",
        ),
    ]
}

#[test]
fn refusals_name_the_field_and_what_was_expected() {
    for (name, tag, message) in cases() {
        let mut region = region([]);
        region.remove(name);
        region.extend(tag.map(|tag| (name.to_owned(), tag)));
        let found = match read(&file([("a", region)])) {
            Ok(_) => panic!("`{name}` is taken, expected: {message}"),
            Err(error) => error.to_string(),
        };
        assert!(found.starts_with(message), "expected: {message}\n   found: {found}");
    }
    let none = read(&file([])).unwrap_err().to_string();
    assert_eq!(none, "the tag `Regions` is empty: expected at least one region");
}

#[test]
fn more_states_than_a_grid_holds() {
    let twice = vec![Tag::Compound(tags([("Name", string("stone"))])); 65_537];
    let error =
        read(&file([("a", region([("BlockStatePalette", Tag::List(twice))]))])).unwrap_err().to_string();
    assert_eq!(error, "`Regions.a.BlockStatePalette`: more than 65,536 distinct block states");
}

#[test]
fn limits_hold() {
    let limits = Limits { max_cells: 3, ..Limits::default() };
    let error = decode(&file([("a", region([]))]), &limits).unwrap_err().to_string();
    assert_eq!(error, "the size 2 x 1 x 2 makes 4 blocks, more than 3, the limit");
    assert!(decode(&file([("a", region([]))]), &Limits { max_cells: 4, ..limits }).is_ok());
}

#[test]
fn leniencies_are_told_of() {
    let versions = |version| {
        let root = [
            ("Version", Tag::Int(version)),
            ("Regions", Tag::Compound(tags([("a", Tag::Compound(region([])))]))),
        ];
        read(&nbt::write("", &tags(root)).unwrap()).map(|decoded| decoded.warnings)
    };
    let too_old = "the tag `Version` is 1: vox knows Litematica schematics from version 2 on";
    assert_eq!(versions(1).unwrap_err().to_string(), too_old);
    assert_eq!(versions(4).unwrap(), [Warning::OldStates]);
    assert_eq!(versions(5).unwrap(), []);
    assert_eq!(versions(8).unwrap(), [Warning::NewVersion { found: 8, known: 7 }]);

    let no_air = region([("BlockStatePalette", palette(["minecraft:dirt", "minecraft:stone"]))]);
    let bytes = file([("a", no_air)]);
    assert_eq!(blocks(&read_grid(&bytes)), ["stone", "dirt", "dirt", "stone"]);
    assert_eq!(read(&bytes).unwrap().warnings, [Warning::PaletteWithoutAir("a".into())]);

    let outside = Tag::Compound(tags([("x", Tag::Int(2)), ("y", Tag::Int(0)), ("z", Tag::Int(0))]));
    let pos = Tag::List([0.0; 3].map(Tag::Double).to_vec());
    let unnamed = Tag::Compound(tags([("Pos", pos)]));
    let strange = region([
        ("TileEntities", Tag::List(vec![outside])),
        ("Entities", Tag::List(vec![unnamed.clone(), unnamed])),
    ]);
    let warnings = read(&file([("a", strange)])).unwrap().warnings;
    assert_eq!(warnings, [Warning::BlockEntitiesOutside(1), Warning::EntitiesUnnamed(2)]);
}

#[test]
fn metadata_have_the_same_names_in_all_formats() {
    let mut grid = Grid::new(Cell::ONE);
    let all = || tags([("Name", string("Hut")), ("Date", Tag::Long(7)), ("WorldEdit", string("7"))]);
    grid.metadata.tags = all();
    let root = nbt_root(&write(&grid));
    let Tag::Compound(written) = &root["Metadata"] else { panic!("no metadata") };
    let expected = tags([
        ("Name", string("Hut")),
        ("Author", string("")),
        ("Description", string("")),
        ("TimeCreated", Tag::Long(7)),
        ("TimeModified", Tag::Long(7)),
        ("WorldEdit", string("7")),
        ("EnclosingSize", xyz(1, 1, 1)),
        ("RegionCount", Tag::Int(1)),
        ("TotalBlocks", Tag::Int(0)),
        ("TotalVolume", Tag::Int(1)),
    ]);
    assert_eq!(*written, expected);
    let Tag::Compound(regions) = &root["Regions"] else { panic!("no regions") };
    assert_eq!(regions.keys().collect::<Vec<_>>(), ["Hut"], "the only region has the name of the whole");
    assert_eq!(read_grid(&write(&grid)).metadata.tags, all());
}

fn nbt_root(bytes: &[u8]) -> Compound {
    let mut plain = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(bytes), &mut plain).unwrap();
    nbt::read(&plain, &nbt::Limits::default()).unwrap().1
}

#[test]
fn blocks_outside_of_the_regions_are_not_lost() {
    let mut grid = complete(varied(Cell::new(4, 1, 1), 3));
    let half =
        Region { name: "half".into(), bounds: Bounds::of_size(Cell::new(2, 1, 1)), tags: Compound::new() };
    grid.metadata.regions = vec![half.clone()];
    let encoded = encode_litematic(&grid, LitematicVersion::V6).unwrap();
    assert_eq!(encoded.lost, [Lost::Regions { count: 1, tags: Vec::new() }]);
    assert!(read_grid(&encoded.bytes).same_blocks(&grid));

    let void = grid.intern(&state("structure_void")).unwrap();
    grid.fill(Bounds::new(Cell::new(2, 0, 0), Cell::new(4, 1, 1)), void);
    grid.metadata.regions = vec![half.clone(), half.clone()];
    let encoded = encode_litematic(&grid, LitematicVersion::V6).unwrap();
    assert_eq!(encoded.lost, [Lost::Regions { count: 2, tags: Vec::new() }], "no region reaches the end");

    let end = Bounds::new(Cell::new(3, 0, 0), Cell::new(4, 1, 1));
    let end = Region { name: "the end".into(), bounds: end, tags: Compound::new() };
    grid.metadata.regions = vec![half.clone(), half, end];
    let encoded = encode_litematic(&grid, LitematicVersion::V6).unwrap();
    assert_eq!(encoded.lost, []);
    let names: Vec<String> =
        read_grid(&encoded.bytes).metadata.regions.iter().map(|region| region.name.clone()).collect();
    assert_eq!(names, ["half", "half (2)", "the end"]);
}

#[test]
fn what_has_no_place_is_told_of() {
    let mut grid = Grid::new(Cell::ONE);
    grid.block_entities.insert([0; 3], tags([("Lock", string("key"))]));
    grid.metadata.own = Some(Own { dialect: Dialect::Sponge, tags: tags([("Extra", Tag::Int(1))]) });
    let map = BiomeMap::Columns(ndarray::Array2::zeros((1, 1)));
    grid.metadata.biomes = Some(Biomes { names: vec!["plains".into()], map });
    grid.variants = vec![Grid::new(Cell::ONE)];
    let lost = encode_litematic(&grid, LitematicVersion::V6).unwrap().lost;
    let expected =
        [Lost::UnnamedBlockEntities(1), Lost::Biomes, Lost::Own(vec!["Extra".into()]), Lost::Variants(1)];
    assert_eq!(lost, expected);
}

#[test]
fn grids_that_have_no_file() {
    let empty = encode_litematic(&Grid::new(Cell::new(1, 0, 1)), LitematicVersion::V6).unwrap_err();
    assert!(matches!(empty, WriteError::Empty(_)), "{empty}");
    let mut far = Grid::new(Cell::new(2, 1, 1));
    far.metadata.offset = Cell::MAX;
    let region = |x| Region {
        name: "a".into(),
        bounds: Bounds::new(Cell::new(x, 0, 0), Cell::new(x + 1, 1, 1)),
        tags: Compound::new(),
    };
    let whole = encode_litematic(&far, LitematicVersion::V6).unwrap_err();
    assert!(matches!(whole, WriteError::Offset(_)), "its end is too far to be read: {whole}");
    far.metadata.regions = vec![region(0), region(1)];
    let error = encode_litematic(&far, LitematicVersion::V6).unwrap_err().to_string();
    assert_eq!(
        error,
        "the offset (2147483647, 2147483647, 2147483647) cannot be written: no number reaches so far"
    );
}

#[test]
fn entities_in_no_region_and_in_several() {
    let mut grid = Grid::new(Cell::new(2, 1, 1));
    let bounds = grid.bounds();
    let region = |name: &str| Region { name: name.into(), bounds, tags: Compound::new() };
    grid.metadata.regions = vec![region("a"), region("b")];
    let pig = |x| Entity { place: [x, 0.0, 0.5], block: None, data: tags([("id", string("minecraft:pig"))]) };
    grid.metadata.entities = vec![pig(-7.5), pig(0.5)];
    assert_eq!(read_grid(&write(&grid)).metadata.entities, grid.metadata.entities, "each once");
}

#[test]
fn real_files_are_read_and_written_back() {
    let Some(folder) = folder() else { return };
    // Blocks that are something, block entities and entities, as other readers count them.
    let known = [
        ("demo_v6", [4, 3, 4], 8, 1, 1),
        ("island", [91, 70, 76], 73_269, 472, 184),
        ("mansion", [39, 41, 40], 7_815, 4, 13),
    ];
    for (name, size, count, block_entities, entities) in known {
        let bytes = std::fs::read(folder.join(format!("builds/{name}.litematic"))).unwrap();
        assert_eq!(read(&bytes).unwrap().warnings, [], "{name}");
        let grid = read_grid(&bytes);
        assert_eq!(grid.size().to_array(), size, "{name}");
        assert_eq!(
            grid.bounds().cells().filter(|&cell| !grid.get(cell).is_nothing()).count(),
            count,
            "{name}"
        );
        assert_eq!(grid.block_entities.len(), block_entities, "{name}");
        assert_eq!(grid.metadata.entities.len(), entities, "{name}");
        let near_the_build = |place: [f64; 3]| {
            (0..3).all(|axis| (-1.0..=f64::from(grid.size()[axis]) + 1.0).contains(&place[axis]))
        };
        assert!(grid.metadata.entities.iter().all(|entity| near_the_build(entity.place)), "{name}");

        let encoded = encode_litematic(&grid, LitematicVersion::V6).unwrap();
        assert_eq!(encoded.lost, [], "{name}");
        let back = read_grid(&encoded.bytes);
        assert!(back.same_blocks(&complete(grid.clone())), "{name}");
        assert_eq!(back.block_entities, grid.block_entities, "{name}");
        assert!(near(&back.metadata.entities, &grid.metadata.entities), "{name}");
        let rest = |metadata: &Metadata| Metadata { entities: Vec::new(), ..metadata.clone() };
        assert_eq!(rest(&back.metadata), rest(&grid.metadata), "{name}");
    }
}
