use super::joint::Joint;
use super::mend::{JOINTS, asked, cells_of, put};
use crate::block::{BlockState, PaletteFull};
use crate::grid::Grid;

/// Lets blocks follow a change from `before` to `grid`, of the same size: where neighbours ask for something else now,
/// they get it. What they ask as before stays as it is written, even where it was not what they asked.
pub fn follow(before: &Grid, grid: &mut Grid) -> Result<(), PaletteFull> {
    let mut variants = std::mem::take(&mut grid.variants);
    for (before, variant) in before.variants.iter().zip(&mut variants) {
        follow(before, variant)?;
    }
    grid.variants = variants;
    let cells = cells_of(grid, &JOINTS);
    if cells.is_empty() {
        return Ok(());
    }
    let [old, new] = [asked(before, &cells_of(before, &JOINTS))?, asked(grid, &cells)?];
    for (cell, joint) in cells {
        // What became another kind of block has been asked already.
        if Joint::of(before.get(cell)) == Some(joint) {
            let state = with_news(grid.get(cell), joint, old.get(cell), new.get(cell));
            put(grid, cell, &state)?;
        }
    }
    Ok(())
}

/// `own` with those properties that neighbours decide otherwise than before.
fn with_news(own: &BlockState, joint: Joint, old: &BlockState, new: &BlockState) -> BlockState {
    let news = joint.keys().iter().filter(|key| old.get(key) != new.get(key));
    news.fold(own.clone(), |state, key| match new.get(key) {
        Some(value) => state.with(key, value),
        None => state,
    })
}
