//! Imports: a grammar and the files that it names become one grammar.

mod constants;
mod link;
mod rename;
mod space;

use super::ast::Import;
use super::check::{Checked, judge};
use super::parse::{Parsed, parse_items_at};
use super::{Code, Diagnostic, Sources, Span};
use link::link;
use std::path::{Component, Path, PathBuf};

/// Files that one grammar may come from, at the most.
const MOST_FILES: usize = 1000;

/// A grammar with all its texts.
#[derive(Clone, Debug)]
pub struct Loaded {
    pub sources: Sources,
    /// Or everything that is wrong with any of the files, and the warnings, in the order of their places.
    pub checked: Result<Checked, Vec<Diagnostic>>,
}

/// Parses and checks a grammar with all that it imports. `fetch` gives the text of a file by its name, or says why there
/// is none; each file is asked for once. Names are paths beside the file that imports them.
pub fn load(name: &str, text: &str, fetch: &mut dyn FnMut(&str) -> Result<String, String>) -> Loaded {
    let mut loading = Loading { sources: Sources::default(), modules: Vec::new(), errors: Vec::new() };
    let root = Path::new(name);
    let folder = root.parent().unwrap_or(Path::new(""));
    loading.add(root.file_name().map_or_else(PathBuf::new, PathBuf::from), name.to_owned(), text);
    let mut at = 0;
    while at < loading.modules.len() {
        for import in loading.modules[at].parsed.grammar.imports.clone() {
            let imported = loading.import(at, &import, folder, fetch);
            loading.modules[at].imports.push(imported);
        }
        at += 1;
    }
    let Loading { sources, modules, mut errors } = loading;
    let is_whole = modules.iter().all(|module| module.imports.iter().all(Option::is_some));
    let (grammar, broken) = link(modules, &mut errors);
    errors.sort_by_key(|error| error.span.start);
    // What a missing file would define is not told of as missing, too.
    let checked = if is_whole { judge(grammar, errors, &broken) } else { Err(errors) };
    Loaded { sources, checked }
}

/// One file.
struct Module {
    /// Where it is, seen from the folder of the root.
    path: PathBuf,
    parsed: Parsed,
    /// The module of each of its imports, if it could be read.
    imports: Vec<Option<usize>>,
}

struct Loading {
    sources: Sources,
    modules: Vec<Module>,
    errors: Vec<Diagnostic>,
}

impl Loading {
    fn add(&mut self, path: PathBuf, name: String, text: &str) {
        let span = self.sources.add(name, text);
        let mut parsed = parse_items_at(self.sources.up_to(span.end), span.start);
        self.errors.append(&mut parsed.errors);
        self.modules.push(Module { path, parsed, imports: Vec::new() });
    }

    /// The module that an import names, which is read if it is new.
    fn import(
        &mut self,
        from: usize,
        import: &Import,
        folder: &Path,
        fetch: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Option<usize> {
        let path = beside(&self.modules[from].path, &import.file);
        if let Some(known) = self.modules.iter().position(|module| module.path == path) {
            return Some(known);
        }
        let name = plain(&folder.join(&path)).to_string_lossy().into_owned();
        let fetched = match self.modules.len() < MOST_FILES {
            true => fetch(&name),
            false => Err(format!("a grammar comes from {MOST_FILES} files at the most")),
        };
        match fetched {
            Ok(text) => {
                self.add(path, name, &text);
                Some(self.modules.len() - 1)
            }
            Err(problem) => {
                self.errors.push(unread(import, &name, &problem));
                None
            }
        }
    }
}

fn unread(import: &Import, name: &str, problem: &str) -> Diagnostic {
    let error = Diagnostic::new(Code::NoImport, import.span, format!("cannot import `{name}`: {problem}"));
    error.label("named here").hint("files are looked for beside the file that imports them")
}

/// The path of a file that another one names.
fn beside(path: &Path, file: &str) -> PathBuf {
    plain(&path.parent().unwrap_or(Path::new("")).join(file))
}

/// A path without detours, so that a file has one name.
fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        let can_go_up = matches!(out.components().next_back(), Some(Component::Normal(_)));
        match part {
            Component::CurDir => {}
            Component::ParentDir if can_go_up => {
                out.pop();
            }
            part => out.push(part),
        }
    }
    out
}

/// The place of an import, for what is wrong with what it names.
fn place(module: &Module, number: usize) -> Span {
    module.parsed.grammar.imports[number].span
}
