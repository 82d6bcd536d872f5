//! The command as users run it. Sessions and what they print stand in `tests/cli`, their input files beside them in
//! folders named `.in`; those in `.out` must be there afterwards, which proves that no input was changed.
//! `TRYCMD=overwrite cargo test --test cli` writes the output anew: read it.

use snapbox::cmd::{Command, cargo_bin};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;

#[test]
fn sessions() {
    let cases = trycmd::TestCases::new();
    cases.env("COLUMNS", "100").case("tests/cli/*.trycmd").case("tests/cli/*.toml");
}

fn vox(folder: &Path, args: &[&str]) -> Command {
    Command::new(cargo_bin!("vox")).current_dir(folder).args(args)
}

/// A folder with the grammar of a small tower in it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let tower = "size(3, 9, 3)\ntower --> repeat(y, 1){ layer }\nlayer --> I(stone)\nlayer --> I(dirt)\n";
    fs::write(folder.path().join("tower.grammar"), tower).unwrap();
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn the_same_seed_writes_the_same_bytes_anywhere() {
    let bytes = |seed: &str| {
        let folder = folder();
        vox(folder.path(), &["run", "tower.grammar", "--seed", seed, "-o", "a.schem"]).assert().success();
        fs::read(folder.path().join("a.schem")).unwrap()
    };
    assert_eq!(bytes("3"), bytes("3"));
    assert_ne!(bytes("3"), bytes("4"));
}

#[test]
fn a_run_of_many_is_many_runs_of_one() {
    let folder = folder();
    vox(folder.path(), &["run", "tower.grammar", "-n", "3", "-o", "{seed}.schem"]).assert().success();
    vox(folder.path(), &["run", "tower.grammar", "--seed", "2", "-o", "single.schem"]).assert().success();
    let read = |name| fs::read(folder.path().join(name)).unwrap();
    assert_eq!(read("2.schem"), read("single.schem"));
}

#[test]
fn a_building_passes_through_pipes() {
    let folder = folder();
    let made = vox(folder.path(), &["run", "tower.grammar", "-o", "-"]).output().unwrap();
    assert!(made.status.success() && made.stderr.is_empty());
    let told = vox(folder.path(), &["info", "-"]).stdin(made.stdout.clone()).output().unwrap();
    assert!(String::from_utf8(told.stdout).unwrap().contains("3 x 9 x 3"));
    let picture = vox(folder.path(), &["render", "-", "-o", "-"]).stdin(made.stdout).output().unwrap();
    assert!(picture.stdout.starts_with(b"\x89PNG"));
}

#[test]
fn a_failed_run_leaves_no_file() {
    let folder = folder();
    fs::write(folder.path().join("old.schem"), "kept").unwrap();
    vox(folder.path(), &["run", "tower.grammar", "--max-steps", "3", "-o", "old.schem"]).assert().code(1);
    vox(folder.path(), &["convert", "tower.grammar", "old.schem"]).assert().code(1);
    vox(folder.path(), &["render", "old.schem", "-o", "new.png"]).assert().code(1);
    assert_eq!(names(folder.path()), ["old.schem", "tower.grammar"]);
    assert_eq!(fs::read_to_string(folder.path().join("old.schem")).unwrap(), "kept");
}

#[test]
fn colours_are_for_terminals_and_can_be_turned_off() {
    let folder = folder();
    let check = || vox(folder.path(), &["check", "none.grammar"]).env_remove("NO_COLOR");
    let has_colour = |command: Command| command.output().unwrap().stderr.contains(&0x1b);
    assert!(!has_colour(check()));
    assert!(has_colour(check().env("CLICOLOR_FORCE", "1")));
    assert!(!has_colour(check().env("NO_COLOR", "1")));
}

#[test]
fn every_shell_gets_completions() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = vox(Path::new("."), &["completions", shell]).output().unwrap();
        assert!(script.status.success() && script.stderr.is_empty());
        let script = String::from_utf8(script.stdout).unwrap();
        assert!(["infer", "render", "schem-version"].iter().all(|word| script.contains(word)), "{shell}");
    }
    vox(Path::new("."), &["completions", "cobol"]).assert().code(2);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = folder();
    let mut child = std::process::Command::new(cargo_bin!("vox"))
        .current_dir(folder.path())
        .args(["graph", "tower.grammar"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty());
}

#[test]
fn a_watched_grammar_runs_again_when_a_file_of_it_changes() {
    let folder = tempfile::tempdir().unwrap();
    // At once, so that nobody sees half of a file.
    let write = |name: &str, text: &str| {
        fs::write(folder.path().join("new"), text).unwrap();
        fs::rename(folder.path().join("new"), folder.path().join(name)).unwrap();
    };
    write("house.grammar", "import \"parts.grammar\"\nsize(3, 3, 3)\nhouse --> part\n");
    write("parts.grammar", "part --> I(stone)\n");
    let mut child = std::process::Command::new(cargo_bin!("vox"))
        .current_dir(folder.path())
        .args(["run", "house.grammar", "-o", "house.schem", "--watch", "--rounds", "5"])
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines().map(Result::unwrap);
    let mut until = |end: &str| while !lines.next().expect(end).contains(end) {};
    until("watching 2 files");
    write("parts.grammar", "part --> split(y){ 1 : I(dirt) | ~1 : nil }\n");
    until("0 added, 18 removed, 9 changed");
    write("parts.grammar", "part --> walls\n");
    until("there is no rule for `walls`");
    write(
        "house.grammar",
        "import \"parts.grammar\"\nimport \"walls.grammar\"\nsize(3, 3, 3)\nhouse --> part\n",
    );
    until("cannot import `walls.grammar`");
    write("walls.grammar", "walls --> I(dirt)\n");
    until("18 added, 0 removed, 0 changed");
    assert!(child.wait().unwrap().success());
}

#[test]
fn a_designer_chooses_rules_and_the_choices_give_the_building_again() {
    let folder = folder();
    vox(folder.path(), &["run", "tower.grammar", "-o", "tower.schem"]).assert().success();
    let session = ["grow", "tower.schem", "--interactive", "-o", "mine.schem", "--save", "mine.json"];
    let told = vox(folder.path(), &session)
        .stdin("1\nlook\nundo\nmore\nback\nrandom\nfoo\n99\ndone\n")
        .output()
        .unwrap();
    let told = String::from_utf8(told.stdout).unwrap();
    for words in ["1 shape, ", "2 shapes, ", "`foo` is none of these", "there is no rule 99", "stone"] {
        assert!(told.contains(words), "`{words}` is missing in:\n{told}");
    }
    vox(folder.path(), &["grow", "tower.schem", "--replay", "mine.json", "-o", "again.schem"])
        .assert()
        .success();
    let read = |name| fs::read(folder.path().join(name)).unwrap();
    assert_eq!(read("mine.schem"), read("again.schem"));
}

#[test]
fn a_session_that_is_left_writes_nothing() {
    let folder = folder();
    vox(folder.path(), &["run", "tower.grammar", "-o", "tower.schem"]).assert().success();
    let session = ["grow", "tower.schem", "--interactive", "-o", "mine.schem"];
    vox(folder.path(), &session).stdin("1\nquit\n").assert().failure();
    assert!(!folder.path().join("mine.schem").exists());
}

#[test]
fn a_layout_and_a_building_pass_through_pipes_to_inference() {
    let folder = folder();
    let layout = fs::read("tests/cli/facade.in/layout.xml").unwrap();
    vox(folder.path(), &["infer", "-", "-o", "facade.grammar"]).stdin(layout).assert().success();
    let made = vox(folder.path(), &["run", "tower.grammar", "-o", "-"]).output().unwrap();
    vox(folder.path(), &["infer", "-", "-o", "learnt.grammar"]).stdin(made.stdout).assert().success();
    assert!(fs::read_to_string(folder.path().join("facade.grammar")).unwrap().contains("facade"));
    assert!(fs::read_to_string(folder.path().join("learnt.grammar")).unwrap().contains("size(3, 9, 3)"));
}
