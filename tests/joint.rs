//! Joint induction: what it learns of known grammars from their samples.

mod grammar_files;

use grammar_files::{GrammarFile, all_in};
use snapbox::assert_data_eq;
use vox::grammar;
use vox::graph::{OpGraph, lower};
use vox::grid::Grid;
use vox::infer::{Example, Freedom, Learnt, Method, infer};
use vox::parse::{Laws, Parser};
use vox::run::{Library, Options, run};
use vox::score::{Agreement, Alphabet, Samples, Seams, agreement, unseen_seams};
use vox::space::Cell;

fn truth(name: &str) -> GrammarFile {
    let mut files = all_in("tests/truth").into_iter();
    files
        .find(|file| file.name() == format!("tests/truth/{name}.grammar"))
        .unwrap_or_else(|| panic!("there is no {name}"))
}

fn graph_of(text: &str) -> OpGraph {
    lower(&grammar::read(text).unwrap(), None).unwrap()
}

fn examples(graph: &OpGraph, count: usize) -> Vec<Grid> {
    examples_from(graph, 0, count)
}

fn examples_from(graph: &OpGraph, first_seed: u64, count: usize) -> Vec<Grid> {
    Samples::draw(graph, &Library::new(), first_seed, count).made
}

fn learnt(grids: &[Grid], freedom: Freedom) -> Learnt {
    let examples: Vec<Example> = grids.iter().cloned().map(Example::Blocks).collect();
    infer(&examples, Method::Joint, freedom).unwrap()
}

#[test]
fn every_example_is_reproduced() {
    for file in all_in("tests/truth") {
        let grids = examples(&file.graph(), 5);
        for freedom in [Freedom::Seen, Freedom::Free] {
            let graph = learnt(&grids, freedom).graph;
            let parser = Parser::new(&graph, Laws::AsWritten);
            assert!(grids.iter().all(|grid| parser.derives(grid)), "{}, {freedom:?}", file.name());
        }
    }
}

#[test]
fn samples_show_what_the_examples_show() {
    for file in all_in("tests/truth") {
        let grids = examples(&file.graph(), 5);
        show_only_what_is_in(&grids, &file.name());
    }
}

/// The outside is not air: a wall may stand at the end of a building only if one does in an example.
#[test]
fn samples_end_as_examples_do() {
    show_only_what_is_in(&examples_from(&truth("wing").graph(), 1_000_000, 5), "wing");
}

fn show_only_what_is_in(grids: &[Grid], name: &str) {
    let graph = learnt(grids, Freedom::Seen).graph;
    let samples = examples(&graph, 24);
    assert_eq!(samples.len(), 24, "{name}: some samples fail");
    let mut alphabet = Alphabet::default();
    let [samples, shown] = [&samples, grids].map(|grids| alphabet.all(grids));
    assert_eq!(unseen_seams(&samples, &Seams::of(&shown)), 0.0, "{name}");
}

/// How much of a grammar is learnt back from so many examples of it.
fn learnt_back(truth: &OpGraph, count: usize) -> Agreement {
    let grids = examples(truth, count);
    agreement(&learnt(&grids, Freedom::Seen).graph, truth, &Library::new(), &grids, 1000, 40)
}

/// Combinations of sizes that no example shows are barred, and nothing else changes for it.
#[test]
fn wings_are_learnt_from_few_examples() {
    let found = learnt_back(&truth("l-plan").graph(), 10);
    assert!(found.precision >= 0.95 && found.structural_recall >= 0.7, "{found:?}");
    assert!(10 * found.rules <= 13 * found.true_rules, "{found:?}");
}

/// A window in the middle of a wall is one step, however wide both are.
#[test]
fn gates_in_the_middle_are_learnt_from_three_examples() {
    let found = learnt_back(&truth("slab-gable").graph(), 3);
    assert!(found.precision >= 0.95 && found.recall >= 0.9, "{found:?}");
}

#[test]
fn materials_are_parameters() {
    let grids = examples(&truth("two-woods").graph(), 10);
    let graph = learnt(&grids, Freedom::Seen).graph;
    let text = vox::graph::raise(&graph).to_string();
    let called = |material: &str| text.lines().any(|line| line.contains(&format!("({material}_")));
    assert!(called("oak") && called("spruce"), "{text}");
    let rules = |material: &str| text.matches(&format!("I({material}_planks)")).count();
    assert_eq!((rules("oak"), rules("spruce")), (0, 0), "{text}");
}

/// A plot has one rule, wherever it stands, and one house for all materials.
#[test]
fn lots_between_streets_are_one_rule() {
    let truth = truth("town").graph();
    let grids = examples(&truth, 10);
    let learnt = learnt(&grids, Freedom::Seen);
    assert_eq!(learnt.by, Method::Joint);
    let found = agreement(&learnt.graph, &truth, &Library::new(), &grids, 1000, 40);
    assert!(found.precision >= 0.95 && found.recall >= 0.9, "{found:?}");
    assert!(2 * found.rules <= 3 * found.true_rules, "{found:?}");
}

/// Low towers stand in every lot but the one in the corner. The others are not told apart for that.
#[test]
fn what_no_example_has_in_one_place_is_not_made_there() {
    let truth = graph_of(
        "size(11, 8, 11)
         city --> split(x){ 5 : split(z){ 5 : corner | 1 : street | 5 : lot } | 1 : street | 5 : row }
         row --> split(z){ 5 : lot | 1 : street | 5 : lot }
         street --> split(y){ 1 : I(gray_concrete) | ~1 : nil }
         lot --> tower(bricks)
         lot --> tower(stone)
         lot --> split(y){ 2 : I(mud_bricks) | ~1 : nil }
         corner --> tower(bricks)
         corner --> tower(stone)
         tower(wall) --> split(y){ randint(4, 6) : I(wall) | ~1 : nil }",
    );
    let grids = examples(&truth, 16);
    let found = agreement(&learnt(&grids, Freedom::Seen).graph, &truth, &Library::new(), &grids, 1000, 60);
    assert!(found.precision == 1.0 && found.recall >= 0.6, "{found:?}");
}

#[test]
fn a_city_is_learnt_back_as_far_as_its_examples_show() {
    let found = learnt_back(&truth("city").graph(), 20);
    assert!(found.precision >= 0.95 && found.recall >= 0.7, "{found:?}");
    assert!(found.rules <= 2 * found.true_rules, "{found:?}");
}

/// From ten examples; how much of the rest is learnt is measured by `benches/induction.rs`.
#[test]
fn known_grammars_are_learnt_back() {
    for (name, least) in [
        ("tower", 0.95),
        ("turned", 0.95),
        ("cottage", 0.7),
        ("hip", 0.95),
        ("walls-by-axis", 0.9),
        ("wing", 0.8),
        ("two-woods", 0.8),
        ("gable", 0.95),
    ] {
        let truth = truth(name).graph();
        let grids = examples(&truth, 10);
        let learnt = learnt(&grids, Freedom::Seen);
        assert_eq!(learnt.by, Method::Joint);
        let Agreement { precision, recall, .. } =
            agreement(&learnt.graph, &truth, &Library::new(), &grids, 1000, 40);
        assert!(precision >= 0.95, "{name}: precision {precision}");
        assert!(recall >= least, "{name}: recall {recall}");
    }
}

/// A roof of courses is one rule that calls itself, and is right at depths that no example has.
#[test]
fn roofs_grow_with_their_houses() {
    let truth = truth("gable").graph();
    let graph = learnt(&examples(&truth, 10), Freedom::Seen).graph;
    let text = vox::graph::raise(&graph).to_string();
    assert!(text.contains("scope.sz > 2 -->"), "{text}");
    let parser = Parser::new(&truth, Laws::AsWritten);
    for depth in 4..=10 {
        let size = Some(Cell::new(8, 10, depth));
        let made = run(&graph, &Library::new(), &Options { size, seed: 1, ..Options::default() });
        assert!(parser.derives(&made.unwrap().made), "depth {depth}");
    }
}

/// Names, materials, storeys and comments, as people read them.
#[test]
fn a_tower_reads_well() {
    let grids = examples(&truth("tower").graph(), 10);
    let text = learnt(&grids, Freedom::Seen).grammar().to_string();
    assert_data_eq!(text, snapbox::file!["infer/tower.grammar"]);
}

/// A draw of the number of storeys gives the heights of the examples.
#[test]
fn storeys_are_set_by_one_constant() {
    let grids = examples(&truth("tower").graph(), 10);
    let mut graph = learnt(&grids, Freedom::Seen).graph;
    graph.set_constant("storeys", "7").unwrap();
    graph.set_constant("wall", "mossy_stone_bricks").unwrap();
    for tower in examples(&graph, 5) {
        assert_eq!(tower.size().y, 2 + 4 * 7);
        assert!(tower.palette().states().iter().all(|state| state.short_name() != "stone_bricks"));
    }
}

#[test]
fn the_same_examples_give_the_same_grammar() {
    let grids = examples(&truth("cottage").graph(), 5);
    let [one, other] = [0, 1].map(|_| vox::graph::raise(&learnt(&grids, Freedom::Seen).graph).to_string());
    assert_eq!(one, other);
}

#[test]
fn buildings_that_share_nothing_are_learnt_by_themselves() {
    let grids = ["tower", "garage", "clutter"].map(|name| examples(&truth(name).graph(), 1).remove(0));
    assert_eq!(learnt(&grids, Freedom::Seen).by, Method::Boxes);
    assert_eq!(learnt(&grids[..1], Freedom::Seen).by, Method::Boxes);
}
