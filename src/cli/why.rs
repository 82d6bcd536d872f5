use super::failure::Failure;
use super::input::{self, Program};
use super::output;
use super::run::OverrunArg;
use super::settings::Settings;
use super::size::SizeArg;
use crate::grammar::{Checked, Sources, Span};
use crate::graph::Op;
use crate::run::{self, Cause, Kind, Limits, Options, Step, Why};
use crate::space::Bounds;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// Tell why a block stands where it stands: the rules, choices and scopes that led to it
///
/// The grammar runs again with the same seed and size. Places are those of the schematic.
#[derive(clap::Args)]
#[command(after_help = "\
Example:
  vox run village.grammar --seed 7 -o house.schem
  vox why village.grammar 3 1 0 --seed 7")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    /// The place of the block: x, y and z from the low corner
    #[arg(num_args = 3, required = true, value_names = ["X", "Y", "Z"])]
    place: Vec<i32>,
    /// The size of the start scope along the grammar's x, y and z; otherwise one that the grammar states
    #[arg(long, value_name = "XxYxZ")]
    size: Option<SizeArg>,
    /// The seed of the building
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// The rule to start from, instead of the first
    #[arg(long, value_name = "LABEL")]
    start: Option<String>,
    /// What to do where sizes do not fit their scope
    #[arg(long, value_enum, default_value = "error")]
    overrun: OverrunArg,
    #[command(flatten)]
    settings: Settings,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let program = input::program(&args.grammar, args.start.as_deref(), &args.settings)?;
    let library = input::library(&program.graph, &args.grammar)?;
    let cell = [args.place[0], args.place[1], args.place[2]].into();
    let options = Options {
        seed: args.seed,
        size: args.size.map(|size| size.0),
        overrun: args.overrun.overrun(),
        detail: None,
        limits: Limits::default(),
    };
    let why = run::why(&program.graph, &library, &options, cell).map_err(|error| match error {
        error if error.origin.is_none() && error.kind == Kind::OutsidePlot => {
            Failure::of_file(program.sources.root(), format!("{} lies outside of what it makes", place(args)))
        }
        error => input::run_failure(&program.sources, &error),
    })?;
    match args.json {
        true => output::json(&as_json(args, &program, &why)),
        false => output::stdout(text(args, &program, &why).as_bytes()),
    }
}

fn place(args: &Args) -> String {
    format!("({}, {}, {})", args.place[0], args.place[1], args.place[2])
}

fn text(args: &Args, program: &Program, why: &Why) -> String {
    let mut text = format!("{}: {}\n", place(args), why.state.short());
    if why.causes.is_empty() {
        text += "nothing was put there\n";
    }
    let Some((last, before)) = why.causes.split_last() else { return text };
    text += &tree(program, last);
    if why.untold > 0 {
        let _ = writeln!(text, "\n{} more were overwritten before these", why.untold);
    }
    for cause in before.iter().rev() {
        let _ = writeln!(text, "\nover {}:", cause.state.short());
        text += &tree(program, cause);
    }
    text
}

/// The operations from the start down, each further in than the one before it.
fn tree(program: &Program, cause: &Cause) -> String {
    let mut text = String::new();
    for (depth, line) in lines(program, cause).iter().enumerate() {
        let choice = line.choice.as_ref().map(|choice| format!(", {}", choice.text())).unwrap_or_default();
        let at = line.span.map(|span| format!("  {}", source(&program.sources, span))).unwrap_or_default();
        let (what, scope, indent) = (&line.what, scope(&line.bounds), 2 * depth + 2);
        let _ = writeln!(text, "{:indent$}{what}{choice}{at}  {scope}", "");
    }
    text
}

/// One operation of the way to a block.
struct Line {
    what: String,
    choice: Option<Choice>,
    span: Option<Span>,
    bounds: Bounds,
}

/// Which rule of a label was taken.
struct Choice {
    /// From 1.
    number: usize,
    of: usize,
    weight: Option<String>,
    condition: Option<String>,
    span: Span,
}

impl Choice {
    fn text(&self) -> String {
        let condition = self.condition.as_ref().map(|condition| format!(" where {condition}"));
        let weight = self.weight.as_ref().map(|weight| format!(", weight {weight}"));
        let [condition, weight] = [condition, weight].map(Option::unwrap_or_default);
        format!("rule {} of {}{condition}{weight}", self.number, self.of)
    }

    fn as_json(&self) -> Value {
        json!({ "rule": self.number, "of": self.of, "weight": self.weight, "condition": self.condition })
    }
}

fn lines(program: &Program, cause: &Cause) -> Vec<Line> {
    let next = cause.steps.iter().skip(1).map(Some).chain([None]);
    cause.steps.iter().zip(next).map(|(step, next)| line(program, step, next)).collect()
}

fn line(program: &Program, step: &Step, next: Option<&Step>) -> Line {
    let (graph, bounds) = (&program.graph, step.scope.bounds);
    let origin = graph.origin(step.node);
    let label = graph.name(step.node).map(|name| name.label.as_str());
    if let (Op::Choose, Some(origin)) = (graph.op(step.node), origin) {
        let choice = next.and_then(|next| choice(&program.checked, &origin.label, next.number as usize));
        let span = choice.as_ref().map(|choice| choice.span);
        return Line { what: origin.label.clone(), choice, span, bounds };
    }
    let span = origin.map(|origin| origin.span);
    if matches!(graph.op(step.node), Op::All) {
        return Line { what: label.unwrap_or("side by side").to_owned(), choice: None, span, bounds };
    }
    let word = span.map_or_else(String::new, |span| word(&program.sources, span));
    let what = match label {
        Some(label) if word != label => format!("{label}: {word}"),
        _ => word,
    };
    Line { what, choice: None, span, bounds }
}

/// The rule of that number of a label.
fn choice(checked: &Checked, label: &str, number: usize) -> Option<Choice> {
    let rule = checked.rules_of(label).nth(number)?;
    Some(Choice {
        number: number + 1,
        of: checked.rules_of(label).count(),
        weight: rule.weight.as_ref().map(ToString::to_string),
        condition: rule.condition.as_ref().map(ToString::to_string),
        span: rule.label.span,
    })
}

/// An operation in the words of the text, up to its parts.
pub fn word(sources: &Sources, span: Span) -> String {
    let place = sources.place(span);
    let text = &place.text[place.span.range()];
    text[..text.find(['{', '\n', '#']).unwrap_or(text.len())].trim_end().to_owned()
}

fn source(sources: &Sources, span: Span) -> String {
    let place = sources.place(span);
    let (line, column) = place.line_column();
    format!("{}:{line}:{column}", place.name)
}

/// A scope by its size and low corner, in the world's axes.
pub fn scope(bounds: &Bounds) -> String {
    let (size, min) = (bounds.size(), bounds.min);
    format!("[{} x {} x {} at ({}, {}, {})]", size.x, size.y, size.z, min.x, min.y, min.z)
}

fn as_json(args: &Args, program: &Program, why: &Why) -> Value {
    let causes: Vec<Value> = why.causes.iter().rev().map(|cause| cause_json(program, cause)).collect();
    json!({
        "place": args.place,
        "block": why.state.to_string(),
        "causes": causes,
        "untold": why.untold,
    })
}

fn cause_json(program: &Program, cause: &Cause) -> Value {
    let steps = lines(program, cause).into_iter().map(|line| {
        let place = line.span.map(|span| program.sources.place(span));
        json!({
            "what": line.what,
            "file": place.map(|place| place.name),
            "line": place.map(|place| place.line_column().0),
            "column": place.map(|place| place.line_column().1),
            "choice": line.choice.as_ref().map(Choice::as_json),
            "min": line.bounds.min.to_array(),
            "size": line.bounds.size().to_array(),
        })
    });
    json!({ "block": cause.state.to_string(), "steps": steps.collect::<Vec<_>>() })
}
