use super::batch::Batch;
use super::failure::Failure;
use super::part::{self, BoxArg};
use super::report;
use super::summary::counted;
use crate::grid::Grid;

/// Cut buildings to a box, or to what is there
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox crop plot.schem house.schem
  vox crop castle.schem tower.schem --box 0,0,0,8,30,8")]
pub struct Args {
    #[command(flatten)]
    batch: Batch,
    /// Two corners that are both inside, counted from the low corner of the building. If not given, the smallest box
    /// around all blocks and entities
    #[arg(long = "box", value_name = "X,Y,Z,X,Y,Z", allow_hyphen_values = true)]
    bounds: Option<BoxArg>,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    args.batch.each_grid(|name, grid| {
        let cropped = match args.bounds {
            Some(BoxArg(bounds)) => part::boxed(name, &grid, bounds),
            None => grid
                .trimmed()
                .ok_or_else(|| Failure::of_file(name, "there is nothing but air, so nothing to cut to")),
        }?;
        tell_cut(name, &grid, &cropped);
        Ok(cropped)
    })
}

fn tell_cut(name: &str, from: &Grid, to: &Grid) {
    let cut = |count: fn(&Grid) -> usize| (count(from) - count(to)) as u64;
    let parts = [
        (from.blocks() - to.blocks(), "block", "blocks"),
        (cut(|grid| grid.block_entities.len()), "block entity", "block entities"),
        (cut(|grid| grid.metadata.entities.len()), "entity", "entities"),
    ];
    let told: Vec<String> = parts
        .iter()
        .filter(|(count, ..)| *count > 0)
        .map(|(count, one, many)| counted(*count, one, many))
        .collect();
    if !told.is_empty() {
        report::note(&format!("{name}: cut off {}", told.join(", ")));
    }
}
