//! What numbers leave to other blocks.

use crate::block::{BlockState, PaletteFull};
use crate::grid::Grid;
use crate::space::Cell;

const TALL_PLANTS: [&str; 6] = ["sunflower", "lilac", "tall_grass", "large_fern", "rose_bush", "peony"];

fn is_tall_plant(state: &BlockState, half: &str) -> bool {
    state.get("half") == Some(half) && TALL_PLANTS.contains(&state.short_name())
}

/// The upper half of a tall plant has no kind of its own: it is the kind of the lower half.
pub fn name_upper_halves(grid: &mut Grid) -> Result<(), PaletteFull> {
    let is_upper: Vec<bool> =
        grid.palette().states().iter().map(|state| is_tall_plant(state, "upper")).collect();
    let upper = grid.bounds().cells().filter(|&cell| cell.y > 0 && is_upper[usize::from(grid.id(cell))]);
    for cell in upper.collect::<Vec<Cell>>() {
        let below = grid.get(cell - Cell::Y);
        if is_tall_plant(below, "lower") {
            let state = below.clone().with("half", "upper");
            let id = grid.intern(&state)?;
            grid.set(cell, id);
        }
    }
    Ok(())
}
