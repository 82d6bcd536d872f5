//! What hangs on walls stays there: paintings of all sizes, item frames, leash knots and animals through every format.

use super::examples::mcedit::{file, row};
use super::round_trip::near;
use super::structure::nbt_root;
use super::{read_grid, tags};
use proptest::collection::vec;
use proptest::prelude::*;
use tempfile::TempDir;
use vox::block::{BlockState, Facing, Mirror};
use vox::grid::{Entity, Grid, Region};
use vox::io::{
    Content, EncodedRegions, Limits, LitematicVersion, Lost, SchemVersion, Warning, encode_litematic,
    encode_regions, encode_schem, encode_structure, read_world,
};
use vox::nbt::{Compound, Tag};
use vox::space::{Bounds, Cell, Turn};

const WALLS: [Facing; 4] = [Facing::South, Facing::West, Facing::North, Facing::East];
const SIDES: [Facing; 6] =
    [Facing::Down, Facing::Up, Facing::North, Facing::South, Facing::West, Facing::East];

fn entity(place: [f64; 3], block: Option<Cell>, id: &str, more: Option<(&str, usize)>) -> Entity {
    let mut data = tags([("id", Tag::String(format!("minecraft:{id}")))]);
    data.extend(more.map(|(name, number)| (name.to_owned(), Tag::Byte(number as i8))));
    Entity { place, block, data }
}

/// Where the game puts the middle of a painting whose block is `home`.
fn painting(home: Cell, wall: usize, [width, height]: [i32; 2]) -> Entity {
    let half = |length: i32| if length % 2 == 0 { 0.5 } else { 0.0 };
    let step = |facing: Facing| facing.step().as_dvec3();
    let place = home.as_dvec3() + 0.5 - 0.46875 * step(WALLS[wall])
        + half(width) * step(WALLS[wall].left())
        + half(height) * step(Facing::Up);
    entity(place.to_array(), Some(home), "painting", Some(("facing", wall)))
}

fn frame(home: Cell, side: usize) -> Entity {
    let place = home.as_dvec3() + 0.5 - 0.46875 * SIDES[side].step().as_dvec3();
    entity(place.to_array(), Some(home), "item_frame", Some(("Facing", side)))
}

fn knot(home: Cell) -> Entity {
    let place = home.as_dvec3() + glam::DVec3::new(0.5, 0.375, 0.5);
    entity(place.to_array(), Some(home), "leash_knot", None)
}

const SIZE: Cell = Cell::new(6, 5, 7);

fn any_entity() -> impl Strategy<Value = Entity> {
    let home = || (-3..9, -3..8, -3..10).prop_map(|(x, y, z)| Cell::new(x, y, z));
    let sizes = prop::sample::select(vec![[1, 1], [2, 1], [1, 2], [2, 2], [4, 3]]);
    prop_oneof![
        (home(), 0..4usize, sizes).prop_map(|(home, wall, size)| painting(home, wall, size)),
        (home(), 0..6usize).prop_map(|(home, side)| frame(home, side)),
        home().prop_map(knot),
        [-3.0..9.0, -3.0..8.0, -3.0..10.0f64].prop_map(|place| entity(place, None, "cow", None)),
    ]
}

/// A block of stone with entities in and around it, of versions with either form of the block.
fn any_grid() -> impl Strategy<Value = Grid> {
    let offset = (-900..900, -60..60, -900..900).prop_map(|(x, y, z)| Cell::new(x, y, z));
    (vec(any_entity(), 0..6), offset, prop::sample::select(vec![3465, 4325])).prop_map(
        |(entities, offset, data_version)| {
            let mut grid = Grid::new(SIZE);
            let stone = grid.intern(&BlockState::new("stone").unwrap()).unwrap();
            grid.fill(grid.bounds(), stone);
            grid.metadata.entities = entities;
            grid.metadata.offset = offset;
            grid.metadata.data_version = Some(data_version);
            grid
        },
    )
}

fn world(EncodedRegions { files, .. }: &EncodedRegions) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, bytes) in files {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    folder
}

fn part_of(folder: &TempDir, part: Option<Bounds>) -> Grid {
    match read_world(folder.path(), part, &Limits::default()).unwrap().content {
        Content::Grid(grid) => grid,
        Content::Boxes(_) => panic!("expected a grid"),
    }
}

/// Near the border of four chunks, so that things hang across it.
const AT: Cell = Cell::new(-3, 70, 12);

/// The grid through every format that holds entities.
fn all_ways(grid: &Grid) -> Vec<(&'static str, Grid)> {
    let regions = encode_regions(grid, AT).unwrap();
    vec![
        ("schem 2", read_grid(&encode_schem(grid, SchemVersion::V2).unwrap().bytes)),
        ("schem 3", read_grid(&encode_schem(grid, SchemVersion::V3).unwrap().bytes)),
        ("litematic", read_grid(&encode_litematic(grid, LitematicVersion::V6).unwrap().bytes)),
        ("structure", read_grid(&encode_structure(grid).unwrap().bytes)),
        ("world", part_of(&world(&regions), None)),
    ]
}

fn sorted(grid: &Grid) -> Vec<Entity> {
    let mut entities = grid.metadata.entities.clone();
    entities.sort_by_key(|entity| format!("{:.6?} {:?} {:?}", entity.place, entity.block, entity.data));
    entities
}

fn any_turn() -> impl Strategy<Value = Turn> {
    prop::sample::select(Turn::ALL.to_vec())
}

fn any_box() -> impl Strategy<Value = Bounds> {
    let cell = || (0..SIZE.x, 0..SIZE.y, 0..SIZE.z).prop_map(|(x, y, z)| Cell::new(x, y, z));
    (cell(), cell()).prop_map(|(a, b)| Bounds::new(a.min(b), a.max(b) + 1))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_format_keeps_what_hangs(grid in any_grid()) {
        for (way, back) in all_ways(&grid) {
            prop_assert!(near(&sorted(&back), &sorted(&grid)), "{way}: {:?}", back.metadata.entities);
        }
    }

    #[test]
    fn turning_before_writing_is_turning_after_reading(grid in any_grid(), turn in any_turn()) {
        let moved = grid.turned(turn).mirrored(Mirror::X);
        for (way, back) in all_ways(&grid) {
            let back = back.turned(turn).mirrored(Mirror::X);
            prop_assert!(near(&sorted(&back), &sorted(&moved)), "{way}: {:?}", back.metadata.entities);
        }
    }

    /// Copies of a build keep the numbers of where it stood.
    #[test]
    fn blocks_of_far_away_are_found_again(grid in any_grid()) {
        let mut far = grid.clone();
        let blocks = far.metadata.entities.iter_mut().filter_map(|entity| entity.block.as_mut());
        blocks.for_each(|block| *block += Cell::new(100, -20, 4000));
        for (way, back) in all_ways(&far) {
            prop_assert!(near(&sorted(&back), &sorted(&grid)), "{way}: {:?}", back.metadata.entities);
        }
    }

    #[test]
    fn a_box_of_a_world_holds_what_a_crop_does(grid in any_grid(), bounds in any_box()) {
        let folder = world(&encode_regions(&grid, AT).unwrap());
        let part = part_of(&folder, Some(Bounds::new(bounds.min + AT, bounds.max + AT)));
        prop_assert!(near(&sorted(&part), &sorted(&grid.cropped(bounds))));
    }

    #[test]
    fn no_entity_is_lost_by_trimming_or_splitting(grid in any_grid(), edge in 1..9u16) {
        prop_assert_eq!(&grid.trimmed().unwrap().metadata.entities, &grid.metadata.entities);
        let pieces = grid.pieces(edge).map(|(_, piece)| piece.metadata.entities.len());
        prop_assert_eq!(pieces.sum::<usize>(), grid.metadata.entities.len());
    }
}

fn doubles(numbers: [f64; 3]) -> Tag {
    Tag::List(numbers.map(Tag::Double).to_vec())
}

fn tiled(Entity { place, block, mut data }: Entity) -> Tag {
    data.insert("Pos".to_owned(), doubles(place));
    let tile =
        block.into_iter().flat_map(|block| ["TileX", "TileY", "TileZ"].into_iter().zip(block.to_array()));
    data.extend(tile.map(|(name, n)| (name.to_owned(), Tag::Int(n))));
    Tag::Compound(data)
}

/// The entities of an MCEdit schematic of 4 x 1 x 1 blocks.
fn mcedit(entities: Vec<Tag>, origin: Option<Cell>) -> Vec<Entity> {
    let mut root = row(&[(1, 0); 4]);
    root.insert("Entities".to_owned(), Tag::List(entities));
    let names = ["WEOriginX", "WEOriginY", "WEOriginZ"];
    let origin = origin.into_iter().flat_map(|origin| names.into_iter().zip(origin.to_array()));
    root.extend(origin.map(|(name, n)| (name.to_owned(), Tag::Int(n))));
    read_grid(&file(&root)).metadata.entities
}

#[test]
fn entities_of_worldedit_in_mcedit_schematics_count_as_in_their_world() {
    let origin = Cell::new(100, 64, 200);
    let here = painting(Cell::new(1, 0, 1), 0, [2, 2]);
    let there = painting(origin + Cell::new(1, 0, 1), 0, [2, 2]);
    assert_eq!(mcedit(vec![tiled(there)], Some(origin)), std::slice::from_ref(&here));
    assert_eq!(mcedit(vec![tiled(here.clone())], Some(origin)), std::slice::from_ref(&here));
    assert_eq!(mcedit(vec![tiled(here.clone())], None), [here]);
}

/// WorldEdit moves places to the low corner, and leaves the blocks as they are in the world.
#[test]
fn worldedit_leaves_the_blocks_of_version_3_in_its_world() {
    let mut grid = Grid::new(SIZE);
    grid.metadata.offset = Cell::new(-3, -1, -9);
    let origin = tags([("Origin", Tag::IntArray(vec![103, 65, 209]))]);
    grid.metadata.tags.insert("WorldEdit".to_owned(), Tag::Compound(origin));
    grid.metadata.entities = vec![painting(Cell::new(3, 2, 1), 0, [2, 2])];
    let bytes = encode_schem(&grid, SchemVersion::V3).unwrap().bytes;
    assert_eq!(read_grid(&bytes).metadata.entities, grid.metadata.entities);
    let root = nbt_root(&bytes);
    let Tag::Compound(root) = &root["Schematic"] else { panic!("no schematic") };
    let Tag::List(entities) = &root["Entities"] else { panic!("no entities") };
    let Tag::Compound(entity) = &entities[0] else { panic!("no entity") };
    assert_eq!(entity["Pos"], doubles([4.0, 3.0, 1.03125]));
    let Tag::Compound(data) = &entity["Data"] else { panic!("no data") };
    assert_eq!(["TileX", "TileY", "TileZ"].map(|name| data[name].clone()), [103, 66, 201].map(Tag::Int));
}

#[test]
fn ticks_do_not_stay_behind() {
    let mut grid = Grid::new(SIZE);
    let ticks = Tag::List(vec![Tag::Compound(tags([("x", Tag::Int(3))]))]);
    let region = |bounds, tags: Compound| Region { name: "a".to_owned(), bounds, tags };
    let own = || tags([("mod:own", Tag::Int(1))]);
    let mut all = own();
    all.insert("PendingBlockTicks".to_owned(), ticks);
    grid.metadata.regions = vec![region(grid.bounds(), all)];
    let lost = encode_schem(&grid, SchemVersion::V2).unwrap().lost;
    let names = ["PendingBlockTicks", "mod:own"].map(str::to_owned).to_vec();
    assert_eq!(lost, [Lost::Regions { count: 1, tags: names }]);

    assert_eq!(grid.cropped(grid.bounds()).metadata.regions, grid.metadata.regions);
    let half = Bounds::of_size(SIZE.with_x(3));
    assert_eq!(grid.cropped(half).metadata.regions, [region(half, own())]);
    let turned = grid.turned(Turn::quarters(1));
    assert_eq!(turned.metadata.regions, [region(turned.bounds(), own())]);
}

#[test]
fn entities_that_do_not_say_what_they_are_are_left_out_with_a_warning() {
    let unnamed = Tag::Compound(tags([("Pos", doubles([0.5, 0.0, 0.5]))]));
    let mut root = row(&[(1, 0)]);
    root.insert("Entities".to_owned(), Tag::List(vec![unnamed]));
    let decoded = super::read(&file(&root)).unwrap();
    assert_eq!(decoded.warnings, [Warning::EntitiesUnnamed(1)]);
}
