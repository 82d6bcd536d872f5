//! Buildings as arrays of numbers, the same number for the same block state in all of them.

use crate::block::BlockState;
use crate::grid::Grid;
use crate::neighbours::settle;
use ndarray::Array3;
use std::collections::BTreeMap;

/// The number of every cell of a building, indexed `[y, z, x]`.
pub type Cells = Array3<u32>;

/// The number of air.
pub const AIR: u32 = 0;

/// What lies outside of a building. No state has this number.
pub const OUTSIDE: u32 = u32::MAX;

/// The block states of several buildings, numbered in order of first use. Air of any kind is 0.
#[derive(Clone, Default, Debug)]
pub struct Alphabet {
    numbers: BTreeMap<BlockState, u32>,
}

impl Alphabet {
    /// The cells of a building as they stand in the game: with all that neighbours decide.
    pub fn cells(&mut self, grid: &Grid) -> Cells {
        let grid = settled(grid);
        let numbers: Vec<u32> = grid.palette().states().iter().map(|state| self.number(state)).collect();
        grid.cells().mapv(|id| numbers[usize::from(id)])
    }

    /// The cells of several buildings.
    pub fn all<'g>(&mut self, grids: impl IntoIterator<Item = &'g Grid>) -> Vec<Cells> {
        grids.into_iter().map(|grid| self.cells(grid)).collect()
    }

    /// How many states there are, air among them.
    pub fn len(&self) -> usize {
        self.numbers.len() + 1
    }

    /// Air is always there.
    pub fn is_empty(&self) -> bool {
        false
    }

    fn number(&mut self, state: &BlockState) -> u32 {
        if state.is_air() {
            return AIR;
        }
        let next = self.numbers.len() as u32 + 1;
        *self.numbers.entry(state.clone()).or_insert(next)
    }
}

/// The building with every property written; as it is where its palette is too full for that.
pub fn settled(grid: &Grid) -> Grid {
    let mut settled = grid.clone();
    match settle(&mut settled) {
        Ok(()) => settled,
        Err(_) => grid.clone(),
    }
}
