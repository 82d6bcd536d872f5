//! The module map holds: a module uses only those above it in `src/lib.rs`, and the map in the docs is that one.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The modules of the library in the order of `src/lib.rs`, from the bottom up.
fn modules() -> Vec<String> {
    let text = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    let names = text.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    names.map(str::to_owned).collect()
}

/// Every Rust file under a folder, sorted.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        match entry.path() {
            path if path.is_dir() => files.extend(sources(&path)),
            path if path.extension().is_some_and(|ending| ending == "rs") => files.push(path),
            _ => {}
        }
    }
    files.sort();
    files
}

/// The modules that a line names: after `crate::`, alone or in braces.
fn used(line: &str) -> impl Iterator<Item = &str> {
    line.match_indices("crate::").flat_map(|(at, prefix)| {
        let rest = &line[at + prefix.len()..];
        let list = rest.strip_prefix('{').map(|list| list.split(','));
        let single = list.is_none().then_some(rest);
        list.into_iter().flatten().chain(single).map(|path| {
            let path = path.trim_start();
            &path[..path.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(path.len())]
        })
    })
}

#[test]
fn modules_use_only_those_above_them() {
    let modules = modules();
    assert!(modules.len() > 9, "found only {modules:?} in src/lib.rs");
    let mut breaches = Vec::new();
    for (place, module) in modules.iter().enumerate() {
        for file in sources(&root().join("src").join(module)) {
            let text = fs::read_to_string(&file).unwrap();
            for (number, line) in text.lines().enumerate() {
                for name in used(line) {
                    if modules.iter().position(|other| other == name).is_some_and(|other| other > place) {
                        let file = file.strip_prefix(root()).unwrap().display();
                        breaches.push(format!(
                            "{file}:{}: `{module}` uses `{name}`, which lies below it",
                            number + 1
                        ));
                    }
                }
            }
        }
    }
    assert!(breaches.is_empty(), "\n{}", breaches.join("\n"));
}

#[test]
fn every_folder_of_the_source_is_a_module() {
    let mut modules = modules();
    modules.sort();
    let entries = fs::read_dir(root().join("src")).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<String> = entries
        .filter(|path| path.is_dir())
        .map(|path| path.file_name().unwrap().to_string_lossy().into_owned())
        .collect();
    folders.sort();
    assert_eq!(folders, modules);
}

#[test]
fn uses_are_found_wherever_they_stand() {
    let names = |line| used(line).collect::<Vec<_>>();
    assert_eq!(names("use crate::space::{Axis, Cell};"), ["space"]);
    assert_eq!(names("    let a = crate::io::read(crate::view::png(x));"), ["io", "view"]);
    assert_eq!(names("use crate::{grid::Grid, io};"), ["grid", "io"]);
}

#[test]
fn only_the_program_uses_the_command_line() {
    let main = fs::read_to_string(root().join("src/main.rs")).unwrap();
    assert!(main.contains("vox::cli::main()"));
    assert_eq!(modules().last().map(String::as_str), Some("cli"));
}

#[test]
fn the_documented_map_is_the_real_one() {
    let text = fs::read_to_string(root().join("docs/architecture.md")).unwrap();
    let modules_section = text.split("\n## ").find(|section| section.starts_with("Modules")).unwrap();
    let rows = modules_section.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    assert_eq!(rows.map(str::to_owned).collect::<Vec<_>>(), modules());
}
