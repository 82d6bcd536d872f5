//! Grammars that import others: cases as data, a folder each. Beside `root.grammar` stands `whole.grammar`, which says the
//! same in one file, or, in the folder `wrong`, the report that it must get.
//! `SNAPSHOTS=overwrite cargo test --test imports` writes the reports anew: read them.

use snapbox::cmd::{Command, cargo_bin};
use snapbox::{Assert, Data};
use std::fs;
use std::path::{Path, PathBuf};
use vox::grammar::{Checked, load, read};
use vox::graph::{OpGraph, lower};

/// The folders of cases in a folder, sorted.
fn cases(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/imports").join(folder);
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut cases: Vec<PathBuf> = paths.filter(|path| path.join("root.grammar").exists()).collect();
    cases.sort();
    assert!(cases.len() > 3);
    cases
}

fn loaded(root: &Path) -> Checked {
    let text = fs::read_to_string(root).unwrap();
    let mut asked = Vec::new();
    let loaded = load(root.to_str().unwrap(), &text, &mut |name| {
        assert!(!asked.contains(&name.to_owned()), "{name} is read twice");
        asked.push(name.to_owned());
        fs::read_to_string(name).map_err(|error| error.to_string())
    });
    loaded.checked.unwrap_or_else(|found| panic!("{}: {found:?}", root.display()))
}

fn graph(checked: &Checked) -> OpGraph {
    lower(checked, None).unwrap()
}

#[test]
fn files_that_import_others_say_the_same_as_one_file() {
    for case in cases("") {
        let whole = read(&fs::read_to_string(case.join("whole.grammar")).unwrap()).unwrap();
        let checked = loaded(&case.join("root.grammar"));
        let name = case.display();
        assert!(checked.warnings.is_empty(), "{name}: {:?}", checked.warnings);
        assert_eq!(checked.first_label(), whole.first_label(), "{name}");
        assert!(graph(&checked) == graph(&whole), "{name}: {:#?}\n{:#?}", graph(&checked), graph(&whole));
    }
}

#[test]
fn wrong_imports_are_reported_at_their_places() {
    for case in cases("wrong") {
        let check = Command::new(cargo_bin!("vox")).current_dir(&case).env("NO_COLOR", "1");
        let output = check.args(["check", "root.grammar"]).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "exit code for {}", case.display());
        let report = Data::read_from(&case.join("root.stderr"), None).raw();
        Assert::new().action_env("SNAPSHOTS").eq(String::from_utf8(output.stderr).unwrap(), report);
    }
}

#[test]
fn a_text_alone_imports_nothing() {
    let found = read("import \"walls.grammar\"\na --> I(stone)\n").unwrap_err();
    assert!(found[0].message.contains("stands alone"), "{found:?}");
}

#[test]
fn styles_of_a_named_import_carry_its_name() {
    let root = "import \"walls.grammar\" as walls\na --> style(walls.dark){ walls.wall }\nstyle own { walls.block = dirt }\n";
    let walls = "block = stone\nstyle dark { block = deepslate }\nwall --> I(block)\n";
    let checked = load("root.grammar", root, &mut |_| Ok(walls.to_owned())).checked.unwrap();
    let mut graph = graph(&checked);
    graph.set_style("walls.dark").unwrap();
    assert!(graph.set_style("dark").is_err());
    assert_eq!(graph.constants[0].name, "walls.block");
    assert_eq!(
        graph.styles.iter().map(|style| style.name.as_str()).collect::<Vec<_>>(),
        ["own", "walls.dark"]
    );
}
