//! What is carved out of a scope: parts tile it, each cell once.

use super::{boxes, graph, options};
use proptest::prelude::*;
use proptest::sample::select;
use std::collections::BTreeMap;
use vox::space::{Axis, Bounds, Cell};

/// The cells that some primitive fills, each with its name. No cell is filled twice.
fn cells(text: &str, size: [i32; 3]) -> Result<BTreeMap<[i32; 3], String>, TestCaseError> {
    let plot = Bounds::of_size(Cell::from(size));
    let mut cells = BTreeMap::new();
    let world = if text.contains("up z") { [size[0], size[2], size[1]] } else { size };
    for labelled in
        boxes(&graph(text), &options(world, 0)).map_err(|error| TestCaseError::fail(error.to_string()))?
    {
        prop_assert!(plot.contains_box(&labelled.bounds), "{:?} lies outside", labelled);
        for cell in labelled.bounds.cells() {
            let name = labelled.label.split('@').next().unwrap_or_default().to_owned();
            prop_assert_eq!(cells.insert(cell.to_array(), name), None, "{} is filled twice", cell);
        }
    }
    Ok(cells)
}

/// How a grammar begins: which axis is up, and a turn.
fn turned(is_z_up: bool, quarters: i32, body: &str) -> String {
    let (up, axis) = if is_z_up { ("up z\n", "z") } else { ("", "y") };
    format!("{up}a --> R({axis}, {}){{ {body} }}", 90 * quarters)
}

/// Along how many axes a cell is less than `depth` from an end.
fn ends(cell: [i32; 3], size: [i32; 3], depth: i32) -> usize {
    (0..3).filter(|&axis| cell[axis] < depth || size[axis] - 1 - cell[axis] < depth).count()
}

const LETTERS: [&str; 9] = [
    "shapeL(3, 2)",
    "shapeL(1, 4)",
    "shapeU(2, 3, 2)",
    "shapeT(3, 2)",
    "shapeT(2, 3)",
    "shapeH(2, 3, 3)",
    "shapeO(2)",
    "shapeO(1, 2, 3, 2)",
    "shapeRound()",
];

proptest! {
    #[test]
    fn components_tile_the_shell(
        size in [1..10i32, 1..10, 1..10], depth in 1..4i32, kind in 0..3usize, is_z_up: bool, quarters in 0..4,
    ) {
        let kind_name = ["f", "e", "v"][kind];
        let body = format!("comp({kind_name}, {depth}){{ all : I(stone) | inside : I(dirt) }}");
        let cells = cells(&turned(is_z_up, quarters, &body), size)?;
        for cell in Bounds::of_size(Cell::from(size)).cells() {
            let name = if ends(cell.to_array(), size, depth) > kind { "stone" } else { "dirt" };
            prop_assert_eq!(cells.get(&cell.to_array()).map(String::as_str), Some(name), "{}", cell);
        }
    }

    #[test]
    fn what_is_not_named_is_left_inside(
        size in [1..10i32, 1..10, 1..10], depth in 1..4i32, kind in select(&["f", "e", "v"][..]),
        names in proptest::sample::subsequence(vec!["top", "bottom", "front", "back", "left", "right", "north", "west", "side"], 1..5),
        quarters in 0..4,
    ) {
        let parts: Vec<String> = names.iter().map(|name| format!("{name} : I(stone)")).collect();
        let body = format!("comp({kind}, {depth}){{ {} | inside : I(dirt) }}", parts.join(" | "));
        let cells = cells(&turned(false, quarters, &body), size)?;
        prop_assert_eq!(cells.len() as i32, size.iter().product::<i32>());
    }

    #[test]
    fn strips_and_borders_tile_the_plan(size in [1..10i32, 1..5, 1..10], depth in 0..4i32, quarters in 0..4) {
        for body in [
            format!("setback({depth}){{ all : I(stone) | inside : I(dirt) }}"),
            format!("offset({depth}){{ border : I(stone) | inside : I(dirt) }}"),
        ] {
            let cells = cells(&turned(false, quarters, &body), size)?;
            for cell in Bounds::of_size(Cell::from(size)).cells() {
                let plan = Cell { y: depth, ..cell }.to_array();
                let name = if ends(plan, [size[0], 99, size[2]], depth) > 0 { "stone" } else { "dirt" };
                prop_assert_eq!(cells.get(&cell.to_array()).map(String::as_str), Some(name), "{}", cell);
            }
        }
    }

    #[test]
    fn a_letter_and_what_remains_tile_the_scope(
        size in [1..12i32, 1..3, 1..12], letter in select(&LETTERS[..]), quarters in 0..4, is_z_up: bool,
    ) {
        let body = format!("{letter}{{ shape : I(stone) | remainder : I(dirt) }}");
        let cells = cells(&turned(is_z_up, quarters, &body), size)?;
        prop_assert_eq!(cells.len() as i32, size.iter().product::<i32>());
    }

    #[test]
    fn components_tile_the_shell_of_a_letter(
        size in [1..14i32, 1..8, 1..14], depth in 1..4i32, letter in select(&LETTERS[..]), quarters in 0..4,
        is_z_up: bool, kind in select(&["f", "e", "v"][..]),
    ) {
        let of = |body: &str| turned(is_z_up, quarters, &format!("{letter}{{ shape : {body} }}"));
        let whole = cells(&of("I(stone)"), size)?;
        let parts = cells(&of(&format!("comp({kind}, {depth}){{ all : I(stone) | inside : I(dirt) }}")), size)?;
        prop_assert!(whole.keys().eq(parts.keys()));
        if kind == "f" {
            for (cell, name) in &parts {
                let is_out = |axis: Axis, step: i32| !whole.contains_key(&(Cell::from(*cell) + axis.unit() * step).to_array());
                let is_shell = Axis::ALL.iter().any(|axis| (-depth..=depth).any(|step| is_out(*axis, step)));
                prop_assert_eq!(name == "stone", is_shell, "{:?}", cell);
            }
        }
    }

    #[test]
    fn splits_moves_and_turns_heed_the_footprint(
        size in [4..12i32, 2..4, 4..12], letter in select(&LETTERS[..]), quarters in 0..4,
    ) {
        let of = |body: &str| format!("a --> {letter}{{ shape : {body} }}");
        let whole: Vec<_> = cells(&of("I(stone)"), size)?.into_keys().collect();
        for body in [
            "split(x){ 1 : I(stone) | ~1 : split(z){ ~1 : I(stone) | ~2 : I(stone) } }".to_owned(),
            "repeat(z, 2){ repeatN(x, 3){ I(stone) } }".to_owned(),
            format!("R(y, {}){{ split(z){{ ~1 : I(stone) | ~1 : I(stone) }} }}", 90 * quarters),
            "T(2, 0, -1){ T(-2, 0, 1){ I(stone) } }".to_owned(),
            "S('1, 1, '1){ S('1, 3, '1){ S('1, scope.sy, '1){ I(stone) } } }".replace("3", &size[1].to_string()),
        ] {
            prop_assert_eq!(&cells(&of(&body), size)?.into_keys().collect::<Vec<_>>(), &whole, "{}", body);
        }
    }
}

#[test]
fn each_face_is_named_by_its_side_its_direction_and_its_number() {
    let face = |quarters: i32, name: &str| {
        let text = turned(false, quarters, &format!("comp(f){{ {name} : I(stone) }}"));
        boxes(&graph(&text), &options([5, 4, 3], 0)).unwrap().remove(0).bounds
    };
    for (names, turned) in [
        (["top", "0", "0"], "top"),
        (["bottom", "1", "1"], "bottom"),
        (["front", "south", "2"], "left"),
        (["back", "north", "3"], "right"),
        (["left", "west", "4"], "back"),
        (["right", "east", "5"], "front"),
    ] {
        assert!(names.iter().all(|name| face(0, name) == face(0, names[0])), "{names:?}");
        assert_eq!(face(1, turned), face(0, names[0]), "the {turned} of a scope turned once");
        assert_eq!(face(1, names[1]), face(0, names[1]), "directions are those of the world");
    }
}

#[test]
fn what_says_most_names_a_part() {
    let text = "a --> comp(e){ all : I(dirt) | top : I(stone) | side : I(oak_log) | top.front : I(glass) | 4 : I(sand) }";
    let parts = boxes(&graph(text), &options([5, 4, 5], 0)).unwrap();
    let count = |name: &str| parts.iter().filter(|part| part.label.starts_with(name)).count();
    assert_eq!(["dirt", "stone", "oak_log", "glass", "sand"].map(count), [3, 3, 4, 1, 1]);
}

#[test]
fn flat_faces_grow_outwards() {
    let text = |up: &str, face: &str, size: &str| {
        format!("{up}a --> T(2, 2, 2){{ S(3, 3, 3){{ comp(f, 0){{ {face} : S({size}){{ I(stone) }} }} }} }}")
    };
    let grown = |face: &str, size: &str| {
        let boxes = boxes(&graph(&text("", face, size)), &options([7, 7, 7], 0)).unwrap();
        [boxes[0].bounds.min.to_array(), boxes[0].bounds.max.to_array()]
    };
    assert_eq!(grown("front", "'1, '1, 2"), [[2, 2, 5], [5, 5, 7]]);
    assert_eq!(grown("back", "'1, '1, 2"), [[2, 2, 0], [5, 5, 2]]);
    assert_eq!(grown("left", "'1, '1, 2"), [[0, 2, 2], [2, 5, 5]]);
    assert_eq!(grown("right", "2, '1, 1"), [[5, 2, 3], [6, 5, 5]]);
    assert_eq!(grown("top", "'1, 2, '1"), [[2, 5, 2], [5, 7, 5]]);
    assert_eq!(grown("bottom", "'1, 1, '1"), [[2, 2, 2], [5, 3, 5]]);
}

#[test]
fn flat_parts_can_be_divided_before_they_grow() {
    let text = "a --> T(0, 0, 0){ S(5, 3, 3){ comp(f, 0){ front : split(x){ ~1 : nil | 1 : S('1, '1, 1){ I(stone) } | ~1 : nil } } } }";
    let boxes = boxes(&graph(text), &options([5, 3, 4], 0)).unwrap();
    assert_eq!(boxes.iter().map(|one| one.bounds.min.to_array()).collect::<Vec<_>>(), [[2, 0, 3]]);
}

#[test]
fn walls_of_a_letter_face_outwards() {
    let text = "a --> shapeL(2, 2){ shape : comp(f){ side : split(x){ 1 : I(stone) | ~1 : nil } } }";
    let boxes = boxes(&graph(text), &options([6, 1, 5], 0)).unwrap();
    // Front, back from the front on, left, right from the front on: the left end of each, seen from outside.
    let starts: Vec<(String, [i32; 2])> =
        boxes.into_iter().map(|one| (one.label, [one.bounds.min.x, one.bounds.min.z])).collect();
    let expected = [
        ("stone", [0, 4]),
        ("stone@180", [5, 3]),
        ("stone@180", [1, 0]),
        ("stone@270", [0, 1]),
        ("stone@90", [1, 2]),
    ];
    assert_eq!(starts, expected.map(|(name, at)| (name.to_owned(), at)));
}

#[test]
fn parts_stand_in_the_order_of_the_text() {
    let text = "a --> comp(f){ left : I(stone) | top : I(dirt) | side : I(glass) }";
    let names: Vec<String> =
        boxes(&graph(text), &options([4, 4, 4], 0)).unwrap().into_iter().map(|one| one.label).collect();
    assert_eq!(names, ["stone@270", "dirt", "glass", "glass@180", "glass@90"]);
}
