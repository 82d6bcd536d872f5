//! Regions: worlds written and read, old layouts, other readers' opinions, and damage.

use super::examples::region::{KINDS, chunk_1_13, chunk_1_16, compound, old_chunk, old_index, region};
use super::{read, read_grid, tags};
use fastanvil::{Chunk, CurrentJavaChunk};
use ndarray::Array3;
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use std::io::Cursor;
use std::path::Path;
use tempfile::TempDir;
use vox::block::{BlockState, Palette, complete};
use vox::grid::{BiomeMap, Biomes, Entity, Grid};
use vox::io::{
    Content, Decoded, EncodedRegions, Limits, Lost, ReadError, Warning, encode_regions, read_world,
};
use vox::nbt::{Compound, Tag};
use vox::space::{Bounds, Cell};

fn world(regions: &EncodedRegions) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, bytes) in &regions.files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    folder
}

fn grid_of(decoded: Decoded) -> Grid {
    match decoded.content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => panic!("expected a grid"),
    }
}

fn read_part(folder: &Path, at: Cell, size: Cell) -> Result<Decoded, ReadError> {
    read_world(folder, Some(Bounds::new(at, at + size)), &Limits::default())
}

fn state(text: &str) -> BlockState {
    complete(&text.parse().unwrap())
}

fn note_blocks(count: usize) -> Palette {
    let mut palette = Palette::default();
    for n in 1..count {
        palette.intern(&state("note_block").with("note", &n.to_string())).unwrap();
    }
    palette
}

fn any_grid() -> impl Strategy<Value = Grid> {
    let size = (1..36usize, 1..36usize, 1..36usize, 1..400usize);
    let cells = size.prop_flat_map(|(x, y, z, count)| {
        vec(0..count as u16, x * y * z).prop_map(move |cells| {
            let cells = Array3::from_shape_vec((y, z, x), cells).unwrap();
            Grid::from_cells(cells, note_blocks(count)).unwrap()
        })
    });
    let block_entities = btree_map([0..36i32, 0..36i32, 0..36i32], "[a-z]{1,9}", 0..6);
    let entities = vec(([0.0..1.0, 0.0..1.0, 0.0..1.0f64], "[a-z]{1,9}"), 0..4);
    (cells, block_entities, entities).prop_map(|(mut grid, block_entities, entities)| {
        for (place, id) in block_entities {
            if grid.bounds().contains(Cell::from_array(place)) {
                grid.block_entities.insert(place, tags([("id", Tag::String(id))]));
            }
        }
        grid.metadata.data_version = Some(3700);
        let size = grid.size().to_array();
        let entity = |(place, id): ([f64; 3], String)| Entity {
            place: [0, 1, 2].map(|i| (place[i] * f64::from(size[i]) * 8.0).floor() / 8.0),
            block: None,
            data: tags([("id", Tag::String(id))]),
        };
        grid.metadata.entities = entities.into_iter().map(entity).collect();
        grid
    })
}

fn any_place() -> impl Strategy<Value = Cell> {
    (-1000..1000i32, -64..280i32, -1000..1000i32).prop_map(|(x, y, z)| Cell::new(x, y, z))
}

fn sorted(mut entities: Vec<Entity>) -> Vec<Entity> {
    entities.sort_by(|a, b| format!("{a:?}").cmp(&format!("{b:?}")));
    entities
}

fn plains(size: Cell) -> Option<Biomes> {
    let columns = ndarray::Array2::zeros((size.z as usize, size.x as usize));
    Some(Biomes { names: vec!["minecraft:plains".into()], map: BiomeMap::Columns(columns) })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn what_is_written_into_a_world_is_read_from_it(grid in any_grid(), at in any_place()) {
        let regions = encode_regions(&grid, at).unwrap();
        prop_assert_eq!(&regions, &encode_regions(&grid, at).unwrap());
        let decoded = read_part(world(&regions).path(), at, grid.size()).unwrap();
        prop_assert_eq!(&decoded.warnings, &[]);
        let back = grid_of(decoded);
        prop_assert!(back.same_blocks(&grid));
        prop_assert_eq!(&back.block_entities, &grid.block_entities);
        prop_assert_eq!(sorted(back.metadata.entities), sorted(grid.metadata.entities.clone()));
        prop_assert_eq!(back.metadata.biomes, plains(grid.size()));
        prop_assert_eq!(back.metadata.data_version, Some(3700));
    }

    #[test]
    fn another_reader_sees_the_same_blocks(grid in any_grid(), at in any_place()) {
        let regions = encode_regions(&grid, at).unwrap();
        let mut seen = 0;
        for (name, bytes) in regions.files.iter().filter(|(name, _)| name.starts_with("region/")) {
            let mut region = fastanvil::Region::from_stream(Cursor::new(bytes)).unwrap();
            let place: Vec<i32> = name.split('.').filter_map(|word| word.parse().ok()).collect();
            for chunk in region.iter().map(Result::unwrap) {
                let low = [place[0] * 512 + chunk.x as i32 * 16, place[1] * 512 + chunk.z as i32 * 16];
                let blocks: CurrentJavaChunk = fastnbt::from_bytes(&chunk.data).unwrap();
                let column = Bounds::new(Cell::new(low[0], at.y, low[1]), Cell::new(low[0] + 16, at.y + grid.size().y, low[1] + 16));
                for cell in column.intersect(&Bounds::new(at, at + grid.size())).cells() {
                    let block = blocks.block((cell.x - low[0]) as usize, cell.y as isize, (cell.z - low[1]) as usize);
                    let expected = grid.get(cell - at);
                    // This reader leaves `powered` out of its descriptions.
                    let described = expected.to_string().replace(",powered=false]", "").replace('[', "|");
                    prop_assert_eq!(block.unwrap().encoded_description().trim_end_matches('|'), described);
                    seen += 1;
                }
            }
        }
        prop_assert_eq!(seen, grid.bounds().volume());
    }

    #[test]
    fn damaged_regions_are_read_or_refused(
        at in 0..16_384usize, byte: u8, kind in 0..4usize,
    ) {
        let mut bytes = region(&[([0, 0], &chunk_1_13([0, 0]))], KINDS[kind]);
        let at = at % bytes.len();
        bytes[at] = byte;
        let _ = read(&bytes);
        let _ = read(&bytes[..at]);
    }
}

#[test]
fn a_region_alone_gives_its_blocks_without_the_air_around() {
    let mut grid = Grid::new(Cell::new(20, 5, 9));
    let id = grid.intern(&state("stone")).unwrap();
    grid.fill(Bounds::new(Cell::new(3, 1, 2), Cell::new(18, 4, 7)), id);
    let regions = encode_regions(&grid, Cell::new(-700, 60, 40)).unwrap();
    assert_eq!(regions.files.iter().map(|(name, _)| &name[..]).collect::<Vec<_>>(), ["region/r.-2.0.mca"]);
    let back = read_grid(&regions.files[0].1);
    assert_eq!(back.size(), Cell::new(15, 3, 5));
    assert!(back.bounds().cells().all(|cell| *back.get(cell) == state("stone")));
    let folder = world(&regions);
    for path in ["", "region", "region/r.-2.0.mca"] {
        let found = read_world(&folder.path().join(path), None, &Limits::default()).unwrap();
        assert!(grid_of(found).same_blocks(&back), "{path}");
    }
}

#[test]
fn chunks_to_be_left_alone_are_left_out_and_others_have_air() {
    let mut grid = Grid::new(Cell::new(32, 1, 16));
    let void = grid.intern(&BlockState::structure_void()).unwrap();
    grid.fill(Bounds::new(Cell::ZERO, Cell::new(17, 1, 16)), void);
    let regions = encode_regions(&grid, Cell::ZERO).unwrap();
    assert_eq!(regions.lost, [Lost::LeftAlone(16)]);
    let decoded = read_part(world(&regions).path(), Cell::ZERO, grid.size()).unwrap();
    assert_eq!(decoded.warnings, [Warning::ChunksNotMade(1)]);
    let back = grid_of(decoded);
    for cell in back.bounds().cells() {
        assert_eq!(back.get(cell).short_name(), if cell.x < 16 { "structure_void" } else { "air" });
    }
}

#[test]
fn block_entities_of_chunks_to_be_left_alone_are_lost_with_a_word() {
    let mut grid = Grid::new(Cell::new(32, 1, 16));
    let void = grid.intern(&BlockState::structure_void()).unwrap();
    grid.fill(Bounds::new(Cell::ZERO, Cell::new(16, 1, 16)), void);
    let chest = tags([("id", Tag::String("minecraft:chest".into()))]);
    grid.block_entities = [[0, 0, 0], [20, 0, 0]].map(|place| (place, chest.clone())).into();
    let regions = encode_regions(&grid, Cell::ZERO).unwrap();
    assert_eq!(regions.lost, [Lost::BlockEntities(1)]);
    let back = grid_of(read_part(world(&regions).path(), Cell::ZERO, grid.size()).unwrap());
    assert_eq!(back.block_entities, [([20, 0, 0], chest)].into());
}

#[test]
fn what_chunks_hold_beside_a_build_is_told() {
    let mut root = chunk_1_16([0, 0]);
    let tick = |y| compound([("x", Tag::Int(1)), ("y", Tag::Int(y)), ("z", Tag::Int(1))]);
    let empty = || Tag::List(vec![Tag::List(Vec::new())]);
    let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
    level.insert("TileTicks", Tag::List(vec![tick(17), tick(200)]));
    level.insert("Heightmaps", compound([("MOTION_BLOCKING", Tag::LongArray(vec![1]))]));
    level.insert("PostProcessing", empty());
    level.insert("Structures", compound([("References", compound([]))]));
    let Some(Tag::List(sections)) = level.get_mut("Sections") else { panic!("no sections") };
    let Tag::Compound(section) = &mut sections[1] else { panic!("no section") };
    section.insert("starlight.skylight_state", Tag::Int(2));
    let told = |root: &Compound| read(&region(&[([0, 0], root)], 2)).unwrap().warnings;
    assert_eq!(told(&root), [Warning::BiomesByNumber, Warning::TicksDropped(1)]);

    let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
    level.insert("ForgeCaps", compound([("mana", Tag::Int(7))]));
    let Some(Tag::List(sections)) = level.get_mut("Sections") else { panic!("no sections") };
    let Tag::Compound(section) = &mut sections[1] else { panic!("no section") };
    section.insert("Colors", Tag::ByteArray(vec![7]));
    root.insert("ChunkBukkitValues", compound([("a:b", Tag::Int(7))]));
    let tags = "ChunkBukkitValues, Level.ForgeCaps, Level.Sections[].Colors";
    assert_eq!(told(&root)[2..], [Warning::ChunkTags(tags.into())]);
}

#[test]
fn biomes_stand_for_cubes_of_four() {
    let mut grid = Grid::new(Cell::new(8, 8, 8));
    let names = vec!["minecraft:desert".to_owned(), "minecraft:river".to_owned()];
    let cells = |step: usize| Array3::from_shape_fn((8, 8, 8), |(y, z, x)| ((y + z + x) / step % 2) as u16);
    let cubes = Array3::from_shape_fn((8, 8, 8), |(y, z, x)| ((y / 4 + z / 4 + x / 4) % 2) as u16);
    for (map, lost) in [(cubes, vec![]), (cells(1), vec![Lost::Biomes])] {
        grid.metadata.biomes = Some(Biomes { names: names.clone(), map: BiomeMap::Cells(map) });
        let regions = encode_regions(&grid, Cell::new(16, 0, -32)).unwrap();
        assert_eq!(regions.lost, lost);
        let decoded = read_part(world(&regions).path(), Cell::new(16, 0, -32), grid.size()).unwrap();
        assert_eq!(grid_of(decoded).metadata.biomes == grid.metadata.biomes, lost.is_empty());
    }
}

#[test]
fn chunks_too_long_for_a_region_stand_beside_it() {
    let mut grid = Grid::new(Cell::ONE);
    let mut noise: u64 = 1;
    let next = |_| {
        noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (noise >> 33) as i64 | (noise << 31).cast_signed()
    };
    let data = Tag::LongArray((0..200_000).map(next).collect());
    grid.block_entities.insert([0; 3], tags([("id", Tag::String("a:b".into())), ("data", data)]));
    let regions = encode_regions(&grid, Cell::new(-1, 0, 0)).unwrap();
    let names: Vec<&str> = regions.files.iter().map(|(name, _)| &name[..]).collect();
    assert_eq!(names, ["region/r.-1.0.mca", "region/c.-1.0.mcc"]);
    let folder = world(&regions);
    let back = grid_of(read_part(folder.path(), Cell::new(-1, 0, 0), Cell::ONE).unwrap());
    assert_eq!(back.block_entities, grid.block_entities);
    let error = read(&regions.files[0].1).unwrap_err().to_string();
    assert_eq!(
        error,
        "the chunk (31, 0) of the region: it is kept in a file of its own, `c.<x>.<z>.mcc` beside the region, \
         which cannot be read"
    );
}

#[test]
fn builds_that_no_world_holds_are_refused() {
    let mut grid = Grid::new(Cell::ONE);
    let refusal = |grid: &Grid, at: Cell| encode_regions(grid, at).unwrap_err().to_string();
    assert!(
        refusal(&grid, Cell::new(i32::MAX, 0, 0))
            .starts_with("the build would reach from (2147483647, 0, 0)")
    );
    assert_eq!(encode_regions(&grid, Cell::new(0, 400, 0)).unwrap().lost, [Lost::OutsideHeights]);
    grid.metadata.data_version = Some(2230);
    assert!(refusal(&grid, Cell::ZERO).starts_with("the blocks are of the data version 2230, but chunks"));
}

#[test]
fn worlds_beyond_the_limits_ask_for_a_box() {
    let mut grid = Grid::new(Cell::new(100, 1, 1));
    let id = grid.intern(&state("stone")).unwrap();
    grid.fill(grid.bounds(), id);
    let folder = world(&encode_regions(&grid, Cell::ZERO).unwrap());
    let limits = Limits { max_cells: 50, ..Limits::default() };
    let error = read_world(folder.path(), None, &limits).unwrap_err().to_string();
    assert!(error.starts_with("the blocks reach from (0, 0, 0) to (99, 0, 0), or further"), "{error}");
    let part = Bounds::new(Cell::new(90, 0, 0), Cell::new(110, 1, 1));
    let back = grid_of(read_world(folder.path(), Some(part), &limits).unwrap());
    assert_eq!(back.cells().iter().filter(|&&id| id != Palette::AIR).count(), 10);
}

#[test]
fn chunks_since_1_13_are_read_in_both_packings_and_all_compressions() {
    for (chunk, data_version) in [(chunk_1_13([-32, 1]), 1631), (chunk_1_16([-32, 1]), 2586)] {
        for kind in KINDS {
            let decoded = read(&region(&[([0, 1], &chunk)], kind)).unwrap();
            assert_eq!(decoded.warnings, [Warning::BiomesByNumber]);
            let grid = grid_of(decoded);
            assert_eq!(grid.size(), Cell::splat(16));
            for (at, cell) in grid.bounds().cells().enumerate() {
                let note = grid.get(cell).get("note").map_or(0, |note| note.parse().unwrap());
                assert_eq!(note, old_index(at), "{data_version}, compression {kind}, {cell}");
            }
            let chest = tags([("id", Tag::String("minecraft:chest".into()))]);
            assert_eq!(grid.block_entities, [([3, 1, 15], chest)].into());
            let cow = Entity {
                place: [0.5, 4.5, 0.5],
                block: None,
                data: tags([("id", Tag::String("minecraft:cow".into()))]),
            };
            assert_eq!(grid.metadata.entities, [cow]);
            assert_eq!(grid.metadata.data_version, Some(data_version));
            assert_eq!(grid.metadata.offset, Cell::ZERO);
        }
    }
}

/// A chunk of Minecraft 1.12 with one section at height 16. `blocks` are ids with data by place there.
fn chunk_1_12(place: [i32; 2], blocks: &[([usize; 3], u16, u8)], block_entities: Vec<Tag>) -> Compound {
    let (mut low, mut data, mut add) = (vec![0_u8; 4096], vec![0_u8; 2048], vec![0_u8; 2048]);
    for &([x, y, z], id, value) in blocks {
        let at = (y * 16 + z) * 16 + x;
        let shift = at % 2 * 4;
        low[at] = id as u8;
        data[at / 2] |= value << shift;
        add[at / 2] |= ((id >> 8) as u8) << shift;
    }
    let bytes = |bytes: Vec<u8>| Tag::ByteArray(bytes.into_iter().map(u8::cast_signed).collect());
    let section = [("Y", Tag::Byte(1)), ("Blocks", bytes(low)), ("Data", bytes(data)), ("Add", bytes(add))];
    let cow = compound([
        ("id", Tag::String("minecraft:cow".into())),
        ("Pos", Tag::List([16 * place[0], 20, 16 * place[1]].map(|n| Tag::Double(n.into())).to_vec())),
    ]);
    let level = compound([
        ("xPos", Tag::Int(place[0])),
        ("zPos", Tag::Int(place[1])),
        ("Sections", Tag::List(vec![compound(section)])),
        ("TileEntities", Tag::List(block_entities)),
        ("Entities", Tag::List(vec![cow])),
    ]);
    tags([("DataVersion", Tag::Int(1343)), ("Level", level)])
}

fn old_block_entity<const N: usize>(id: &str, [x, y, z]: [i32; 3], more: [(&str, Tag); N]) -> Tag {
    let mut tags = tags([
        ("id", Tag::String(format!("minecraft:{id}"))),
        ("x", Tag::Int(x)),
        ("y", Tag::Int(16 + y)),
        ("z", Tag::Int(z)),
    ]);
    tags.extend(more.map(|(name, tag)| (name.to_owned(), tag)));
    Tag::Compound(tags)
}

#[test]
fn numbers_of_chunks_before_1_13_become_states() {
    let blocks = [
        ([0, 0, 0], 1, 0),
        // Beside a fence of the next chunk.
        ([15, 0, 0], 85, 0),
        ([2, 0, 0], 175, 4),
        ([2, 1, 0], 175, 8),
        ([4, 0, 0], 26, 0),
        ([6, 0, 0], 140, 0),
        ([8, 0, 0], 54, 2),
        ([10, 0, 0], 300, 5),
        ([12, 0, 0], 1, 15),
        ([3, 15, 15], 35, 14),
    ];
    let item = compound([("id", Tag::String("minecraft:stone".into()))]);
    let block_entities = vec![
        old_block_entity("bed", [4, 0, 0], [("color", Tag::Int(11))]),
        old_block_entity("flower_pot", [6, 0, 0], [("Item", Tag::String("minecraft:cactus".into()))]),
        old_block_entity("chest", [8, 0, 0], [("Items", Tag::List(vec![item]))]),
    ];
    let chunk = chunk_1_12([0, 0], &blocks, block_entities);
    let beside = chunk_1_12([1, 0], &[([0, 0, 0], 85, 0)], Vec::new());
    let decoded = read(&region(&[([0, 0], &chunk), ([1, 0], &beside)], 2)).unwrap();
    let expected = [
        Warning::UnknownData { blocks: 1, ids: "1:15".into() },
        Warning::UnknownIds { blocks: 1, ids: "300:5".into() },
        Warning::OldItems(1),
        Warning::OldEntities(2),
    ];
    assert_eq!(decoded.warnings, expected);
    let grid = grid_of(decoded);
    assert_eq!((grid.size(), grid.metadata.data_version), (Cell::new(17, 16, 16), Some(3700)));
    let states = [
        ([0, 0, 0], "stone"),
        ([15, 0, 0], "oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]"),
        ([16, 0, 0], "oak_fence[east=false,north=false,south=false,waterlogged=false,west=true]"),
        ([2, 0, 0], "rose_bush[half=lower]"),
        ([2, 1, 0], "rose_bush[half=upper]"),
        ([4, 0, 0], "blue_bed[facing=south,occupied=false,part=foot]"),
        ([6, 0, 0], "potted_cactus"),
        ([8, 0, 0], "chest[facing=north,type=single,waterlogged=false]"),
        ([10, 0, 0], "legacy:300[data=5]"),
        ([12, 0, 0], "stone"),
        ([3, 15, 15], "red_wool"),
        ([9, 9, 9], "air"),
    ];
    for (place, state) in states {
        assert_eq!(grid.get(Cell::from_array(place)).short(), state, "{place:?}");
    }
    let kept: Vec<[i32; 3]> = grid.block_entities.keys().copied().collect();
    assert_eq!(kept, [[4, 0, 0], [8, 0, 0]]);
    assert!(grid.block_entities.values().all(|data| !data.contains_key("x")));
}

#[test]
fn states_of_older_chunks_are_brought_to_the_highest_version() {
    let named = |place, data_version, name: &str| {
        let mut chunk = old_chunk(place, data_version, Vec::new());
        let Some(Tag::Compound(level)) = chunk.get_mut("Level") else { panic!("no level") };
        let palette = Tag::List(vec![compound([("Name", Tag::String(format!("minecraft:{name}")))])]);
        let section = compound([("Y", Tag::Byte(1)), ("Palette", palette)]);
        level.insert("Sections".to_owned(), Tag::List(vec![section]));
        chunk
    };
    let chunks = [
        named([0, 0], 1631, "sign"),
        named([1, 0], 2586, "grass_path"),
        chunk_1_12([2, 0], &[([15, 15, 15], 208, 0)], Vec::new()),
        named([3, 0], 3837, "stone_slab"),
        named([4, 0], 1631, "stone_slab"),
    ];
    let chunks: Vec<([usize; 2], &Compound)> =
        chunks.iter().enumerate().map(|(x, chunk)| ([x, 0], chunk)).collect();
    let decoded = read(&region(&chunks, 2)).unwrap();
    assert!(decoded.warnings.contains(&Warning::MixedVersions { first: 1631, last: 3837 }));
    let grid = grid_of(decoded);
    assert_eq!(grid.metadata.data_version, Some(3837));
    let names = [0, 16, 47, 48, 64].map(|x| grid.get(Cell::new(x, 15, 15)).short_name());
    assert_eq!(names, ["oak_sign", "dirt_path", "dirt_path", "stone_slab", "smooth_stone_slab"]);
}

#[test]
fn chunks_of_several_versions_or_in_the_wrong_place_are_told_of() {
    let (first, second, third) = (chunk_1_13([0, 0]), chunk_1_16([1, 0]), chunk_1_16([7, 7]));
    let decoded = read(&region(&[([0, 0], &first), ([1, 0], &second), ([2, 0], &third)], 2)).unwrap();
    assert_eq!(
        decoded.warnings,
        [
            Warning::BiomesByNumber,
            Warning::MixedVersions { first: 1631, last: 2586 },
            Warning::ChunksMisplaced(1)
        ]
    );
    assert_eq!(grid_of(decoded).size(), Cell::new(32, 16, 16));
}

/// What is put into the body of a good chunk, and the message it is refused with.
fn broken_chunks() -> Vec<(Compound, &'static str)> {
    let level = |name: &str, tag: Tag| {
        let mut root = chunk_1_16([0, 0]);
        let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
        level.insert(name.to_owned(), tag);
        root
    };
    let section = |name: &str, tag: Tag| {
        let mut root = chunk_1_16([0, 0]);
        let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
        let Some(Tag::List(sections)) = level.get_mut("Sections") else { panic!("no sections") };
        let Tag::Compound(section) = &mut sections[1] else { panic!("no section") };
        section.insert(name.to_owned(), tag);
        root
    };
    let numbered = compound([("Y", Tag::Byte(0)), ("Blocks", Tag::ByteArray(vec![0; 4096]))]);
    vec![
        (level("xPos", Tag::String("0".into())), "the tag `Level.xPos` is a String: expected an Int"),
        (section("Y", Tag::Int(200)), "the tag `Level.Sections[1].Y` is an Int (200): expected a Byte"),
        (
            section("Palette", Tag::List(vec![])),
            "`Level.Sections[1].BlockStates` holds 342 longs, into which 4096",
        ),
        (
            section("BlockStates", Tag::LongArray(vec![0; 341])),
            "`Level.Sections[1].BlockStates` holds 341 longs, into which 4096 indices of 18 entries are never packed",
        ),
        (
            section("BlockStates", Tag::LongArray(vec![-1; 342])),
            "`Level.Sections[1].BlockStates`, number 0: index 31 is not in the palette of 18 entries",
        ),
        (
            section("Palette", Tag::List(vec![compound([("Name", Tag::String("Stone".into()))])])),
            "the entry `Stone` of `Level.Sections[1].Palette[0].Name` is no block state: ",
        ),
        (level("Sections", Tag::List(vec![numbered])), "the tag `Level.Sections[0].Data` is missing"),
    ]
}

#[test]
fn broken_chunks_are_refused_with_their_field() {
    for (chunk, message) in broken_chunks() {
        let error = read(&region(&[([0, 0], &chunk)], 3)).unwrap_err().to_string();
        let expected = format!("the chunk (0, 0) of the region: {message}");
        assert!(error.starts_with(&expected), "expected: {expected}\n   found: {error}");
    }
}

#[test]
fn broken_tables_are_refused() {
    let good = region(&[([5, 3], &chunk_1_16([5, 3]))], 2);
    let table = 4 * (3 * 32 + 5);
    let with = |at: usize, bytes: &[u8]| {
        let mut broken = good.clone();
        broken[at..at + bytes.len()].copy_from_slice(bytes);
        broken
    };
    let cases = [
        (with(8192, &[0, 0, 0, 0]), "its length is 0, but"),
        (with(8192, &[255, 255, 255, 255]), "its length is 4294967295, but"),
        (with(8196, &[9]), "its compression is 9: expected 1 (gzip), 2 (zlib), 3 (none) or 4 (LZ4)"),
        (with(8196, &[130]), "it is kept in a file of its own"),
        (with(8197, &[7, 7]), "its packed data are damaged: "),
        (with(8196, &[4]), "its packed data are damaged: a block of LZ4 does not begin with `LZ4Block`"),
        (with(8196, &[3]), "broken NBT at byte 0: expected a compound (tag type 10) at the root"),
        (good[..8200].to_vec(), "its length is"),
    ];
    for (bytes, message) in cases {
        let error = read(&bytes).unwrap_err().to_string();
        let expected = format!("the chunk (5, 3) of the region: {message}");
        assert!(error.starts_with(&expected), "expected: {expected}\n   found: {error}");
    }
    // Such tables do not even look like one, unless the name of the file says so.
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("r.0.0.mca");
    for (bytes, message) in [
        (
            with(table, &[0, 0, 1, 1]),
            "r.0.0.mca: the chunk (5, 3) of the region: the table says sector 1, but",
        ),
        (
            with(table, &[255, 0, 0, 1]),
            "r.0.0.mca: the chunk (5, 3) of the region: the table says sector 16711680,",
        ),
        (vec![1, 2, 3], "r.0.0.mca: the region is 3 bytes long: its table alone takes 8,192"),
        (Vec::new(), "there is no block but air"),
    ] {
        std::fs::write(&path, bytes).unwrap();
        let error = read_world(&path, None, &Limits::default()).unwrap_err().to_string();
        assert!(error.starts_with(message), "expected: {message}\n   found: {error}");
    }
}

#[test]
fn chunks_that_share_their_sectors_are_read_once() {
    let mut bytes = region(&[([0, 0], &chunk_1_16([0, 0]))], 2);
    bytes.copy_within(0..4, 4);
    let decoded = read(&bytes).unwrap();
    assert_eq!(decoded.warnings, [Warning::BiomesByNumber, Warning::ChunksMisplaced(1)]);
    assert_eq!(grid_of(decoded).size(), Cell::splat(16));
}

#[test]
fn bombs_stop_at_the_limit_of_the_region() {
    let mut chunk = chunk_1_16([0, 0]);
    chunk.insert("zeros", Tag::ByteArray(vec![0; 1 << 20]));
    let limits = Limits { max_bytes: 3 << 20, ..Limits::default() };
    for kind in [1, 2, 4] {
        let mut bytes = region(&[([0, 0], &chunk)], kind);
        assert!(bytes.len() < 1 << 16, "{} bytes", bytes.len());
        for slot in 1..32 {
            bytes.copy_within(0..4, 4 * slot);
        }
        let error = vox::io::decode(&bytes, &limits).unwrap_err().to_string();
        assert_eq!(
            error,
            "the chunk (2, 0) of the region: the chunks of the region unpack to more than 3145728 bytes, the limit"
        );
    }
}

#[test]
fn chunks_beyond_the_edge_of_all_worlds_count_as_not_made() {
    let mut root = chunk_1_16([0, 0]);
    let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
    level.insert("xPos", Tag::Int(i32::MIN));
    let error = read(&region(&[([0, 0], &root)], 2)).unwrap_err().to_string();
    assert_eq!(error, "there is no block but air");
}

#[test]
fn half_made_chunks_count_as_not_made() {
    let mut root = chunk_1_16([0, 0]);
    let Some(Tag::Compound(level)) = root.get_mut("Level") else { panic!("no level") };
    level.insert("Status", Tag::String("structure_starts".into()));
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("r.0.0.mca");
    std::fs::write(&path, region(&[([0, 0], &root)], 2)).unwrap();
    let decoded = read_part(&path, Cell::ZERO, Cell::splat(16)).unwrap();
    assert_eq!(decoded.warnings, [Warning::ChunksNotMade(1)]);
}

#[test]
fn a_folder_without_regions_and_a_box_without_cells_are_refused() {
    let folder = TempDir::new().unwrap();
    let error = read_world(folder.path(), None, &Limits::default()).unwrap_err().to_string();
    assert_eq!(
        error,
        "the folder holds no region: expected files `r.<x>.<z>.mca`, or a folder `region` with such"
    );
    std::fs::write(folder.path().join("r.0.0.mca"), []).unwrap();
    for part in [
        Bounds::new(Cell::ZERO, Cell::new(0, 1, 1)),
        Bounds::new(Cell::MIN, Cell::MAX),
        Bounds::new(Cell::splat(i32::MAX - 1), Cell::MAX),
    ] {
        let error = read_world(folder.path(), Some(part), &Limits::default()).unwrap_err().to_string();
        assert!(error.starts_with("no part of a world reaches from ("), "{error}");
    }
}

#[test]
fn real_builds_pass_through_a_world() {
    let Some(folder) = super::real::folder() else { return };
    let pattern = folder.join("houses/*/*.schem");
    let mut count = 0;
    for path in glob::glob(&pattern.to_string_lossy()).unwrap().map(Result::unwrap) {
        let mut grid = read_grid(&std::fs::read(&path).unwrap());
        grid.map_states(complete).unwrap();
        grid.metadata.data_version = Some(3465);
        let at = Cell::new(-9, -70, 1000);
        let folder = world(&encode_regions(&grid, at).unwrap());
        let back = grid_of(read_part(folder.path(), at, grid.size()).unwrap());
        assert!(back.same_blocks(&grid), "{}", path.display());
        assert_eq!(back.block_entities, grid.block_entities, "{}", path.display());
        count += 1;
    }
    assert!(count > 0, "no schematics in {}", folder.display());
}
