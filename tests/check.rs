//! What users are told of a grammar: cases as data. Each `*.grammar` in `err` and `run` has beside it the report
//! that it must get, as `*.stderr`. `SNAPSHOTS=overwrite cargo test --test check` writes them anew: read them.

use snapbox::cmd::{Command, cargo_bin};
use snapbox::{Assert, Data};
use std::fs;
use std::path::{Path, PathBuf};

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
fn reported(folder: &Path, name: &str, args: &[&str]) {
    let run = Command::new(cargo_bin!("vox")).current_dir(folder).args(args).env("NO_COLOR", "1");
    let output = run.output().unwrap();
    assert_eq!(output.status.code(), Some(1), "exit code for {name}");
    assert!(output.stdout.is_empty(), "{name} goes to standard output");
    let report = folder.join(name).with_extension("stderr");
    let told = String::from_utf8(output.stderr).unwrap();
    Assert::new().action_env("SNAPSHOTS").eq(told, Data::read_from(&report, None).raw());
}

#[test]
fn wrong_grammars_are_reported() {
    let (folder, names) = cases("err");
    for name in names {
        reported(&folder, &name, &["check", &name]);
    }
}

#[test]
fn grammars_that_cannot_run_are_reported() {
    let (folder, names) = cases("run");
    let out = tempfile::tempdir().unwrap();
    let building = out.path().join("building.schem");
    for name in names {
        reported(&folder, &name, &["run", &name, "-o", building.to_str().unwrap()]);
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
