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
/// A door, a bed and a tall plant count once, a double slab twice; item frames and armour stands with what they hold. What
/// is in chests does not count. Of several files, the list is for all together.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox materials house.schem
  vox materials out/*.schem --json

A box is a shulker box of 27 stacks.")]
pub struct Args {
    #[arg(required = true, help = input::BUILDINGS)]
    files: Vec<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: Limit,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mut needed = Needed::default();
    for path in input::paths(&args.files)? {
        needed.add(&input::grid(&path, &args.limit.reading())?);
    }
    let items = needed.sorted();
    match args.json {
        true => print_json(&items, &needed),
        false => output::stdout(text(&items, &needed).as_bytes()),
    }
}

/// What buildings take.
#[derive(Default)]
struct Needed {
    items: BTreeMap<String, u64>,
    /// Item frames, armour stands and the like, whose items are among the others.
    entities: u64,
    /// Animals and what else no item puts down.
    left_out: u64,
}

impl Needed {
    fn add(&mut self, grid: &Grid) {
        for (state, cells) in grid.counts() {
            block::items(state).into_iter().for_each(|(item, count)| self.add_item(item, cells * count));
        }
        for entity in &grid.metadata.entities {
            match entity.items() {
                Some(items) => {
                    self.entities += 1;
                    items.into_iter().for_each(|(item, count)| self.add_item(item, count));
                }
                None => self.left_out += 1,
            }
        }
    }

    fn add_item(&mut self, item: String, count: u64) {
        *self.items.entry(item).or_insert(0) += count;
    }

    /// The items, those that most are needed of first.
    fn sorted(&self) -> Vec<(String, u64)> {
        let mut items: Vec<(String, u64)> =
            self.items.iter().map(|(item, count)| (item.clone(), *count)).collect();
        // The sort keeps the order of names among equals.
        items.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        items
    }

    /// What is to be said of entities, one line each.
    fn notes(&self) -> impl Iterator<Item = String> {
        let counted_in = |count| {
            let entities = counted(count, "entity is", "entities are");
            format!("{entities} counted with what they hold (item frames, armour stands, ..)")
        };
        let out = |count| {
            format!("{} left out, which no item puts down", counted(count, "entity is", "entities are"))
        };
        let notes = [(self.entities, counted_in(self.entities)), (self.left_out, out(self.left_out))];
        notes.into_iter().filter(|(count, _)| *count > 0).map(|(_, note)| note)
    }
}

fn total(items: &[(String, u64)]) -> u64 {
    items.iter().map(|(_, count)| count).sum()
}

fn print_json(items: &[(String, u64)], needed: &Needed) -> Result<(), Failure> {
    let each = items.iter().map(|(item, count)| {
        let stack = block::stack(item);
        json!({ "item": item, "count": count, "stack": stack, "stacks": count / stack, "rest": count % stack })
    });
    output::json(&json!({
        "items": each.collect::<Vec<_>>(),
        "total": total(items),
        "entities": needed.entities,
        "entities_left_out": needed.left_out,
    }))
}

fn text(items: &[(String, u64)], needed: &Needed) -> String {
    let mut text = String::new();
    for (item, count) in items {
        let _ = writeln!(text, "{}", format!("{count:>8}  {item:<32}{}", stacks(item, *count)).trim_end());
    }
    let kinds = counted(items.len() as u64, "kind", "kinds");
    let _ = writeln!(text, "{:>8}  items of {kinds}", total(items));
    needed.notes().for_each(|note| text += &format!("{note}\n"));
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
