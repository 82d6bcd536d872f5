//! The documents are true: every example of a grammar in them is parsed, checked and run.

use std::fs;
use std::path::Path;
use vox::grammar::read;
use vox::graph::lower;
use vox::run::{Library, Options, run};

/// The examples of a page, each with the line it starts on.
fn examples(page: &str) -> Vec<(usize, String)> {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap();
    let mut examples: Vec<(usize, String)> = Vec::new();
    let mut is_inside = false;
    for (number, line) in page.lines().enumerate() {
        match line {
            "```grammar" => {
                examples.push((number + 2, String::new()));
                is_inside = true;
            }
            "```" => is_inside = false,
            line if is_inside => {
                let (_, text) = examples.last_mut().unwrap();
                *text += line;
                text.push('\n');
            }
            _ => {}
        }
    }
    examples
}

#[test]
fn every_example_runs() {
    for (page, least) in [("docs/language.md", 12), ("README.md", 1)] {
        let examples = examples(page);
        assert!(examples.len() >= least, "found only {} examples in {page}", examples.len());
        examples.iter().for_each(|(line, text)| runs(&format!("{page}:{line}"), text));
    }
}

/// Runs an example on several seeds: no error, no warning, and something stands there.
fn runs(place: &str, text: &str) {
    let checked = read(text).unwrap_or_else(|found| panic!("{place}: {found:?}"));
    assert!(checked.warnings.is_empty(), "{place}: {:?}", checked.warnings);
    let graph = lower(&checked, None).unwrap_or_else(|error| panic!("{place}: {error}"));
    for seed in 0..20 {
        let options = Options { seed, ..Options::default() };
        let made = run(&graph, &Library::new(), &options).unwrap_or_else(|error| panic!("{place}: {error}"));
        assert!(made.warnings.is_empty(), "{place}: {:?}", made.warnings);
        assert!(made.made.cells().iter().any(|id| *id != 0), "{place}: nothing was placed");
    }
}
