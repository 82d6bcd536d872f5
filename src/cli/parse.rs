use super::failure::Failure;
use super::input::{self, Limit, Program};
use super::output;
use super::settings::Settings;
use super::why::{scope, word};
use crate::graph::Op;
use crate::grid::Grid;
use crate::parse::{Choice, Derivation, Laws, Parser, Step, Unexplained};
use crate::run::Library;
use crate::space::Bounds;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Find the derivation of buildings under a grammar: the rules, choices and sizes that give them
///
/// Of all derivations the likeliest is told. Where there is none, the smallest region that no rule explains is told, and the
/// exit code is 1.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox parse house.schem village.grammar
  vox parse house*.schem village.grammar --depth 2
  vox parse house.schem village.grammar --json | jq .bits")]
pub struct Args {
    /// The buildings, and one grammar file, which ends in .grammar
    #[arg(required = true, num_args = 2.., value_name = "FILE")]
    files: Vec<PathBuf>,
    /// How many operations inside one another to print
    #[arg(long, value_name = "NUMBER")]
    depth: Option<u32>,
    /// Take lengths for any: the order of parts is all that counts
    #[arg(long)]
    widened: bool,
    /// The rule to start from, instead of the first
    #[arg(long, value_name = "LABEL")]
    start: Option<String>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    limit: Limit,
    /// Print as JSON, one line a building
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let (grammar, buildings) = sorted(&args.files)?;
    let program = input::program(&grammar, args.start.as_deref(), &args.settings)?;
    let library: Library = input::library(&program.graph, &grammar)?;
    let laws = if args.widened { Laws::Widened } else { Laws::AsWritten };
    let parser = Parser::new(&program.graph, laws).with_library(&library);
    let paths = input::paths(&buildings)?;
    let mut failed = false;
    for path in &paths {
        let grid = input::grid(path, &args.limit.reading())?;
        let parsed = parser.parse(&grid);
        failed |= parsed.is_err();
        tell(args, &program, path, &grid, &parsed, paths.len() > 1)?;
    }
    if failed { Err(Failure::Told) } else { Ok(()) }
}

/// The grammar among the files, and the others.
fn sorted(files: &[PathBuf]) -> Result<(PathBuf, Vec<PathBuf>), Failure> {
    let is_grammar = |path: &&PathBuf| path.extension().is_some_and(|ending| ending == "grammar");
    match files.iter().filter(is_grammar).collect::<Vec<_>>().as_slice() {
        [grammar] => {
            let others = files.iter().filter(|path| !is_grammar(path)).cloned().collect();
            Ok(((*grammar).clone(), others))
        }
        found => {
            let failure =
                Failure::new(format!("expected one file that ends in .grammar, found {}", found.len()));
            Err(failure.hint("name it after the buildings: `vox parse house.schem village.grammar`"))
        }
    }
}

fn tell(
    args: &Args,
    program: &Program,
    path: &Path,
    grid: &Grid,
    parsed: &Result<Derivation, Unexplained>,
    is_one_of_several: bool,
) -> Result<(), Failure> {
    let name = input::name(path);
    if args.json {
        return output::json(&match parsed {
            Ok(derivation) => derivation_json(program, &name, derivation),
            Err(unexplained) => unexplained_json(&name, grid, unexplained),
        });
    }
    let mut text = String::new();
    if is_one_of_several {
        let _ = writeln!(text, "{name}:");
    }
    match parsed {
        Ok(derivation) => text += &tree(args, program, derivation),
        Err(unexplained) => text += &reasons(grid, unexplained),
    }
    output::stdout(text.as_bytes())
}

fn tree(args: &Args, program: &Program, derivation: &Derivation) -> String {
    let mut text = format!("{:.1} bits\n", derivation.bits);
    let most = args.depth.unwrap_or(u32::MAX);
    for step in derivation.steps.iter().filter(|step| step.depth < most) {
        let indent = 2 * step.depth as usize + 2;
        let what = what(program, step);
        let choice = choice(program, step).map(|choice| format!(", {choice}")).unwrap_or_default();
        let _ = writeln!(text, "{:indent$}{what}{choice}  {}", "", scope(&step.scope.bounds));
    }
    text
}

/// An operation by its label and its words in the text.
fn what(program: &Program, step: &Step) -> String {
    let graph = &program.graph;
    let label = graph.name(step.node).map(|name| name.label.clone());
    let origin = graph.origin(step.node);
    match (graph.op(step.node), label, origin) {
        (Op::Choose, _, Some(origin)) => origin.label.clone(),
        (Op::All, label, _) => label.unwrap_or_else(|| "side by side".to_owned()),
        (_, label, Some(origin)) => {
            let word = word(&program.sources, origin.span);
            label.filter(|label| *label != word).map_or(word.clone(), |label| format!("{label}: {word}"))
        }
        (_, label, None) => label.unwrap_or_default(),
    }
}

fn choice(program: &Program, step: &Step) -> Option<String> {
    let list = |lengths: &[i32]| lengths.iter().map(ToString::to_string).collect::<Vec<_>>().join(" + ");
    Some(match &step.choice {
        Choice::Only => return None,
        Choice::Alternative(number) | Choice::StretchedAlternative(number) => {
            format!("rule {} of {}", number + 1, program.graph.children(step.node).count())
        }
        Choice::Lengths(lengths) => list(lengths),
        Choice::Times(count) | Choice::StretchedTimes(count) => format!("{count} times"),
        Choice::Stretched(lengths) => list(&lengths.iter().map(|(_, length)| *length).collect::<Vec<i32>>()),
        Choice::Arguments(values) if values.is_empty() => return None,
        Choice::Arguments(values) => format!("with {}", values.join(", ")),
        Choice::Other(cells) => format!("differs in {cells} cells"),
    })
}

fn reasons(grid: &Grid, unexplained: &Unexplained) -> String {
    let percent = 100.0 * unexplained.coverage();
    let mut text = format!(
        "{}; {} of {} blocks are explained ({percent:.1} %)\n",
        unexplained.reason, unexplained.explained, unexplained.cells
    );
    let _ = writeln!(text, "no rule explains {}:", scope(&unexplained.region));
    for (state, count) in standing(grid, unexplained.region).into_iter().take(8) {
        let _ = writeln!(text, "  {count} {state}");
    }
    if unexplained.regions.len() > 1 {
        let _ = writeln!(text, "and {} smaller regions", unexplained.regions.len() - 1);
    }
    text
}

/// What stands in a region, the most frequent first.
fn standing(grid: &Grid, region: Bounds) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for cell in region.intersect(&grid.bounds()).cells() {
        *counts.entry(grid.get(cell).short()).or_default() += 1;
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

fn derivation_json(program: &Program, name: &str, derivation: &Derivation) -> Value {
    let steps = derivation.steps.iter().map(|step| step_json(program, step));
    json!({ "file": name, "bits": derivation.bits, "steps": steps.collect::<Vec<_>>() })
}

fn step_json(program: &Program, step: &Step) -> Value {
    let mut value = json!({
        "what": what(program, step),
        "label": program.graph.name(step.node).map(|name| &name.label),
        "depth": step.depth,
        "min": step.scope.bounds.min.to_array(),
        "size": step.scope.bounds.size().to_array(),
        "turn": 90 * u32::from(step.scope.frame.turn.count()),
    });
    let (key, chosen) = match &step.choice {
        Choice::Only => return value,
        Choice::Alternative(number) | Choice::StretchedAlternative(number) => ("rule", json!(number + 1)),
        Choice::Lengths(lengths) => ("lengths", json!(&**lengths)),
        Choice::Times(count) | Choice::StretchedTimes(count) => ("times", json!(count)),
        Choice::Stretched(lengths) => {
            ("lengths", json!(lengths.iter().map(|(_, length)| length).collect::<Vec<&i32>>()))
        }
        Choice::Arguments(values) => ("arguments", json!(&**values)),
        Choice::Other(cells) => ("differs", json!(cells)),
    };
    value[key] = chosen;
    value
}

fn unexplained_json(name: &str, grid: &Grid, unexplained: &Unexplained) -> Value {
    let region = |region: &Bounds| json!({ "min": region.min.to_array(), "size": region.size().to_array() });
    json!({
        "file": name,
        "reason": unexplained.reason.to_string(),
        "region": region(&unexplained.region),
        "blocks": standing(grid, unexplained.region).into_iter().collect::<BTreeMap<String, usize>>(),
        "regions": unexplained.regions.iter().map(region).collect::<Vec<_>>(),
        "explained": unexplained.explained,
        "cells": unexplained.cells,
    })
}
