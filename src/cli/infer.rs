use super::failure::Failure;
use super::input::{self, Reading};
use super::output;
use super::progress::Progress;
use super::report;
use crate::grammar::{self, Diagnostic};
use crate::graph::{OpGraph, dot, lower, raise};
use crate::infer::{self, Derivable, Example, InferError, derivable};
use crate::io::{Content, Scale};
use serde_json::json;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Learn a grammar from example buildings
///
/// Before it writes, vox proves that the grammar derives every example, block for block.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox infer house*.schem -o village.grammar --dot village.dot
  vox infer house1.obj house2.obj --scale 3 -o houses.grammar")]
pub struct Args {
    /// Schematics, or OBJ files of labelled boxes (`o name`); - for standard input
    #[arg(required = true)]
    examples: Vec<String>,
    /// Where to write the grammar; standard output if not given
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// Where to write the op graph, in Graphviz's dot language
    #[arg(long, value_name = "FILE")]
    dot: Option<PathBuf>,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = scale)]
    scale: Option<Scale>,
    /// Print what was learnt as JSON. The grammar then goes to a file only
    #[arg(long, requires = "output")]
    json: bool,
}

fn scale(text: &str) -> Result<Scale, String> {
    let scale = text.parse().ok().and_then(Scale::new);
    scale.ok_or_else(|| "expected a number above zero".to_owned())
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let paths = input::paths(&args.examples)?;
    let reading = Reading { scale: args.scale, ..Reading::default() };
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
    let mut graph = infer::infer(&examples).map_err(|error| failure(&paths, &error))?;
    graph.preamble = preamble(&paths);
    let text = raise(&graph).to_string();
    let graph = read_back(&text)?;
    let reproduced: Vec<bool> =
        examples.iter().map(|example| derivable(&graph, example) == Derivable::Yes).collect();
    prove(&paths, &reproduced)?;
    output::write(&args.output, text.as_bytes())?;
    if let Some(path) = &args.dot {
        output::write(path, dot(&graph).as_bytes())?;
    }
    tell(args, &graph, examples.len())
}

fn failure(paths: &[PathBuf], error: &InferError) -> Failure {
    match error.example() {
        Some(example) => Failure::of_file(&input::name(&paths[example]), error),
        None => Failure::new(error),
    }
}

fn preamble(paths: &[PathBuf]) -> Vec<String> {
    let names: Vec<String> = paths
        .iter()
        .map(|path| {
            path.file_name().map_or_else(|| input::name(path), |name| name.to_string_lossy().into_owned())
        })
        .collect();
    let mut lines = vec!["Learnt by vox from".to_owned()];
    for name in names {
        match lines.last_mut() {
            Some(line) if line.len() + name.len() < 98 => *line += &format!(" {name}"),
            _ => lines.push(name),
        }
    }
    lines
}

/// What the text says is what is proved, not what it was printed from.
fn read_back(text: &str) -> Result<OpGraph, Failure> {
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

fn tell(args: &Args, graph: &OpGraph, examples: usize) -> Result<(), Failure> {
    let grammar = raise(graph);
    let labels: BTreeSet<&str> = grammar.rules.iter().map(|rule| rule.label.name.as_str()).collect();
    if args.json {
        return output::json(&json!({
            "examples": examples,
            "reproduced": examples,
            "rules": grammar.rules.len(),
            "labels": labels.len(),
            "operations": graph.unified().len(),
        }));
    }
    report::note(&format!("{examples} of {examples} examples reproduced, by {} rules", grammar.rules.len()));
    Ok(())
}
