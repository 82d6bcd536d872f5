//! The grammars printed in "Procedural Generation of Buildings", which define the language.

mod grammar_files;

use grammar_files::{GrammarFile, all_in, root};
use vox::grammar::{Code, check, parse};
use vox::graph::{lower, raise};
use vox::grid::Grid;
use vox::run::{Options, run};

const SEEDS: std::ops::Range<u64> = 0..6;

fn printed(name: &str) -> GrammarFile {
    GrammarFile::read(root().join("tests/seed1").join(name))
}

fn filled(grid: &Grid) -> usize {
    grid.bounds().cells().filter(|cell| !grid.get(*cell).is_air()).count()
}

#[test]
fn printed_grammars_run_at_two_sizes() {
    for file in all_in("tests/seed1") {
        let sizes = file.sizes();
        assert!(sizes.len() >= 2, "{} has {} sizes", file.name(), sizes.len());
        for (size, seed) in sizes.into_iter().flat_map(|size| SEEDS.map(move |seed| (size, seed))) {
            let grid = file.run(Some(size), seed).made;
            assert!(filled(&grid) > 0, "{} at {size} with seed {seed} is empty", file.name());
        }
    }
}

#[test]
fn printed_grammars_survive_printing_and_raising() {
    for file in all_in("tests/seed1") {
        let grammar = parse(&file.text).unwrap();
        assert_eq!(parse(&grammar.to_string()).as_ref(), Ok(&grammar), "{}", file.name());
        let graph = file.graph();
        let raised = check(raise(&graph)).unwrap();
        assert_eq!(lower(&raised, None).unwrap(), graph, "{}", file.name());
    }
}

#[test]
fn printed_grammars_are_warned_of_nothing_but_what_they_do_not_use() {
    for file in all_in("tests/seed1") {
        for warning in file.checked().warnings {
            let is_unused = matches!(warning.code, Code::Unreachable | Code::UnusedParameter);
            assert!(is_unused, "{}: {warning:?}", file.name());
        }
    }
}

#[test]
fn functions_but_rand_can_be_names() {
    let text = "floor = 4\nwall(max) --> split(y){ max : I(stone) | ~max(max, 1) : nil }\n";
    let grammar = parse(&format!("start --> wall(floor)\n{text}")).unwrap();
    assert!(check(grammar).is_ok());
    assert!(parse("rand = 4\nwall --> I(stone)").and_then(check).is_err());
}

#[test]
fn the_loop_is_the_same_as_repeat_n() {
    let printed = printed("rep-n.grammar");
    let again = parse("up z\nstart --> repeatN(x, 4){ I(rect) }").unwrap();
    let again = lower(&check(again).unwrap(), None).unwrap();
    for size in printed.sizes() {
        let options = Options { size: Some(size), ..Default::default() };
        let repeated = run(&again, &Default::default(), &options).unwrap().made;
        assert!(printed.run(Some(size), 0).made.same_blocks(&repeated));
    }
}
