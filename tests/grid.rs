//! Laws of moving and cutting builds, over random builds with all that can be in them.

use ndarray::{Array2, Array3};
use proptest::collection::vec;
use proptest::prelude::*;
use vox::block::{BlockState, Facing, Known, Mirror, Palette, all};
use vox::grid::{BiomeMap, Biomes, Entity, Grid, Region};
use vox::nbt::{Compound, Tag};
use vox::space::{Bounds, Cell, Turn};

fn any_state() -> impl Strategy<Value = BlockState> {
    prop::sample::select(all().iter().collect::<Vec<_>>()).prop_flat_map(|known: &'static Known| {
        let pairs = known.properties().iter().map(|property| {
            prop::sample::select(property.values.clone()).prop_map(|value| (property.key, value))
        });
        pairs.collect::<Vec<_>>().prop_map(|pairs| {
            let bare = BlockState::new(known.name()).unwrap();
            pairs.into_iter().fold(bare, |state, (key, value)| state.with(key, value))
        })
    })
}

fn any_size() -> impl Strategy<Value = Cell> {
    (1..6, 1..4, 1..6).prop_map(|(x, y, z)| Cell::new(x, y, z))
}

fn any_cell(size: Cell) -> impl Strategy<Value = Cell> {
    (0..size.x, 0..size.y, 0..size.z).prop_map(|(x, y, z)| Cell::new(x, y, z))
}

fn any_box(size: Cell) -> impl Strategy<Value = Bounds> {
    (any_cell(size), any_cell(size)).prop_map(|(a, b)| Bounds::new(a.min(b), a.max(b) + Cell::ONE))
}

fn shape(size: Cell) -> (usize, usize, usize) {
    (size.y as usize, size.z as usize, size.x as usize)
}

fn any_blocks(size: Cell) -> impl Strategy<Value = Grid> {
    vec(any_state(), 1..5).prop_flat_map(move |states| {
        let volume = Bounds::of_size(size).volume() as usize;
        vec(0..=states.len(), volume).prop_map(move |picks| {
            let mut palette = Palette::default();
            let ids: Vec<u16> = states.iter().map(|state| palette.intern(state).unwrap()).collect();
            let ids = picks.into_iter().map(|pick| if pick == 0 { 0 } else { ids[pick - 1] }).collect();
            Grid::from_cells(Array3::from_shape_vec(shape(size), ids).unwrap(), palette).unwrap()
        })
    })
}

fn compound<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
    tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect()
}

fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

fn doubles(numbers: [f64; 3]) -> Tag {
    Tag::List(numbers.map(Tag::Double).to_vec())
}

fn any_animal(size: Cell) -> impl Strategy<Value = Entity> {
    let place = (0..size.x * 32, 0..size.y * 32, 0..size.z * 32);
    (place, -360..360, -2..3).prop_map(|((x, y, z), yaw, push)| Entity {
        place: [x, y, z].map(|at| f64::from(at) / 32.0 + 1.0 / 64.0),
        block: None,
        data: compound([
            ("id", text("minecraft:cow")),
            ("Rotation", Tag::List(vec![Tag::Float(yaw as f32 / 2.0), Tag::Float(12.5)])),
            ("Motion", doubles([f64::from(push), 0.25, 1.0])),
        ]),
    })
}

/// A painting by the rules of the game: where its home cell is, where it looks, and whether it is of even size.
#[derive(Clone, Debug)]
struct Painting {
    home: Cell,
    facing: Facing,
    size: Cell,
}

const WALLS: [Facing; 4] = [Facing::South, Facing::West, Facing::North, Facing::East];

impl Painting {
    fn entity(&self) -> Entity {
        let half = |length: i32| if length % 2 == 0 { 0.5 } else { 0.0 };
        let step = |facing: Facing| facing.step().as_dvec3();
        let place = self.home.as_dvec3() + 0.5 - 0.46875 * step(self.facing)
            + half(self.size.x) * step(self.facing.left())
            + half(self.size.y) * step(Facing::Up);
        let number = WALLS.iter().position(|wall| *wall == self.facing).unwrap();
        let data = compound([("id", text("minecraft:painting")), ("facing", Tag::Byte(number as i8))]);
        Entity { place: place.to_array(), block: Some(self.home), data }
    }

    fn of(entity: &Entity, size: Cell) -> Painting {
        let Tag::Byte(number) = entity.data["facing"] else { panic!("no facing") };
        Painting { home: entity.block.unwrap(), facing: WALLS[number as usize], size }
    }

    /// The cells that it covers.
    fn cells(&self) -> Vec<Cell> {
        let low = |length: i32| -(length - 1) / 2;
        let along = (0..self.size.x).map(|at| self.facing.left().step() * (at + low(self.size.x)));
        let cells = along.flat_map(|along| {
            (0..self.size.y).map(move |at| self.home + along + Cell::Y * (at + low(self.size.y)))
        });
        let mut cells: Vec<Cell> = cells.collect();
        cells.sort_by_key(|cell| cell.to_array());
        cells
    }
}

fn any_painting(size: Cell) -> impl Strategy<Value = Painting> {
    let facing = prop::sample::select(WALLS.to_vec());
    (any_cell(size), facing, 1..5, 1..5).prop_map(|(home, facing, width, height)| Painting {
        home,
        facing,
        size: Cell::new(width, height, 1),
    })
}

fn any_entity(size: Cell) -> impl Strategy<Value = Entity> {
    prop_oneof![any_animal(size), any_painting(size).prop_map(|painting| painting.entity())]
}

fn any_biomes(size: Cell) -> impl Strategy<Value = Option<Biomes>> {
    let cells = vec(0..2u16, Bounds::of_size(size).volume() as usize);
    (0..3, cells).prop_map(move |(kind, ids)| {
        let (y, z, x) = shape(size);
        let map = match kind {
            0 => return None,
            1 => BiomeMap::Columns(Array2::from_shape_vec((z, x), ids[..z * x].to_vec()).unwrap()),
            _ => BiomeMap::Cells(Array3::from_shape_vec((y, z, x), ids).unwrap()),
        };
        Some(Biomes { names: vec!["plains".to_owned(), "desert".to_owned()], map })
    })
}

fn any_region(size: Cell) -> impl Strategy<Value = Region> {
    any_box(size).prop_map(|bounds| Region { name: "main".to_owned(), bounds, tags: Compound::new() })
}

fn any_grid() -> impl Strategy<Value = Grid> {
    any_size().prop_flat_map(|size| {
        let heads = (any_cell(size), 0..16i8).prop_map(|(cell, turn)| {
            (cell.to_array(), compound([("id", text("minecraft:skull")), ("Rot", Tag::Byte(turn))]))
        });
        let offset = (-9..9, -9..9, -9..9).prop_map(|(x, y, z)| Cell::new(x, y, z));
        let parts = (vec(any_blocks(size), 0..2), vec(heads, 0..3), vec(any_entity(size), 0..3));
        let rest = (any_biomes(size), vec(any_region(size), 0..2), offset);
        (any_blocks(size), parts, rest).prop_map(|(mut grid, (variants, heads, entities), rest)| {
            grid.variants = variants;
            grid.block_entities = heads.into_iter().collect();
            grid.metadata.entities = entities;
            (grid.metadata.biomes, grid.metadata.regions, grid.metadata.offset) = rest;
            grid
        })
    })
}

fn any_turn() -> impl Strategy<Value = Turn> {
    prop::sample::select(Turn::ALL.to_vec())
}

fn any_mirror() -> impl Strategy<Value = Mirror> {
    prop::sample::select(Mirror::ALL.to_vec())
}

fn same(a: &Grid, b: &Grid) -> bool {
    a.same_blocks(b)
        && a.block_entities == b.block_entities
        && a.metadata == b.metadata
        && a.variants.len() == b.variants.len()
        && a.variants.iter().zip(&b.variants).all(|(a, b)| same(a, b))
}

/// Turning is the same as what its inverse undoes: numbers are kept exactly, but for angles beyond a half circle.
fn settled(grid: &Grid) -> Grid {
    grid.turned(Turn::quarters(1)).turned(Turn::quarters(3))
}

proptest! {
    #[test]
    fn four_quarter_turns_and_two_mirrors_change_nothing(grid in any_grid(), mirror in any_mirror()) {
        let grid = settled(&grid);
        let quarter = Turn::quarters(1);
        let turned = grid.turned(quarter).turned(quarter).turned(quarter).turned(quarter);
        prop_assert!(same(&turned, &grid));
        prop_assert!(same(&grid.mirrored(mirror).mirrored(mirror), &grid));
    }

    #[test]
    fn turns_and_mirrors_compose(grid in any_grid(), a in any_turn(), b in any_turn(), mirror in any_mirror()) {
        let grid = settled(&grid);
        prop_assert!(same(&grid.turned(a).turned(b), &grid.turned(a + b)));
        prop_assert!(same(&grid.turned(a).mirrored(mirror), &grid.mirrored(mirror).turned(a.inverse())));
        let both = grid.mirrored(Mirror::X).mirrored(Mirror::Z);
        prop_assert!(same(&both, &grid.turned(Turn::quarters(2))));
    }

    #[test]
    fn blocks_stand_where_the_turn_puts_them(grid in any_grid(), turn in any_turn()) {
        let turned = grid.turned(turn);
        let corners = [Cell::ZERO, grid.size() - Cell::ONE].map(|corner| turn.apply(corner));
        for cell in grid.bounds().cells() {
            let to = turn.apply(cell) - corners[0].min(corners[1]);
            prop_assert_eq!(turned.get(to), &grid.get(cell).turned(turn));
        }
    }

    #[test]
    fn a_crop_of_the_turned_is_the_turned_crop(
        (grid, bounds) in any_grid().prop_flat_map(|grid| { let size = grid.size(); (Just(grid), any_box(size)) }),
        turn in any_turn(),
    ) {
        let grid = settled(&grid);
        let corners = [Cell::ZERO, grid.size() - Cell::ONE].map(|corner| turn.apply(corner));
        let [a, b] = [bounds.min, bounds.max - Cell::ONE].map(|corner| turn.apply(corner) - corners[0].min(corners[1]));
        let moved = Bounds::new(a.min(b), a.max(b) + Cell::ONE);
        prop_assert!(same(&grid.turned(turn).cropped(moved), &grid.cropped(bounds).turned(turn)));
    }

    #[test]
    fn a_crop_to_everything_keeps_everything(grid in any_grid()) {
        prop_assert!(same(&grid.cropped(grid.bounds()), &grid));
        if let Some(bounds) = grid.occupied() {
            let cropped = grid.cropped(bounds);
            prop_assert_eq!(cropped.occupied(), Some(cropped.bounds()));
            prop_assert_eq!(cropped.metadata.entities.len(), grid.metadata.entities.len());
        }
    }

    #[test]
    fn paintings_do_not_creep(
        painting in any_painting(Cell::splat(6)), turn in any_turn(), mirror in any_mirror(),
    ) {
        let mut grid = Grid::new(Cell::splat(6));
        grid.metadata.entities.push(painting.entity());
        let moved = grid.turned(turn).mirrored(mirror);
        let found = Painting::of(&moved.metadata.entities[0], painting.size);
        prop_assert_eq!(found.entity().place, moved.metadata.entities[0].place);
        let corners = [Cell::ZERO, Cell::splat(5)].map(|corner| turn.apply(corner));
        let flip = |cell: Cell| match mirror {
            Mirror::X => cell.with_x(5 - cell.x),
            Mirror::Z => cell.with_z(5 - cell.z),
        };
        let cells = painting.cells().into_iter().map(|cell| flip(turn.apply(cell) - corners[0].min(corners[1])));
        let mut cells: Vec<Cell> = cells.collect();
        cells.sort_by_key(|cell| cell.to_array());
        prop_assert_eq!(found.cells(), cells);
    }
}

#[test]
fn item_frames_look_where_they_are_turned_in_both_ways_of_counting() {
    // Each hangs on the west side of its cell and looks east.
    for (number, turned) in [(5, 2), (3, 2)] {
        let mut grid = Grid::new(Cell::splat(3));
        let data = compound([("id", text("minecraft:item_frame")), ("Facing", Tag::Byte(number))]);
        grid.metadata.entities.push(Entity { place: [1.03125, 1.5, 1.5], block: Some(Cell::ONE), data });
        let entity = &grid.turned(Turn::quarters(1)).metadata.entities[0];
        assert_eq!(entity.data["Facing"], Tag::Byte(turned));
        assert_eq!(entity.place, [1.5, 1.5, 1.96875]);
        assert_eq!(entity.block, Some(Cell::ONE));
    }
}

#[test]
fn animals_look_and_go_where_they_are_turned() {
    let mut grid = Grid::new(Cell::new(4, 1, 2));
    let data = compound([
        ("id", text("minecraft:cow")),
        ("Rotation", Tag::List(vec![Tag::Float(-90.0), Tag::Float(5.0)])),
        ("Motion", doubles([1.0, 0.0, 0.0])),
    ]);
    grid.metadata.entities.push(Entity { place: [3.5, 0.0, 0.25], block: None, data });
    let entity = &grid.turned(Turn::quarters(1)).metadata.entities[0];
    assert_eq!(entity.place, [0.25, 0.0, 0.5]);
    assert_eq!(entity.data["Rotation"], Tag::List(vec![Tag::Float(-180.0), Tag::Float(5.0)]));
    assert_eq!(entity.data["Motion"], doubles([0.0, 0.0, -1.0]));
}

#[test]
fn the_point_of_copying_stays_when_a_build_is_turned_or_cropped() {
    let mut grid = Grid::new(Cell::new(4, 1, 2));
    grid.metadata.offset = Cell::new(1, -1, 1);
    assert_eq!(grid.turned(Turn::quarters(1)).metadata.offset, Cell::new(1, -1, -4));
    assert_eq!(grid.mirrored(Mirror::X).metadata.offset, Cell::new(-4, -1, 1));
    let cropped = grid.cropped(Bounds::new(Cell::new(1, 0, 1), Cell::new(3, 1, 2)));
    assert_eq!((cropped.size(), cropped.metadata.offset), (Cell::new(2, 1, 1), Cell::new(2, -1, 2)));
}

#[test]
fn a_crop_leaves_out_states_that_are_not_used_and_what_lies_outside() {
    let mut grid = Grid::new(Cell::new(3, 1, 1));
    for (x, name) in ["stone", "dirt"].into_iter().enumerate() {
        let id = grid.intern(&name.parse().unwrap()).unwrap();
        grid.set(Cell::new(x as i32, 0, 0), id);
        grid.block_entities.insert([x as i32, 0, 0], compound([("id", text(name))]));
    }
    assert_eq!(grid.occupied(), Some(Bounds::of_size(Cell::new(2, 1, 1))));
    let cropped = grid.cropped(Bounds::new(Cell::X, Cell::new(2, 1, 1)));
    assert_eq!(cropped.palette().states().len(), 2);
    assert_eq!(
        cropped.block_entities.into_iter().collect::<Vec<_>>(),
        [([0; 3], compound([("id", text("dirt"))]))]
    );
    assert_eq!(Grid::new(Cell::ONE).occupied(), None);
}

#[test]
fn no_number_of_a_file_is_too_large_to_turn() {
    let mut grid = Grid::new(Cell::ONE);
    grid.metadata.offset = Cell::MIN;
    for place in [[f64::MAX; 3], [f64::NEG_INFINITY; 3], [f64::NAN; 3]] {
        let data = compound([("id", text("painting")), ("facing", Tag::Byte(-7))]);
        grid.metadata.entities.push(Entity { place, block: Some(Cell::MIN), data });
    }
    for turn in Turn::ALL {
        let moved = grid.turned(turn).mirrored(Mirror::X).mirrored(Mirror::Z);
        assert_eq!(moved.cropped(moved.bounds()).size(), Cell::ONE);
    }
}
