//! The language reference is true: every example in it is parsed, checked and run.

use std::fs;
use std::path::Path;
use vox::grammar::read;
use vox::graph::lower;
use vox::run::{Library, Options, run};

/// The examples of the page, each with the line it starts on.
fn examples() -> Vec<(usize, String)> {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/language.md")).unwrap();
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
    let examples = examples();
    assert!(examples.len() > 10, "found only {} examples", examples.len());
    for (line, text) in examples {
        let fail = |why: String| -> ! { panic!("docs/language.md:{line}: {why}\n{text}") };
        let checked = read(&text).unwrap_or_else(|found| fail(format!("{found:?}")));
        assert!(checked.warnings.is_empty(), "docs/language.md:{line}: {:?}", checked.warnings);
        let graph = lower(&checked, None).unwrap_or_else(|error| fail(error.to_string()));
        for seed in 0..20 {
            let options = Options { seed, ..Options::default() };
            let made = run(&graph, &Library::new(), &options).unwrap_or_else(|error| fail(error.to_string()));
            let grid = made.made;
            let told: Vec<String> = made.warnings.iter().map(|warning| warning.error.to_string()).collect();
            assert!(told.is_empty(), "docs/language.md:{line}: {told:?}");
            assert!(grid.cells().iter().any(|id| *id != 0), "docs/language.md:{line}: nothing was placed");
        }
    }
}
