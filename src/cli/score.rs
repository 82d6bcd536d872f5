use super::failure::Failure;
use super::input::{self, Limit, Program};
use super::output;
use super::settings::Settings;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::score::{Agreement, Rooms, Scores, Soundness, agreement, scores};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Tell how good a grammar is beside the buildings that it was learnt from
///
/// What each number means: docs/scores.md. The same files, seed and number of samples always give the same numbers.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox score village.grammar --against house*.schem
  vox score village.grammar --against house*.schem -n 500 --json
  vox score learnt.grammar --against house*.schem --truth known.grammar")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    /// The examples
    #[arg(long, required = true, num_args = 1.., value_name = "FILE")]
    against: Vec<PathBuf>,
    /// How many samples to draw
    #[arg(short, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    number: u32,
    /// The seed of the first sample; each further one takes the next
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// The grammar that the examples were made by: how much of it was learnt
    #[arg(long, value_name = "GRAMMAR")]
    truth: Option<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    limit: Limit,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let Program { sources, graph, .. } = input::program(&args.grammar, None, &args.settings)?;
    let library = input::library(&graph, &args.grammar)?;
    require_size(sources.root(), &graph)?;
    let reading = args.limit.reading();
    let paths = input::paths(&args.against)?;
    let examples =
        paths.iter().map(|path| input::grid(path, &reading)).collect::<Result<Vec<Grid>, Failure>>()?;
    let count = args.number as usize;
    let found = scores(&graph, &library, &examples, args.seed, count);
    let truth = args.truth.as_ref().map(|path| truth(path)).transpose()?;
    let agreed = truth.map(|truth| agreement(&graph, &truth, &library, &examples, args.seed, count));
    match args.json {
        true => output::json(&as_json(&found, agreed.as_ref())),
        false => output::stdout(table(&found, agreed.as_ref()).as_bytes()),
    }
}

fn truth(path: &Path) -> Result<OpGraph, Failure> {
    let Program { sources, graph, .. } = input::program(path, None, &Settings::default())?;
    require_size(sources.root(), &graph)?;
    Ok(graph)
}

/// A grammar without a size makes no sample at all: that is told once.
fn require_size(name: &str, graph: &OpGraph) -> Result<(), Failure> {
    match graph.sizes.is_empty() {
        true => Err(Failure::of_file(name, "the size of the samples is not known")
            .hint("write one in the grammar: `size(9, 7, 9)`")),
        false => Ok(()),
    }
}

/// A line of the table: what is scored, the number, and what belongs to it.
struct Line(&'static str, String, String);

fn table(found: &Scores, agreed: Option<&Agreement>) -> String {
    let mut lines = of_examples(found);
    lines.extend(of_samples(found));
    lines.extend(agreed.into_iter().flat_map(of_truth));
    let lines = lines.iter().map(|Line(what, number, beside)| {
        format!("{}\n", format!("{what:<22}{number:>8}  {beside}").trim_end())
    });
    lines.collect()
}

fn of_examples(found: &Scores) -> Vec<Line> {
    let length = match found.length {
        Some(length) => Line(
            "length beside zlib's",
            share(length.ratio()),
            format!("{:.0} bits, {:.0} of them the grammar's", length.model + length.data, length.model),
        ),
        None => Line("length beside zlib's", none(), "not every example is reproduced".to_owned()),
    };
    vec![
        Line("reproduced", found.reproduced.to_string(), format!("of {} examples", found.examples)),
        Line("coverage", share(found.coverage), "of their blocks".to_owned()),
        length,
        Line("learnt by heart", found.template.map_or_else(none, share), "of their blocks".to_owned()),
    ]
}

fn of_samples(found: &Scores) -> Vec<Line> {
    let [near, far] = found.distances;
    let plain = |what, number: String, beside: &str| Line(what, number, beside.to_owned());
    let (rooms, shown) = (&found.rooms.samples, &found.rooms.examples);
    let (faults, worst) = (&found.faults.samples, &found.faults.examples);
    let of_rooms = |part: usize, whole: usize| {
        if whole == 0 { none() } else { share(part as f64 / whole as f64) }
    };
    let beside_faults = |most: usize| format!("in a sample at most, {most} in an example");
    vec![
        Line("samples", found.samples.to_string(), format!("{} runs failed", found.failed)),
        plain("new", share(found.novelty.novelty), "equal to no example"),
        plain("different", share(found.novelty.variety), "of one another"),
        plain("copies", share(found.novelty.copies), "equal to an example, turned or not"),
        plain("unseen seams", format!("{:.2}", found.seams), "in 1,000 cells"),
        plain("distance", format!("{near:.2}"), "of neighbourhoods of 2 x 2 x 2"),
        plain("", format!("{far:.2}"), "of neighbourhoods of 3 x 3 x 3"),
        plain("odd parts", format!("{:.2}", found.odd), "in a sample"),
        Line(
            "reachable rooms",
            of_rooms(rooms.reachable, rooms.rooms),
            format!("{} in the examples", of_rooms(shown.reachable, shown.rooms)),
        ),
        Line(
            "roofless columns",
            of_rooms(rooms.roofless, rooms.columns),
            format!("{} in the examples", of_rooms(shown.roofless, shown.columns)),
        ),
        plain("sound", share(found.sound), "no more faults than an example"),
        Line("floating pieces", faults.floating.to_string(), beside_faults(worst.floating)),
        Line("missing halves", faults.halves.to_string(), beside_faults(worst.halves)),
        Line("illegal states", faults.illegal.to_string(), beside_faults(worst.illegal)),
    ]
}

fn of_truth(agreed: &Agreement) -> Vec<Line> {
    let plain = |what, number: String, beside: &str| Line(what, number, beside.to_owned());
    vec![
        Line(
            "precision",
            share(agreed.precision),
            format!("of {} fresh samples are of the true grammar", agreed.fresh),
        ),
        plain("recall", share(agreed.recall), "of fresh samples of the true grammar"),
        plain("structural recall", share(agreed.structural_recall), "of them, with any lengths of parts"),
        Line("rules", agreed.rules.to_string(), format!("{} in the true grammar", agreed.true_rules)),
    ]
}

/// What stands where there is no number.
fn none() -> String {
    "-".to_owned()
}

fn share(number: f64) -> String {
    format!("{number:.2}")
}

fn as_json(found: &Scores, agreed: Option<&Agreement>) -> Value {
    let rooms = |rooms: &Rooms| {
        json!({
            "rooms": rooms.rooms,
            "reachable": rooms.reachable,
            "columns": rooms.columns,
            "roofless": rooms.roofless,
            "inside": rooms.inside,
        })
    };
    let faults = |faults: &Soundness| json!({ "floating": faults.floating, "halves": faults.halves, "illegal": faults.illegal });
    json!({
        "examples": found.examples,
        "reproduced": found.reproduced,
        "coverage": found.coverage,
        "length": found.length.map(|length| json!({
            "model": length.model,
            "data": length.data,
            "zlib": length.zlib,
            "ratio": length.ratio(),
        })),
        "template": found.template,
        "samples": found.samples,
        "failed": found.failed,
        "novelty": found.novelty.novelty,
        "variety": found.novelty.variety,
        "copies": found.novelty.copies,
        "unseen_seams": found.seams,
        "distance_2": found.distances[0],
        "distance_3": found.distances[1],
        "odd_parts": found.odd,
        "rooms": { "samples": rooms(&found.rooms.samples), "examples": rooms(&found.rooms.examples) },
        "faults": { "samples": faults(&found.faults.samples), "examples": faults(&found.faults.examples) },
        "sound": found.sound,
        "truth": agreed.map(|agreed| json!({
            "precision": agreed.precision,
            "recall": agreed.recall,
            "structural_recall": agreed.structural_recall,
            "fresh": agreed.fresh,
            "rules": agreed.rules,
            "true_rules": agreed.true_rules,
        })),
    })
}
