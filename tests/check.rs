//! What users are told of a grammar: cases as data. Each `*.grammar` in `err`, `warn` and `run` has beside it the report
//! that it must get, as `*.stderr`. `SNAPSHOTS=overwrite cargo test --test check` writes them anew: read them.

use snapbox::cmd::{Command, cargo_bin};
use snapbox::{Assert, Data};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use vox::grammar::{Checked, Code, Diagnostic, load};
use vox::graph::lower;
use vox::run::{Library, Options, run};

/// The grammars of a folder beside this file, sorted.
fn cases(folder: &str) -> (PathBuf, Vec<String>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/check").join(folder);
    let names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.filter(|name| name.ends_with(".grammar")).collect();
    names.sort();
    assert!(!names.is_empty());
    (folder, names)
}

/// Runs vox in `folder` and compares what it says with the case's report.
fn reported(folder: &Path, name: &str, args: &[&str], exit: i32) {
    let run = Command::new(cargo_bin!("vox")).current_dir(folder).args(args).env("NO_COLOR", "1");
    let output = run.output().unwrap();
    assert_eq!(output.status.code(), Some(exit), "exit code for {name}");
    assert!(output.stdout.is_empty(), "{name} goes to standard output");
    let report = folder.join(name).with_extension("stderr");
    let told = String::from_utf8(output.stderr).unwrap();
    Assert::new().action_env("SNAPSHOTS").eq(told, Data::read_from(&report, None).raw());
}

#[test]
fn wrong_grammars_are_reported() {
    let (folder, names) = cases("err");
    for name in names {
        reported(&folder, &name, &["check", &name], 1);
    }
}

#[test]
fn doubtful_grammars_are_warned_of() {
    let (folder, names) = cases("warn");
    for name in names {
        reported(&folder, &name, &["check", &name], 0);
    }
}

#[test]
fn grammars_that_cannot_run_are_reported() {
    let (folder, names) = cases("run");
    let out = tempfile::tempdir().unwrap();
    let building = out.path().join("building.schem");
    for name in names {
        reported(&folder, &name, &["run", &name, "-o", building.to_str().unwrap()], 1);
        assert!(!building.exists(), "{name} left a file");
    }
}

#[test]
fn right_grammars_run_without_a_warning() {
    let (folder, names) = cases("ok");
    let out = tempfile::tempdir().unwrap();
    for name in names {
        let buildings = format!("{}/{{seed}}.schem", out.path().display());
        let args = ["run", &name, "-n", "5", "-o", &buildings];
        Command::new(cargo_bin!("vox"))
            .current_dir(&folder)
            .args(args)
            .assert()
            .success()
            .stderr_eq("wrote 5 files, [..]\n");
    }
}

/// Checks an example, in which `# --- walls.grammar` begins a file of that name.
fn read_example(text: &str) -> Result<Checked, Vec<Diagnostic>> {
    let mut files = text.split("# --- ");
    let root = files.next().unwrap_or(text);
    let others: BTreeMap<&str, &str> = files.filter_map(|file| file.split_once('\n')).collect();
    let fetch =
        |name: &str| others.get(name).map(|text| (*text).to_owned()).ok_or_else(|| "no such file".to_owned());
    load("example.grammar", root, &mut { fetch }).checked
}

/// The codes that are told of a grammar when it is checked and, where it can be, run.
fn told(text: &str) -> BTreeSet<Code> {
    let checked = match read_example(text) {
        Ok(checked) => checked,
        Err(found) => return found.iter().map(|finding| finding.code).collect(),
    };
    let mut codes: BTreeSet<Code> = checked.warnings.iter().map(|finding| finding.code).collect();
    // What takes parameters cannot start: that is told above.
    let Ok(graph) = lower(&checked, None) else { return codes };
    match run(&graph, &Library::new(), &Options::default()) {
        Ok(made) => codes.extend(made.warnings.iter().map(|warning| warning.error.kind.code())),
        Err(error) => drop(codes.insert(error.kind.code())),
    }
    codes
}

#[test]
fn every_explanation_shows_its_slip_and_puts_it_right() {
    for code in Code::ALL.iter().filter(|code| **code != Code::PaletteFull) {
        let explanation = code.explanation();
        assert!(told(explanation.wrong).contains(code), "{}: {:?}", code.id(), told(explanation.wrong));
        let mut left = told(explanation.right);
        // Examples of what is wrong in a text need no size to run at, and no files to run with.
        if code.id() < "E05" || code.id() > "W" {
            left.remove(&Code::NoStartSize);
        }
        left.remove(&Code::NoFile);
        assert!(left.is_empty(), "{}: the right example is told of as well: {left:?}", code.id());
    }
}

#[test]
fn codes_are_in_order_and_have_one_meaning() {
    let ids: Vec<&str> = Code::ALL.iter().map(|code| code.id()).collect();
    assert!(ids.is_sorted_by(|a, b| a < b));
    assert!(Code::ALL.iter().all(|code| Code::of_id(code.id()) == Some(*code)));
}
