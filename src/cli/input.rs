//! Reading what the command line names: files, patterns and standard input.

use super::failure::Failure;
use super::part;
use super::report::{self, Source};
use crate::grammar::{self, Checked};
use crate::graph::{OpGraph, lower};
use crate::grid::Grid;
use crate::io::{self, Content, Decoded, Limits, Options, ReadError, Scale};
use crate::run::{Library, RunError};
use crate::space::Bounds;
use std::path::{Path, PathBuf};

/// The kinds of files that hold blocks, by their endings.
macro_rules! with_blocks {
    () => {
        "What to read: .schem, .litematic, .nbt, .schematic, .mcstructure, .blueprint, .bp, .vox, .mca or the folder \
         of a world"
    };
}

/// What is told of them beside.
macro_rules! by_content {
    () => {
        ", or - for standard input. The content tells what it is, not the name"
    };
}

/// What a command reads that needs blocks, for help texts.
pub const BUILDINGS: &str = concat!(with_blocks!(), by_content!());

/// What a command reads that takes labelled boxes as well.
pub const FILES: &str = concat!(with_blocks!(), ", .obj of labelled boxes (`o name`)", by_content!());

/// The files that the arguments name: a pattern that the shell left alone is looked up here.
pub fn paths(args: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut paths = Vec::new();
    for path in args {
        let pattern = path.to_str().filter(|text| text.contains(['*', '?', '[']) && !path.exists());
        let Some(arg) = pattern else {
            paths.push(path.clone());
            continue;
        };
        let found = glob::glob(arg).map_err(|error| Failure::of_file(arg, error))?;
        let mut found: Vec<PathBuf> = found.filter_map(Result::ok).collect();
        if found.is_empty() {
            return Err(Failure::of_file(arg, "no file matches this pattern"));
        }
        found.sort_by_cached_key(|path| natural(&path.to_string_lossy()));
        paths.extend(found);
    }
    Ok(paths)
}

/// A key that sorts numbers by value: house-2 before house-10.
fn natural(name: &str) -> Vec<(u64, String)> {
    let mut key: Vec<(u64, String)> = vec![(0, String::new())];
    for c in name.chars() {
        match (c.to_digit(10).map(u64::from), key.last_mut()) {
            (Some(digit), Some((number, text))) if text.is_empty() => {
                *number = number.saturating_mul(10).saturating_add(digit);
            }
            (Some(digit), _) => key.push((digit, String::new())),
            (None, Some((_, text))) => text.push(c),
            (None, None) => {}
        }
    }
    key
}

/// What messages call a file.
pub fn name(path: &Path) -> String {
    if is_stdio(path) { "standard input".to_owned() } else { path.display().to_string() }
}

pub fn is_stdio(path: &Path) -> bool {
    path == Path::new("-")
}

/// What to read a file with.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    pub limits: Limits,
    pub options: Options,
    /// The box to take.
    pub part: Option<Bounds>,
}

/// How much a file may unfold to.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct Limit {
    /// The most that a file may unfold to, in GiB: a small file can ask for any amount of memory
    #[arg(long = "limit", value_name = "GIB", default_value = "1", value_parser = clap::value_parser!(u16).range(1..))]
    gib: u16,
}

impl Limit {
    pub fn reading(self) -> Reading {
        let (one, times) = (Limits::default(), u64::from(self.gib));
        let limits = Limits { max_bytes: times * one.max_bytes, max_cells: times * one.max_cells };
        Reading { limits, ..Reading::default() }
    }

    /// With labelled boxes at this scale.
    pub fn scaled(self, scale: Option<Scale>) -> Reading {
        let options = Options { scale: scale.unwrap_or_default(), ..Options::default() };
        Reading { options, ..self.reading() }
    }
}

/// A scale on the command line.
pub fn scale(text: &str) -> Result<Scale, String> {
    let scale = text.parse().ok().and_then(Scale::new);
    scale.ok_or_else(|| "expected a number above zero".to_owned())
}

/// The content of a building's file. What reading it had to put right is told.
pub fn content(path: &Path, reading: &Reading) -> Result<Content, Failure> {
    told(path, reading).map(|decoded| decoded.content)
}

/// All that can be told of a building's file. What reading it had to put right is told.
pub fn told(path: &Path, reading: &Reading) -> Result<Decoded, Failure> {
    let (name, decoded) = (name(path), decoded(path, reading)?);
    decoded.warnings.iter().for_each(|warning| report::warning(&format!("{name}: {warning}")));
    Ok(decoded)
}

/// All that can be told of a building's file.
pub fn decoded(path: &Path, reading: &Reading) -> Result<Decoded, Failure> {
    if path.is_dir() {
        return world(path, reading);
    }
    let (name, bytes) = (name(path), bytes(path, reading.limits.max_bytes)?);
    // Worlds are many files: where one lies tells where the others are.
    if io::is_region(&bytes) && !is_stdio(path) {
        return world(path, reading);
    }
    let decoded = io::decode_with(&bytes, &reading.limits, &reading.options);
    let decoded = decoded.map_err(|error| Failure::read(&name, &error))?;
    match (reading.part, decoded.content) {
        (Some(bounds), Content::Grid(grid)) => {
            Ok(Decoded { content: Content::Grid(part::boxed(&name, &grid, bounds)?), ..decoded })
        }
        (_, content) => Ok(Decoded { content, ..decoded }),
    }
}

fn world(path: &Path, reading: &Reading) -> Result<Decoded, Failure> {
    io::read_world(path, reading.part, &reading.limits).map_err(|error| Failure::read(&name(path), &error))
}

/// The blocks of a file; labelled boxes have none.
pub fn grid(path: &Path, reading: &Reading) -> Result<Grid, Failure> {
    require_grid(&name(path), content(path, reading)?)
}

/// The blocks of what was read from the file `name`.
pub fn require_grid(name: &str, content: Content) -> Result<Grid, Failure> {
    match content {
        Content::Grid(grid) => Ok(grid),
        Content::Boxes(_) => {
            let failure = Failure::of_file(name, "this file holds labelled boxes, not blocks");
            Err(failure.hint("`vox infer` learns from labelled boxes; `vox run` then makes blocks"))
        }
    }
}

fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, Failure> {
    let read = match is_stdio(path) {
        true => io::read_bytes(std::io::stdin(), most),
        false => {
            std::fs::File::open(path).map_err(ReadError::from).and_then(|file| io::read_bytes(file, most))
        }
    };
    read.map_err(|error| Failure::read(&name(path), &error))
}

/// The text of a grammar file, with its name.
pub fn source(path: &Path) -> Result<Source, Failure> {
    const MOST: u64 = 64 << 20;
    let name = name(path);
    let bytes = bytes(path, MOST)?;
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Source { name, text }),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let failure = Failure::of_file(&name, format!("this is not a text: byte {at} is not UTF-8"));
            Err(failure.hint("a grammar is a text file; schematics are read by `vox infer` and `vox info`"))
        }
    }
}

/// A grammar without errors. Every finding is told.
pub fn checked(source: &Source) -> Result<Checked, Failure> {
    let checked = without_errors(source)?;
    checked.warnings.iter().for_each(|finding| report::diagnostic(source, finding));
    Ok(checked)
}

/// A grammar without errors. Its warnings are not told.
fn without_errors(source: &Source) -> Result<Checked, Failure> {
    grammar::read(&source.text).map_err(|findings| {
        findings.iter().for_each(|finding| report::diagnostic(source, finding));
        let errors = findings.iter().filter(|finding| finding.is_error()).count();
        let noun = if errors == 1 { "error" } else { "errors" };
        Failure::of_file(&source.name, format!("{errors} {noun}"))
    })
}

/// A grammar file as a graph from `start`, or from its first rule.
pub fn graph(source: &Source, start: Option<&str>) -> Result<OpGraph, Failure> {
    // What the first rule does not reach is no slip where another one starts.
    let checked = if start.is_some() { without_errors(source)? } else { checked(source)? };
    lower(&checked, start).map_err(|error| Failure::of_file(&source.name, error))
}

/// The schematics that a graph names as primitives, looked for beside its grammar.
pub fn library(graph: &OpGraph, grammar: &Path) -> Result<Library, Failure> {
    let folder = grammar.parent().unwrap_or(Path::new("."));
    let mut library = Library::new();
    for file in graph.files() {
        let read = grid(&folder.join(file), &Reading::default());
        let named =
            |failure: Failure| failure.hint("the grammar names this file: it is looked for beside it");
        library.insert(file.to_owned(), read.map_err(named)?);
    }
    Ok(library)
}

/// Tells of an error of a run at its place in the text.
pub fn run_failure(source: &Source, error: &RunError) -> Failure {
    let Some(origin) = &error.origin else {
        let text = format!("{}: {error}", source.name);
        report::coded_error(error.kind.code(), &text, error.hint().as_deref());
        return Failure::Told;
    };
    let finding =
        grammar::Diagnostic::new(error.kind.code(), origin.span, error.to_string()).label("this operation");
    report::diagnostic(source, &finding.maybe_hint(error.hint()));
    Failure::Told
}
