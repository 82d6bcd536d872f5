use super::failure::Failure;
use super::input::{self, Reading};
use super::output;
use crate::block::BlockState;
use crate::grid::{Grid, LabelledBoxes};
use crate::io::{Content, Scale};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

/// Tell what is in a file: its size, its blocks, what it says of itself
#[derive(clap::Args)]
#[command(after_help = "Example:\n  vox info cottage.schem")]
pub struct Args {
    /// Schematics or OBJ files, or - for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
    /// Print as JSON, one line a file
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let reading = Reading { scale: args.scale.unwrap_or_default(), ..Reading::default() };
    for path in input::paths(&args.files)? {
        let name = input::name(&path);
        match (input::content(&path, &reading)?, args.json) {
            (Content::Grid(grid), true) => output::json(&grid_json(&name, &grid))?,
            (Content::Grid(grid), false) => output::stdout(grid_text(&name, &grid).as_bytes())?,
            (Content::Boxes(boxes), true) => output::json(&boxes_json(&name, &boxes))?,
            (Content::Boxes(boxes), false) => output::stdout(boxes_text(&name, &boxes).as_bytes())?,
        }
    }
    Ok(())
}

/// How often each block state stands in the grid, the most frequent first.
fn counts(grid: &Grid) -> Vec<(&BlockState, u64)> {
    let mut counts = vec![0; grid.palette().states().len()];
    grid.cells().iter().for_each(|id| counts[usize::from(*id)] += 1);
    let mut counted: Vec<_> =
        grid.palette().states().iter().zip(counts).filter(|(_, count)| *count > 0).collect();
    counted.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    counted
}

fn solid(counted: &[(&BlockState, u64)]) -> u64 {
    counted.iter().filter(|(state, _)| !state.is_air()).map(|(_, count)| count).sum()
}

fn grid_text(name: &str, grid: &Grid) -> String {
    let (size, counted) = (grid.size(), counts(grid));
    let metadata = &grid.metadata;
    let version = metadata.data_version.map_or("not said".to_owned(), |version| version.to_string());
    let mut text = format!("{name}\n");
    let mut line = |label: &str, value: String| {
        let _ = writeln!(text, "  {label:<15}{value}");
    };
    line("size", format!("{} x {} x {} (x, y, z)", size.x, size.y, size.z));
    line("blocks", format!("{} of {} cells", solid(&counted), grid.bounds().volume()));
    line("data version", version);
    line("offset", format!("{}, {}, {}", metadata.offset.x, metadata.offset.y, metadata.offset.z));
    line("block entities", grid.block_entities.len().to_string());
    line("entities", metadata.entities.len().to_string());
    line("block states", counted.len().to_string());
    for (state, count) in counted {
        let _ = writeln!(text, "  {count:>10}  {}", state.short());
    }
    text
}

fn grid_json(name: &str, grid: &Grid) -> Value {
    let counted = counts(grid);
    let blocks: Vec<Value> = counted.iter().map(|(state, count)| json!([state.to_string(), count])).collect();
    json!({
        "file": name,
        "size": grid.size().to_array(),
        "blocks": solid(&counted),
        "data_version": grid.metadata.data_version,
        "offset": grid.metadata.offset.to_array(),
        "block_entities": grid.block_entities.len(),
        "entities": grid.metadata.entities.len(),
        "palette": blocks,
    })
}

fn labels(boxes: &LabelledBoxes) -> BTreeMap<&str, u64> {
    let mut labels = BTreeMap::new();
    boxes.boxes.iter().for_each(|labelled| *labels.entry(labelled.label.as_str()).or_insert(0) += 1);
    labels
}

fn boxes_text(name: &str, boxes: &LabelledBoxes) -> String {
    let size = boxes.container.size();
    let mut text = format!("{name}\n  {:<15}{} x {} x {} (x, y, z)\n", "size", size.x, size.y, size.z);
    let _ = writeln!(text, "  {:<15}{}", "labelled boxes", boxes.boxes.len());
    for (label, count) in labels(boxes) {
        let _ = writeln!(text, "  {count:>10}  {label}");
    }
    text
}

fn boxes_json(name: &str, boxes: &LabelledBoxes) -> Value {
    json!({
        "file": name,
        "size": boxes.container.size().to_array(),
        "boxes": boxes.boxes.len(),
        "labels": labels(boxes),
    })
}
