//! What stands in a cell over all looks of a structure: a block of the file names one index for all palettes.

use crate::block::BlockState;
use crate::grid::Grid;
use crate::io::states::{self, Complete};
use rustc_hash::FxHashMap;

pub(super) struct Joint {
    /// Numbers of `combinations`, by cell in the order of the grid.
    pub cells: Vec<u32>,
    /// For each look the number of its state.
    combinations: Vec<Vec<u16>>,
    looks: Vec<Complete>,
}

impl Joint {
    /// Of grids of the same size, of which there is one at least.
    pub fn of(grids: &[&Grid]) -> Joint {
        // A file says its version once.
        let version = grids[0].metadata.version();
        let looks: Vec<Complete> = grids.iter().map(|grid| Complete::of(grid.palette(), version)).collect();
        let mut cells = vec![0; grids[0].cells().len()];
        let mut combinations = vec![Vec::new()];
        for (grid, look) in grids.iter().zip(&looks) {
            combinations = join(&mut cells, &combinations, grid, look);
        }
        Joint { cells, combinations, looks }
    }

    /// The state of `combination` in the look `look`.
    pub fn state(&self, combination: u32, look: usize) -> &BlockState {
        let number = self.combinations[combination as usize][look];
        &self.looks[look].states[usize::from(number)]
    }

    /// By combination, whether the world is left alone in all looks.
    pub fn left_alone(&self) -> Vec<bool> {
        let leave_alone = states::leave_alone();
        let is_left_alone =
            |number| (0..self.looks.len()).all(|look| *self.state(number, look) == leave_alone);
        (0..self.combinations.len() as u32).map(is_left_alone).collect()
    }
}

/// Joins the states of a further look to the combinations of those before.
fn join(cells: &mut [u32], before: &[Vec<u16>], grid: &Grid, look: &Complete) -> Vec<Vec<u16>> {
    let mut numbers = FxHashMap::default();
    let mut combinations = Vec::new();
    for (cell, &id) in cells.iter_mut().zip(grid.cells()) {
        let state = look.numbers[usize::from(id)];
        *cell = *numbers.entry((*cell, state)).or_insert_with(|| {
            combinations.push([&before[*cell as usize][..], &[state]].concat());
            (combinations.len() - 1) as u32
        });
    }
    combinations
}
