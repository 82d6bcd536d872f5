//! Mending what does not go together.

use crate::laws::{grid, grids, settled, states};
use proptest::prelude::*;
use vox::grid::Grid;
use vox::neighbours::{Mended, mend};
use vox::space::Cell;

fn mended(grid: &Grid) -> (Grid, Mended) {
    let mut grid = grid.clone();
    let mended = mend(&mut grid).unwrap().mended;
    (grid, mended)
}

/// A row of blocks along x with air around it, mended: what stands in the row then.
fn row(states: &[&str]) -> (Vec<String>, String) {
    let mut wide = Grid::new(Cell::new(states.len() as i32 + 2, 3, 3));
    let row = grid(Cell::new(states.len() as i32, 1, 1), states);
    for cell in row.bounds().cells() {
        let id = wide.intern(row.get(cell)).unwrap();
        wide.set(cell + Cell::ONE, id);
    }
    let (wide, count) = mended(&wide);
    let cells = row.bounds().cells().map(|cell| wide.get(cell + Cell::ONE).short());
    (cells.collect(), count.to_string())
}

const JOINED: &str = "oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]";

#[test]
fn fences_that_do_not_join_are_joined() {
    let (row, count) = row(&["oak_fence[east=false]", "oak_fence[east=true]"]);
    assert_eq!(row[0], JOINED);
    assert_eq!(row[1], JOINED.replace("west=false", "west=true").replace("east=true", "east=false"));
    assert_eq!(count, "2 blocks that join others");
}

#[test]
fn corners_of_stairs_are_made() {
    let (row, count) =
        row(&["oak_stairs[facing=east,shape=straight]", "oak_stairs[facing=north,shape=straight]"]);
    assert_eq!(row[0], "oak_stairs[facing=east,half=bottom,shape=outer_left,waterlogged=false]");
    assert_eq!(count, "1 corner of stairs");
}

#[test]
fn half_a_chest_is_a_chest_and_two_make_a_pair() {
    let (row, count) =
        self::row(&["chest[facing=north,type=left]", "stone", "chest[facing=north,type=right]"]);
    assert_eq!(row[0], "chest[facing=north,type=single,waterlogged=false]");
    assert_eq!(count, "2 chests");
    let (row, _) = self::row(&["chest[facing=north,type=right]", "chest[facing=north,type=left]"]);
    assert_eq!(row[0], "chest[facing=north,type=left,waterlogged=false]");
    assert_eq!(row[1], "chest[facing=north,type=right,waterlogged=false]");
}

#[test]
fn halves_alone_are_made_whole_or_go() {
    let (row, count) = self::row(&["red_bed[facing=east,part=foot]", "air"]);
    assert_eq!(row[1], "red_bed[facing=east,occupied=false,part=head]");
    assert_eq!(count, "1 half of a door, bed or plant");
    let (row, _) = self::row(&["red_bed[facing=east,part=foot]", "stone"]);
    assert_eq!(row, ["air", "stone"]);
}

#[test]
fn the_halves_of_a_door_agree() {
    let door = [
        "oak_door[facing=east,half=lower,hinge=left,open=true]",
        "oak_door[facing=west,half=upper,hinge=right]",
    ];
    let (grid, count) = mended(&grid(Cell::new(1, 2, 1), &door));
    let lower = "oak_door[facing=east,half=lower,hinge=right,open=true,powered=false]";
    assert_eq!(grid.get(Cell::ZERO).short(), lower);
    assert_eq!(grid.get(Cell::Y).short(), lower.replace("lower", "upper"));
    assert_eq!(count.halves, 2);
}

#[test]
fn what_goes_together_stays() {
    let rows: [&[&str]; 4] = [
        &["chest[facing=north,type=single]", "chest[facing=north,type=single]"],
        &["redstone_wire[east=none,north=none,south=none,west=none]"],
        &["oak_stairs[facing=north,shape=straight]", "oak_stairs[facing=north,shape=straight]"],
        &["stone", "oak_planks"],
    ];
    for states in rows {
        let (_, count) = row(states);
        assert_eq!(count, "nothing to mend", "{states:?}");
    }
}

#[test]
fn what_lies_past_the_border_is_not_known() {
    let texts =
        [JOINED, "oak_stairs[facing=east,shape=outer_left]", "oak_door[half=upper]", "chest[type=left]"];
    for text in texts {
        let (_, mended) = mended(&grid(Cell::ONE, &[text]));
        assert_eq!(mended, Mended::default(), "{text}");
    }
    let beside_void = grid(Cell::new(2, 1, 1), &[JOINED, "structure_void"]);
    assert_eq!(mended(&beside_void).1, Mended::default());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn what_is_mended_needs_no_mending(grid in grids()) {
        let (once, _) = mended(&grid);
        let (twice, count) = mended(&once);
        prop_assert_eq!(states(&twice), states(&once));
        prop_assert_eq!(count, Mended::default());
    }

    #[test]
    fn every_change_is_counted(grid in grids()) {
        let whole = settled(&grid);
        let (mended, count) = mended(&whole);
        prop_assert_eq!(states(&mended) == states(&whole), count == Mended::default());
    }
}

/// One block above the other, mended.
fn column(states: [&str; 2]) -> [String; 2] {
    let (grid, _) = mended(&grid(Cell::new(1, 2, 1), &states));
    [Cell::ZERO, Cell::Y].map(|cell| grid.get(cell).short())
}

#[test]
fn crops_have_an_upper_half_once_they_are_tall() {
    for age in 0..=4 {
        let lower = format!("pitcher_crop[age={age},half=lower]");
        let above = if age < 3 { "air".to_owned() } else { lower.replace("lower", "upper") };
        assert_eq!(column([&lower, "air"]), [lower.clone(), above.clone()]);
        assert_eq!(column([&lower, &above]), [lower, above]);
    }
}

#[test]
fn plants_in_water_keep_it_and_grow_in_it() {
    const WATER: &str = "water[level=0]";
    const LEAF: &str = "small_dripleaf[facing=north,half=lower,waterlogged=true]";
    let wet = LEAF.replace("lower", "upper");
    let dry = wet.replace("true", "false");
    let cases = [
        (["tall_seagrass[half=lower]", WATER], ["tall_seagrass[half=lower]", "tall_seagrass[half=upper]"]),
        ([WATER, "tall_seagrass[half=upper]"], ["tall_seagrass[half=lower]", "tall_seagrass[half=upper]"]),
        (["tall_seagrass[half=lower]", "air"], [WATER, "air"]),
        (["sand", "tall_seagrass[half=upper]"], ["sand", WATER]),
        ([LEAF, WATER], [LEAF, wet.as_str()]),
        ([LEAF, "air"], [LEAF, dry.as_str()]),
        ([LEAF, "stone"], [WATER, "stone"]),
        (["tall_grass[half=lower]", WATER], ["air", WATER]),
    ];
    for (states, expected) in cases {
        assert_eq!(column(states), expected, "{states:?}");
    }
}

#[test]
fn what_is_not_mended_is_told_with_its_places() {
    let states = ["oak_fence[east=true,west=true]", "mod:stone", "oak_door[half=upper]", "chest[type=left]"];
    let mut grid = grid(Cell::new(4, 1, 1), &states);
    let mending = mend(&mut grid).unwrap();
    let at = |x| Cell::new(x, 0, 0);
    // The fence has its west side to the border, the door its lower half below it, the chest its other half.
    assert_eq!((mending.border.count, mending.border.first), (3, vec![at(2), at(3), at(0)]));
    assert_eq!((mending.unknown.count, mending.unknown.first), (1, vec![at(1)]));
}

/// What stands beside a fence whose side to it was written by hand decides nothing unless it asks for something else.
#[test]
fn neighbours_of_what_is_replaced_follow_where_it_decides() {
    let fence = "oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]";
    let before = grid(Cell::new(3, 1, 1), &["stone", fence, "stone"]);
    let follow = |rule: &str| {
        let mut after = before.clone();
        after.replace(&[rule.parse().unwrap()]).unwrap();
        vox::neighbours::follow(&before, &mut after).unwrap();
        after.get(Cell::X).short()
    };
    assert_eq!(follow("stone=andesite"), fence, "both ask for a side to the west as stone does");
    assert_eq!(follow("stone=white_carpet"), fence.replace("east=true", "east=false"));
}
