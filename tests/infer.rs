//! Laws of inference: what was learnt derives every example, and runs.

#[path = "common/jumble.rs"]
mod jumble;
#[path = "common/real.rs"]
mod real;

use proptest::prelude::*;
use snapbox::assert_data_eq;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use vox::block::BlockState;
use vox::grammar::{Code, check, format};
use vox::graph::{OpGraph, dot, lower, raise};
use vox::grid::{Grid, LabelledBox, LabelledBoxes};
use vox::infer::{Example, Freedom, InferError, Labels, Method, infer};
use vox::io::{self, Content, Limits};
use vox::neighbours::settle;
use vox::parse::{Laws, Parser};
use vox::run::{Library, Options, run, run_boxes};
use vox::space::{Bounds, Cell};

fn graph_of(text: &str) -> OpGraph {
    let checked = check(text.parse().unwrap()).unwrap();
    // The thesis prints a rule that nothing reaches and a parameter that nothing reads, and houses may hold what vox does not know.
    let is_known = |code| matches!(code, Code::UnknownProperty | Code::Unreachable | Code::UnusedParameter);
    assert!(checked.warnings.iter().all(|warning| is_known(warning.code)), "{:?}", checked.warnings);
    lower(&checked, None).unwrap()
}

/// What the learnt grammar says as text, and the graph of that text.
fn learnt(examples: &[Example]) -> (String, OpGraph) {
    let learnt = infer(examples, Method::default(), Freedom::default()).unwrap();
    let text = raise(&learnt.graph).to_string();
    let read_back = graph_of(&text);
    assert_eq!(learnt.graph, read_back, "{text}");
    let with_comments = learnt.grammar().to_string();
    assert_eq!(graph_of(&with_comments), read_back, "{with_comments}");
    assert_eq!(format(&with_comments).unwrap(), with_comments, "as `vox fmt` lays it out");
    (text, read_back)
}

/// Whether there is a derivation of an example.
fn derives(graph: &OpGraph, labels: &Labels, example: &Example) -> bool {
    example.is_derived_by(&Parser::new(graph, Laws::AsWritten).with_labels(labels))
}

fn sample(graph: &OpGraph, seed: u64) -> Grid {
    let options = Options { seed, ..Options::default() };
    run(graph, &Library::new(), &options).unwrap_or_else(|error| panic!("seed {seed}: {error}")).made
}

/// Every block neighbourhood of 2 x 2 x 2 of a grid, by the names of the blocks.
fn neighbourhoods(grid: &Grid) -> BTreeSet<Vec<String>> {
    let corners = Bounds::of_size(grid.size() - Cell::ONE);
    let around = |corner: Cell| {
        let cells = Bounds::new(corner, corner + 2 * Cell::ONE).cells();
        cells.map(|cell| grid.get(cell).to_string()).collect()
    };
    corners.cells().map(around).collect()
}

/// Some of them leave to their neighbours how they join, others say it, whether it goes together or not.
const BLOCKS: [&str; 16] = [
    "air",
    "air",
    "air",
    "stone",
    "stone",
    "stone",
    "glass",
    "oak_stairs[facing=east]",
    "oak_stairs[facing=north]",
    "oak_stairs[facing=north,shape=outer_left]",
    "oak_fence",
    "oak_fence[east=true]",
    "stone_brick_wall[up=false]",
    "oak_door[half=lower]",
    "oak_door[half=upper,hinge=right]",
    "create:brass_casing",
];

fn grid(size: Cell, blocks: &[u8]) -> Grid {
    let mut grid = Grid::new(size);
    let ids: Vec<u16> = BLOCKS.iter().map(|name| grid.intern(&name.parse().unwrap()).unwrap()).collect();
    for (cell, block) in grid.bounds().cells().zip(blocks) {
        grid.set(cell, ids[usize::from(*block)]);
    }
    grid
}

fn grids() -> impl Strategy<Value = Grid> {
    (1..6i32, 1..6i32, 1..6i32).prop_flat_map(|(x, y, z)| {
        let volume = (x * y * z) as usize;
        prop::collection::vec(0..BLOCKS.len() as u8, volume)
            .prop_map(move |blocks| grid(Cell::new(x, y, z), &blocks))
    })
}

fn is_empty(grid: &Grid) -> bool {
    grid.bounds().cells().all(|cell| grid.get(cell).is_air())
}

/// The same cells with every property written out, as a run writes them.
fn settled(grid: &Grid) -> Vec<BlockState> {
    let mut grid = grid.clone();
    settle(&mut grid).unwrap();
    grid.bounds().cells().map(|cell| grid.get(cell).clone()).collect()
}

proptest! {
    #[test]
    fn one_example_is_given_back(grid in grids()) {
        prop_assume!(!is_empty(&grid));
        let (_, graph) = learnt(&[Example::Blocks(grid.clone())]);
        let again = sample(&graph, 0);
        prop_assert_eq!(settled(&again), settled(&grid));
    }

    #[test]
    fn every_example_is_derived_and_every_sample_runs(grids in prop::collection::vec(grids(), 1..5)) {
        prop_assume!(!grids.iter().any(is_empty));
        let examples: Vec<Example> = grids.into_iter().map(Example::Blocks).collect();
        let (text, graph) = learnt(&examples);
        for example in &examples {
            prop_assert!(derives(&graph, &Labels::new(), example), "{}", text);
        }
        for seed in 0..8 {
            sample(&graph, seed);
        }
    }

    #[test]
    fn what_differs_in_one_cell_is_not_derived(grid in grids(), at in 0..200usize) {
        prop_assume!(!is_empty(&grid));
        let (_, graph) = learnt(&[Example::Blocks(grid.clone())]);
        let mut other = grid;
        let cell = other.bounds().cells().nth(at % other.bounds().volume() as usize).unwrap();
        let id = other.intern(&BlockState::new("bedrock").unwrap()).unwrap();
        other.set(cell, id);
        prop_assert!(!derives(&graph, &Labels::new(), &Example::Blocks(other)));
    }
}

#[test]
fn storeys_are_exchanged_where_no_seam_is_new() {
    let house = |wall: &str, roof: &str| {
        let text = format!(
            "size(5, 6, 5)
             house --> split(y){{ 2 : I({wall}) | 2 : I(stone) | ~1 : I({roof}) }}"
        );
        Example::Blocks(sample(&graph_of(&text), 0))
    };
    let (_, graph) = learnt(&[house("oak_planks", "bricks"), house("birch_planks", "sandstone")]);
    let seen: BTreeSet<_> = ["oak_planks", "birch_planks"]
        .iter()
        .zip(["bricks", "sandstone"])
        .flat_map(|(wall, roof)| {
            let Example::Blocks(grid) = house(wall, roof) else { unreachable!() };
            neighbourhoods(&grid)
        })
        .collect();
    let samples: Vec<Grid> = (0..40).map(|seed| sample(&graph, seed)).collect();
    let distinct: BTreeSet<Vec<String>> =
        samples.iter().map(|grid| settled(grid).iter().map(BlockState::to_string).collect()).collect();
    assert_eq!(distinct.len(), 4);
    assert!(samples.iter().all(|grid| neighbourhoods(grid).is_subset(&seen)));
}

#[test]
fn houses_that_share_no_plan_become_longer_where_no_seam_is_new() {
    let house = |end: &str| {
        let text = format!(
            "size(6, 3, 3)
             house --> split(x){{ 1 : I(stone) | ~1 : I(glass) | 1 : I({end}) }}"
        );
        Example::Blocks(sample(&graph_of(&text), 0))
    };
    let examples = [house("bricks"), house("dirt")];
    let graph = infer(&examples, Method::Boxes, Freedom::Seen).unwrap().graph;
    let seen: BTreeSet<_> = examples
        .iter()
        .filter_map(|example| example.clone().into_grid())
        .flat_map(|grid| neighbourhoods(&grid))
        .collect();
    let samples: Vec<Grid> = (0..40).map(|seed| sample(&graph, seed)).collect();
    assert!(samples.iter().any(|grid| grid.size().x > 6));
    assert!(samples.iter().all(|grid| neighbourhoods(grid).is_subset(&seen)));
}

/// Two rooms with a slab of stone across each, further back in one of them: where the floor changes, it matters which.
#[test]
fn what_stands_otherwise_in_two_places_is_not_drawn_in_either() {
    let graph = graph_of(
        "size(7, 4, 10)
         house --> split(y){ 1 : split(z){ 4 : I(dirt) | ~1 : I(sand) } | ~1 : rooms }
         rooms --> split(x){ 3 : room(3) | 1 : I(bricks) | 3 : room(4) }
         room(n) --> split(z){ n : nil | 1 : I(stone) | ~1 : nil }",
    );
    let house = sample(&graph, 0);
    let shown = |freedom: Freedom| {
        let example = Example::Blocks(house.clone());
        let graph = infer(&[example.clone(), example], Method::Boxes, freedom).unwrap().graph;
        let samples: Vec<Grid> = (0..40).map(|seed| sample(&graph, seed)).collect();
        samples.iter().flat_map(neighbourhoods).collect::<BTreeSet<_>>()
    };
    assert_eq!(shown(Freedom::Seen), neighbourhoods(&house).into_iter().collect());
    assert!(shown(Freedom::Free).len() > shown(Freedom::Seen).len());
}

#[test]
fn with_freedom_a_mirrored_seam_is_as_good_as_another() {
    let house = || {
        let text = "size(4, 1, 1)
             house --> split(x){ 1 : I(bricks) | 1 : I(stone) | 1 : I(sand) | 1 : I(dirt) }";
        Example::Blocks(sample(&graph_of(text), 0))
    };
    let lengths = |freedom: Freedom| -> BTreeSet<i32> {
        let graph = infer(&[house(), house()], Method::Boxes, freedom).unwrap().graph;
        (0..40).map(|seed| sample(&graph, seed).size().x).collect()
    };
    assert_eq!(lengths(Freedom::Seen), BTreeSet::from([4]));
    assert!(lengths(Freedom::Free).contains(&6));
}

/// Each of two houses has one door, in the left or in the right half: exchanging the halves would leave a
/// house without a door, or one with two, though no seam would be new.
#[test]
fn what_every_example_has_once_every_sample_has_once() {
    let house = |front: &str| {
        let text = format!(
            "size(9, 5, 3)
             house --> split(y){{ ~1 : walls | 2 : I(bricks) }}
             walls --> split(z){{ ~1 : I(stone) | 1 : split(x){{ {front} }} }}
             door --> split(y){{ 2 : I(door) | ~1 : I(stone) }}"
        );
        sample(&graph_of(&text), 0)
    };
    let left = house("1 : I(stone) | 1 : door | ~1 : I(stone)");
    let right = house("~1 : I(stone) | 1 : door | 1 : I(stone)");
    let (_, graph) = learnt(&[Example::Blocks(left), Example::Blocks(right)]);
    let doors = |grid: &Grid| {
        grid.bounds().cells().filter(|cell| grid.get(*cell).get("half") == Some("lower")).count()
    };
    for seed in 0..20 {
        assert_eq!(doors(&sample(&graph, seed)), 1, "seed {seed}");
    }
}

#[test]
fn dense_graphs_are_drawn_as_tables_of_coloured_cells() {
    let storeys: String =
        (1..80).map(|width| format!("1 : split(x){{ {width} : I(stone) | ~1 : nil }} | ")).collect();
    let graph = graph_of(&format!("h --> split(y){{ {storeys}~1 : I(glass) }}"));
    let drawn = dot(&graph);
    assert!(drawn.contains("<BR/>stone</FONT></TD>"), "{drawn}");
    assert_eq!(drawn.matches("->").count(), 79, "only what is no terminal has an edge");
}

#[test]
fn texts_are_quoted_in_drawings() {
    let drawn = dot(&graph_of(r#"h --> I("foo\")"#));
    assert!(drawn.contains(r#"label="h\n\"foo\\\"""#), "{drawn}");
}

/// The labelled boxes of a grammar's first runs, as an example each.
fn runs(graph: &OpGraph, size: [i32; 3], count: u64) -> Vec<Example> {
    (0..count)
        .map(|seed| {
            let options = Options { seed, size: Some(Cell::from(size)), ..Options::default() };
            Example::Boxes(LabelledBoxes::new(run_boxes(graph, &options).unwrap().made).unwrap())
        })
        .collect()
}

/// Seed 1, section 12.1: from ten runs of the house with a garage, the rules say what the true ones say.
#[test]
fn the_house_with_a_garage_is_recovered() {
    let graph = graph_of(
        "up z
         plot --> split(x){ ~2 : house | ~1 : garage } : 0.5
         plot --> split(x){ ~1 : garage | ~2 : house } : 0.5
         house --> split(z){ ~2 : I(rect) | ~1 : I(triangle) }
         garage --> split(z){ ~rand(0.75, 1.25) : I(rect) | ~2 : nil }",
    );
    let examples = runs(&graph, [15, 10, 30], 10);
    let (text, graph) = learnt(&examples);
    assert!(examples.iter().all(|example| derives(&graph, &Labels::new(), example)));
    assert_data_eq!(text, snapbox::file!["infer/garage.grammar"]);
}

/// Labels that mean something else in the language, and labels that only differ in what a name cannot hold.
#[test]
fn any_label_can_be_learnt() {
    let labels = ["x", "nil", "rand", "stone", "a b", "a_b", "7", "rect", "white_concrete", "it's"];
    let boxes = labels.iter().zip(0..).map(|(label, at)| LabelledBox {
        label: (*label).to_owned(),
        bounds: Bounds::new(Cell::new(2 * at, 0, 0), Cell::new(2 * at + 2, 1, 1)),
    });
    let example = Example::Boxes(LabelledBoxes::new(boxes.collect()).unwrap());
    let learnt = infer(std::slice::from_ref(&example), Method::default(), Freedom::default()).unwrap();
    let text = raise(&learnt.graph).to_string();
    let graph = graph_of(&text);
    assert!(derives(&graph, &learnt.labels, &example), "{text}");
    assert!(text.contains("I(stone)"), "a label that is a block is that block: {text}");
    sample(&graph, 0);
}

/// Two small boxes a world apart: the space between them takes no memory.
#[test]
fn far_boxes_are_learnt() {
    let far = [0, 29_999_999].map(|at| LabelledBox {
        label: "rect".to_owned(),
        bounds: Bounds::new(Cell::splat(at), Cell::splat(at + 1)),
    });
    let example = Example::Boxes(LabelledBoxes::new(far.to_vec()).unwrap());
    let (_, graph) = learnt(std::slice::from_ref(&example));
    assert!(derives(&graph, &Labels::new(), &example));
}

/// Eighty houses that can be exchanged at four planes.
#[test]
fn many_exchangeable_examples_are_learnt_at_once() {
    let graph = graph_of(
        "size(3, 14, 3)
         h --> split(y){ 1 : v | 2 : I(stone) | 1 : v | 2 : I(stone) | 1 : v | 2 : I(stone) | 1 : v | ~1 : I(stone) }
         v --> I(bricks)
         v --> I(glass)
         v --> I(oak_planks)",
    );
    let examples: Vec<Example> = (0..80).map(|seed| Example::Blocks(sample(&graph, seed))).collect();
    let (_, graph) = learnt(&examples);
    assert!(examples.iter().all(|example| derives(&graph, &Labels::new(), example)));
}

/// Seed 1, sections 12.2 and 12.3, and its better roofs: the rules stay about as many as they were found to be.
#[test]
fn the_other_families_of_the_thesis_are_recovered() {
    let families = [
        ("better-roofs", [40, 30, 30], 10, 25),
        ("modern-house", [40, 30, 30], 10, 45),
        ("skyscraper-city", [128, 128, 64], 3, 40),
        ("skyscraper-city", [128, 128, 64], 10, 40),
    ];
    for (name, size, count, most) in families {
        let text =
            fs::read_to_string(format!("{}/tests/seed1/{name}.grammar", env!("CARGO_MANIFEST_DIR"))).unwrap();
        let examples = runs(&graph_of(&text), size, count);
        let (text, graph) = learnt(&examples);
        for example in &examples {
            assert!(derives(&graph, &Labels::new(), example), "{name}");
        }
        let rules = text.lines().filter(|line| line.contains("-->")).count();
        assert!(rules <= most, "{name}: {rules} rules");
    }
}

/// A proof is not made again of a text that says what was proved.
#[test]
fn what_is_proved_of_labelled_boxes_is_what_the_text_says() {
    let city = include_str!("seed1/skyscraper-city.grammar");
    let examples = runs(&graph_of(city), [128, 128, 64], 3);
    let learnt = infer(&examples, Method::Joint, Freedom::Seen).unwrap();
    assert!(learnt.is_proved);
    assert!(graph_of(&learnt.grammar().to_string()) == learnt.graph);
}

/// Labelled boxes of a random split tree.
fn jumbled(count: usize, seed: u64) -> Example {
    let (_, boxes) = jumble::jumble(count, seed);
    let labelled = |(number, (bounds, _)): (usize, &(Bounds, u32))| LabelledBox {
        label: ["rect", "window", "stone"][number % 3].to_owned(),
        bounds: *bounds,
    };
    Example::Boxes(LabelledBoxes::new(boxes.iter().enumerate().map(labelled).collect()).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn labelled_boxes_are_derived_and_every_sample_runs(jumbles in prop::collection::vec((1..120usize, 0..1000u64), 2..4)) {
        let examples: Vec<Example> = jumbles.iter().map(|(count, seed)| jumbled(*count, *seed)).collect();
        let (text, graph) = learnt(&examples);
        for example in &examples {
            prop_assert!(derives(&graph, &Labels::new(), example), "{}", text);
        }
        (0..20).for_each(|seed| drop(sample(&graph, seed)));
        prop_assert_eq!(learnt(&examples).0, text);
    }
}

#[test]
fn turned_primitives_are_learnt_turned() {
    let graph = graph_of("house --> split(x){ ~1 : I(corner) | ~1 : R(y, 90){ I(corner) } }");
    let (text, _) = learnt(&runs(&graph, [4, 2, 2], 1));
    assert_eq!(text, "size(4, 2, 2)\n\nhouse --> split(x){ ~1 : I(corner) | ~1 : R(y, 90){ I(corner) } }\n");
}

#[test]
fn examples_that_cannot_be_learnt_from_are_named() {
    let blocks = Example::Blocks(grid(Cell::ONE, &[3]));
    let boxes = runs(&graph_of("a --> I(rect)"), [1, 1, 1], 1).remove(0);
    assert_eq!(infer(&[], Method::default(), Freedom::default()).unwrap_err(), InferError::NoExample);
    assert_eq!(
        infer(
            &[blocks.clone(), Example::Blocks(Grid::new(Cell::ONE))],
            Method::default(),
            Freedom::default()
        )
        .unwrap_err(),
        InferError::Empty { example: 1 }
    );
    assert_eq!(
        infer(&[blocks, boxes], Method::default(), Freedom::default()).unwrap_err(),
        InferError::Mixed { example: 1 }
    );
}

fn family(folder: &Path) -> Vec<Example> {
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
        .iter()
        .filter(|path| path.extension().is_some_and(|ending| ending == "schem"))
        .map(|path| match io::read(path, &Limits::default()).unwrap().content {
            Content::Grid(grid) => Example::Blocks(grid),
            Content::Boxes(boxes) => Example::Boxes(boxes),
        })
        .collect()
}

#[test]
fn families_of_real_houses_are_reproduced_and_grow() {
    let Some(data) = real::folder() else { return };
    for folder in fs::read_dir(data.join("houses")).unwrap() {
        let folder = folder.unwrap().path();
        let examples = family(&folder);
        let (_, graph) = learnt(&examples);
        for (number, example) in examples.iter().enumerate() {
            assert!(derives(&graph, &Labels::new(), example), "{} {number}", folder.display());
        }
        for seed in 0..12 {
            sample(&graph, seed);
        }
    }
}

#[test]
fn a_real_house_alone_is_given_back_block_by_block() {
    let Some(data) = real::folder() else { return };
    for folder in fs::read_dir(data.join("houses")).unwrap() {
        let folder = folder.unwrap().path();
        for (number, example) in family(&folder).into_iter().enumerate() {
            let (_, graph) = learnt(std::slice::from_ref(&example));
            let Example::Blocks(house) = example else { panic!("{} {number}", folder.display()) };
            assert!(settled(&sample(&graph, 0)) == settled(&house), "{} {number}", folder.display());
        }
    }
}
