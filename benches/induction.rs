//! How much of a known grammar is learnt back from its samples.
//!
//!     cargo bench --bench induction -- [GRAMMAR ...] [--examples 3,5,10,20] [--seeds 5] [--samples 100]
//!
//! Grammars are those of `tests/truth`, by name. Each line is the mean over seeds. The same arguments give
//! the same table, but for the seconds. What each column means is in `docs/scores.md`.

mod common {
    pub mod table;
}

use clap::Parser as _;
use common::table::{self, mean};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;
use vox::grammar;
use vox::graph::{OpGraph, lower};
use vox::grid::Grid;
use vox::infer::{Example, Freedom, Method, infer};
use vox::parse::{Laws, Parser};
use vox::run::Library;
use vox::score::{Agreement, Alphabet, Cells, Explained, Length, Samples, Seams, agreement, unseen_seams};

#[derive(clap::Parser)]
struct Args {
    /// Names of grammars in tests/truth; all of them if none is given
    grammars: Vec<String>,
    /// How many examples to learn from
    #[arg(long, value_delimiter = ',', default_value = "3,5,10,20")]
    examples: Vec<usize>,
    /// How many times to do so, each time with other examples
    #[arg(long, default_value_t = 5)]
    seeds: u64,
    /// How many samples to draw of either grammar
    #[arg(long, default_value_t = 100)]
    samples: usize,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() {
    let args = Args::parse();
    let truths = truths(&args.grammars);
    println!(
        "{} grammars, {} seeds, {} samples; s is for learning from 10,000 cells\n",
        truths.len(),
        args.seeds,
        args.samples
    );
    let mut lines = Vec::new();
    let mut measured = Vec::new();
    for truth in &truths {
        for &examples in &args.examples {
            let trials: Vec<Trial> =
                (0..args.seeds).map(|seed| trial(truth, examples, seed, args.samples)).collect();
            let trial = Trial::mean(&trials);
            lines.push(trial.line(&truth.name, examples));
            measured.push((examples, trial));
        }
    }
    table::print(&HEAD, &lines);
    println!();
    args.examples.iter().for_each(|examples| summarise(*examples, &measured));
}

/// A grammar that is known.
struct Truth {
    name: String,
    graph: OpGraph,
}

fn truths(names: &[String]) -> Vec<Truth> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/truth");
    let files = fs::read_dir(folder).expect("tests/truth is there");
    let mut files: Vec<PathBuf> = files.filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.sort();
    let truths = files.iter().map(|path| Truth {
        name: path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned()),
        graph: graph(path),
    });
    truths.filter(|truth| names.is_empty() || names.contains(&truth.name)).collect()
}

fn graph(path: &Path) -> OpGraph {
    let text = fs::read_to_string(path).expect("it can be read");
    let checked = grammar::read(&text).unwrap_or_else(|errors| panic!("{}: {errors:?}", path.display()));
    lower(&checked, None).expect("it has a first rule")
}

/// What was measured, of one set of examples or on average over several.
#[derive(Clone, Copy)]
struct Trial {
    precision: f64,
    recall: f64,
    /// The recall that no grammar exceeds which shows nothing that its examples do not show.
    reachable: f64,
    structural: f64,
    /// Of the examples.
    reproduced: f64,
    rules: f64,
    true_rules: f64,
    /// Description length over that of zlib; nothing where an example is not reproduced.
    length: f64,
    /// The same of the true grammar.
    true_length: f64,
    seams: f64,
    /// Learning from 10,000 cells.
    seconds: f64,
    slowest: f64,
}

const HEAD: [&str; 12] = [
    "grammar",
    "examples",
    "reproduced",
    "precision",
    "recall",
    "reachable",
    "structural",
    "rules",
    "length",
    "seams",
    "s",
    "worst s",
];

impl Trial {
    fn mean(trials: &[Trial]) -> Trial {
        let mean = |number: fn(&Trial) -> f64| mean(trials.iter().map(number).filter(|n| !n.is_nan()));
        Trial {
            precision: mean(|trial| trial.precision),
            recall: mean(|trial| trial.recall),
            reachable: mean(|trial| trial.reachable),
            structural: mean(|trial| trial.structural),
            reproduced: mean(|trial| trial.reproduced),
            rules: mean(|trial| trial.rules),
            true_rules: mean(|trial| trial.true_rules),
            length: mean(|trial| trial.length),
            true_length: mean(|trial| trial.true_length),
            seams: mean(|trial| trial.seams),
            seconds: mean(|trial| trial.seconds),
            slowest: trials.iter().map(|trial| trial.slowest).fold(0.0, f64::max),
        }
    }

    fn line(&self, name: &str, examples: usize) -> Vec<String> {
        vec![
            name.to_owned(),
            examples.to_string(),
            format!("{:.2}", self.reproduced),
            format!("{:.2}", self.precision),
            format!("{:.2}", self.recall),
            format!("{:.2}", self.reachable),
            format!("{:.2}", self.structural),
            format!("{:.1} : {}", self.rules, self.true_rules),
            format!("{:.2} : {:.2}", self.length, self.true_length),
            format!("{:.1}", self.seams),
            format!("{:.3}", self.seconds),
            format!("{:.3}", self.slowest),
        ]
    }
}

fn trial(truth: &Truth, count: usize, seed: u64, wanted: usize) -> Trial {
    let (first, library) = (seed * 1_000_000, Library::new());
    let grids = Samples::draw(&truth.graph, &library, first, count).made;
    let examples: Vec<Example> = grids.iter().cloned().map(Example::Blocks).collect();
    let before = Instant::now();
    let learnt =
        infer(&examples, Method::default(), Freedom::default()).expect("there are examples").graph.unified();
    let seconds = before.elapsed().as_secs_f64();
    let cells: u64 = grids.iter().map(|grid| grid.bounds().volume()).sum();
    let seconds = seconds * 10_000.0 / cells as f64;
    let explained = Explained::of(&Parser::new(&learnt, Laws::AsWritten), &grids);
    let explained_truly = Explained::of(&Parser::new(&truth.graph, Laws::AsWritten), &grids);
    let length = |graph, explained| Length::of(graph, explained, &grids).map_or(f64::NAN, Length::ratio);
    let Agreement { precision, recall, structural_recall, rules, true_rules, .. } =
        agreement(&learnt, &truth.graph, &library, &grids, first + 500_000, wanted);
    Trial {
        precision,
        recall,
        reachable: reachable(&truth.graph, &grids, first + 500_000, wanted),
        structural: structural_recall,
        reproduced: explained.reproduced() as f64 / grids.len() as f64,
        rules: rules as f64,
        true_rules: true_rules as f64,
        length: length(&learnt, &explained),
        true_length: length(&truth.graph, &explained_truly),
        seams: seams(&Samples::draw(&learnt, &library, first, wanted).made, &grids),
        seconds,
        slowest: seconds,
    }
}

/// The share of fresh samples of the true grammar that put nothing side by side which examples do not. To cover any
/// other is to make unseen neighbourhoods.
fn reachable(truth: &OpGraph, examples: &[Grid], first_seed: u64, wanted: usize) -> f64 {
    let fresh = Samples::draw_fresh(truth, &Library::new(), first_seed, wanted, examples).made;
    let mut alphabet = Alphabet::default();
    let shown = Seams::of(&alphabet.all(examples));
    let samples: Vec<Cells> = alphabet.all(&fresh);
    let is_shown = |sample: &&Cells| unseen_seams(std::slice::from_ref(*sample), &shown) == 0.0;
    match samples.len() {
        0 => f64::NAN,
        all => samples.iter().filter(is_shown).count() as f64 / all as f64,
    }
}

fn seams(samples: &[Grid], examples: &[Grid]) -> f64 {
    let mut alphabet = Alphabet::default();
    let examples: Vec<Cells> = alphabet.all(examples);
    unseen_seams(&alphabet.all(samples), &Seams::of(&examples))
}

/// The means over all grammars beside the bars, with the worst of what every grammar has to reach.
fn summarise(examples: usize, measured: &[(usize, Trial)]) {
    let of_count: Vec<Trial> =
        measured.iter().filter(|(count, _)| *count == examples).map(|(_, trial)| *trial).collect();
    let all = Trial::mean(&of_count);
    let least = |number: fn(&Trial) -> f64| of_count.iter().map(number).fold(f64::INFINITY, f64::min);
    let most = |number: fn(&Trial) -> f64| of_count.iter().map(number).fold(0.0, f64::max);
    let rules = |trial: &Trial| trial.rules / trial.true_rules;
    println!("{examples} examples:");
    let line = |what: &str, mean: f64, worst: f64, bar: &str| {
        println!("  {what:<18} mean {mean:>5.2}  worst {worst:>5.2}  {bar}");
    };
    let from_five = |bar: &'static str| if examples < 5 { "" } else { bar };
    line("reproduced", all.reproduced, least(|trial| trial.reproduced), "bar: every one");
    line("precision", all.precision, least(|trial| trial.precision), "bar: 0.95 on every grammar");
    line("structural recall", all.structural, least(|trial| trial.structural), from_five("bar: 0.95"));
    let recall = if examples < 10 { "bar: 0.80 on average" } else { "bar: 0.95" };
    line("recall", all.recall, least(|trial| trial.recall), from_five(recall));
    line("reachable", all.reachable, least(|trial| trial.reachable), "recall, with no unseen neighbourhood");
    line("rules : true", mean(of_count.iter().map(rules)), most(rules), "bar: 1.5");
    line("length : zlib's", all.length, most(|trial| trial.length), "bar: 0.33");
    line("of the true one", all.true_length, most(|trial| trial.true_length), "");
    line("unseen seams", all.seams, most(|trial| trial.seams), "in 1,000 cells");
    line("seconds", all.seconds, all.slowest, "for 10,000 cells; bar: 0.2");
}
