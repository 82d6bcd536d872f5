//! What rules see of other shapes, and in which order they run.

use super::{SHORT, blocks, boxes, checked, graph, graph_of, options, row};
use proptest::prelude::*;
use vox::graph::OpGraph;
use vox::grid::Grid;
use vox::run::{Options, Overrun};
use vox::space::Cell;

/// Every priority, in rounds even where nothing is asked.
fn in_rounds(options: Options) -> Options {
    Options { detail: Some(u32::MAX), ..options }
}

fn made(text: &str, size: [i32; 3]) -> Grid {
    blocks(&graph(text), &options(size, 0)).unwrap()
}

fn name(grid: &Grid, cell: [i32; 3]) -> &str {
    grid.get(Cell::from(cell)).short_name()
}

fn asks(graph: &OpGraph) -> bool {
    let text = vox::graph::raise(graph).to_string();
    ["occ(", "visible(", "snap"].iter().any(|word| text.contains(word))
}

proptest! {
    #[test]
    fn rounds_make_what_is_made_without(grammar in checked::grammars(), seed in 0..9u64) {
        let graph = graph_of(grammar);
        prop_assume!(!asks(&graph));
        let options = Options { overrun: Overrun::Clip, limits: SHORT, ..options([9, 7, 8], seed) };
        let (plain, rounds) = (boxes(&graph, &options), boxes(&graph, &in_rounds(options)));
        prop_assert_eq!(plain.ok(), rounds.ok());
    }

    #[test]
    fn questions_end_and_have_one_answer(grammar in checked::grammars(), seed in 0..9u64) {
        let graph = graph_of(grammar);
        let options = Options { overrun: Overrun::Clip, ..options([9, 7, 8], seed) };
        let (one, two) = (boxes(&graph, &options), boxes(&graph, &options));
        prop_assert_eq!(one.ok(), two.ok());
    }
}

/// Two masses that meet, as in figure 8 of seed 2: tiles of their walls are windows where they are free.
const MASSES: &str = "
    lot --> [ S(9, 9, 9){ mass } T(6, 0, 3){ S(10, 6, 12){ mass } } ]
    mass --> comp(f){ side : wall }
    priority 2
    wall --> repeat(x, 3){ repeat(y, 3){ tile } }
    tile : occ(noparent) == none --> I(glass)
    tile : occ(noparent) == part --> I(bricks)
    tile : occ(noparent) == full --> nil
";

#[test]
fn tiles_keep_out_of_other_masses() {
    let grid = made(MASSES, [16, 9, 15]);
    assert_eq!(name(&grid, [1, 1, 8]), "glass", "the free front of the first mass");
    assert_eq!(name(&grid, [7, 1, 8]), "air", "its front inside of the second");
    assert_eq!(name(&grid, [7, 7, 8]), "glass", "and above it");
    assert_eq!(name(&grid, [6, 1, 13]), "glass", "the free side of the second");
    assert_eq!(name(&grid, [6, 1, 6]), "air", "its side inside of the first");
    assert_eq!(name(&grid, [9, 1, 3]), "bricks", "where its back leaves the first");
}

#[test]
fn a_distance_keeps_more_free() {
    let tiles = |distance: u32| {
        let text = format!(
            "lot --> split(x){{ 4 : repeat(x, 1){{ tile }} | 2 : nil | 1 : post }}
             post --> I(oak_log)
             tile : occ(post, {distance}) == none --> I(glass)
             tile : occ(post, {distance}) != none --> I(stone)"
        );
        row(&text, 7)
    };
    assert_eq!(tiles(2), "glass glass glass glass air air oak_log");
    assert_eq!(tiles(3), "glass glass glass stone air air oak_log");
    assert_eq!(tiles(4), "glass glass stone stone air air oak_log");
}

/// Floors of figure 10: the tower is derived first and its floors mark planes; those of the wing keep to them.
#[test]
fn floors_snap_to_those_of_the_tower() {
    let bands = |wing: &str| {
        let text = format!(
            "lot --> split(x){{ 2 : tower | ~1 : wing }}
             tower --> repeat(y, 4){{ [ snap(y) storey ] }}
             storey --> split(y){{ 1 : I(stone) | ~1 : I(glass) }}
             priority 2
             wing --> {wing}"
        );
        made(&text, [6, 12, 1])
    };
    let is_floor =
        |grid: &Grid, x: i32| -> Vec<i32> { (0..12).filter(|y| name(grid, [x, *y, 0]) == "stone").collect() };
    let loose = bands("repeat(y, 6){ storey }");
    assert_ne!(is_floor(&loose, 5), is_floor(&loose, 0));
    let snapped = bands("repeat(y, 6, snap){ storey }");
    assert_eq!(is_floor(&snapped, 5), [0, 4, 8]);
    let split = bands("split(y, snap){ 5 : storey | ~1 : storey | 5 : storey }");
    assert_eq!(is_floor(&split, 5), [0, 4, 8]);
    let inside = bands("local{ repeat(y, 6, snap){ storey } }");
    assert_eq!(is_floor(&inside, 5), is_floor(&loose, 5), "planes end at `local`");
}

/// Only the wall that faces the street has an entrance.
#[test]
fn an_entrance_faces_the_street() {
    let grid = made(
        "lot --> split(z){ ~1 : house | 3 : nil | 2 : street }
         street --> S('1, 1, '1){ pavement }
         pavement --> I(gravel)
         house --> comp(f){ side : wall }
         priority 2
         wall : visible(pavement) --> split(x){ ~1 : I(bricks) | 1 : I(oak_planks) | ~1 : I(bricks) }
         wall --> I(stone)
        ",
        [9, 5, 14],
    );
    assert_eq!(name(&grid, [4, 0, 8]), "oak_planks", "the front");
    assert_eq!(name(&grid, [0, 0, 8]), "bricks");
    for side in [[4, 0, 0], [0, 0, 4], [8, 0, 4]] {
        assert_eq!(name(&grid, side), "stone");
    }
}

#[test]
fn later_levels_stay_masses() {
    let text = "lot --> split(x){ 1 : I(stone) | ~1 : body }\npriority 2\nbody --> I(glass)";
    let at = |detail| {
        let options = Options { detail, ..options([3, 1, 1], 0) };
        name(&blocks(&graph(text), &options).unwrap(), [2, 0, 0]).to_owned()
    };
    assert_eq!([at(None), at(Some(1)), at(Some(2))], ["glass", "white_concrete", "glass"]);
    assert_eq!(row(text, 3), "stone glass glass");
}

#[test]
fn all_questions_of_a_level_have_one_answer() {
    // Each of two asks whether the other is there: neither is before the other.
    let text = "lot --> [ S(2, 1, 1){ one } T(1, 0, 0){ S(2, 1, 1){ two } } ]
                one : occ(two) == none --> I(glass)
                one : occ(two) != none --> I(stone)
                two : occ(one) == none --> I(glass)
                two : occ(one) != none --> I(bricks)";
    assert_eq!(row(text, 3), "stone bricks bricks");
    // The first level is done before the second asks: what was replaced is not active.
    let later = "lot --> [ S(2, 1, 1){ one } T(1, 0, 0){ S(2, 1, 1){ two } } ]
                 one --> nil
                 priority 2
                 two : occ(active) == none --> I(glass)
                 two : occ(active) != none --> I(bricks)";
    assert_eq!(row(later, 3), "air glass glass");
}
