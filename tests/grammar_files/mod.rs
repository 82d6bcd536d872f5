//! Grammar files as test data: comments `# runs at 9x7x9` in each say at which sizes, beside its own.

// Every test crate uses a part of it.
#![allow(dead_code)]

use std::path::{Path, PathBuf};
use vox::grammar::{Checked, check, parse};
use vox::graph::{OpGraph, lower};
use vox::grid::Grid;
use vox::io::{Content, Limits, read};
use vox::run::{Library, Made, Options, run};
use vox::space::Cell;

/// A file that ends in `.grammar`, and its text.
pub struct GrammarFile {
    pub path: PathBuf,
    pub text: String,
}

/// The grammar files under a folder of the repository, sorted.
pub fn all_in(folder: &str) -> Vec<GrammarFile> {
    let mut files = Vec::new();
    collect(&root().join(folder), &mut files);
    files.sort_by(|a, b| a.path.cmp(&b.path));
    assert!(!files.is_empty(), "no grammars in {folder}");
    files
}

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn collect(folder: &Path, files: &mut Vec<GrammarFile>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "grammar") {
            files.push(GrammarFile::read(path));
        }
    }
}

impl GrammarFile {
    pub fn read(path: PathBuf) -> GrammarFile {
        let text =
            std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        GrammarFile { path, text }
    }

    pub fn name(&self) -> String {
        self.path.strip_prefix(root()).unwrap().display().to_string()
    }

    pub fn checked(&self) -> Checked {
        parse(&self.text).and_then(check).unwrap_or_else(|errors| panic!("{}: {errors:#?}", self.name()))
    }

    pub fn graph(&self) -> OpGraph {
        lower(&self.checked(), None).unwrap()
    }

    /// The sizes that its comments promise.
    pub fn sizes(&self) -> Vec<Cell> {
        let promises = self.text.lines().filter_map(|line| line.strip_prefix("# runs at "));
        promises.map(|size| size_of(size).unwrap_or_else(|| panic!("{}: {size}", self.name()))).collect()
    }

    /// Runs it at a size, or at one of its own; a run that fails ends the test.
    pub fn run(&self, size: Option<Cell>, seed: u64) -> Made<Grid> {
        let options = Options { seed, size, ..Options::default() };
        let graph = self.graph();
        run(&graph, &self.library(&graph), &options)
            .unwrap_or_else(|error| panic!("{} at {size:?}, seed {seed}: {error}", self.name()))
    }

    fn library(&self, graph: &OpGraph) -> Library {
        let folder = self.path.parent().unwrap();
        graph.files().into_iter().map(|file| (file.to_owned(), grid(&folder.join(file)))).collect()
    }
}

/// The blocks of a schematic file.
pub fn grid(path: &Path) -> Grid {
    match read(path, &Limits::default()) {
        Ok(decoded) => match decoded.content {
            Content::Grid(grid) => grid,
            Content::Boxes(_) => panic!("{} holds boxes", path.display()),
        },
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

fn size_of(text: &str) -> Option<Cell> {
    let lengths: Vec<i32> =
        text.trim().split('x').map(|length| length.parse().ok()).collect::<Option<_>>()?;
    <[i32; 3]>::try_from(lengths).ok().map(Cell::from)
}
