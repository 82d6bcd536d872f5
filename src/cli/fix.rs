use super::batch::Batch;
use super::failure::Failure;
use super::report;
use super::summary::counted;
use crate::block::{BlockState, Version, translated};
use crate::grid::{Grid, NotIn};
use crate::neighbours::{Mending, Places, mend};
use crate::space::Cell;

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
        let mending = mend_in_version(&mut grid).map_err(|error| Failure::of_file(name, error))?;
        report::note(&format!("{name}: {}", mending.mended));
        let left = [
            (&mending.border, "that face the border or cells left alone"),
            (&mending.unknown, "that nothing is known of"),
        ];
        for (places, which) in left.into_iter().filter(|(places, _)| places.count > 0) {
            report::note(&format!("{name}: left as they are: {}", told(places, which)));
        }
        Ok(grid)
    })
}

/// `5 blocks that face the border, the first at 0,1,2 and 0,1,3`
fn told(places: &Places, which: &str) -> String {
    let first: Vec<String> = places.first.iter().map(|Cell { x, y, z }| format!("{x},{y},{z}")).collect();
    let blocks = counted(places.count as u64, "block", "blocks");
    format!("{blocks} {which}, at {}{}", first.join(" "), if places.count > first.len() { " .." } else { "" })
}

/// Mends a grid by the rules of the newest version, in the words of its own.
fn mend_in_version(grid: &mut Grid) -> Result<Mending, NotIn> {
    let newest = Version::newest();
    let data_version = grid.data_version();
    let own = Version::of_data(data_version).ok_or(NotIn::OldStates(data_version))?;
    let said = grid.metadata.data_version.replace(newest.data_version());
    let moved =
        |from, to| move |state: &BlockState| translated(state, from, to).unwrap_or_else(|_| state.clone());
    grid.map_states(moved(own, newest))?;
    let mending = mend(grid)?;
    grid.metadata.data_version = said;
    grid.map_states(moved(newest, own))?;
    Ok(mending)
}
