//! What a grammar makes has a derivation under it, and a derivation gives what was parsed.

use super::{blocks, graph, options};
use proptest::collection::vec;
use proptest::prelude::*;
use vox::block::BlockState;
use vox::graph::{Expr, Op, OpGraph};
use vox::grid::Grid;
use vox::parse::{Choice, Derivation, Laws, Parser};
use vox::space::Cell;

const BLOCKS: [&str; 4] = ["stone", "dirt", "glass", "oak_log"];

proptest! {
    #[test]
    fn every_sample_has_a_derivation_that_gives_it(text in grammars(), size in sizes(), seed in 0..4u64) {
        let graph = graph(&text);
        if let Ok(grid) = blocks(&graph, &options(size, seed)) {
            for laws in [Laws::AsWritten, Laws::Widened] {
                let parsed = Parser::new(&graph, laws).parse(&grid);
                prop_assert!(parsed.is_ok(), "{text}\n{laws:?} {size:?} {seed} {:?}", parsed);
                assert_gives(&graph, &parsed.unwrap(), &grid)?;
            }
        }
    }

    #[test]
    fn what_is_changed_has_no_derivation_or_one_that_gives_it(
        text in grammars(), size in sizes(), seed in 0..4u64, at in 0..1000usize, block in 0..BLOCKS.len(),
    ) {
        let graph = graph(&text);
        if let Ok(mut grid) = blocks(&graph, &options(size, seed)) {
            let cell = grid.bounds().cells().nth(at % grid.bounds().volume() as usize).unwrap();
            let id = grid.intern(&BLOCKS[block].parse().unwrap()).unwrap();
            grid.set(cell, id);
            vox::neighbours::settle(&mut grid).unwrap();
            match Parser::new(&graph, Laws::AsWritten).parse(&grid) {
                Ok(derivation) => assert_gives(&graph, &derivation, &grid)?,
                Err(unexplained) => {
                    prop_assert!(unexplained.explained <= unexplained.cells);
                    // All but the changed cell can be explained: the nearest derivation differs in no more.
                    prop_assert!(unexplained.explained + 1 >= unexplained.cells, "{text} {unexplained:?}");
                    prop_assert_eq!(unexplained.region.volume(), 1, "{} {:?}", text, unexplained);
                }
            }
        }
    }
}

pub fn sizes() -> impl Strategy<Value = [i32; 3]> {
    [1..8i32, 1..6, 1..8]
}

pub fn grammars() -> impl Strategy<Value = String> {
    let rules = |label: &'static str, next: &'static str| {
        vec((operation(next), 1..4u32), 1..3).prop_map(move |rules| {
            rules.iter().map(|(body, weight)| format!("{label} --> {body} : {weight}\n")).collect::<String>()
        })
    };
    (rules("a", "b"), rules("b", "c"), rules("c", "I(stone)"))
        .prop_map(|(a, b, c)| format!("{a}{b}{c}unused(n) --> b\n").replace("unused(n) --> b\n", ""))
        .prop_filter("every label is used", |text| text.contains(" b ") && text.contains(" c "))
}

fn operation(next: &'static str) -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just(next.to_owned()),
        Just(next.to_owned()),
        (0..BLOCKS.len()).prop_map(|at| format!("I({})", BLOCKS[at])),
        Just("nil".to_owned()),
        Just(format!("R(y, pi/2){{ {next} }}")),
    ];
    let size = prop_oneof![
        (0..3u32).prop_map(|n| n.to_string()),
        (1..3u32).prop_map(|n| format!("randint({n}, {})", n + 2)),
        (1..4u32).prop_map(|n| format!("~{n}")),
        Just("~rand(0.5, 2)".to_owned()),
        Just("rand(0.4, 1.6)".to_owned()),
        Just("'0.3".to_owned()),
        Just("pick{ 1 : 1 | 2 : 3 }".to_owned()),
    ];
    let axis = prop_oneof![Just("x"), Just("y"), Just("z")];
    let part = (size, leaf.clone()).prop_map(|(size, leaf)| format!("{size} : {leaf}"));
    prop_oneof![
        (axis.clone(), vec(part, 1..4), leaf.clone()).prop_map(|(axis, parts, rest)| format!(
            "split({axis}){{ {} | ~1 : {rest} | ~1 : {rest} }}",
            parts.join(" | ")
        )),
        (axis.clone(), 1..4u32, leaf.clone())
            .prop_map(|(axis, n, leaf)| format!("repeat({axis}, {n}){{ {leaf} }}")),
        (axis, leaf.clone(), leaf).prop_map(|(axis, one, two)| {
            format!("split({axis}){{ {{ 1 : {one} | randint(1, 2) : {two} }}* | ~1 : {one} }}")
        }),
    ]
}

/// Puts the primitives of a derivation into a grid and compares.
fn assert_gives(graph: &OpGraph, derivation: &Derivation, grid: &Grid) -> Result<(), TestCaseError> {
    let mut made = Grid::new(grid.size());
    for step in &derivation.steps {
        prop_assert!(!matches!(step.choice, Choice::Other(_)));
        if let Op::Primitive { name: Expr::Thing(thing), .. } = graph.op(step.node) {
            let state = thing.block().unwrap().turned(step.scope.frame.turn);
            let id = made.intern(&state).unwrap();
            made.fill(step.scope.bounds, id);
        }
    }
    vox::neighbours::settle(&mut made).unwrap();
    prop_assert!(made.same_blocks(grid));
    Ok(())
}

fn made(text: &str, size: [i32; 3], seed: u64) -> (OpGraph, Grid) {
    let graph = graph(text);
    let grid = blocks(&graph, &options(size, seed)).unwrap();
    (graph, grid)
}

fn changed(grid: &Grid, cell: [i32; 3]) -> Grid {
    let mut grid = grid.clone();
    let id = grid.intern(&BlockState::new("bedrock").unwrap()).unwrap();
    grid.set(Cell::from(cell), id);
    grid
}

#[test]
fn the_draws_of_a_derivation_cost_what_their_chances_say() {
    let bits = |text: &str, size| {
        let (graph, grid) = made(text, size, 0);
        Parser::new(&graph, Laws::AsWritten).parse(&grid).unwrap().bits
    };
    assert_eq!(bits("a --> I(stone)", [3, 3, 3]), 0.0);
    assert_eq!(bits("a --> split(x){ randint(1, 4) : I(stone) | ~1 : I(dirt) }", [9, 1, 1]), 2.0);
    assert_eq!(bits("a --> I(stone) : 1\na --> I(stone) : 3", [1, 1, 1]), -(0.75f64.log2()));
    assert_eq!(bits("a --> I(pick{ 1 : stone | 1 : dirt })", [1, 1, 1]), 1.0);
    assert_eq!(bits("a --> I(mix{ 1 : stone | 1 : dirt })", [4, 1, 1]), 4.0);
    assert_eq!(bits("wall = pick{ 1 : stone | 1 : dirt }\na --> repeat(x, 1){ I(wall) }", [4, 1, 1]), 1.0);
    assert_eq!(
        bits(
            "a --> b(randint(1, 2))\nb(n) --> split(x){ n : I(stone) | ~1 : I(dirt) | n : I(stone) }",
            [9, 1, 1]
        ),
        1.0
    );
}

#[test]
fn rings_and_endless_rules_end() {
    let texts = [
        "a --> b\na --> I(stone)\nb --> a\nb --> I(dirt)",
        "a --> b(1)\nb(n) --> b(n + 1) : 0.5\nb(n) --> I(stone) : 0.5",
        "a --> split(x){ ~1 : a | ~1 : nil } : 0.1\na --> I(stone)",
    ];
    for text in texts {
        let graph = graph(text);
        let mut grid = Grid::new(Cell::new(6, 1, 1));
        let id = grid.intern(&BlockState::new("stone").unwrap()).unwrap();
        grid.fill(grid.bounds(), id);
        assert!(Parser::new(&graph, Laws::AsWritten).derives(&grid), "{text}");
        let other = changed(&grid, [0, 0, 0]);
        assert!(Parser::new(&graph, Laws::AsWritten).parse(&other).is_err(), "{text}");
    }
}

#[test]
fn a_search_that_takes_too_long_says_so() {
    let (graph, grid) = made(
        "a --> repeat(x, 1){ b }\nb --> split(y){ randint(1, 3) : I(stone) | ~1 : I(dirt) }",
        [9, 5, 1],
        0,
    );
    let unexplained = Parser::new(&graph, Laws::AsWritten).with_steps(2).parse(&grid).unwrap_err();
    assert_eq!(unexplained.reason.to_string(), "no derivation was found within 2 steps");
}

#[test]
fn the_smallest_region_is_the_one_that_was_changed() {
    let text = "
        a --> split(y){ 1 : I(cobblestone) | ~1 : walls | 1 : I(bricks) }
        walls --> split(x){ 1 : I(oak_log) | ~1 : repeat(x, 3){ bay } | 1 : I(oak_log) }
        bay --> split(x){ ~1 : I(oak_planks) | 1 : I(glass) | ~1 : I(oak_planks) } : 2
        bay --> I(oak_planks)";
    let (graph, grid) = made(text, [11, 5, 1], 1);
    let parser = Parser::new(&graph, Laws::AsWritten);
    assert!(parser.parse(&grid).is_ok());
    let unexplained = parser.parse(&changed(&grid, [4, 2, 0])).unwrap_err();
    assert_eq!((unexplained.region.min, unexplained.region.volume()), (Cell::new(4, 2, 0), 1));
    assert_eq!((unexplained.explained, unexplained.cells), (54, 55));
}

/// A door is painted, not filled: what differs of it was lost from the count.
#[test]
fn what_differs_of_a_painted_shape_is_not_explained() {
    let text = "
        a --> split(x){ ~1 : I(stone) | 1 : entry | ~1 : I(stone) }
        entry --> split(y){ 2 : I(door, spruce) | ~1 : I(stone) }";
    let (graph, grid) = made(text, [5, 3, 1], 0);
    let other = changed(&changed(&grid, [2, 0, 0]), [2, 1, 0]);
    let unexplained = Parser::new(&graph, Laws::AsWritten).parse(&other).unwrap_err();
    assert_eq!((unexplained.region.min, unexplained.region.max), (Cell::new(2, 0, 0), Cell::new(3, 2, 1)));
    assert_eq!((unexplained.explained, unexplained.cells), (13, 15));
}

#[test]
fn stretched_laws_are_kept_where_they_will_do() {
    let text = "a --> split(x){ 2 : I(stone) | 1 : I(dirt) | ~1 : b }\nb --> split(x){ 1 : I(dirt) | ~1 : I(glass) }";
    let graph = graph(text);
    let choices = |names: &[&str]| {
        let parsed = Parser::new(&graph, Laws::Stretched).parse(&row(names)).unwrap();
        parsed.steps.into_iter().map(|step| step.choice).collect::<Vec<Choice>>()
    };
    let kept = choices(&["stone", "stone", "dirt", "dirt", "glass"]);
    assert!(!kept.iter().any(|choice| matches!(choice, Choice::Stretched(_))), "{kept:?}");
    let longer = choices(&["stone", "stone", "dirt", "dirt", "dirt", "glass"]);
    let stretched = longer.iter().filter(|choice| matches!(choice, Choice::Stretched(_)));
    assert_eq!(stretched.count(), 1, "{longer:?}");
}

#[test]
fn stretched_laws_take_rules_whose_conditions_do_not_hold() {
    let graph = graph("a --> b\nb : scope.sx == 2 --> I(stone)\nb --> I(dirt)");
    let parsed = Parser::new(&graph, Laws::Stretched).parse(&row(&["stone", "stone", "stone"])).unwrap();
    assert!(parsed.steps.iter().any(|step| step.choice == Choice::StretchedAlternative(0)));
    assert!(!Parser::new(&graph, Laws::Widened).derives(&row(&["stone", "stone", "stone"])));
}

/// Blocks along x.
fn row(names: &[&str]) -> Grid {
    let mut grid = Grid::new(Cell::new(names.len() as i32, 1, 1));
    for (x, name) in names.iter().enumerate() {
        let id = grid.intern(&BlockState::new(name).unwrap()).unwrap();
        grid.set(Cell::new(x as i32, 0, 0), id);
    }
    grid
}

#[test]
fn widened_laws_take_any_length_in_the_same_order() {
    let graph = graph("a --> split(x){ 2 : I(stone) | randint(1, 2) : I(dirt) | ~1 : I(glass) }");
    let [exact, widened] = [Laws::AsWritten, Laws::Widened].map(|laws| Parser::new(&graph, laws));
    let longer = row(&["stone", "dirt", "dirt", "dirt", "glass"]);
    assert!(!exact.derives(&longer) && widened.derives(&longer));
    let other = row(&["dirt", "stone", "glass"]);
    assert!(!exact.derives(&other) && !widened.derives(&other));
}

#[test]
fn operations_in_one_scope_are_taken_apart() {
    let text = "
        a --> [ S('1, 1, '1){ I(grass_block) } T(0, 1, 0){ S('1, '0.5, '1){ comp(f){ side : wall } } } plants ]
        wall --> I(pick{ 1 : oak_planks | 1 : birch_planks })
        plants --> split(x){ 2 : nil | 1 : split(z){ 2 : nil | 1 : I(oak_log) | ~1 : nil } | ~1 : nil } : 1
        plants --> nil : 1";
    for seed in 0..8 {
        let (graph, grid) = made(text, [6, 4, 6], seed);
        let parser = Parser::new(&graph, Laws::AsWritten);
        let parsed = parser.parse(&grid);
        assert!(parsed.is_ok(), "{seed}: {parsed:?}");
        assert!(parsed.unwrap().steps.len() > 8);
        assert!(parser.parse(&changed(&grid, [0, 1, 0])).is_err());
    }
}
