//! Good files to start from: small ones, of every kind that the writers make, and some by hand.

use super::bytes;
use super::examples::{axiom, blueprint, magica, mcedit, mcstructure, region, tags};
use ndarray::{Array2, Array3};
use vox::block::{BlockState, Palette, color};
use vox::grid::{BiomeMap, Biomes, Dialect, Entity, Grid, Own, Region};
use vox::io::{
    LitematicVersion, SchemVersion, encode_litematic, encode_regions, encode_schem, encode_structure,
    encode_vox,
};
use vox::nbt::{self, Tag};
use vox::space::{Bounds, Cell};

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
    metadata.entities =
        vec![Entity { place: [0.5, 1.0, 2.5], block: None, data: tags([("id", text("minecraft:pig"))]) }];
    grid
}

fn with_biomes(map: BiomeMap) -> Grid {
    let mut grid = full();
    let names = ["minecraft:plains", "minecraft:desert"].map(str::to_owned).into();
    grid.metadata.biomes = Some(Biomes { names, map });
    grid
}

/// So many that their numbers take a second byte.
const MANY: usize = 200;

/// So many that their tags keep to the limits.
const SOME: usize = 40;

/// Grids that between them have everything that files can hold; one is of `count` states.
fn grids(count: usize) -> Vec<Grid> {
    let columns = Array2::from_shape_fn((5, 3), |(z, x)| ((x + z) % 2) as u16);
    let cells = Array3::from_shape_fn((4, 5, 3), |(y, ..)| (y % 2) as u16);
    vec![
        Grid::new(Cell::ONE),
        plain(Cell::new(7, 5, 6), count),
        with_biomes(BiomeMap::Columns(columns)),
        with_biomes(BiomeMap::Cells(cells)),
    ]
}

pub fn schem() -> Vec<Vec<u8>> {
    let written =
        |version| grids(MANY).into_iter().map(move |grid| encode_schem(&grid, version).unwrap().bytes);
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

pub fn litematic() -> Vec<Vec<u8>> {
    let mut regions = full();
    let bounds = [Bounds::of_size(Cell::new(3, 2, 5)), Bounds::new(Cell::new(1, 1, 0), Cell::new(3, 4, 2))];
    let named = bounds.into_iter().zip(["low", "high"]);
    regions.metadata.regions = named.map(|(bounds, name)| part(name, bounds)).collect();
    let grids = grids(SOME).into_iter().chain([regions]);
    let versions = [LitematicVersion::V6, LitematicVersion::V7];
    grids.flat_map(|grid| versions.map(|version| encode_litematic(&grid, version).unwrap().bytes)).collect()
}

fn part(name: &str, bounds: Bounds) -> Region {
    Region { name: name.to_owned(), bounds, tags: tags([("Own", Tag::Byte(1))]) }
}

pub fn structure() -> Vec<Vec<u8>> {
    let mut of_two_looks = full();
    let mut look = plain(of_two_looks.size(), 4);
    look.block_entities = of_two_looks.block_entities.clone();
    of_two_looks.variants = vec![look];
    let grids = grids(SOME).into_iter().chain([of_two_looks]);
    let written = grids.map(|grid| encode_structure(&grid).unwrap().bytes);
    written.chain([structure_with_jigsaw()]).collect()
}

fn structure_with_jigsaw() -> Vec<u8> {
    let ints = |numbers: [i32; 3]| Tag::List(numbers.map(Tag::Int).to_vec());
    let nbt = tags([("id", text("minecraft:jigsaw")), ("final_state", text("minecraft:stone"))]);
    let block = tags([("pos", ints([1, 0, 0])), ("state", Tag::Int(0)), ("nbt", Tag::Compound(nbt))]);
    let jigsaw = tags([("Name", text("minecraft:jigsaw"))]);
    let root = tags([
        ("size", ints([2, 1, 1])),
        ("palette", Tag::List(vec![Tag::Compound(jigsaw)])),
        ("blocks", Tag::List(vec![Tag::Compound(block)])),
    ]);
    nbt::write("", &root).unwrap()
}

pub fn mcedit() -> Vec<Vec<u8>> {
    vec![mcedit::example(), bytes::packed(&mcedit::example())]
}

pub fn blueprint() -> Vec<Vec<u8>> {
    vec![blueprint::example()]
}

pub fn mcstructure() -> Vec<Vec<u8>> {
    vec![mcstructure::example()]
}

pub fn axiom() -> Vec<Vec<u8>> {
    vec![axiom::example()]
}

pub fn vox() -> Vec<Vec<u8>> {
    let mut long = Grid::new(Cell::new(300, 1, 2));
    let stone = long.intern(&BlockState::new("stone").unwrap()).unwrap();
    long.fill(Bounds::of_size(Cell::new(299, 1, 1)), stone);
    let grids = [plain(Cell::new(7, 5, 6), 20), long];
    let written = grids.map(|grid| encode_vox(&grid, color).unwrap().bytes);
    written.into_iter().chain([magica::scene()]).collect()
}

/// Regions of today's chunks, and of older ones in each compression.
pub fn region() -> Vec<Vec<u8>> {
    let [packed, across] = [region::chunk_1_16([5, 1]), region::chunk_1_13([4, 1])];
    let slots = [([5, 1], &packed), ([4, 1], &across)];
    let old = region::KINDS.map(|kind| region::region(&slots, kind));
    regions("region/").chain(old).collect()
}

/// What stands beside regions of blocks.
pub fn entities() -> Vec<Vec<u8>> {
    regions("entities/").collect()
}

fn regions(folder: &'static str) -> impl Iterator<Item = Vec<u8>> {
    let files = grids(SOME)
        .into_iter()
        .skip(1)
        .flat_map(|grid| encode_regions(&grid, Cell::new(1, 2, 3)).unwrap().files);
    files.filter(move |(name, _)| name.starts_with(folder)).map(|(_, bytes)| bytes)
}

/// Chunks that are too long for their region, without their packing.
pub fn chunks() -> Vec<Vec<u8>> {
    [region::chunk_1_13([0, 0]), region::chunk_1_16([0, 0])]
        .map(|chunk| nbt::write("", &chunk).unwrap())
        .into()
}

pub fn anything() -> Vec<Vec<u8>> {
    let all = [
        schem(),
        obj(),
        litematic(),
        structure(),
        mcedit(),
        blueprint(),
        mcstructure(),
        axiom(),
        vox(),
        region(),
    ];
    all.concat()
}
