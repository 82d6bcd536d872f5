use super::failure::Failure;
use super::input::{self, Limit};
use super::output;
use super::summary::counted;
use crate::block;
use crate::grid::Grid;
use serde_json::json;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

/// List the items that buildings take: what to gather before you build
///
/// A door, a bed and a tall plant count once, a double slab twice. Of several files, the list is for all together.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox materials house.schem
  vox materials out/*.schem --json

A box is a shulker box of 27 stacks.")]
pub struct Args {
    /// Schematics, or - for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: Limit,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mut totals = BTreeMap::new();
    for path in input::paths(&args.files)? {
        add(&mut totals, &input::grid(&path, &args.limit.reading())?);
    }
    let mut items: Vec<(String, u64)> = totals.into_iter().collect();
    // The sort keeps the order of names among equals.
    items.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    match args.json {
        true => print_json(&items),
        false => output::stdout(text(&items).as_bytes()),
    }
}

fn add(totals: &mut BTreeMap<String, u64>, grid: &Grid) {
    for (state, cells) in grid.counts() {
        for (item, count) in block::items(state) {
            *totals.entry(item).or_insert(0) += cells * count;
        }
    }
}

fn total(items: &[(String, u64)]) -> u64 {
    items.iter().map(|(_, count)| count).sum()
}

fn print_json(items: &[(String, u64)]) -> Result<(), Failure> {
    let each = items.iter().map(|(item, count)| {
        let stack = block::stack(item);
        json!({ "item": item, "count": count, "stack": stack, "stacks": count / stack, "rest": count % stack })
    });
    output::json(&json!({ "items": each.collect::<Vec<_>>(), "total": total(items) }))
}

fn text(items: &[(String, u64)]) -> String {
    let mut text = String::new();
    for (item, count) in items {
        let _ = writeln!(text, "{}", format!("{count:>8}  {item:<32}{}", stacks(item, *count)).trim_end());
    }
    let kinds = counted(items.len() as u64, "kind", "kinds");
    let _ = writeln!(text, "{:>8}  items of {kinds}", total(items));
    text
}

/// How a count is carried: `1 box + 3 stacks + 12`. Less than a stack, and what does not stack, is plain by its number.
fn stacks(item: &str, count: u64) -> String {
    const BOX: u64 = 27;
    let stack = block::stack(item);
    if count < stack || (stack == 1 && count < BOX) {
        return String::new();
    }
    let parts = [
        (count / (stack * BOX), "box", "boxes"),
        (if stack == 1 { 0 } else { count / stack % BOX }, "stack", "stacks"),
    ];
    let rest = if stack == 1 { count % BOX } else { count % stack };
    let parts = parts.into_iter().filter(|(count, ..)| *count > 0);
    let mut words: Vec<String> = parts.map(|(count, one, many)| counted(count, one, many)).collect();
    words.extend((rest > 0).then(|| rest.to_string()));
    words.join(" + ")
}
