use super::derivation_file;
use super::failure::Failure;
use super::input::{self, Limit};
use super::output::{self, Output, Writing};
use super::progress::Progress;
use super::run;
use super::session;
use super::shaping::Shaping;
use super::size::SizeArg;
use super::summary::{self, Summary};
use super::template::Template;
use crate::grid::Grid;
use crate::neighbours::mend;
use crate::shapes::{self, Adjacency, Derivation, Enclosure, Growth, Rest, ShapeGrammar};
use crate::space::Cell;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Grow new buildings from the shapes of others
///
/// Shapes are put beside one another as they stand in the examples; matching shapes of several examples link them. The method
/// is SIGI's, which knows how shapes meet and nothing of buildings as a whole: grammars of `vox infer` do.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox grow house*.schem --steps 50 --enclose -o new.schem
  vox grow house*.schem --seen -n 12 -o 'out/grown-{seed}.schem'
  vox grow house.schem --interactive --save mine.json -o mine.schem
  vox grow house.schem --replay mine.json -o again.schem")]
pub struct Args {
    #[arg(required = true, help = input::BUILDINGS)]
    files: Vec<PathBuf>,
    #[arg(short, long, value_name = "FILE", help = run::OUTPUT)]
    output: Template,
    /// How many rules are applied
    #[arg(long, value_name = "N", default_value_t = 50)]
    steps: usize,
    /// Take away shapes that enclose nothing, but for those that enclose nothing in the examples
    #[arg(long)]
    enclose: bool,
    /// Let blocks stand beside one another only as they do in the examples, turned or not: the building is ended so, and shapes
    /// are taken away where it cannot be
    #[arg(long)]
    seen: bool,
    /// The most blocks along x, y and z; if not given, 48 or twice the largest example
    #[arg(long, value_name = "XxYxZ")]
    most: Option<SizeArg>,
    /// The seed of the first building; each further one takes the next
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How many buildings to make
    #[arg(short, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    number: u32,
    #[command(flatten)]
    shaping: Shaping,
    /// Choose each rule yourself: what it adds is drawn, and every choice can be undone
    #[arg(long, conflicts_with_all = ["number", "seen", "replay", "json"])]
    interactive: bool,
    /// Where to write the choices that gave the building, as JSON
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,
    /// Take the choices of such a file: the same examples and options give the same bytes
    #[arg(long, value_name = "FILE", conflicts_with_all = ["number", "steps", "seen", "enclose", "save"])]
    replay: Option<PathBuf>,
    #[command(flatten)]
    writing: Writing,
    #[command(flatten)]
    limit: Limit,
    /// Print what was made as JSON, one line a building
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let paths = input::paths(&args.files)?;
    let seeds: Vec<u64> = (0..u64::from(args.number)).map(|number| args.seed.wrapping_add(number)).collect();
    let outputs = args.output.of_seeds(&seeds)?;
    check_outputs(args, &outputs)?;
    let mut examples = Vec::with_capacity(paths.len());
    for path in &paths {
        examples.push(input::grid(path, &args.limit.reading())?);
    }
    let most = args.most.map_or_else(|| roomy(&examples), |size| size.0);
    let version = examples.first().and_then(|grid| grid.metadata.data_version);
    let grammar = ShapeGrammar::learn(examples, &args.shaping.settings(Rest::Searched, args.seed));
    if grammar.parts.parts.is_empty() {
        return Err(Failure::new("the examples hold no blocks, and so no shapes to grow from"));
    }
    let progress = Progress::new(seeds.len());
    let mut summary = Summary::default();
    for (seed, output) in seeds.into_iter().zip(&outputs) {
        let derivation = derivation(args, &grammar, most, seed)?;
        write(args, (&paths, output), &grammar, &derivation, (version, seed), &mut summary)?;
        progress.step();
    }
    drop(progress);
    summary.tell();
    Ok(())
}

/// Room for buildings that are larger than the examples.
fn roomy(examples: &[Grid]) -> Cell {
    const LEAST: Cell = Cell::splat(48);
    examples.iter().fold(LEAST, |most, grid| most.max(2 * grid.size()))
}

fn check_outputs(args: &Args, outputs: &[PathBuf]) -> Result<(), Failure> {
    if args.save.is_some() && outputs.len() > 1 {
        let failure = Failure::new(format!("{} buildings cannot be saved in one file", outputs.len()));
        return Err(failure.hint("grow one at a time: `-n 1 --seed 7 --save choices.json`"));
    }
    let Some(path) = outputs.first() else { return Ok(()) };
    args.writing.kind(path)?;
    if input::is_stdio(path) && (args.json || args.interactive) {
        let what = if args.json { "JSON" } else { "a session" };
        return Err(Failure::new(format!("standard output cannot hold both the building and {what}")));
    }
    Ok(())
}

fn derivation(args: &Args, grammar: &ShapeGrammar, most: Cell, seed: u64) -> Result<Derivation, Failure> {
    let enclosure = if args.enclose { Enclosure::Enforced } else { Enclosure::Ignored };
    if let Some(path) = &args.replay {
        return derivation_file::read(path, grammar);
    }
    let growth = Growth {
        steps: args.steps,
        enclosure,
        adjacency: if args.seen { Adjacency::Enforced } else { Adjacency::Ignored },
        most,
        seed,
    };
    match args.interactive {
        true => session::run(grammar, &growth),
        false => Ok(shapes::grow(grammar, &growth)),
    }
}

/// Writes a building and, where they are asked for, the choices that gave it.
fn write(
    args: &Args,
    (inputs, output): (&[PathBuf], &Path),
    grammar: &ShapeGrammar,
    derivation: &Derivation,
    (version, seed): (Option<i32>, u64),
    summary: &mut Summary,
) -> Result<(), Failure> {
    let grid = built(grammar, derivation, version)?;
    let (size, what, blocks) =
        (grid.size().to_array(), summary::building(&grid, args.writing.split), grid.blocks());
    if blocks == 0 {
        return Err(empty(output, derivation));
    }
    let mut outputs = args.writing.grid(output, grid)?;
    let files: Vec<PathBuf> = args.writing.pieces(output, &outputs).into_iter().map(Path::to_owned).collect();
    outputs
        .extend(args.save.iter().map(|path| Output::new(path, derivation_file::text(grammar, derivation))));
    output::write(&outputs, inputs)?;
    match args.json {
        true => output::json(&json!({
            "file": output.display().to_string(),
            "seed": seed,
            "size": size,
            "blocks": blocks,
            "steps": derivation.steps.len(),
        })),
        false => {
            summary.add(&files.iter().map(PathBuf::as_path).collect::<Vec<_>>(), what);
            Ok(())
        }
    }
}

/// The blocks of a derivation, joined to their neighbours, and halves with their other halves.
fn built(grammar: &ShapeGrammar, derivation: &Derivation, version: Option<i32>) -> Result<Grid, Failure> {
    let production = derivation.production(grammar).map_err(Failure::new)?;
    let mut grid = shapes::grid(&production).map_err(Failure::new)?;
    grid.metadata.data_version = version;
    mend(&mut grid).map_err(Failure::new)?;
    Ok(grid)
}

fn empty(output: &Path, derivation: &Derivation) -> Failure {
    let failure = Failure::of_file(&output.display().to_string(), "nothing is left of this building");
    failure.hint(match derivation.enclosure {
        Enclosure::Enforced => {
            "none of its shapes encloses anything: more `--steps`, or another `--seed`, may close it"
        }
        Enclosure::Ignored => "its shapes meet as in no example: another `--seed` may end well",
    })
}
