//! The grammars that come with vox, and the schematics made by them.

mod buildings;
mod grammar_files;

use grammar_files::{GrammarFile, all_in, root};
use vox::grammar::{check, parse};
use vox::graph::{lower, raise};
use vox::space::Cell;

const SEEDS: std::ops::Range<u64> = 0..6;

/// Grammars whose buildings people walk into.
const HOUSES: [&str; 4] = ["cottage", "garage", "better-roofs", "modern-house"];

fn ours() -> Vec<GrammarFile> {
    all_in("grammars")
}

fn house(name: &str) -> GrammarFile {
    GrammarFile::read(root().join("grammars").join(name).with_extension("grammar"))
}

/// Every size and seed to run a grammar at; its own size is drawn by the seed.
fn runs(file: &GrammarFile) -> Vec<(Option<Cell>, u64)> {
    let promised = file.sizes().into_iter().map(Some);
    let sizes: Vec<Option<Cell>> = std::iter::once(None).chain(promised).collect();
    sizes.into_iter().flat_map(|size| SEEDS.map(move |seed| (size, seed))).collect()
}

#[test]
fn printing_keeps_them() {
    for file in ours() {
        let grammar = parse(&file.text).unwrap();
        let printed = grammar.to_string();
        assert_eq!(parse(&printed).as_ref(), Ok(&grammar), "{}: {printed}", file.name());
    }
}

#[test]
fn raising_keeps_what_they_derive() {
    for file in ours() {
        let graph = file.graph();
        let raised = check(raise(&graph)).unwrap_or_else(|errors| panic!("{}: {errors:#?}", file.name()));
        assert!(lower(&raised, None).unwrap() == graph, "{}", file.name());
    }
}

#[test]
fn none_has_a_warning() {
    for file in ours() {
        let warnings = file.checked().warnings;
        assert!(warnings.is_empty(), "{}: {warnings:#?}", file.name());
    }
}

#[test]
fn all_run_at_their_own_size_and_at_two_others() {
    for file in ours() {
        assert!(file.sizes().len() >= 2, "{} promises too few sizes", file.name());
        for (size, seed) in runs(&file) {
            let made = file.run(size, seed);
            let at = format!("{} at {size:?} with seed {seed}", file.name());
            let warnings: Vec<String> =
                made.warnings.iter().map(|warning| warning.error.to_string()).collect();
            assert!(warnings.is_empty(), "{at}: {warnings:?}");
            assert!(made.made.same_blocks(&file.run(size, seed).made), "{at} is not the same twice");
        }
    }
}

#[test]
fn families_vary_with_the_seed() {
    for file in HOUSES.map(house) {
        let size = file.sizes()[0];
        let first = file.run(Some(size), SEEDS.start).made;
        let others = SEEDS.skip(1).filter(|&seed| !file.run(Some(size), seed).made.same_blocks(&first));
        assert!(others.count() >= 3, "{} looks the same with most seeds", file.name());
    }
}

#[test]
fn houses_are_sound() {
    for file in HOUSES.map(house) {
        for (size, seed) in runs(&file) {
            let grid = file.run(size, seed).made;
            let at = format!("{} at {size:?} with seed {seed}", file.name());
            assert!(buildings::doors(&grid) > 0, "{at} has no door");
            assert_eq!(buildings::half_doors(&grid), [], "{at} has half a door");
            assert_eq!(buildings::blocked_doors(&grid), [], "{at} has a door that cannot be walked through");
            assert_eq!(buildings::floating(&grid), [], "{at} has floating blocks");
            assert_eq!(buildings::unsupported(&grid), [], "{at} has blocks that hang on nothing");
            assert_eq!(buildings::half_beds(&grid), [], "{at} has half a bed");
            assert_eq!(buildings::exposed(&grid), [], "{at} has a room with a hole");
        }
    }
}

#[test]
fn the_cities_doors_open_and_nothing_floats() {
    let city = house("skyscraper-city");
    for size in city.sizes() {
        let grid = city.run(Some(size), 1).made;
        assert!(buildings::doors(&grid) > 10);
        assert_eq!(buildings::half_doors(&grid), []);
        assert_eq!(buildings::blocked_doors(&grid), []);
        assert_eq!(buildings::floating(&grid), []);
    }
}

/// By the commands in `grammars/README.md`.
#[test]
fn the_cottages_are_made_by_their_grammar() {
    let grammar = house("cottage");
    for seed in 1..=8 {
        let size = if seed <= 4 { [11, 9, 10] } else { [13, 10, 12] };
        let file = root().join(format!("schematics/cottage-{seed}.schem"));
        let made = grammar.run(Some(Cell::from(size)), seed).made;
        assert!(grammar_files::grid(&file).same_blocks(&made), "{} is out of date", file.display());
    }
}
