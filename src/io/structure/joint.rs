//! What stands in a cell over all looks of a structure: a block of the file names one index for all palettes.

use crate::block::BlockState;
use crate::grid::Grid;
use crate::io::states::Complete;
use rustc_hash::FxHashMap;

/// Of one look, a number is that of a state in it. Of several it is that of a combination of such.
pub(super) struct Joint<'g> {
    first: &'g Grid,
    looks: Vec<Complete>,
    combined: Option<Combined>,
}

/// The combinations that occur in several looks.
struct Combined {
    /// By cell in the order of the grid.
    cells: Vec<u32>,
    /// For each combination the states in all looks, one after the other.
    states: Vec<u16>,
}

impl<'g> Joint<'g> {
    /// Of grids of the same size.
    pub fn of(first: &'g Grid, others: &[&Grid]) -> Joint<'g> {
        let grids = || std::iter::once(first).chain(others.iter().copied());
        // A file says its version once.
        let version = first.version();
        let looks: Vec<Complete> = grids().map(|grid| Complete::of(grid.palette(), version)).collect();
        let combined = (!others.is_empty()).then(|| {
            let mut combined = Combined { cells: vec![0; first.cells().len()], states: Vec::new() };
            for (before, (grid, look)) in grids().zip(&looks).enumerate() {
                combined.join(before, grid, look);
            }
            combined
        });
        Joint { first, looks, combined }
    }

    pub fn looks(&self) -> usize {
        self.looks.len()
    }

    /// The number of each cell, in the order of the grid.
    pub fn numbers(&self) -> impl Iterator<Item = u32> + '_ {
        self.first.cells().iter().enumerate().map(|(at, id)| match &self.combined {
            Some(combined) => combined.cells[at],
            None => u32::from(self.looks[0].numbers[usize::from(*id)]),
        })
    }

    /// How many numbers there are.
    fn len(&self) -> u32 {
        match &self.combined {
            Some(combined) => (combined.states.len() / self.looks.len()) as u32,
            None => self.looks[0].states.len() as u32,
        }
    }

    /// What stands in the look `look` where `number` does.
    pub fn state(&self, number: u32, look: usize) -> &BlockState {
        let state = match &self.combined {
            Some(combined) => usize::from(combined.states[number as usize * self.looks.len() + look]),
            None => number as usize,
        };
        &self.looks[look].states[state]
    }

    /// By number, in how many looks the world is left alone.
    pub fn left_alone(&self) -> Vec<usize> {
        let leave_alone = BlockState::structure_void();
        let looks =
            |number| (0..self.looks()).filter(|&look| *self.state(number, look) == leave_alone).count();
        (0..self.len()).map(looks).collect()
    }
}

impl Combined {
    /// Joins the states of a further look to the combinations of the `before` looks so far.
    fn join(&mut self, before: usize, grid: &Grid, look: &Complete) {
        let mut numbers = FxHashMap::default();
        let mut states = Vec::new();
        for (cell, &id) in self.cells.iter_mut().zip(grid.cells()) {
            let state = look.numbers[usize::from(id)];
            *cell = *numbers.entry((*cell, state)).or_insert_with(|| {
                let start = *cell as usize * before;
                states.extend_from_slice(&self.states[start..start + before]);
                states.push(state);
                (states.len() / (before + 1) - 1) as u32
            });
        }
        self.states = states;
    }
}
