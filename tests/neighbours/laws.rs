//! Laws over random heaps of blocks that depend on each other.

use proptest::prelude::*;
use vox::block::{BlockState, Mirror};
use vox::grid::Grid;
use vox::neighbours::{settle, unsettle};
use vox::space::{Cell, Turn};

/// Blocks of every kind with their own properties; what neighbours decide is left open or, in some, said.
const STATES: [&str; 40] = [
    "air",
    "air",
    "air",
    "stone",
    "glass",
    "oak_fence",
    "oak_fence",
    "oak_fence[east=true]",
    "nether_brick_fence",
    "glass_pane",
    "iron_bars",
    "stone_brick_wall",
    "stone_brick_wall",
    "cobblestone_wall[up=false,north=low,south=low]",
    "oak_fence_gate[facing=east]",
    "oak_fence_gate[facing=north,open=true]",
    "oak_stairs[facing=north,half=bottom]",
    "oak_stairs[facing=east,half=bottom]",
    "oak_stairs[facing=south,half=bottom]",
    "oak_stairs[facing=west,half=bottom]",
    "oak_stairs[facing=north,half=top]",
    "oak_stairs[facing=north,half=bottom,shape=outer_left]",
    "oak_slab[type=bottom]",
    "oak_door[facing=north,hinge=left]",
    "oak_door[facing=north,half=upper,hinge=right]",
    "oak_door[facing=north,hinge=right,open=true]",
    "sunflower",
    "red_bed[facing=south]",
    "red_bed[facing=south,part=head]",
    "chest[facing=east]",
    "chest[facing=east]",
    "chest[facing=east,type=left]",
    "redstone_wire",
    "redstone_wire",
    "repeater[facing=north]",
    "tripwire",
    "vine[north=true]",
    "snow",
    "grass_block",
    "oak_trapdoor[facing=north,open=true]",
];

pub fn grids() -> impl Strategy<Value = Grid> {
    let cells = |[x, y, z]: [i32; 3]| {
        let count = (x * y * z) as usize;
        prop::collection::vec(prop::sample::select(STATES.to_vec()), count)
            .prop_map(move |states| grid(Cell::new(x, y, z), &states))
    };
    [1..6, 1..4, 1..6].prop_flat_map(cells)
}

pub fn grid(size: Cell, states: &[&str]) -> Grid {
    let mut grid = Grid::new(size);
    for (cell, state) in grid.bounds().cells().zip(states) {
        let id = grid.intern(&state.parse::<BlockState>().unwrap()).unwrap();
        grid.set(cell, id);
    }
    grid
}

pub fn settled(grid: &Grid) -> Grid {
    let mut grid = grid.clone();
    settle(&mut grid).unwrap();
    grid
}

/// The grid with every cell at another place and its state changed to go with it.
fn moved(grid: &Grid, place: impl Fn(Cell) -> Cell, state: impl Fn(&BlockState) -> BlockState) -> Grid {
    let corners = [place(Cell::ZERO), place(grid.size() - 1)];
    let low = corners[0].min(corners[1]);
    let mut new = Grid::new(corners[0].max(corners[1]) + 1 - low);
    for cell in grid.bounds().cells() {
        let id = new.intern(&state(grid.get(cell))).unwrap();
        new.set(place(cell) - low, id);
    }
    new
}

fn turned(grid: &Grid, turn: Turn) -> Grid {
    moved(grid, |cell| turn.apply(cell), |state| state.turned(turn))
}

fn mirrored(grid: &Grid, mirror: Mirror) -> Grid {
    let unit = mirror.axis().unit();
    moved(grid, |cell| cell - 2 * cell * unit, |state| state.mirrored(mirror))
}

pub fn states(grid: &Grid) -> Vec<String> {
    grid.bounds().cells().map(|cell| format!("{cell} {}", grid.get(cell).short())).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn settling_twice_is_settling_once(grid in grids()) {
        let once = settled(&grid);
        prop_assert_eq!(states(&settled(&once)), states(&once));
        for state in once.palette().states() {
            prop_assert_eq!(&vox::block::complete(state), state);
        }
    }

    #[test]
    fn settling_goes_with_turns(grid in grids()) {
        for turn in Turn::ALL {
            prop_assert_eq!(states(&settled(&turned(&grid, turn))), states(&turned(&settled(&grid), turn)));
        }
    }

    #[test]
    fn settling_goes_with_mirrors(grid in grids()) {
        for mirror in Mirror::ALL {
            prop_assert_eq!(states(&settled(&mirrored(&grid, mirror))), states(&mirrored(&settled(&grid), mirror)));
        }
    }

    #[test]
    fn what_is_taken_off_comes_back(grid in grids()) {
        let whole = settled(&grid);
        let mut open = whole.clone();
        unsettle(&mut open).unwrap();
        prop_assert_eq!(states(&settled(&open)), states(&whole));
    }
}

#[test]
fn variants_are_settled_as_well() {
    let mut grid = grid(Cell::new(2, 1, 1), &["oak_fence", "oak_fence"]);
    grid.variants = vec![self::grid(Cell::new(2, 1, 1), &["stone", "oak_fence"])];
    settle(&mut grid).unwrap();
    let fence = grid.variants[0].get(Cell::X).clone();
    assert_eq!((fence.get("west"), fence.get("east")), (Some("true"), Some("false")));
    assert_eq!(grid.get(Cell::X), &fence);
}

#[test]
fn what_can_be_computed_goes() {
    let row = ["oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]"; 2];
    let mut grid = grid(Cell::new(2, 1, 1), &row);
    unsettle(&mut grid).unwrap();
    let second = grid.get(Cell::X);
    assert_eq!(grid.get(Cell::ZERO).short(), "oak_fence[waterlogged=false]");
    assert_eq!(second.short(), row[0], "it joins nothing on its east side");
}

#[test]
fn builds_of_old_versions_are_settled_in_their_words() {
    let states = ["oak_leaves", "cobblestone_wall", "stone", "rail", "skeleton_skull"];
    let expected = |data_version, walls: &str, others: [&str; 3]| {
        let mut grid = grid(Cell::new(5, 1, 1), &states);
        grid.metadata.data_version = Some(data_version);
        grid.variants = vec![grid.clone()];
        grid.variants[0].metadata.data_version = None;
        settle(&mut grid).unwrap();
        let expected = [others[0], walls, "stone", others[1], others[2]];
        for grid in [&grid, &grid.variants[0]] {
            let found = grid.bounds().cells().map(|cell| grid.get(cell).short());
            assert_eq!(found.collect::<Vec<String>>(), expected);
        }
        let before = grid.clone();
        settle(&mut grid).unwrap();
        assert!(grid.same_blocks(&before));
    };
    expected(
        2230,
        "cobblestone_wall[east=true,north=false,south=false,up=true,waterlogged=false,west=false]",
        ["oak_leaves[distance=7,persistent=false]", "rail[shape=north_south]", "skeleton_skull[rotation=0]"],
    );
    expected(
        4671,
        "cobblestone_wall[east=low,north=none,south=none,up=true,waterlogged=false,west=none]",
        [
            "oak_leaves[distance=7,persistent=false,waterlogged=false]",
            "rail[shape=north_south,waterlogged=false]",
            "skeleton_skull[powered=false,rotation=0]",
        ],
    );
}
