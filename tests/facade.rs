//! Facades: layouts read and refused, grammars that give them back, and other sizes with every window whole.

#[path = "common/layouts.rs"]
mod layouts;
#[path = "common/real.rs"]
mod real;
#[path = "common/seed4.rs"]
mod seed4;

use proptest::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use vox::facade::{
    self, Drawing, Form, Learnt, Meanings, Method, Near, Options, Roof, Scale, Stretch, Variety, What,
    is_wall,
};
use vox::grammar;
use vox::graph::{Expr, OpGraph, lower, raise};
use vox::io::{Colours, Limits, decode_layout};
use vox::run::{self, Library};
use vox::space::Cell;

fn learnt(drawing: &Drawing, options: &Options) -> Learnt {
    facade::infer(std::slice::from_ref(drawing), options).unwrap()
}

/// What the text of a grammar says, from the facade on.
fn read_back(learnt: &Learnt) -> OpGraph {
    let checked = grammar::read(&raise(&learnt.graph).to_string()).unwrap();
    lower(&checked, Some(&facade::facade_label(0))).unwrap()
}

fn reproduced(learnt: &Learnt) -> usize {
    learnt.reproduced(0, &read_back(learnt), &Library::new()).unwrap()
}

/// The labels and sizes of all that is not wall, at a size.
fn hard_leaves(learnt: &Learnt, graph: &OpGraph, [width, height]: [u32; 2]) -> BTreeSet<(String, i32, i32)> {
    let labels = learnt.facades[0].layout.labels();
    let mut graph = graph.clone();
    for (constant, label) in graph.constants.iter_mut().zip(labels) {
        constant.value = Expr::name(label.as_str());
    }
    let hard = labels.iter().zip(&learnt.meant.list).filter(|(_, meaning)| {
        meaning.stretch == Stretch::Hard && !matches!(meaning.what, What::Door { .. })
    });
    let hard: BTreeSet<&String> = hard.map(|(label, _)| label).collect();
    let size = Cell::new(width as i32, height as i32, learnt.depth.total() as i32);
    let options = run::Options { size: Some(size), ..run::Options::default() };
    let boxes = run::run_boxes(&graph, &options).unwrap().made;
    let sizes = boxes.into_iter().filter(|leaf| hard.contains(&leaf.label)).map(|leaf| {
        let size = leaf.bounds.size();
        (leaf.label, size.x, size.y)
    });
    sizes.collect()
}

/// At these shares of its own size a facade has no window that it does not have at its own.
fn stays_whole(learnt: &Learnt, shares: impl IntoIterator<Item = [f64; 2]>) {
    let graph = read_back(learnt);
    let own = learnt.facades[0].layout.size();
    let drawn = hard_leaves(learnt, &graph, own);
    for [across, up] in shares {
        let size = [(f64::from(own[0]) * across) as u32, (f64::from(own[1]) * up) as u32]
            .map(|length| length.max(1));
        let there = hard_leaves(learnt, &graph, size);
        assert!(there.is_subset(&drawn), "{size:?}: {:?}", there.difference(&drawn).collect::<Vec<_>>());
    }
}

fn xml(path: &Path) -> Drawing {
    let bytes = fs::read(path).unwrap();
    decode_layout(&bytes, None, &|_| false, &Limits::default()).unwrap()
}

/// The layouts of seed 4.
fn real_layouts() -> Vec<PathBuf> {
    let Some(folder) = real::folder() else { return Vec::new() };
    let entries = fs::read_dir(folder.join("facades")).unwrap().map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|ending| ending == "xml")).collect();
    paths.sort();
    paths
}

#[test]
fn real_layouts_come_back_leaf_for_leaf() {
    for path in real_layouts() {
        let drawing = xml(&path);
        for method in [Method::Greedy, Method::Searched] {
            let learnt = learnt(&drawing, &Options { method, ..Options::default() });
            assert_eq!(reproduced(&learnt), drawing.areas.len(), "{}", path.display());
        }
    }
}

#[test]
fn real_layouts_stretch_with_every_window_whole() {
    for path in real_layouts() {
        let learnt = learnt(&xml(&path), &Options::default());
        let shares = [0.1, 0.3, 0.5, 0.8, 0.99, 1.01, 1.5, 2.0, 3.7];
        stays_whole(&learnt, shares.into_iter().flat_map(|across| shares.map(|up| [across, up])));
    }
}

#[test]
fn the_groups_of_the_high_rise_are_those_that_seed_4_counts() {
    for path in real_layouts().into_iter().filter(|path| path.ends_with("high_rise.xml")) {
        let drawing = xml(&path);
        let learnt = learnt(&drawing, &Options::default());
        let facade = &learnt.facades[0];
        assert_eq!((drawing.areas.len(), facade.layout.labels().len()), (357, 15));
        assert_eq!((facade.counts.structures, facade.counts.groups), (229, 1533));
    }
}

#[test]
fn rules_are_fewer_and_shorter_than_those_of_seed_4() {
    let Some(folder) = real::folder() else { return };
    for (layout, theirs) in [("Layout.xml", "Layout.txt"), ("NR07031_basic.xml", "NR07031.txt")] {
        let theirs = seed4::rules(&fs::read_to_string(folder.join("facades").join(theirs)).unwrap());
        let ours = learnt(&xml(&folder.join("facades").join(layout)), &Options::default());
        let ours = &ours.facades[0].rules;
        assert!(
            ours.list.len() < theirs.list.len(),
            "{layout}: {} of {}",
            ours.list.len(),
            theirs.list.len()
        );
        assert!(ours.length() < theirs.length(), "{layout}: {} of {}", ours.length(), theirs.length());
    }
}

/// What a case comes to: the message of an error, or the grammar.
fn case(path: &Path) -> String {
    let beside = |ending: &str| fs::read_to_string(path.with_extension(ending)).ok();
    let colours: Option<Colours> = match beside("colours").map(|text| text.parse()).transpose() {
        Ok(colours) => colours,
        Err(error) => return format!("{error}\n"),
    };
    let meanings: Meanings = match beside("labels").unwrap_or_default().parse() {
        Ok(meanings) => meanings,
        Err(error) => return format!("{error}\n"),
    };
    let wall = |label: &str| is_wall(label, &meanings);
    let drawing = match decode_layout(&fs::read(path).unwrap(), colours.as_ref(), &wall, &Limits::default()) {
        Ok(drawing) => drawing,
        Err(error) => return format!("{error}\n"),
    };
    let scale = beside("width").map_or(Scale::Fitting, |width| Scale::Width(width.trim().parse().unwrap()));
    let options = Options { meanings: meanings.clone(), scale, ..Options::default() };
    match facade::infer(&[drawing], &options) {
        Ok(learnt) => raise(&learnt.graph).to_string(),
        Err(error) => format!("{error}\n"),
    }
}

fn cases(folder: &str, ending: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/facade").join(folder);
    let mut paths: Vec<PathBuf> = fs::read_dir(root).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "xml" || ending == "png"));
    paths.sort();
    assert!(!paths.is_empty());
    for path in paths {
        let (told, expected) = (case(&path), path.with_extension(ending));
        if std::env::var_os("SNAPSHOTS").is_some_and(|value| value == "overwrite") {
            fs::write(&expected, &told).unwrap();
        }
        assert_eq!(told, fs::read_to_string(&expected).unwrap_or_default(), "{}", path.display());
    }
}

#[test]
fn good_layouts_become_these_grammars() {
    cases("ok", "grammar");
}

#[test]
fn bad_layouts_are_refused_in_these_words() {
    cases("err", "stderr");
}

#[test]
fn a_building_has_the_facade_on_all_sides() {
    let drawing = layouts::rows(3, 2);
    for roof in [Roof::Flat, Roof::Gable, Roof::Hip, Roof::Mansard, Roof::Pyramid] {
        let learnt = learnt(&drawing, &Options { form: Form::Building(roof), ..Options::default() });
        assert_eq!(reproduced(&learnt), drawing.areas.len());
        let checked = grammar::read(&raise(&learnt.graph).to_string()).unwrap();
        let graph = lower(&checked, None).unwrap();
        let grid = run::run(&graph, &Library::new(), &run::Options::default()).unwrap().made;
        let glass = grid.counts().into_iter().find(|(state, _)| state.short_name() == "glass");
        let [width, height] = learnt.facades[0].layout.size();
        let window = hard_leaves(&learnt, &read_back(&learnt), [width, height]);
        let area: i32 = window.iter().map(|(_, width, height)| width * height).sum();
        assert_eq!(glass.map(|(_, count)| count), Some(4 * 6 * area as u64), "{roof:?}");
    }
}

#[test]
fn several_layouts_become_one_grammar() {
    let drawings = [layouts::rows(3, 2), layouts::rows(2, 4)];
    let learnt = facade::infer(&drawings, &Options::default()).unwrap();
    let checked = grammar::read(&raise(&learnt.graph).to_string()).unwrap();
    for (number, drawing) in drawings.iter().enumerate() {
        let graph = lower(&checked, Some(&facade::facade_label(number))).unwrap();
        assert_eq!(learnt.reproduced(number, &graph, &Library::new()).unwrap(), drawing.areas.len());
    }
}

#[test]
fn parts_of_one_size_are_exchanged_by_chance() {
    let mut drawing = layouts::rows(4, 3);
    let windows = drawing.areas.iter_mut().filter(|area| area.label == "window");
    windows.step_by(3).for_each(|area| area.label = "window2".to_owned());
    let learnt = learnt(&drawing, &Options { variety: Variety::Exchanged, ..Options::default() });
    let mut graph = read_back(&learnt);
    let made = |seed| {
        let options = run::Options { seed, ..run::Options::default() };
        run::run(&graph, &Library::new(), &options).unwrap().made
    };
    assert!((1..9).any(|seed| !made(0).same_blocks(&made(seed))));
    assert!(made(3).same_blocks(&made(3)));
    graph.set_constant(facade::VARIETY, "0").unwrap();
    assert_eq!(learnt.reproduced(0, &graph, &Library::new()).unwrap(), drawing.areas.len());
}

#[test]
fn windows_that_were_drawn_alike_are_alike_in_blocks() {
    // Seven windows of 1.1 units, 0.83 apart: rounded line by line they would be two widths.
    let mut drawing = layouts::rows(7, 1);
    for area in &mut drawing.areas {
        for end in &mut area.sides[0] {
            *end *= 0.537;
        }
    }
    for width in [17, 23, 29, 31, 47] {
        let learnt = learnt(&drawing, &Options { scale: Scale::Width(width), ..Options::default() });
        let layout = &learnt.facades[0].layout;
        let windows = layout.leaves().iter().filter(|leaf| layout.labels()[leaf.label as usize] == "window");
        let widths: BTreeSet<u32> = windows.map(|leaf| leaf.region.len(facade::Side::X)).collect();
        assert_eq!(widths.len(), 1, "{width}: {widths:?}");
    }
}

#[test]
fn lines_stay_apart_where_they_are_told_to() {
    // Two rows that are a hair out of line.
    let mut drawing = layouts::rows(2, 2);
    let row: Vec<usize> =
        (6..drawing.areas.len()).filter(|at| drawing.areas[*at].sides[1][0] > 6.0).collect();
    for at in row {
        for end in drawing.areas[at].sides[0].iter_mut().filter(|end| **end > 0.0 && **end < 10.0) {
            *end += 0.01;
        }
    }
    let width =
        |near: Near| learnt(&drawing, &Options { near, ..Options::default() }).facades[0].layout.size()[0];
    let met = learnt(&drawing, &Options::default()).facades[0].met;
    assert_eq!((width(Near::Meet), met), (5, 4));
    assert!(width(Near::Apart) > 8);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_layout_comes_back(leaves in 1_usize..60, seed: u64) {
        let drawing = layouts::layout(leaves, seed);
        for method in [Method::Greedy, Method::Searched] {
            let learnt = learnt(&drawing, &Options { method, ..Options::default() });
            prop_assert_eq!(reproduced(&learnt), drawing.areas.len());
        }
    }

    #[test]
    fn searching_is_never_worse_than_being_greedy(leaves in 1_usize..60, seed: u64) {
        let drawing = layouts::layout(leaves, seed);
        let length = |method| learnt(&drawing, &Options { method, ..Options::default() }).facades[0].rules.length();
        prop_assert!(length(Method::Searched) <= length(Method::Greedy));
    }

    #[test]
    fn no_size_cuts_a_window(leaves in 2_usize..40, seed: u64, shares in prop::collection::vec([0.05..3.0, 0.05..3.0], 12)) {
        stays_whole(&learnt(&layouts::layout(leaves, seed), &Options::default()), shares);
    }

    #[test]
    fn the_same_layout_gives_the_same_text(leaves in 1_usize..40, seed: u64) {
        let text = || raise(&learnt(&layouts::layout(leaves, seed), &Options::default()).graph).to_string();
        prop_assert_eq!(text(), text());
    }

    #[test]
    fn leaves_tile_their_layout(leaves in 1_usize..60, seed: u64, width in 60_u32..400) {
        let options = Options { scale: Scale::Width(width), ..Options::default() };
        let Ok(learnt) = facade::infer(&[layouts::layout(leaves, seed)], &options) else { return Ok(()) };
        let layout = &learnt.facades[0].layout;
        let area = |sides: [[u32; 2]; 2]| sides.map(|[low, high]| u64::from(high - low)).iter().product::<u64>();
        let all: u64 = layout.leaves().iter().map(|leaf| area(leaf.region.sides)).sum();
        prop_assert_eq!(all, layout.size().map(u64::from).iter().product::<u64>());
        prop_assert_eq!(layout.size()[0], width);
    }

    #[test]
    fn damaged_layouts_are_refused_or_read(at in 0_usize..4000, byte: u8, cut in 0_usize..4000) {
        let mut bytes = fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/facade/ok/storeys.xml")).unwrap();
        let len = bytes.len();
        bytes[at % len] = byte;
        bytes.truncate(len - cut % 200);
        if let Ok(drawing) = decode_layout(&bytes, None, &|_| false, &Limits::default()) {
            let _ = facade::infer(&[drawing], &Options::default());
        }
    }
}
