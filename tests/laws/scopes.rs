//! What each operation does to a scope.

use super::{blocks, boxes, graph, options, row};
use proptest::prelude::*;
use vox::grid::Grid;
use vox::space::{Bounds, Cell};

fn box_of(text: &str, size: [i32; 3]) -> [[i32; 3]; 2] {
    let boxes = boxes(&graph(text), &options(size, 0)).unwrap();
    assert_eq!(boxes.len(), 1);
    [boxes[0].bounds.min.to_array(), boxes[0].bounds.max.to_array()]
}

fn grid(text: &str, size: [i32; 3]) -> Grid {
    blocks(&graph(text), &options(size, 0)).unwrap()
}

fn state(text: &str) -> String {
    grid(text, [1, 1, 1]).get(Cell::ZERO).short().to_string()
}

#[test]
fn translating_moves_a_scope_along_its_axes() {
    let inner = |delta: &str| format!("a --> S(1, 1, 1){{ T({delta}){{ I(stone) }} }}");
    assert_eq!(box_of(&inner("2, 1, 3"), [5, 5, 5]), [[2, 1, 3], [3, 2, 4]]);
    assert_eq!(box_of("a --> S(2, 2, 2){ T('1, '0.5, 0){ I(stone) } }", [5, 5, 5]), [[2, 1, 0], [4, 3, 2]]);
    assert_eq!(
        box_of("a --> T(2, 0, 0){ S(2, 1, 1){ T(-1, 0, 0){ I(stone) } } }", [4, 4, 4]).map(|c| c[0]),
        [1, 3],
        "only what is placed has to lie inside the plot"
    );
}

#[test]
fn resizing_keeps_the_low_corner() {
    assert_eq!(box_of("a --> S(2, 3, 1){ I(stone) }", [5, 5, 5]), [[0, 0, 0], [2, 3, 1]]);
    assert_eq!(box_of("a --> S('0.5, '1, '0.2){ I(stone) }", [6, 5, 5]), [[0, 0, 0], [3, 5, 1]]);
    let smaller_then_larger = "a --> S(1, 1, 1){ S(3, 1, 1){ I(stone) } }";
    assert_eq!(box_of(smaller_then_larger, [4, 4, 4]), [[0, 0, 0], [3, 1, 1]]);
}

#[test]
fn a_scope_of_no_volume_is_skipped() {
    assert!(boxes(&graph("a --> S(0, 3, 3){ I(stone) }"), &options([4, 4, 4], 0)).unwrap().is_empty());
    assert_eq!(row("a --> split(x){ 0 : I(stone) | ~1 : I(dirt) }", 2), "dirt dirt");
}

#[test]
fn a_turn_takes_x_to_where_north_was() {
    // One quarter, counter-clockwise seen from above: the low end of x is the south end of the world.
    let text = "a --> R(y, pi/2){ split(x){ 1 : I(stone) | ~1 : I(dirt) } }";
    let grid = grid(text, [2, 1, 3]);
    let names = |z: i32| [0, 1].map(|x| grid.get(Cell::new(x, 0, z)).short_name().to_owned());
    assert_eq!(names(2), ["stone", "stone"]);
    assert_eq!(names(1), ["dirt", "dirt"]);
    assert_eq!(names(0), ["dirt", "dirt"]);
}

#[test]
fn a_turn_turns_the_blocks() {
    let turned = |angle: &str| state(&format!("a --> R(y, {angle}){{ I(oak_log[axis=x]) }}"));
    assert_eq!(turned("0"), "oak_log[axis=x]");
    assert_eq!(turned("pi/2"), "oak_log[axis=z]");
    assert_eq!(turned("90"), "oak_log[axis=z]");
    assert_eq!(turned("-pi"), "oak_log[axis=x]");
    let ladder = |angle: &str| state(&format!("a --> R(y, {angle}){{ I(ladder[facing=east]) }}"));
    let facing = ["0", "pi/2", "180", "3*pi/2"].map(ladder);
    let expected = ["east", "north", "west", "south"];
    for (found, facing) in facing.iter().zip(expected) {
        assert!(found.contains(&format!("facing={facing}")), "{found}");
    }
}

#[test]
fn four_turns_are_none() {
    let body = "split(x){ 1 : I(stone) | ~1 : split(z){ ~1 : I(oak_stairs[facing=east]) | 2 : I(dirt) } }";
    let four = format!("a --> R(y, 90){{ R(y, 90){{ R(y, 90){{ R(y, 90){{ {body} }} }} }} }}");
    assert!(grid(&four, [4, 2, 5]).same_blocks(&grid(&format!("a --> {body}"), [4, 2, 5])));
}

#[test]
fn lengths_are_those_of_the_turned_scope() {
    let text = "a --> R(y, pi/2){ b }\nb : scope.sx == 5 and scope.sz == 2 --> I(stone)";
    assert_eq!(box_of(text, [2, 1, 5]), [[0, 0, 0], [2, 1, 5]]);
}

#[test]
fn faces_share_out_the_shell() {
    let text = "a --> comp(f){ top : I(glass) | bottom : I(dirt) | front : I(stone) | back : I(bricks) | left : I(sand) | right : I(gravel) }";
    let size = [5, 4, 3];
    let boxes = boxes(&graph(text), &options(size, 0)).unwrap();
    let mut covered = Grid::new(Cell::from(size));
    for cell in boxes.iter().flat_map(|labelled| labelled.bounds.cells()) {
        assert_eq!(covered.id(cell), 0, "{cell} lies on two faces");
        covered.set(cell, 1);
    }
    let inside = Bounds::new(Cell::ONE, Cell::from(size) - Cell::ONE);
    assert!(covered.bounds().cells().all(|cell| (covered.id(cell) == 0) == inside.contains(cell)));
    let grid = grid(text, size);
    let name = |x, y, z| grid.get(Cell::new(x, y, z)).short_name();
    assert_eq!(
        [name(0, 3, 0), name(0, 0, 2), name(0, 1, 2), name(4, 1, 0)],
        ["glass", "dirt", "stone", "bricks"]
    );
    assert_eq!([name(0, 1, 1), name(4, 1, 1), name(2, 1, 1)], ["sand", "gravel", "air"]);
}

#[test]
fn faces_have_x_to_the_right_as_seen_from_outside() {
    let text = "a --> comp(f){ side : split(x){ 1 : I(stone) | ~1 : I(dirt) } }";
    let grid = grid(text, [4, 1, 4]);
    let at = |x, z| grid.get(Cell::new(x, 0, z)).short_name();
    // The left end of: the front (south), the back (north), the left (west) and the right side (east).
    assert_eq!([at(0, 3), at(3, 0)], ["stone", "stone"]);
    assert_eq!([at(0, 1), at(3, 2)], ["stone", "stone"]);
}

#[test]
fn repeats_share_out_evenly() {
    let row_of = |head: &str| row(&format!("a --> {head}{{ split(x){{ 1 : I(stone) | ~1 : I(dirt) }} }}"), 7);
    assert_eq!(row_of("repeatN(x, 3)"), "stone dirt stone dirt dirt stone dirt");
    assert_eq!(row_of("repeat(x, 3)"), row_of("repeatN(x, 3)"));
    assert_eq!(row_of("repeatN(x, 0)"), "air air air air air air air");
    assert_eq!(row("a --> repeat(x){ 2 : I(stone) }", 3), row("a --> repeat(x, 2){ I(stone) }", 3),);
}

#[test]
fn a_rhythm_is_repeated_as_often_as_it_fits() {
    let fence = "a --> split(x){ { 1 : I(stone) | 2 : I(glass) }* | 1 : I(stone) | ~1 : I(dirt) }";
    assert_eq!(row(fence, 5), "stone glass glass stone dirt");
    assert_eq!(row(fence, 8), "stone glass glass stone glass glass stone dirt");
    let nested = "a --> split(x){ { 1 : I(bricks) | { 1 : I(glass) }* }* | 1 : I(bricks) }";
    assert_eq!(row(nested, 5).split(' ').filter(|name| *name == "bricks").count(), 3);
}

proptest! {
    #[test]
    fn z_up_is_a_turn_of_y_up(size in [2..9i32, 2..9, 2..9], cut in [1..2u32, 1..2, 1..2], seed in 0..9u64) {
        let [a, b, c] = cut;
        // The text of the same rule with either axis up: `U` is up, `D` the depth.
        let text = |up: &str, upward: &str, depth: &str| format!("{up}
            start --> split(U){{ {a} : floor | ~1 : split(D){{ {b} : I(stone) | ~1 : any }} }}
            floor --> split(x){{ ~1 : I(bricks) | {c} : any }}
            any : scope.sD > 2 --> split(D){{ ~1 : I(glass) | ~1 : any }}
            any : scope.sD < 3 --> I(sand)
            any : scope.sD < 3 --> I(dirt)
        ").replace('U', upward).replace('D', depth);
        let [x, y, z] = size;
        let y_up = boxes(&graph(&text("up y", "y", "z")), &options([x, y, z], seed)).unwrap();
        let z_up = boxes(&graph(&text("up z", "z", "y")), &options([x, z, y], seed)).unwrap();
        // The depth of z-up runs north, against the game's z.
        let turned: Vec<_> = y_up.into_iter().map(|mut labelled| {
            let Bounds { min, max } = labelled.bounds;
            labelled.bounds = Bounds::new(Cell { z: z - max.z, ..min }, Cell { z: z - min.z, ..max });
            labelled
        }).collect();
        prop_assert_eq!(z_up, turned);
    }
}
