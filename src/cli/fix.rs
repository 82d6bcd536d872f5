use super::batch::Batch;
use super::failure::Failure;
use super::report;
use crate::block::{BlockState, PaletteFull, Version, translated};
use crate::grid::Grid;
use crate::neighbours::{Mended, mend};

/// Mend what does not go together: fences and panes that do not join, corners of stairs, half doors, half chests
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox fix old.schem mended.schem
  vox fix *.schematic 'mended/{name}.schem'

Blocks at the border keep the sides that face outwards: what stands there is not known.")]
pub struct Args {
    #[command(flatten)]
    batch: Batch,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    args.batch.each_grid(|name, mut grid| {
        let mended = mend_in_version(&mut grid).map_err(|error| Failure::of_file(name, error))?;
        report::note(&format!("{name}: {mended}"));
        Ok(grid)
    })
}

/// Mends a grid by the rules of the newest version, in the words of its own.
fn mend_in_version(grid: &mut Grid) -> Result<Mended, PaletteFull> {
    let (own, newest) = (grid.version(), Version::newest());
    let said = grid.metadata.data_version.replace(newest.data_version());
    let moved =
        |from, to| move |state: &BlockState| translated(state, from, to).unwrap_or_else(|_| state.clone());
    grid.map_states(moved(own, newest))?;
    let mended = mend(grid)?;
    grid.metadata.data_version = said;
    grid.map_states(moved(newest, own))?;
    Ok(mended)
}
