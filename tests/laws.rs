//! Laws that hold for every grammar: of the text, of the graph, and of what runs make.

#[path = "laws/analyses.rs"]
mod analyses;
#[path = "laws/carving.rs"]
mod carving;
#[path = "laws/checked.rs"]
mod checked;
#[path = "laws/context.rs"]
mod context;
#[path = "laws/graphs.rs"]
mod graphs;
#[path = "laws/limits.rs"]
mod limits;
#[path = "laws/noise.rs"]
mod noise;
#[path = "laws/parse.rs"]
mod parse;
#[path = "laws/scopes.rs"]
mod scopes;
#[path = "laws/seeds.rs"]
mod seeds;
#[path = "laws/syntax.rs"]
mod syntax;
#[path = "laws/tiling.rs"]
mod tiling;
#[path = "laws/update.rs"]
mod update;

use vox::grammar::ast::Grammar;
use vox::grammar::{self, Diagnostic, check};
use vox::graph::{OpGraph, lower};
use vox::grid::{Grid, LabelledBox};
use vox::run::{Library, Limits, Options, RunError, run, run_boxes};
use vox::space::Cell;

fn messages(findings: &[Diagnostic]) -> String {
    findings.iter().map(|finding| format!("{}\n", finding.message)).collect()
}

/// The graph of a grammar that is known to be right.
fn graph_of(grammar: Grammar) -> OpGraph {
    let text = grammar.to_string();
    let checked = check(grammar).unwrap_or_else(|found| panic!("{}in\n{text}", messages(&found)));
    lower(&checked, None).unwrap()
}

fn graph(text: &str) -> OpGraph {
    graph_of(grammar::parse(text).unwrap_or_else(|found| panic!("{}in\n{text}", messages(&found))))
}

/// Few enough steps that a grammar without an end is told of at once.
const SHORT: Limits = Limits { cells: 1 << 20, depth: 1_000, steps: 200_000 };

fn options(size: [i32; 3], seed: u64) -> Options {
    Options { seed, size: Some(Cell::from(size)), limits: SHORT, ..Options::default() }
}

fn blocks(graph: &OpGraph, options: &Options) -> Result<Grid, RunError> {
    run(graph, &Library::new(), options).map(|made| made.made)
}

fn boxes(graph: &OpGraph, options: &Options) -> Result<Vec<LabelledBox>, RunError> {
    run_boxes(graph, options).map(|made| made.made)
}

/// The block names of a row of cells along x, at the origin of y and z.
fn row(text: &str, length: i32) -> String {
    let grid = blocks(&graph(text), &options([length, 1, 1], 0)).unwrap();
    let names: Vec<&str> = (0..length).map(|x| grid.get(Cell::new(x, 0, 0)).short_name()).collect();
    names.join(" ")
}
