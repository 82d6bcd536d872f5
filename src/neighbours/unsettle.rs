use super::{ask, bare, complete, settle_in};
use crate::block::{self, PaletteFull, Version};
use crate::grid::Grid;

/// Rounds after which everything stays written that neighbours could decide.
const MOST_ROUNDS: usize = 16;

/// Takes off what neighbours decide, wherever [`settle`] gives it back: settling the grid again gives what
/// settling it before would have given.
pub fn unsettle(grid: &mut Grid) -> Result<(), PaletteFull> {
    unsettle_in(grid, grid.version())
}

fn unsettle_in(grid: &mut Grid, version: Version) -> Result<(), PaletteFull> {
    settle_in(grid, version)?;
    grid.variants.iter_mut().try_for_each(|variant| unsettle_in(variant, version))?;
    if grid.palette().states().iter().all(|state| bare(state) == *state) {
        return Ok(());
    }
    let variants = std::mem::take(&mut grid.variants);
    if let Some(open) = open(grid, version)? {
        *grid = open;
    }
    grid.variants = variants;
    Ok(())
}

/// The whole grid with bare states in all cells where that is enough.
fn open(whole: &Grid, version: Version) -> Result<Option<Grid>, PaletteFull> {
    let mut written = vec![false; whole.cells().len()];
    for _ in 0..MOST_ROUNDS {
        let open = bared(whole, &written)?;
        let mut settled = open.clone();
        ask(&mut settled, version)?;
        // Most often the neighbours have said all that was left out. States that no cell holds any more do not count.
        if !is_complete(&settled) {
            complete(&mut settled, version)?;
        }
        let differing = differing(whole, &settled);
        if differing.is_empty() {
            return Ok(Some(open));
        }
        differing.into_iter().for_each(|at| written[at] = true);
    }
    Ok(None)
}

/// `whole` with bare states in all cells but those `written`.
fn bared(whole: &Grid, written: &[bool]) -> Result<Grid, PaletteFull> {
    let mut grid = whole.clone();
    let states = whole.palette().states().iter();
    let bare = states.map(|state| grid.intern(&bare(state))).collect::<Result<Vec<u16>, _>>()?;
    for (cell, _) in whole.bounds().cells().zip(written).filter(|(_, written)| !**written) {
        grid.set(cell, bare[usize::from(whole.id(cell))]);
    }
    Ok(grid)
}

/// Whether every cell holds a state that says everything.
fn is_complete(grid: &Grid) -> bool {
    let complete: Vec<bool> = grid.palette().states().iter().map(block::is_complete).collect();
    grid.cells().iter().all(|id| complete[usize::from(*id)])
}

/// The cells, by number, that hold something else than `whole` has there.
fn differing(whole: &Grid, other: &Grid) -> Vec<usize> {
    let states = whole.palette().states().iter();
    let same: Vec<Option<u16>> = states.map(|state| other.palette().find(state)).collect();
    let cells = whole.cells().iter().zip(other.cells()).enumerate();
    cells.filter(|(_, (own, id))| same[usize::from(**own)] != Some(**id)).map(|(at, _)| at).collect()
}
