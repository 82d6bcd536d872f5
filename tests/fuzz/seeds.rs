//! Good files to start from: small ones, of every kind that the writers make, and some by hand.

use super::bytes;
use ndarray::{Array2, Array3};
use vox::block::{BlockState, Palette};
use vox::grid::{BiomeMap, Biomes, Dialect, Entity, Grid, Own};
use vox::io::{SchemVersion, encode_schem};
use vox::nbt::{self, Compound, Tag};
use vox::space::Cell;

fn tags<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
    tags.map(|(name, tag)| (name.to_owned(), tag)).into()
}

fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

/// A grid of `count` states in turn.
fn plain(size: Cell, count: usize) -> Grid {
    let mut palette = Palette::default();
    for n in 1..count {
        let state = BlockState::new("note_block").unwrap().with("note", &n.to_string());
        palette.intern(&state).unwrap();
    }
    let [x, y, z] = size.to_array().map(|n| n as usize);
    let cells = Array3::from_shape_fn((y, z, x), |(j, k, i)| ((i + x * (k + z * j)) % count) as u16);
    Grid::from_cells(cells, palette).unwrap()
}

/// A grid with all that a grid can have.
fn full() -> Grid {
    let mut grid = plain(Cell::new(3, 4, 5), 6);
    let item = tags([("Slot", Tag::Byte(1)), ("id", text("minecraft:stone")), ("Count", Tag::Byte(64))]);
    let chest = [("id", text("minecraft:chest")), ("Items", Tag::List(vec![Tag::Compound(item)]))];
    grid.block_entities.insert([1, 2, 3], tags(chest));
    let metadata = &mut grid.metadata;
    metadata.data_version = Some(3465);
    metadata.offset = Cell::new(-1, 2, -3);
    metadata.tags = tags([("Name", text("house")), ("Date", Tag::Long(1_700_000_000_000))]);
    metadata.own = Some(Own { dialect: Dialect::Sponge, tags: tags([("More", Tag::IntArray(vec![1, 2]))]) });
    metadata.entities = vec![Entity { place: [0.5, 1.0, 2.5], data: tags([("id", text("minecraft:pig"))]) }];
    grid
}

fn with_biomes(map: BiomeMap) -> Grid {
    let mut grid = full();
    let names = ["minecraft:plains", "minecraft:desert"].map(str::to_owned).into();
    grid.metadata.biomes = Some(Biomes { names, map });
    grid
}

/// Grids that between them have everything that files can hold.
pub fn grids() -> Vec<Grid> {
    let columns = Array2::from_shape_fn((5, 3), |(z, x)| ((x + z) % 2) as u16);
    let cells = Array3::from_shape_fn((4, 5, 3), |(y, ..)| (y % 2) as u16);
    vec![
        Grid::new(Cell::ONE),
        plain(Cell::new(7, 5, 6), 200),
        with_biomes(BiomeMap::Columns(columns)),
        with_biomes(BiomeMap::Cells(cells)),
    ]
}

pub fn schem() -> Vec<Vec<u8>> {
    let written = |version| grids().into_iter().map(move |grid| encode_schem(&grid, version).unwrap().bytes);
    let versions = [SchemVersion::V2, SchemVersion::V3].into_iter();
    versions.flat_map(written).chain(schem_by_hand()).collect()
}

/// Layouts that are read and not written.
fn schem_by_hand() -> Vec<Vec<u8>> {
    let palette =
        Tag::Compound(tags([("air", Tag::Int(0)), ("minecraft:chest[facing=east]", Tag::Int(300))]));
    let data = Tag::ByteArray(vec![0, -84, 2, 0, 0]);
    let chest =
        tags([("Id", text("minecraft:chest")), ("Pos", Tag::IntArray(vec![11, 0, 0])), ("Lock", text("a"))]);
    let chests = Tag::List(vec![Tag::Compound(chest)]);
    let offset = Tag::IntArray(vec![10, 0, 0]);
    let size =
        [("Width", Tag::Short(2)), ("Height", Tag::Short(1)), ("Length", Tag::Int(2)), ("Offset", offset)];
    let mut version_1 = tags(size.clone());
    version_1.extend(tags([
        ("Palette", palette.clone()),
        ("BlockData", data.clone()),
        ("TileEntities", chests.clone()),
    ]));
    let mut unnested = tags(size);
    let blocks = tags([("Palette", palette), ("Data", data), ("BlockEntities", chests)]);
    unnested.insert("Blocks".to_owned(), Tag::Compound(blocks));
    let [version_1, unnested] = [version_1, unnested].map(|root| nbt::write("Schematic", &root).unwrap());
    vec![bytes::packed(&bytes::packed(&version_1)), version_1, unnested]
}

pub fn obj() -> Vec<Vec<u8>> {
    let cube = "v 0 0 0\nv 2 0 0\nv 2 0 3\nv 0 0 3\nv 0 4 0\nv 2 4 0\nv 2 4 3\nv 0 4 3\n";
    let faces = "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf -1 -2 -6 -5\n";
    vec![format!("o wall\n{cube}{faces}").into_bytes()]
}
