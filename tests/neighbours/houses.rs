//! Real houses, as the game saved them, are the measure: what is taken off every block and settled again is what
//! the game had put there.

use crate::real::folder;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use vox::block::BlockState;
use vox::grid::Grid;
use vox::neighbours::{bare, mend, settle, unsettle};
use vox::space::Cell;

fn house(file: &Path) -> Grid {
    let read = vox::io::read(file, &vox::io::Limits::default()).unwrap();
    let vox::io::Content::Grid(mut grid) = read.content else { panic!("{} is no grid", file.display()) };
    settle(&mut grid).unwrap();
    grid
}

/// The `.schem` files of the houses, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let styles = std::fs::read_dir(folder.join("houses")).unwrap();
    let files = styles.flat_map(|style| std::fs::read_dir(style.unwrap().path()).unwrap());
    let mut files: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "schem"));
    files.sort();
    files
}

/// Why a block differs from what its neighbours ask for.
fn kind(house: &Grid, cell: Cell) -> &'static str {
    let state = house.get(cell);
    let is_air = |step: Cell| {
        let beside = cell + step;
        !house.bounds().contains(beside) || house.get(beside).is_air()
    };
    let sides = [("east", Cell::X), ("north", -Cell::Z), ("south", Cell::Z), ("west", -Cell::X)];
    let joins_air = sides.iter().any(|(side, step)| state.get(side) == Some("true") && is_air(*step));
    let is_low = |side: &(&str, Cell)| state.get(side.0) != Some("tall");
    match state.short_name() {
        name if name.ends_with("_wall") && sides.iter().all(is_low) && state.get("up") == Some("true") => {
            "wall of before 1.16: without tall arms, with posts throughout"
        }
        name if name.ends_with("_fence") && joins_air => "fence joined to what the file has left out",
        name if name.ends_with("_fence") => "fence put beside a log without an update",
        name => panic!("{name} at {cell}: {state}"),
    }
}

fn differences(house: &Grid, other: &Grid) -> Vec<Cell> {
    house.bounds().cells().filter(|cell| house.get(*cell) != other.get(*cell)).collect()
}

/// The blocks of the houses that are not as the game would put them today.
const OUT_OF_DATE: [(&str, usize); 3] = [
    ("fence joined to what the file has left out", 4),
    ("fence put beside a log without an update", 7),
    ("wall of before 1.16: without tall arms, with posts throughout", 29),
];

#[test]
fn houses_are_settled_as_the_game_does() {
    let Some(folder) = folder() else { return };
    let mut joints = 0;
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for file in files(&folder) {
        let house = house(&file);
        let mut again = house.clone();
        again.map_states(bare).unwrap();
        joints += differences(&house, &again).len();
        settle(&mut again).unwrap();
        for cell in differences(&house, &again) {
            *kinds.entry(kind(&house, cell)).or_default() += 1;
        }
    }
    assert_eq!(joints, 3886);
    assert_eq!(kinds.into_iter().collect::<Vec<_>>(), OUT_OF_DATE);
}

#[test]
fn houses_come_back_from_what_they_leave_open() {
    let Some(folder) = folder() else { return };
    for file in files(&folder) {
        let house = house(&file);
        let mut open = house.clone();
        unsettle(&mut open).unwrap();
        let said = |state: &BlockState| state.properties().len();
        let count = |grid: &Grid| grid.bounds().cells().map(|cell| said(grid.get(cell))).sum::<usize>();
        assert!(count(&open) <= count(&house));
        settle(&mut open).unwrap();
        assert_eq!(differences(&house, &open), [], "{}", file.display());
    }
}

#[test]
fn houses_need_no_mending_but_where_the_game_would_mend_them() {
    let Some(folder) = folder() else { return };
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for file in files(&folder) {
        let house = house(&file);
        let mut mended = house.clone();
        mend(&mut mended).unwrap();
        for cell in differences(&house, &mended) {
            *kinds.entry(kind(&house, cell)).or_default() += 1;
        }
    }
    assert_eq!(kinds.into_iter().collect::<Vec<_>>(), OUT_OF_DATE);
}
