//! `vox info`.

mod json;
mod tags;
mod text;

use super::failure::Failure;
use super::input::{self, Limit, Reading};
use super::output;
use crate::grid::{BiomeMap, Entity, Grid, LabelledBoxes};
use crate::io::{Content, Decoded, Format, Scale};
use crate::nbt::{Compound, Tag};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Tell what is in a file, what it says of itself, and what is odd about it
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox info cottage.schem
  vox info --json *.schem | jq .blocks")]
pub struct Args {
    #[arg(required = true, help = input::FILES)]
    files: Vec<PathBuf>,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
    #[command(flatten)]
    limit: Limit,
    /// Print as JSON, one line a file
    #[arg(long)]
    json: bool,
    /// List all block states, not only the most frequent ones; JSON always has all
    #[arg(long)]
    all: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let reading = args.limit.scaled(args.scale);
    let mut failed = false;
    for path in input::paths(&args.files)? {
        match tell(&path, args, &reading) {
            Ok(()) => {}
            Err(Failure::Pipe) => return Err(Failure::Pipe),
            Err(failure) => {
                failure.report();
                failed = true;
            }
        }
    }
    if failed { Err(Failure::Told) } else { Ok(()) }
}

fn tell(path: &Path, args: &Args, reading: &Reading) -> Result<(), Failure> {
    let (name, decoded) = (input::name(path), input::decoded(path, reading)?);
    let notes = notes(path, &decoded);
    match args.json {
        true => output::json(&json::of(&name, &decoded, &notes)),
        false => output::stdout(text::of(&name, &decoded, &notes, args.shown()).as_bytes()),
    }
}

impl Args {
    /// How many block states are listed.
    fn shown(&self) -> usize {
        const MOST: usize = 20;
        if self.all { usize::MAX } else { MOST }
    }
}

/// What is odd about a file.
fn notes(path: &Path, decoded: &Decoded) -> Vec<String> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let format = decoded.about.format;
    let has_name = !input::is_stdio(path) && !path.is_dir();
    let wrong_name = (has_name && !ending.eq_ignore_ascii_case(format.ending()))
        .then(|| format!("the name ends in `.{ending}`, but this is {format}"));
    let warnings = decoded.warnings.iter().map(ToString::to_string);
    let oddities = match &decoded.content {
        Content::Grid(grid) => grid.oddities(),
        Content::Boxes(_) => Vec::new(),
    };
    let oddities = oddities.iter().map(ToString::to_string);
    wrong_name.into_iter().chain(warnings).chain(oddities).collect()
}

/// The name of a format without its article.
fn format_name(format: Format) -> String {
    let described = format.to_string();
    described.split_once(' ').map_or(described.clone(), |(_, name)| name.to_owned())
}

/// How many there are of each.
type Counts = BTreeMap<String, u64>;

fn block_entities(grid: &Grid) -> Counts {
    tally(grid.block_entities.values().map(id))
}

fn entities(grid: &Grid) -> Counts {
    tally(grid.metadata.entities.iter().map(|Entity { data, .. }| id(data)))
}

/// How many columns or cells each biome has.
fn biomes(grid: &Grid) -> Counts {
    let Some(biomes) = &grid.metadata.biomes else { return Counts::new() };
    let name = |id: &u16| biomes.names.get(usize::from(*id)).map_or("unknown", String::as_str).to_owned();
    match &biomes.map {
        BiomeMap::Columns(columns) => tally(columns.iter().map(name)),
        BiomeMap::Cells(cells) => tally(cells.iter().map(name)),
    }
}

fn labels(boxes: &LabelledBoxes) -> Counts {
    tally(boxes.boxes.iter().map(|labelled| labelled.label.clone()))
}

fn tally(names: impl Iterator<Item = String>) -> Counts {
    let mut counts = Counts::new();
    names.for_each(|name| *counts.entry(name).or_insert(0) += 1);
    counts
}

fn id(data: &Compound) -> String {
    match data.get("id") {
        Some(Tag::String(id)) => id.strip_prefix("minecraft:").unwrap_or(id).to_owned(),
        _ => "without an id".to_owned(),
    }
}
