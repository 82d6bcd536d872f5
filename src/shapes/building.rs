//! A building as a search for shapes sees it.

use super::tally::Kind;
use crate::block::BlockState;
use crate::grid::Grid;
use crate::space::{Axis, Bounds, Cell};
use std::collections::BTreeMap;

/// The number of a block: its place in the order of [`Building::cells`].
pub type Block = u32;

/// The blocks of a building, with the type of each.
#[derive(Debug)]
pub struct Building {
    /// Where the blocks are, x slowest and z fastest: the order in which the authors' program scans them, on which
    /// its first steps depend.
    cells: Vec<Cell>,
    kinds: Vec<Kind>,
    size: Cell,
    /// The block at each place, if any.
    places: Vec<Option<Block>>,
}

impl Building {
    /// A building whose blocks are of one type if they have one name, whichever way they face and whatever they hang on. Two slabs
    /// are the block that they make.
    pub fn of(grid: &Grid) -> Building {
        Building::of_types(grid, name)
    }

    /// A building whose blocks are of one type if they have one name in the words of `name`.
    pub fn of_types(grid: &Grid, name: impl Fn(&BlockState) -> String) -> Building {
        let kinds = kinds(grid, name);
        let size = grid.size();
        let mut building = Building { cells: Vec::new(), kinds: Vec::new(), size, places: Vec::new() };
        for x in 0..size.x {
            for y in 0..size.y {
                for z in 0..size.z {
                    let cell = Cell::new(x, y, z);
                    building.enter(cell, kinds[usize::from(grid.id(cell))]);
                }
            }
        }
        building
    }

    fn enter(&mut self, cell: Cell, kind: Option<Kind>) {
        self.places.push(kind.map(|_| self.cells.len() as Block));
        if let Some(kind) = kind {
            self.cells.push(cell);
            self.kinds.push(kind);
        }
    }

    /// The number of blocks.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    pub fn cell(&self, block: Block) -> Cell {
        self.cells[block as usize]
    }

    pub fn kind(&self, block: Block) -> Kind {
        self.kinds[block as usize]
    }

    pub fn at(&self, cell: Cell) -> Option<Block> {
        let [x, y, z] = cell.to_array().map(|n| n as usize);
        let is_inside = Bounds::of_size(self.size).contains(cell);
        is_inside.then(|| self.places[(x * self.size.y as usize + y) * self.size.z as usize + z]).flatten()
    }

    /// The blocks beside a block along the given axes.
    pub fn beside(&self, block: Block, axes: &[Axis]) -> impl Iterator<Item = Block> {
        let cell = self.cell(block);
        axes.iter()
            .flat_map(move |axis| [cell - axis.unit(), cell + axis.unit()])
            .filter_map(|cell| self.at(cell))
    }
}

/// The type of each block of the palette; none for air.
fn kinds(grid: &Grid, name: impl Fn(&BlockState) -> String) -> Vec<Option<Kind>> {
    let mut known = BTreeMap::new();
    let mut number = |state: &BlockState| {
        let next = known.len() as Kind;
        *known.entry(name(state)).or_insert(next)
    };
    grid.palette().states().iter().map(|state| (!state.is_nothing()).then(|| number(state))).collect()
}

fn name(state: &BlockState) -> String {
    let name = state.short_name().replace("wall_", "");
    if state.get("type") == Some("double") { name.replace("_slab", "") } else { name }
}
