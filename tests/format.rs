//! The layout of grammars: all comments stay, in their order; a second time changes nothing; the grammar stays what it is.
//! `tests/format` holds grammars as people write them, and beside each the layout it gets, as `*.formatted`.
//! `SNAPSHOTS=overwrite cargo test --test format` writes the layouts anew: read them.

use proptest::prelude::*;
use snapbox::{Assert, Data};
use std::fs;
use std::path::{Path, PathBuf};
use vox::grammar::{format, parse, read};
use vox::graph::lower;

/// Every grammar of a folder and the folders in it, sorted.
fn grammars(folder: &Path) -> Vec<PathBuf> {
    let mut paths = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        match path.is_dir() {
            true => paths.extend(grammars(&path)),
            false if path.extension().is_some_and(|ending| ending == "grammar") => paths.push(path),
            false => {}
        }
    }
    paths.sort();
    paths
}

/// All grammars of the repository that can be read.
fn readable() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let paths = ["grammars", "tests"].map(|folder| grammars(&root.join(folder))).concat();
    let texts = paths.iter().map(|path| String::from_utf8_lossy(&fs::read(path).unwrap()).into_owned());
    let texts: Vec<String> = texts.filter(|text| parse(text).is_ok()).collect();
    assert!(texts.len() > 50);
    texts
}

/// The comments of a text without their markers.
fn comments(text: &str) -> Vec<&str> {
    text.lines().filter_map(comment_of).collect()
}

fn comment_of(line: &str) -> Option<&str> {
    let mut is_quoted = false;
    for (at, c) in line.char_indices() {
        match c {
            '"' => is_quoted = !is_quoted,
            '#' if !is_quoted => return Some(line[at + 1..].trim()),
            '/' if !is_quoted && line[at..].starts_with("//") => return Some(line[at + 2..].trim()),
            _ => {}
        }
    }
    None
}

/// That the layout of a grammar keeps all it should.
fn keeps(text: &str) -> String {
    let formatted = format(text).unwrap_or_else(|found| panic!("{found:?}\n{text}"));
    assert_eq!(comments(text), comments(&formatted), "\n{text}\n---\n{formatted}");
    assert_eq!(format(&formatted).as_ref(), Ok(&formatted), "\n{text}\n---\n{formatted}");
    if let Ok(before) = read(text) {
        let after = read(&formatted).unwrap_or_else(|found| panic!("{found:?}\n{formatted}"));
        assert!(lower(&before, None) == lower(&after, None), "\n{text}\n---\n{formatted}");
    }
    formatted
}

#[test]
fn every_grammar_keeps_its_comments_and_its_meaning() {
    readable().iter().for_each(|text| drop(keeps(text)));
}

#[test]
fn grammars_get_the_one_layout() {
    let cases = grammars(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/format"));
    assert!(cases.len() > 1);
    for path in cases {
        let formatted = keeps(&fs::read_to_string(&path).unwrap());
        let expected = Data::read_from(&path.with_extension("formatted"), None).raw();
        Assert::new().action_env("SNAPSHOTS").eq(formatted, expected);
    }
}

/// A grammar with comments behind some of the marks at which lines can break, and above some of its lines.
fn commented(text: &str, choices: &[u8]) -> String {
    let mut choices = choices.iter().cycle();
    let mut out = String::new();
    let mut number = 0;
    for line in text.lines() {
        let code = &line[..comment_of(line).map_or(line.len(), |_| line.find(['#', '/']).unwrap_or(0))];
        if *choices.next().unwrap() < 16 {
            number += 1;
            out += &format!("# above {number}\n");
        }
        for c in code.chars() {
            out.push(c);
            if "{|(},[".contains(c) && *choices.next().unwrap() < 24 {
                number += 1;
                out += &format!(" # inside {number}\n        ");
            }
        }
        if *choices.next().unwrap() < 24 {
            number += 1;
            out += &format!(" # behind {number}");
        }
        out.push('\n');
    }
    out
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Wherever comments stand, as long as the text is still a grammar.
    #[test]
    fn comments_anywhere_stay(at in any::<prop::sample::Index>(), choices in prop::collection::vec(any::<u8>(), 64..512)) {
        let texts = readable();
        let chosen: &String = at.get(&texts);
        let text = commented(chosen, &choices);
        if parse(&text).is_ok() {
            keeps(&text);
        }
    }
}
