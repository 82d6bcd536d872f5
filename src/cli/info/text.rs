use super::tags;
use super::{Counts, biomes, block_entities, entities, format_name, labels};
use crate::block::Version;
use crate::grid::{Grid, LabelledBoxes};
use crate::io::{About, Content, Decoded};
use crate::space::Cell;
use std::fmt::Write;

/// What `vox info` prints of a file, with as many block states as are to be `shown`.
pub(super) fn of(name: &str, decoded: &Decoded, notes: &[String], shown: usize) -> String {
    let mut text = format!("{name}\n");
    line(&mut text, "format", &format(&decoded.about));
    if let Some(Cell { x, y, z }) = decoded.about.place {
        line(&mut text, "in its world", &format!("from {x}, {y}, {z}"));
    }
    match &decoded.content {
        Content::Grid(grid) => of_grid(&mut text, grid, notes, shown),
        Content::Boxes(boxes) => of_boxes(&mut text, boxes, notes),
    }
    text
}

fn format(about: &About) -> String {
    let version = about.version.map_or(String::new(), |version| format!(", version {version}"));
    format!("{}{version}", format_name(about.format))
}

/// `3465 (Minecraft 1.20.1)`
fn game(data_version: i32) -> String {
    let name = Version::of_data(data_version).map_or("before 1.13".to_owned(), |version| version.to_string());
    format!("{data_version} (Minecraft {name})")
}

fn line(text: &mut String, label: &str, value: &str) {
    let _ = writeln!(text, "  {label:<15}{value}");
}

fn of_grid(text: &mut String, grid: &Grid, notes: &[String], shown: usize) {
    let metadata = &grid.metadata;
    let version = metadata.data_version.map_or("not said".to_owned(), game);
    line(text, "size", &size(grid.size()));
    line(text, "blocks", &format!("{} of {} cells", grid.blocks(), grid.bounds().volume()));
    line(text, "data version", &version);
    line(text, "offset", &format!("{}, {}, {}", metadata.offset.x, metadata.offset.y, metadata.offset.z));
    for (name, tag) in &metadata.tags {
        line(text, name, &tags::short(name, tag));
    }
    for region in &metadata.regions {
        let [low, extent] = [region.bounds.min, region.bounds.size()];
        let place = format!("{} at {}, {}, {}", size(extent), low.x, low.y, low.z);
        line(text, "region", &format!("{}: {place}", region.name));
    }
    if !grid.variants.is_empty() {
        line(text, "variants", &format!("{} more", grid.variants.len()));
    }
    let biomes = biomes(grid);
    if !biomes.is_empty() {
        line(text, "biomes", &biomes.keys().cloned().collect::<Vec<_>>().join(", "));
    }
    line(text, "block entities", &counts(&block_entities(grid)));
    line(text, "entities", &counts(&entities(grid)));
    if let Some(own) = &metadata.own {
        line(text, "other tags", &own.tags.keys().cloned().collect::<Vec<_>>().join(", "));
    }
    notes.iter().for_each(|note| line(text, "odd", note));
    let counted = grid.counts();
    line(text, "block states", &counted.len().to_string());
    for (state, count) in counted.iter().take(shown) {
        let _ = writeln!(text, "  {count:>10}  {}", state.short());
    }
    if let Some(more @ 1..) = counted.len().checked_sub(shown) {
        let _ = writeln!(text, "  {:>10}  and {more} more: `--all` lists them", "..");
    }
}

fn of_boxes(text: &mut String, boxes: &LabelledBoxes, notes: &[String]) {
    line(text, "size", &size(boxes.container.size()));
    notes.iter().for_each(|note| line(text, "odd", note));
    line(text, "labelled boxes", &boxes.boxes.len().to_string());
    for (label, count) in labels(boxes) {
        let _ = writeln!(text, "  {count:>10}  {label}");
    }
}

fn size(size: Cell) -> String {
    format!("{} x {} x {} (x, y, z)", size.x, size.y, size.z)
}

/// `3: chest 2, sign 1`
fn counts(counts: &Counts) -> String {
    let each: Vec<String> = counts.iter().map(|(name, count)| format!("{name} {count}")).collect();
    let total: u64 = counts.values().sum();
    if each.is_empty() { total.to_string() } else { format!("{total}: {}", each.join(", ")) }
}
