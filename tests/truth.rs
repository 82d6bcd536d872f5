//! The known grammars that induction is measured by: what they have to be for the measure to mean something.

mod grammar_files;

use grammar_files::{GrammarFile, all_in};
use vox::grid::Grid;
use vox::run::{Library, Options, run};

fn samples(file: &GrammarFile, count: u64) -> Vec<Grid> {
    let graph = file.graph();
    let sample = |seed| {
        let options = Options { seed, ..Options::default() };
        run(&graph, &Library::new(), &options)
            .unwrap_or_else(|error| panic!("{}, seed {seed}: {error}", file.name()))
            .made
    };
    (0..count).map(sample).collect()
}

#[test]
fn they_are_small_buildings() {
    for file in all_in("tests/truth") {
        for grid in samples(&file, 50) {
            let volume = grid.bounds().volume();
            assert!((150..=2000).contains(&volume), "{}: {volume} cells", file.name());
            assert!(grid.cells().iter().any(|id| *id != 0), "{} is empty", file.name());
        }
    }
}

/// Twenty examples must not be nearly all that a grammar makes.
#[test]
fn they_make_more_than_is_shown() {
    for file in all_in("tests/truth") {
        let mut distinct: Vec<Grid> = Vec::new();
        for grid in samples(&file, 400) {
            if !distinct.iter().any(|known| known.same_blocks(&grid)) {
                distinct.push(grid);
            }
        }
        assert!(distinct.len() >= 60, "{}: {} buildings", file.name(), distinct.len());
    }
}

#[test]
fn they_have_no_warning_and_are_laid_out() {
    let files = all_in("tests/truth");
    assert!(files.len() >= 14);
    for file in files {
        let checked = file.checked();
        assert!(checked.warnings.is_empty(), "{}: {:?}", file.name(), checked.warnings);
        assert_eq!(vox::grammar::format(&file.text).unwrap(), file.text, "{}", file.name());
    }
}
