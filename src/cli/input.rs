//! Reading what the command line names: files, patterns and standard input.

use super::failure::{self, Failure};
use super::part;
use super::report;
use super::settings::Settings;
use crate::grammar::{self, Checked, Loaded, Sources, is_mesh};
use crate::graph::{OpGraph, lower};
use crate::grid::Grid;
use crate::io::{self, Content, Decoded, Limits, ObjModel, Options, ReadError, Scale};
use crate::run::{Library, RunError};
use crate::space::Bounds;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

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

/// What rules are learnt from.
pub const EXAMPLES: &str = concat!(
    with_blocks!(),
    ", .obj of labelled boxes (`o name`), .xml or .png of a facade's layout",
    by_content!()
);

/// What can be drawn.
pub const DRAWN: &str =
    concat!(with_blocks!(), ", .xml or .png of a facade's layout, or a .grammar", by_content!());

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

pub fn bytes(path: &Path, most: u64) -> Result<Vec<u8>, Failure> {
    read(path, most).map_err(|error| Failure::read(&name(path), &error))
}

/// What came in on standard input, which can be read once only: it is looked at before it is known what it is.
static STDIN: OnceLock<Vec<u8>> = OnceLock::new();

fn read(path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
    match is_stdio(path) {
        true => match STDIN.get() {
            Some(bytes) => Ok(bytes.clone()),
            None => io::read_bytes(std::io::stdin(), most).map(|bytes| STDIN.get_or_init(|| bytes).clone()),
        },
        false => {
            std::fs::File::open(path).map_err(ReadError::from).and_then(|file| io::read_bytes(file, most))
        }
    }
}

/// The text of a grammar file.
pub fn text(path: &Path) -> Result<String, Failure> {
    text_of(path).map_err(|problem| {
        let failure = Failure::of_file(&name(path), &problem);
        match problem {
            NoText::Unread(_) => failure,
            NoText::NotUtf8(_) => {
                failure.hint("a grammar is a text file; schematics are read by `vox infer` and `vox info`")
            }
        }
    })
}

/// Why a file gives no text.
#[derive(Debug, thiserror::Error)]
enum NoText {
    #[error("{0}")]
    Unread(String),
    #[error("this is not a text: byte {0} is not UTF-8")]
    NotUtf8(usize),
}

fn text_of(path: &Path) -> Result<String, NoText> {
    const MOST: u64 = 64 << 20;
    let bytes = read(path, MOST).map_err(|error| NoText::Unread(failure::plain(&error)))?;
    String::from_utf8(bytes).map_err(|error| NoText::NotUtf8(error.utf8_error().valid_up_to()))
}

/// A grammar file and all that it imports.
pub fn loaded(path: &Path) -> Result<Loaded, Failure> {
    let text = text(path)?;
    let mut fetch = |name: &str| text_of(Path::new(name)).map_err(|problem| problem.to_string());
    Ok(grammar::load(&name(path), &text, &mut fetch))
}

/// The files that a grammar comes from, also those that are not there.
pub fn files_of(path: &Path) -> Vec<PathBuf> {
    let mut files = vec![path.to_owned()];
    let text = text_of(path).unwrap_or_default();
    grammar::load(&name(path), &text, &mut |name| {
        files.push(PathBuf::from(name));
        text_of(Path::new(name)).map_err(|problem| problem.to_string())
    });
    files
}

/// A grammar without errors, and its texts. Every finding is told.
pub fn checked(path: &Path) -> Result<(Sources, Checked), Failure> {
    let (sources, checked) = without_errors(path)?;
    checked.warnings.iter().for_each(|finding| report::diagnostic(&sources, finding));
    Ok((sources, checked))
}

/// A grammar without errors. Its warnings are not told.
fn without_errors(path: &Path) -> Result<(Sources, Checked), Failure> {
    let Loaded { sources, checked } = loaded(path)?;
    match checked {
        Ok(checked) => Ok((sources, checked)),
        Err(findings) => {
            findings.iter().for_each(|finding| report::diagnostic(&sources, finding));
            let errors = findings.iter().filter(|finding| finding.is_error()).count();
            let noun = if errors == 1 { "error" } else { "errors" };
            Err(Failure::of_file(sources.root(), format!("{errors} {noun}")))
        }
    }
}

/// A grammar as a graph, with its texts.
pub struct Program {
    pub sources: Sources,
    pub checked: Checked,
    pub graph: OpGraph,
    /// The files that it was read from, which nothing is to write over.
    pub files: Vec<PathBuf>,
}

/// A grammar file as a graph from `start`, or from its first rule, with what the command line sets.
pub fn program(path: &Path, start: Option<&str>, settings: &Settings) -> Result<Program, Failure> {
    // What the first rule does not reach is no slip where another one starts.
    let (sources, checked) = if start.is_some() { without_errors(path)? } else { checked(path)? };
    let mut graph = lower(&checked, start).map_err(|error| Failure::of_file(sources.root(), error))?;
    settings.apply(&mut graph, sources.root())?;
    let imported = sources.names().skip(1).map(PathBuf::from);
    let files = std::iter::once(path.to_owned()).chain(imported).collect();
    Ok(Program { sources, checked, graph, files })
}

/// The schematics that a graph names as primitives, looked for beside its grammar.
pub fn library(graph: &OpGraph, grammar: &Path) -> Result<Library, Failure> {
    let folder = grammar.parent().unwrap_or(Path::new("."));
    let mut library = Library::new();
    for file in graph.files().into_iter().filter(|file| !is_mesh(file)) {
        let read = grid(&folder.join(file), &Reading::default());
        let named =
            |failure: Failure| failure.hint("the grammar names this file: it is looked for beside it");
        library.insert(file.to_owned(), read.map_err(named)?);
    }
    Ok(library)
}

/// The meshes that a graph names, looked for beside its grammar.
pub fn models(graph: &OpGraph, grammar: &Path) -> Result<BTreeMap<String, ObjModel>, Failure> {
    let folder = grammar.parent().unwrap_or(Path::new("."));
    let mut models = BTreeMap::new();
    for file in graph.files().into_iter().filter(|file| is_mesh(file)) {
        let path = folder.join(file);
        let bytes = bytes(&path, Limits::default().max_bytes)?;
        let model = io::decode_obj_model(&bytes).map_err(|error| Failure::of_file(&name(&path), error))?;
        models.insert(file.to_owned(), model);
    }
    Ok(models)
}

/// The bytes of a layout, if that is what a file holds.
pub fn layout(path: &Path, most: u64) -> Result<Option<Vec<u8>>, Failure> {
    const HEAD: u64 = 1024;
    if path.is_dir() {
        return Ok(None);
    }
    if is_stdio(path) {
        return bytes(path, most).map(|bytes| io::is_layout(&bytes).then_some(bytes));
    }
    let mut head = Vec::new();
    let read = std::fs::File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    // What cannot be opened is told of as other buildings are.
    match read.is_ok() && io::is_layout(&head) {
        true => bytes(path, most).map(Some),
        false => Ok(None),
    }
}

/// A text beside a layout, which says what it means.
pub fn said<T: std::str::FromStr<Err: std::fmt::Display>>(path: &Path) -> Result<T, Failure> {
    let text = text_of(path).map_err(|problem| Failure::of_file(&name(path), problem))?;
    text.parse().map_err(|error| Failure::of_file(&name(path), error))
}

/// Tells of an error of a run at its place in the text.
pub fn run_failure(sources: &Sources, error: &RunError) -> Failure {
    let Some(origin) = &error.origin else {
        let text = format!("{}: {error}", sources.root());
        report::coded_error(error.kind.code(), &text, error.hint().as_deref());
        return Failure::Told;
    };
    let finding =
        grammar::Diagnostic::new(error.kind.code(), origin.span, error.to_string()).label("this operation");
    report::diagnostic(sources, &finding.maybe_hint(error.hint()));
    Failure::Told
}
