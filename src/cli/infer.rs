use super::facade;
use super::failure::Failure;
use super::input::{self, Limit};
use super::output::{self, Output};
use super::progress::Progress;
use super::report;
use super::update;
use crate::facade::Variety;
use crate::grammar::{self, Diagnostic};
use crate::graph::{OpGraph, dot, lower, raise};
use crate::grid::Grid;
use crate::infer::{self, Example, InferError, Learnt, derived, variety};
use crate::io::{Content, Scale};
use crate::parse::{Laws, MOST_STEPS, Parser};
use crate::score::{Explained, Length, Outline, outline};
use serde_json::json;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// So many samples are scored.
const SAMPLES: usize = 24;
/// Examples of more cells than this in all are not scored: that would take longer than to learn from them.
const MOST_CELLS: u64 = 250_000;

/// Learn a grammar from example buildings
///
/// Examples are buildings, or layouts of facades: XML of nested labelled shapes, or a PNG with one colour a label. Before
/// it writes, vox proves that the grammar derives every example, block for block.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox infer house*.schem -o village.grammar --dot village.dot
  vox infer house1.obj house2.obj --scale 3 -o houses.grammar
  vox infer layout.xml -o facade.grammar --building hip
  vox infer --update village.grammar house6.schem")]
pub struct Args {
    #[arg(required = true, help = input::EXAMPLES)]
    examples: Vec<PathBuf>,
    /// A grammar to change as little as may be, so that it derives the examples as well: all else that is written in it
    /// stays
    #[arg(long, value_name = "GRAMMAR", conflicts_with_all = ["scale", "method", "terminals", "freedom"])]
    update: Option<PathBuf>,
    /// Where to write the grammar; if not given, standard output, or the grammar to update
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Where to write the op graph, in Graphviz's dot language
    #[arg(long, value_name = "FILE")]
    dot: Option<PathBuf>,
    /// Blocks per unit of the coordinates of OBJ files and layouts
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
    /// How examples become rules
    #[arg(long, value_enum, default_value_t)]
    method: Method,
    /// What examples that are learnt by `boxes` are split into; `shapes` are always learnt so
    #[arg(long, value_enum, default_value_t)]
    terminals: Terminals,
    /// How far what is learnt may leave the examples
    #[arg(long, value_enum, default_value_t)]
    freedom: Freedom,
    #[command(flatten)]
    layouts: facade::LayoutArgs,
    #[command(flatten)]
    limit: Limit,
    /// Print what was learnt as JSON. The grammar then goes to a file only
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Default, clap::ValueEnum)]
enum Method {
    /// One operation for all the boxes that a rule stands for, by description length
    #[default]
    Joint,
    /// Each example is split by itself, then what is equal is joined
    Boxes,
}

#[derive(Clone, Copy, Default, clap::ValueEnum)]
enum Terminals {
    /// The largest cuboids of one block
    #[default]
    Cuboids,
    /// Walls, windows and the like, as `vox shapes` finds them
    Shapes,
}

#[derive(Clone, Copy, Default, clap::ValueEnum)]
enum Freedom {
    /// Blocks stand beside one another only as they do in an example
    #[default]
    Seen,
    /// Whatever the shortest description allows; by `boxes`, also as they do in an example turned or mirrored
    Free,
}

impl From<Freedom> for infer::Freedom {
    fn from(freedom: Freedom) -> infer::Freedom {
        match freedom {
            Freedom::Seen => infer::Freedom::Seen,
            Freedom::Free => infer::Freedom::Free,
        }
    }
}

/// The method that the arguments ask for.
fn method(args: &Args) -> infer::Method {
    match (args.terminals, args.method) {
        (Terminals::Shapes, _) => infer::Method::Shapes,
        (Terminals::Cuboids, Method::Joint) => infer::Method::Joint,
        (Terminals::Cuboids, Method::Boxes) => infer::Method::Boxes,
    }
}

impl From<Freedom> for Variety {
    fn from(freedom: Freedom) -> Variety {
        match freedom {
            Freedom::Seen => Variety::None,
            Freedom::Free => Variety::Exchanged,
        }
    }
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let Args { examples, dot, limit, json, .. } = args;
    let known = args.update.as_deref().unwrap_or(Path::new("-"));
    let output = args.output.as_deref().unwrap_or(known);
    if args.json && input::is_stdio(output) {
        let failure = Failure::new("standard output cannot hold both the grammar and JSON");
        return Err(failure.hint("say where the grammar goes: `-o village.grammar`"));
    }
    match &args.update {
        None => learn(args, output),
        Some(grammar) => update::execute(&update::Task {
            grammar,
            houses: examples,
            output,
            dot: dot.as_deref(),
            reading: limit.reading(),
            json: *json,
        }),
    }
}

fn learn(args: &Args, output: &Path) -> Result<(), Failure> {
    let paths = input::paths(&args.examples)?;
    let task = facade::Task {
        paths: &paths,
        output,
        dot: args.dot.as_deref(),
        scale: args.scale,
        variety: args.freedom.into(),
        limit: args.limit,
        json: args.json,
    };
    if facade::learn(&args.layouts, &task)?.is_some() {
        return Ok(());
    }
    let reading = args.limit.scaled(args.scale);
    let progress = Progress::new(paths.len());
    let mut examples = Vec::with_capacity(paths.len());
    for path in &paths {
        examples.push(match input::content(path, &reading)? {
            Content::Grid(grid) => Example::Blocks(grid),
            Content::Boxes(boxes) => Example::Boxes(boxes),
        });
        progress.step();
    }
    drop(progress);
    tell_losses(&paths, &examples);
    let mut learnt = infer::infer(&examples, method(args), args.freedom.into())
        .map_err(|error| failure(&paths, &error))?;
    learnt.graph.preamble = preamble(&paths, ["one house:", "houses:"]);
    let text = learnt.grammar().to_string();
    let graph = read_back(&text)?;
    if !learnt.is_proved || graph != learnt.graph {
        prove(&paths, &derived(&examples, &graph, &learnt.labels, MOST_STEPS))?;
    }
    let Learnt { labels, by, .. } = learnt;
    let parser = Parser::new(&graph, Laws::AsWritten).with_labels(&labels);
    let mut outputs = vec![Output::new(output, text)];
    outputs.extend(args.dot.as_ref().map(|path| Output::new(path, dot(&graph))));
    output::write(&outputs, &paths)?;
    let grids: Vec<Grid> = examples.into_iter().filter_map(Example::into_grid).collect();
    if by != method(args) && grids.len() > 1 {
        report::note("no rule was found that joins the examples: they were learnt as with `--method boxes`");
    }
    let outline = (1..=MOST_CELLS)
        .contains(&cells(&grids))
        .then(|| outline(&graph, &Explained::of(&parser, &grids), &grids, SAMPLES));
    tell(args, &graph, paths.len(), outline)
}

/// Grammars place block states only.
fn tell_losses(paths: &[PathBuf], examples: &[Example]) {
    let counts = examples.iter().map(|example| match example {
        Example::Blocks(grid) => grid.block_entities.len() + grid.metadata.entities.len(),
        Example::Boxes(_) => 0,
    });
    let lost: Vec<usize> = counts.collect();
    let total: usize = lost.iter().sum();
    if let Some(first) = lost.iter().position(|count| *count > 0) {
        let others = lost.iter().filter(|count| **count > 0).count() - 1;
        let more = if others == 0 { String::new() } else { format!(" and {others} more") };
        report::warning(&format!(
            "{}{more}: what is in {total} chests, signs, beds and the like is not learnt, only their blocks",
            input::name(&paths[first])
        ));
    }
}

fn failure(paths: &[PathBuf], error: &InferError) -> Failure {
    match error.example() {
        Some(example) => Failure::of_file(&input::name(&paths[example]), error),
        None => Failure::new(error),
    }
}

/// Which files a grammar was learnt from; `[one, several]` say what they are.
pub fn preamble(paths: &[PathBuf], [one, several]: [&str; 2]) -> Vec<String> {
    let names: Vec<String> = paths
        .iter()
        .map(|path| {
            path.file_name().map_or_else(|| input::name(path), |name| name.to_string_lossy().into_owned())
        })
        .collect();
    let houses = if paths.len() == 1 { one.to_owned() } else { format!("{} {several}", paths.len()) };
    let mut lines = vec![format!("Learnt by vox from {houses}")];
    for name in names {
        match lines.last_mut() {
            Some(line) if line.len() + name.len() < 98 => *line += &format!(" {name}"),
            _ => lines.push(name),
        }
    }
    lines
}

/// What the text says is what is proved, not what it was printed from.
pub fn read_back(text: &str) -> Result<OpGraph, Failure> {
    let told = |findings: Vec<Diagnostic>| {
        let first = findings.first().map_or(String::new(), |finding| finding.message.clone());
        Failure::new(format!("the learnt grammar does not read back, which is a fault of vox: {first}"))
    };
    let checked = grammar::read(text).map_err(told)?;
    lower(&checked, None).map_err(Failure::new)
}

/// Nothing is written unless every example is reproduced.
fn prove(paths: &[PathBuf], reproduced: &[bool]) -> Result<(), Failure> {
    let missed: Vec<String> =
        paths.iter().zip(reproduced).filter(|(_, is)| !**is).map(|(path, _)| input::name(path)).collect();
    match missed.is_empty() {
        true => Ok(()),
        false => Err(Failure::new(format!(
            "the learnt grammar was not shown to reproduce {}, which is a fault of vox",
            missed.join(", ")
        ))),
    }
}

fn cells(grids: &[Grid]) -> u64 {
    grids.iter().map(|grid| grid.bounds().volume()).sum()
}

fn tell(args: &Args, graph: &OpGraph, examples: usize, outline: Option<Outline>) -> Result<(), Failure> {
    let grammar = raise(graph);
    let labels: BTreeSet<&str> = grammar.rules.iter().map(|rule| rule.label.name.as_str()).collect();
    let ways = variety(graph).unwrap_or(f64::INFINITY);
    if args.json {
        return output::json(&json!({
            "ways": ways,
            "examples": examples,
            "reproduced": examples,
            "rules": grammar.rules.len(),
            "labels": labels.len(),
            "operations": graph.unified().len(),
            "length": outline.and_then(|outline| outline.length).map(Length::ratio),
            "novelty": outline.map(|outline| outline.novelty),
            "unseen_seams": outline.map(|outline| outline.seams),
            "sound": outline.map(|outline| outline.sound),
        }));
    }
    let rules = count(grammar.rules.len() as f64, "rule");
    report::note(&format!("{examples} of {examples} examples reproduced, by {rules}"));
    let makes_more = outline.map_or(ways > examples as f64, |outline| outline.novelty > 0.0);
    if !makes_more {
        report::note(
            "the rules make only the examples again: nothing else shows only what stands beside one another in them. \
             More examples help, or `--freedom free`",
        );
    }
    if let Some(outline) = outline {
        report::note(&scores(&outline));
    }
    Ok(())
}

/// The scores that matter most; `vox score` tells the rest.
fn scores(outline: &Outline) -> String {
    let of_samples = |share: f64| (share * SAMPLES as f64).round();
    let length = outline.length.map_or_else(String::new, |length| {
        format!("; rules and choices take {:.2} of what zlib takes", length.ratio())
    });
    format!(
        "of {SAMPLES} samples {} are new and {} are sound, with {:.1} unseen neighbourhoods in 1,000 cells{length}",
        of_samples(outline.novelty),
        of_samples(outline.sound),
        outline.seams
    )
}

/// A number with its noun; a large one in words of ten.
pub fn count(number: f64, noun: &str) -> String {
    let plural = if number == 1.0 { "" } else { "s" };
    match number < 1e6 {
        true => format!("{number} {noun}{plural}"),
        false => format!("more than a million {noun}{plural}"),
    }
}
