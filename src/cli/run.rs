use super::failure::Failure;
use super::input;
use super::output::{self, Kind, Writing};
use super::progress::Progress;
use super::report::{self, Source};
use super::size::SizeArg;
use super::summary::{self, Summary};
use super::template::Template;
use crate::graph::OpGraph;
use crate::run::{self, Library, Limits, Made, Options, Overrun};
use crate::space::Cell;
use clap::ValueEnum;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Run a grammar: make new buildings
///
/// The same grammar, size and seed always give the same bytes.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox run cottage.grammar --seed 7 -o cottage.schem
  vox run tower.grammar --size 7x30x7 -o tower.png
  vox run village.grammar -n 50 -o 'out/house-{seed}.schem'
  vox run garage.grammar -n 10 --boxes -o 'garage-{number}.obj'")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    /// Where to write: .schem, .litematic, .nbt, .vox, .obj or .png. {seed} and {number} stand for the seed and the number of each building
    #[arg(short, long, value_name = "FILE")]
    output: Template,
    /// The size of the start scope along the grammar's x, y and z; otherwise one that the grammar states
    #[arg(long, value_name = "XxYxZ")]
    size: Option<SizeArg>,
    /// The seed of the first building; each further one takes the next
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How many buildings to make
    #[arg(short, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    number: u32,
    /// The rule to start from, instead of the first
    #[arg(long, value_name = "LABEL")]
    start: Option<String>,
    /// What to do where sizes do not fit their scope
    #[arg(long, value_enum, default_value = "error")]
    overrun: OverrunArg,
    /// The last priority whose rules run; what waits for a later one stays a plain mass
    #[arg(long, value_name = "N")]
    detail: Option<u32>,
    /// Write the primitives as labelled boxes, one OBJ object each, instead of blocks
    #[arg(long)]
    boxes: bool,
    /// The most operations that one building may take
    #[arg(long, value_name = "N", default_value_t = Limits::default().steps)]
    max_steps: u64,
    /// The most blocks that a start scope may hold
    #[arg(long, value_name = "N", default_value_t = Limits::default().cells)]
    max_cells: u64,
    /// Print what was made as JSON, one line a building
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    writing: Writing,
}

#[derive(Clone, Copy, ValueEnum)]
enum OverrunArg {
    /// Stop, and name the rule
    Error,
    /// Cut off what runs over, and warn
    Clip,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let source = input::source(&args.grammar)?;
    let graph = input::graph(&source, args.start.as_deref())?;
    let library = input::library(&graph, &args.grammar)?;
    let seeds: Vec<u64> = (0..u64::from(args.number)).map(|number| args.seed.wrapping_add(number)).collect();
    let paths = args.output.of_seeds(&seeds)?;
    if let Some(path) = paths.first() {
        let kind = args.writing.kind(path)?;
        let is_obj = kind == Kind::Obj || (input::is_stdio(path) && args.writing.format.is_none());
        if args.boxes && !is_obj {
            let failure =
                Failure::of_file(&path.display().to_string(), "labelled boxes are written as .obj only");
            return Err(failure.hint("name it .obj, or leave out `--boxes`"));
        }
        if args.json && input::is_stdio(path) {
            return Err(Failure::new("standard output cannot hold both the building and JSON"));
        }
    }
    let progress = Progress::new(seeds.len());
    let mut summary = Summary::default();
    for (seed, path) in seeds.into_iter().zip(&paths) {
        let (size, what) = make(args, &source, &graph, &library, seed, path)?;
        match args.json {
            true => output::json(&json!({
                "file": path.display().to_string(), "seed": seed, "size": size.to_array(),
            }))?,
            false => summary.add(path, what),
        }
        progress.step();
    }
    drop(progress);
    summary.tell();
    Ok(())
}

/// Makes and writes one building; gives back its size in the world, and what it is in a few words.
fn make(
    args: &Args,
    source: &Source,
    graph: &OpGraph,
    library: &Library,
    seed: u64,
    path: &Path,
) -> Result<(Cell, String), Failure> {
    let options = Options {
        seed,
        size: args.size.map(|size| size.0),
        overrun: match args.overrun {
            OverrunArg::Error => Overrun::Refuse,
            OverrunArg::Clip => Overrun::Clip,
        },
        detail: args.detail,
        limits: Limits { steps: args.max_steps, cells: args.max_cells, ..Limits::default() },
    };
    let inputs = std::slice::from_ref(&args.grammar);
    let fail = |error| input::run_failure(source, &error);
    if args.boxes {
        let boxes = told(source, run::run_boxes(graph, &options).map_err(fail)?);
        output::write(&output::boxes(path, &boxes), inputs)?;
        let size = boxes.iter().map(|labelled| labelled.bounds).reduce(|all, next| all.union(&next));
        let what = summary::boxes(boxes.len());
        return Ok((size.map_or(Cell::ZERO, |bounds| bounds.size()), what));
    }
    let grid = told(source, run::run(graph, library, &options).map_err(fail)?);
    let (size, what) = (grid.size(), summary::building(&grid, args.writing.split));
    output::write(&args.writing.grid(path, grid)?, inputs)?;
    Ok((size, what))
}

/// What was made; the warnings are told.
fn told<T>(source: &Source, made: Made<T>) -> T {
    for warning in &made.warnings {
        let line =
            warning.error.origin.as_ref().map(|origin| report::line_column(&source.text, origin.span).0);
        let place = line.map_or(source.name.clone(), |line| format!("{}:{line}", source.name));
        let times = if warning.times == 1 { String::new() } else { format!(" ({} times)", warning.times) };
        report::warning(&format!("{place}: {}{times}", warning.error));
    }
    made.made
}
