//! Random choices belong to places: what they depend on, and what not.

use super::tiling::tilings;
use super::{blocks, boxes, graph, graph_of, options};
use proptest::prelude::*;
use vox::grammar::ast::*;
use vox::io::{SchemVersion, encode_schem};
use vox::run::{Options, Overrun};
use vox::space::Cell;

/// A block for every cell, drawn from three.
const NOISE: &str = "
    start --> repeat(x, 1){ repeat(y, 1){ repeat(z, 1){ any } } }
    any --> I(stone) : 2
    any --> I(dirt)
    any --> I(glass)
";

proptest! {
    #[test]
    fn the_same_seed_makes_the_same_bytes(grammar in tilings(), seed: u64) {
        let bytes = || {
            let options = Options { overrun: Overrun::Clip, ..options([9, 7, 8], seed) };
            encode_schem(&blocks(&graph_of(grammar.clone()), &options).unwrap(), SchemVersion::V2).unwrap().bytes
        };
        prop_assert_eq!(bytes(), bytes());
    }

    #[test]
    fn different_seeds_differ_somewhere(one: u64, two: u64) {
        prop_assume!(one != two);
        let graph = graph(NOISE);
        let make = |seed| blocks(&graph, &options([5, 5, 5], seed)).unwrap();
        prop_assert!(!make(one).same_blocks(&make(two)));
    }

    #[test]
    fn an_edit_leaves_the_rest_alone(kept in tilings(), old in tilings(), new in tilings(), seed in 0..99u64) {
        let beside = |other: &Grammar| {
            let start = "start --> split(x){ ~1 : edited_start | ~1 : kept_start }";
            let mut grammar = vox::grammar::parse(start).unwrap();
            grammar.rules.extend(prefixed(other, "edited"));
            grammar.rules.extend(prefixed(&kept, "kept"));
            let options = Options { overrun: Overrun::Clip, ..options([12, 5, 6], seed) };
            let boxes = boxes(&graph_of(grammar), &options).unwrap();
            boxes.into_iter().filter(|labelled| labelled.bounds.min.x >= 6).collect::<Vec<_>>()
        };
        prop_assert_eq!(beside(&old), beside(&new));
    }
}

/// The rules of a tiling under labels of their own.
fn prefixed(grammar: &Grammar, prefix: &str) -> Vec<Rule> {
    let text = grammar.to_string().replace("any", &format!("{prefix}_any"));
    let text = text.replace("start", &format!("{prefix}_start"));
    vox::grammar::parse(&text).unwrap().rules
}

#[test]
fn weights_are_frequencies() {
    let grid = blocks(&graph(NOISE), &options([20, 20, 20], 1)).unwrap();
    let stone = grid.bounds().cells().filter(|cell| grid.get(*cell).short_name() == "stone").count();
    // Half of 8,000, five standard deviations wide.
    assert!((3776..=4224).contains(&stone), "{stone} of 8000");
}

#[test]
fn a_constant_is_drawn_once_for_a_whole_run() {
    let text = "n = randint(1, 1000)\nstart --> repeat(x, 1){ cell }\ncell : n > 500 --> I(stone)\ncell : n <= 500 --> I(dirt)";
    for seed in 0..20 {
        let grid = blocks(&graph(text), &options([9, 1, 1], seed)).unwrap();
        assert_eq!(grid.palette().states().len(), 2, "air and one block");
        assert!(grid.bounds().cells().all(|cell| grid.get(cell) == grid.get(Cell::ZERO)));
    }
}

#[test]
fn parameters_are_values_not_draws() {
    // The argument is drawn once: both halves see the same number.
    let text = "
        start --> repeat(y, 1){ pair(randint(0, 1)) }
        pair(n) --> split(x){ ~1 : half(n) | ~1 : half(n) }
        half(n) : n == 0 --> I(stone)
        half(n) : n == 1 --> I(dirt)
    ";
    let grid = blocks(&graph(text), &options([2, 40, 1], 3)).unwrap();
    let names: Vec<&str> = (0..40)
        .map(|y| [0, 1].map(|x| grid.get(Cell::new(x, y, 0)).short_name()))
        .map(|[a, b]| {
            assert_eq!(a, b);
            a
        })
        .collect();
    assert!(names.contains(&"stone") && names.contains(&"dirt"));
}

#[test]
fn a_rule_that_is_not_used_changes_nothing() {
    let with = |extra: &str| {
        let text = format!("{NOISE}\n{extra}");
        blocks(&graph(&text), &options([6, 6, 6], 5)).unwrap()
    };
    assert!(with("").same_blocks(&with("unused --> I(bricks)")));
}
