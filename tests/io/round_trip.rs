use super::{read, read_grid, tags};
use ndarray::{Array2, Array3};
use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use vox::block::{self, BlockState, Palette, complete_in};
use vox::grid::{BiomeMap, Biomes, Dialect, Entity, Grid, Metadata, Own};
use vox::io::{DEFAULT_DATA_VERSION, Limits, Lost, SchemVersion, WriteError, decode, encode_schem};
use vox::nbt::Tag;
use vox::space::Cell;

const VERSIONS: [SchemVersion; 2] = [SchemVersion::V2, SchemVersion::V3];

fn schem(grid: &Grid, version: SchemVersion) -> Vec<u8> {
    encode_schem(grid, version).unwrap().bytes
}

pub fn states(count: usize) -> Palette {
    let mut palette = Palette::default();
    for n in 1..count {
        let state = BlockState::new("note_block").unwrap().with("note", &n.to_string());
        palette.intern(&block::complete(&state)).unwrap();
    }
    palette
}

/// A grid in which each of `count` states is in use.
pub fn varied(size: Cell, count: usize) -> Grid {
    let [x, y, z] = size.to_array().map(|n| n as usize);
    let cells = Array3::from_shape_fn((y, z, x), |(j, k, i)| ((i + x * (k + z * j)) * 7919 % count) as u16);
    Grid::from_cells(cells, states(count)).unwrap()
}

fn metadata() -> impl Strategy<Value = Metadata> {
    let numbers = -2000..2000i32;
    let entities = vec(([-99.0..99.0, -99.0..99.0, -99.0..99.0f64], "[a-z]{1,9}"), 0..3);
    (1..5000i32, [numbers.clone(), numbers.clone(), numbers], ".{0,20}", entities).prop_map(
        |(data_version, offset, author, entities)| Metadata {
            data_version: Some(data_version),
            offset: Cell::from_array(offset),
            tags: tags([("Author", Tag::String(author))]),
            entities: entities
                .into_iter()
                .map(|(place, id)| Entity { place, block: None, data: tags([("id", Tag::String(id))]) })
                .collect(),
            ..Metadata::default()
        },
    )
}

pub fn grid() -> impl Strategy<Value = Grid> {
    let size = (1..9usize, 1..9usize, 1..9usize);
    let cells = size.prop_flat_map(|(x, y, z)| {
        (1..300usize).prop_flat_map(move |count| {
            (vec(0..count as u16, x * y * z), Just(count)).prop_map(move |(cells, count)| {
                let cells = Array3::from_shape_vec((y, z, x), cells).unwrap();
                Grid::from_cells(cells, states(count)).unwrap()
            })
        })
    });
    let data = (any::<i64>(), "[a-z]{1,9}");
    let block_entities = btree_map([0..8i32, 0..8i32, 0..8i32], data, 0..6);
    (cells, block_entities, metadata()).prop_map(|(mut grid, block_entities, metadata)| {
        for (place, (seed, id)) in block_entities {
            if grid.bounds().contains(Cell::from_array(place)) {
                let data = tags([("id", Tag::String(id)), ("LootTableSeed", Tag::Long(seed))]);
                grid.block_entities.insert(place, data);
            }
        }
        grid.metadata = metadata;
        grid
    })
}

/// The grid as it is written: with all properties that its version has.
pub fn complete(mut grid: Grid) -> Grid {
    let version = grid.version();
    grid.map_states(|state| complete_in(state, version)).unwrap();
    grid
}

/// Sums of coordinates round, so places are compared up to that.
pub fn near(a: &[Entity], b: &[Entity]) -> bool {
    let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| a.data == b.data && a.block == b.block && close(a.place, b.place))
}

proptest! {
    #[test]
    fn what_is_written_is_read(grid in grid()) {
        for version in VERSIONS {
            let decoded = read(&schem(&grid, version)).unwrap();
            prop_assert_eq!(&decoded.warnings, &[]);
            let back = read_grid(&schem(&grid, version));
            prop_assert!(back.same_blocks(&grid));
            prop_assert_eq!(&back.block_entities, &grid.block_entities);
            prop_assert!(near(&back.metadata.entities, &grid.metadata.entities));
            let rest = |metadata: &Metadata| Metadata { entities: Vec::new(), ..metadata.clone() };
            prop_assert_eq!(rest(&back.metadata), rest(&grid.metadata));
        }
    }

    #[test]
    fn writing_again_gives_the_same_bytes(grid in grid()) {
        for version in VERSIONS {
            let bytes = schem(&grid, version);
            let mut back = read_grid(&bytes);
            back.metadata.entities = grid.metadata.entities.clone();
            prop_assert_eq!(schem(&back, version), bytes);
        }
    }

    #[test]
    fn damaged_files_are_read_or_refused(grid in grid(), at: prop::sample::Index, byte: u8) {
        let packed = schem(&grid, SchemVersion::V2);
        let mut plain = Vec::new();
        std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(&packed[..]), &mut plain).unwrap();
        let at = at.index(plain.len());
        plain[at] = byte;
        let _ = read(&plain);
    }
}

#[test]
fn palettes_of_every_varint_length() {
    for count in [1, 2, 127, 128, 129, 255, 256, 16_383, 16_384, 16_385, 65_536] {
        let grid = varied(Cell::new(64, 17, 64), count);
        for version in VERSIONS {
            let back = read_grid(&schem(&grid, version));
            assert!(back.same_blocks(&grid), "{count} states");
            // Air stands in every palette, used or not.
            assert_eq!(back.palette().states().len(), count, "{count} states");
        }
    }
}

#[test]
fn order_and_waste_of_the_palette_do_not_show() {
    let stone = BlockState::new("stone").unwrap();
    let mut plain = Grid::new(Cell::ONE);
    let id = plain.intern(&stone).unwrap();
    plain.set(Cell::ZERO, id);
    let mut wasteful = Grid::new(Cell::ONE);
    wasteful.intern(&BlockState::new("dirt").unwrap()).unwrap();
    let id = wasteful.intern(&stone).unwrap();
    wasteful.set(Cell::ZERO, id);
    for version in VERSIONS {
        assert_eq!(schem(&plain, version), schem(&wasteful, version));
    }
}

#[test]
fn cells_in_any_memory_order_are_written_alike() {
    let grid = varied(Cell::new(3, 4, 5), 7);
    let mut turned = grid.cells().clone().reversed_axes();
    turned = turned.as_standard_layout().into_owned().reversed_axes();
    assert!(turned.as_slice().is_none());
    let turned = Grid::from_cells(turned, grid.palette().clone()).unwrap();
    assert_eq!(schem(&turned, SchemVersion::V2), schem(&grid, SchemVersion::V2));
}

#[test]
fn a_grid_without_a_data_version_gets_the_default() {
    let back = read_grid(&schem(&Grid::new(Cell::ONE), SchemVersion::V2));
    assert_eq!(back.metadata.data_version, Some(DEFAULT_DATA_VERSION));
}

#[test]
fn biomes_convert_between_columns_and_cells() {
    let mut grid = Grid::new(Cell::new(2, 3, 2));
    let names: Vec<String> = ["plains", "minecraft:desert"].map(str::to_owned).into();
    let columns = Array2::from_shape_fn((2, 2), |(z, x)| (x + z) as u16 % 2);
    let pillars = Array3::from_shape_fn((3, 2, 2), |(_, z, x)| columns[(z, x)]);
    let layers = Array3::from_shape_fn((3, 2, 2), |(y, ..)| y as u16 % 2);
    let biomes = |map| Some(Biomes { names: names.clone(), map });
    let (columns, pillars, layers) = (
        biomes(BiomeMap::Columns(columns)),
        biomes(BiomeMap::Cells(pillars)),
        biomes(BiomeMap::Cells(layers)),
    );
    let cases = [
        (&columns, SchemVersion::V2, &columns, vec![]),
        (&columns, SchemVersion::V3, &pillars, vec![]),
        (&pillars, SchemVersion::V2, &columns, vec![]),
        (&layers, SchemVersion::V3, &layers, vec![]),
    ];
    for (from, version, to, lost) in cases {
        grid.metadata.biomes = from.clone();
        let encoded = encode_schem(&grid, version).unwrap();
        assert_eq!(read_grid(&encoded.bytes).metadata.biomes, *to);
        assert_eq!(encoded.lost, lost);
    }
    grid.metadata.biomes = layers;
    assert_eq!(encode_schem(&grid, SchemVersion::V2).unwrap().lost, [Lost::Biomes]);
}

#[test]
fn unknown_tags_survive() {
    let number = |n| Tag::Int(n);
    let blocks = Tag::Compound(tags([("Lights", number(2))]));
    let own = |tags| Some(Own { dialect: Dialect::Sponge, tags });
    let everything = tags([("Palisade", Tag::ByteArray(vec![1])), ("Blocks", blocks.clone())]);
    let mut grid = Grid::new(Cell::ONE);
    grid.metadata.own = own(everything.clone());
    let cases = [
        (SchemVersion::V3, own(everything), vec![]),
        (
            SchemVersion::V2,
            own(tags([("Palisade", Tag::ByteArray(vec![1]))])),
            vec![Lost::Own(vec!["Lights".into()])],
        ),
    ];
    for (version, kept, lost) in cases {
        let encoded = encode_schem(&grid, version).unwrap();
        assert_eq!(read_grid(&encoded.bytes).metadata.own, kept);
        assert_eq!(encoded.lost, lost);
    }
}

#[test]
fn tags_of_one_s_own_never_stand_for_those_of_the_format() {
    let mut grid = Grid::new(Cell::ONE);
    let plain = schem(&grid, SchemVersion::V2);
    let misleading = tags([("Width", Tag::Short(7)), ("Biomes", Tag::Int(1)), ("Blocks", Tag::Int(1))]);
    grid.metadata.own = Some(Own { dialect: Dialect::Sponge, tags: misleading });
    assert_eq!(schem(&grid, SchemVersion::V2), plain);
}

#[test]
fn states_that_are_one_once_complete_share_an_index() {
    let mut grid = Grid::new(Cell::new(2, 1, 1));
    let bare = BlockState::new("oak_log").unwrap();
    for (x, state) in [(0, bare.clone()), (1, bare.with("axis", "y"))] {
        let id = grid.intern(&state).unwrap();
        grid.set(Cell::new(x, 0, 0), id);
    }
    let back = read_grid(&schem(&grid, SchemVersion::V2));
    assert_eq!(back.cells().iter().copied().collect::<Vec<u16>>(), [1, 1]);
    assert_eq!(back.palette().states()[1].short(), "oak_log[axis=y]");
}

#[test]
fn block_entities_without_id_are_lost_with_a_word() {
    let mut grid = Grid::new(Cell::ONE);
    grid.block_entities.insert([0, 0, 0], tags([("Lock", Tag::String("key".into()))]));
    let encoded = encode_schem(&grid, SchemVersion::V2).unwrap();
    assert!(read_grid(&encoded.bytes).block_entities.is_empty());
    assert_eq!(encoded.lost, [Lost::UnnamedBlockEntities(1)]);
    assert_eq!(encoded.lost[0].to_string(), "1 block entity without an `id`");
}

#[test]
fn sizes_that_have_no_schematic() {
    for size in [Cell::new(65_536, 1, 1), Cell::new(1, 0, 1)] {
        let error = encode_schem(&Grid::new(size), SchemVersion::V2).unwrap_err();
        assert!(matches!(error, WriteError::Size(_)), "{error}");
    }
    let long = Grid::new(Cell::new(65_535, 1, 1));
    assert!(read_grid(&schem(&long, SchemVersion::V3)).same_blocks(&long));
}

#[test]
fn every_truncated_file_is_refused() {
    let bytes = schem(&varied(Cell::new(4, 4, 4), 9), SchemVersion::V2);
    for len in 0..bytes.len() {
        assert!(read(&bytes[..len]).is_err(), "{len} of {} bytes", bytes.len());
    }
}

#[test]
fn limits_hold() {
    let bytes = schem(&Grid::new(Cell::splat(100)), SchemVersion::V2);
    let cases = [
        (Limits { max_cells: 999_999, ..Limits::default() }, "more than 999999, the limit"),
        (Limits { max_bytes: 999_999, ..Limits::default() }, "unpacks to more than 999999 bytes, the limit"),
    ];
    for (limits, message) in cases {
        let error = decode(&bytes, &limits).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
    assert!(decode(&bytes, &Limits { max_cells: 1_000_000, ..Limits::default() }).is_ok());
}
