use super::failure::Failure;
use super::input::{self, Limit};
use super::output;
use super::report;
use super::summary::counted;
use crate::grid::{BlockDiff, Diff, Entity};
use crate::nbt::Tag;
use crate::space::Cell;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Tell what is different between two buildings
///
/// They may be different kinds of files. Blocks are compared place by place from the low corners.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox diff old.schem new.schem
  vox diff house.schem copy.schem && echo same

Exit codes: 0 the buildings are the same, 1 they are not, 2 a file cannot be read.")]
pub struct Args {
    #[arg(help = input::BUILDINGS)]
    old: PathBuf,
    /// The other building
    new: PathBuf,
    /// Print as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: Limit,
}

/// As other programs that compare, this one says by its exit code what it found.
pub fn execute(args: &Args) -> ExitCode {
    match compare(args) {
        Ok(true) | Err(Failure::Pipe) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            failure.report();
            ExitCode::from(2)
        }
    }
}

/// Whether both are the same; what is different is told.
fn compare(args: &Args) -> Result<bool, Failure> {
    let [old, new] = [&args.old, &args.new].map(|path| input::grid(path, &args.limit.reading()));
    let diff = Diff::of(&old?, &new?);
    let names = [input::name(&args.old), input::name(&args.new)];
    match args.json {
        true => output::json(&as_json(&names, &diff))?,
        false if diff.is_none() => {
            report::note(&format!("{} and {} hold the same building", names[0], names[1]));
        }
        false => output::stdout(text(&names, &diff).as_bytes())?,
    }
    Ok(diff.is_none())
}

fn text(names: &[String; 2], diff: &Diff) -> String {
    let mut text = format!("{} -> {}\n", names[0], names[1]);
    let mut line = |label: &str, value: String| {
        let _ = writeln!(text, "  {label:<15}{value}");
    };
    let [from, to] = diff.sizes.map(|size| format!("{} x {} x {}", size.x, size.y, size.z));
    if from != to {
        line("size", format!("{from} -> {to}"));
    }
    if !diff.metadata.is_empty() {
        line("metadata", diff.metadata.iter().cloned().collect::<Vec<_>>().join(", "));
    }
    if !diff.block_entities.is_empty() {
        line("block entities", format!("{} at {}", diff.block_entities.len(), places(&diff.block_entities)));
    }
    for (entities, verb) in diff.entities.iter().zip(["gone", "new"]) {
        for (id, count) in by_id(entities) {
            line("entities", format!("{count} {id} {verb}"));
        }
    }
    line("blocks", total(&diff.blocks));
    for BlockDiff { states: [from, to], count, first } in &diff.blocks {
        let place = places(std::slice::from_ref(first));
        let _ = writeln!(text, "  {count:>10}  {} -> {}, first at {place}", from.short(), to.short());
    }
    text
}

fn total(blocks: &[BlockDiff]) -> String {
    let total = blocks.iter().map(|diff| diff.count).sum();
    format!("{} different", counted(total, "cell is", "cells are"))
}

/// The first few places.
fn places(cells: &[Cell]) -> String {
    const SHOWN: usize = 4;
    let shown = cells.iter().take(SHOWN).map(|cell| format!("({}, {}, {})", cell.x, cell.y, cell.z));
    let more = if cells.len() > SHOWN { ", ..." } else { "" };
    format!("{}{more}", shown.collect::<Vec<_>>().join(", "))
}

fn by_id(entities: &[Entity]) -> BTreeMap<String, u64> {
    let mut counts = BTreeMap::new();
    for entity in entities {
        let id = match entity.data.get("id") {
            Some(Tag::String(id)) => id.strip_prefix("minecraft:").unwrap_or(id),
            _ => "entity without an id",
        };
        *counts.entry(id.to_owned()).or_insert(0) += 1;
    }
    counts
}

fn as_json(names: &[String; 2], diff: &Diff) -> Value {
    let block = |BlockDiff { states: [from, to], count, first }: &BlockDiff| json!({ "from": from.to_string(), "to": to.to_string(), "count": count, "first": first.to_array() });
    let places: Vec<[i32; 3]> = diff.block_entities.iter().map(|place| place.to_array()).collect();
    json!({
        "files": names,
        "same": diff.is_none(),
        "sizes": diff.sizes.map(|size| size.to_array()),
        "blocks": diff.blocks.iter().map(block).collect::<Vec<_>>(),
        "block_entities": places,
        "entities_gone": by_id(&diff.entities[0]),
        "entities_new": by_id(&diff.entities[1]),
        "metadata": diff.metadata,
    })
}
