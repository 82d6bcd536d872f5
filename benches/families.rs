//! How far what is learnt of real houses reaches: each house of a family is left out in turn.
//!
//!     cargo bench --bench families -- [FAMILY ...] [--samples 24] [--most 8]
//!
//! Families are the folders in `houses` of the folder that `VOX_DATA` names. Coverage is of the house that was left
//! out; what the other columns mean is in `docs/scores.md`. Each line is the mean over the houses left out.

mod common {
    pub mod table;
}
#[path = "../tests/common/real.rs"]
mod real;

use clap::Parser as _;
use common::table::{self, mean};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;
use vox::grid::Grid;
use vox::infer::Freedom::Seen;
use vox::infer::Method::{Boxes, Joint};
use vox::infer::{Example, InferError, Learnt, infer};
use vox::io::{self, Content, Limits};
use vox::parse::{Laws, Parser};
use vox::run::Library;
use vox::score::{Alphabet, Cells, Explained, Samples, Seams, Soundness, novelty, unseen_seams};

#[derive(clap::Parser)]
struct Args {
    /// Names of families; all of them if none is given
    families: Vec<String>,
    /// How many samples to draw of each grammar
    #[arg(long, default_value_t = 24)]
    samples: usize,
    /// How many houses of a family to leave out at the most
    #[arg(long, default_value_t = usize::MAX)]
    most: usize,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

type Method = fn(&[Example]) -> Result<Learnt, InferError>;

/// The methods of learning, with their names.
const METHODS: [(&str, Method); 2] =
    [("joint", |examples| infer(examples, Joint, Seen)), ("boxes", |examples| infer(examples, Boxes, Seen))];

fn main() {
    let args = Args::parse();
    // It says so where there are none.
    let Some(data) = real::folder() else { return };
    let mut lines = Vec::new();
    for (name, houses) in families(&data.join("houses"), &args.families) {
        let copied = (0..houses.len().min(args.most)).map(|out| copying(&houses, out)).collect();
        lines.push(line(&name, "copying", houses.len(), copied));
        for (method, learn) in METHODS {
            let trials = (0..houses.len().min(args.most))
                .filter_map(|out| leaving_out(&houses, out, learn, args.samples))
                .collect();
            lines.push(line(&name, method, houses.len(), trials));
        }
    }
    table::print(&HEAD, &lines);
}

fn families(folder: &Path, names: &[String]) -> Vec<(String, Vec<Grid>)> {
    let name =
        |path: &Path| path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let wanted = |path: &PathBuf| names.is_empty() || names.contains(&name(path));
    sorted(folder).into_iter().filter(wanted).map(|path| (name(&path), houses(&path))).collect()
}

fn sorted(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    paths
}

fn houses(folder: &Path) -> Vec<Grid> {
    let is_house = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "schem");
    let read = |path: PathBuf| match io::read(&path, &Limits::default()) {
        Ok(decoded) => match decoded.content {
            Content::Grid(grid) => Some(grid),
            Content::Boxes(_) => None,
        },
        Err(error) => panic!("{}: {error}", path.display()),
    };
    sorted(folder).into_iter().filter(is_house).filter_map(read).collect()
}

/// What was measured with one house left out.
struct Trial {
    coverage: f64,
    reproduced: f64,
    rules: f64,
    seams: f64,
    novelty: f64,
    sound: f64,
    seconds: f64,
}

const HEAD: [&str; 10] =
    ["family", "method", "houses", "coverage", "reproduced", "rules", "seams", "new", "sound", "s"];

fn line(family: &str, method: &str, houses: usize, trials: Vec<Trial>) -> Vec<String> {
    let mean = |number: fn(&Trial) -> f64| mean(trials.iter().map(number));
    vec![
        family.to_owned(),
        method.to_owned(),
        houses.to_string(),
        format!("{:.2}", mean(|trial| trial.coverage)),
        format!("{:.2}", mean(|trial| trial.reproduced)),
        format!("{:.0}", mean(|trial| trial.rules)),
        format!("{:.1}", mean(|trial| trial.seams)),
        format!("{:.2}", mean(|trial| trial.novelty)),
        format!("{:.2}", mean(|trial| trial.sound)),
        format!("{:.2}", mean(|trial| trial.seconds)),
    ]
}

fn shown(houses: &[Grid], out: usize) -> Vec<Grid> {
    let others = houses.iter().enumerate().filter(|(number, _)| *number != out);
    others.map(|(_, house)| house.clone()).collect()
}

/// Learns from all houses but one.
fn leaving_out(houses: &[Grid], out: usize, learn: Method, count: usize) -> Option<Trial> {
    let shown = shown(houses, out);
    let examples: Vec<Example> = shown.iter().cloned().map(Example::Blocks).collect();
    let before = Instant::now();
    let graph = learn(&examples).ok()?.graph.unified();
    let seconds = before.elapsed().as_secs_f64();
    let parser = Parser::new(&graph, Laws::AsWritten);
    let reproduced = shown.iter().filter(|house| parser.derives(house)).count();
    let samples = Samples::draw(&graph, &Library::new(), 0, count);
    let worst = Soundness::worst(shown.iter().map(Soundness::of));
    let sound = samples.made.iter().filter(|sample| Soundness::of(sample).is_no_worse_than(worst)).count();
    Some(Trial {
        coverage: Explained::of(&parser, &houses[out..=out]).coverage(),
        reproduced: reproduced as f64 / shown.len() as f64,
        rules: graph.len() as f64,
        seams: seams(&samples.made, &shown),
        novelty: novelty(&samples.made, &shown).novelty,
        sound: sound as f64 / samples.len().max(1) as f64,
        seconds,
    })
}

/// Makes nothing but the examples. Of the house left out, each example explains the blocks that it has at the same
/// place.
fn copying(houses: &[Grid], out: usize) -> Trial {
    let mut alphabet = Alphabet::default();
    let left_out = alphabet.cells(&houses[out]);
    let coverage = shown(houses, out)
        .iter()
        .map(|house| in_common(&left_out, &alphabet.cells(house)))
        .fold(0.0, f64::max);
    Trial { coverage, reproduced: 1.0, rules: 0.0, seams: 0.0, novelty: 0.0, sound: 1.0, seconds: 0.0 }
}

/// The share of a building's blocks that another one has at the same place.
fn in_common(wanted: &Cells, other: &Cells) -> f64 {
    let blocks = || wanted.indexed_iter().filter(|(_, state)| **state != vox::score::AIR);
    let same = blocks().filter(|(place, state)| other.get(*place) == Some(state)).count();
    same as f64 / blocks().count().max(1) as f64
}

fn seams(samples: &[Grid], examples: &[Grid]) -> f64 {
    let mut alphabet = Alphabet::default();
    let examples: Vec<Cells> = alphabet.all(examples);
    unseen_seams(&alphabet.all(samples), &Seams::of(&examples))
}
