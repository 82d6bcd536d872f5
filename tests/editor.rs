//! The highlighting of editors knows the language.

use serde_json::Value;
use std::fs;
use std::path::Path;
use vox::grammar::reserved;

fn json(file: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/editor").join(file);
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// Every pattern below a value.
fn patterns(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            found.extend(fields.get("match").and_then(Value::as_str).map(str::to_owned));
            fields.values().for_each(|value| patterns(value, found));
        }
        Value::Array(values) => values.iter().for_each(|value| patterns(value, found)),
        _ => {}
    }
}

/// The words in brackets of a pattern: `\\b(a|b)\\b` has a and b.
fn words(pattern: &str) -> impl Iterator<Item = &str> {
    let groups = pattern.split('(').skip(1).filter_map(|rest| rest.split(')').next());
    groups.flat_map(|group| group.split('|'))
}

#[test]
fn every_word_of_the_language_has_a_colour() {
    let mut found = Vec::new();
    patterns(&json("vox.tmLanguage.json"), &mut found);
    let known: Vec<&str> = found.iter().flat_map(|pattern| words(pattern)).collect();
    let missing: Vec<&str> = reserved().filter(|word| !known.contains(word)).collect();
    assert!(reserved().count() > 40 && missing.is_empty(), "no pattern matches {missing:?}");
}

#[test]
fn every_pattern_that_is_named_is_there() {
    let grammar = json("vox.tmLanguage.json");
    let text = grammar.to_string();
    let named = text.split("\"include\":\"#").skip(1).filter_map(|rest| rest.split('"').next());
    for name in named {
        assert!(grammar["repository"].get(name).is_some(), "there is no {name}");
    }
}

#[test]
fn the_extension_names_its_files() {
    let contributes = &json("package.json")["contributes"];
    assert_eq!(contributes["grammars"][0]["scopeName"], json("vox.tmLanguage.json")["scopeName"]);
    for file in [&contributes["grammars"][0]["path"], &contributes["languages"][0]["configuration"]] {
        json(file.as_str().unwrap());
    }
}
