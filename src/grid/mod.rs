//! The voxel grid: palette indices in an `ndarray`, block entities, and what a file says of itself.
//! Knows nothing of text or files.

mod anchor;
mod count;
mod crop;
mod diff;
mod entity;
mod era;
mod flood;
mod hash;
mod labelled;
mod metadata;
mod oddity;
mod placed;
mod replace;
mod split;
mod turn;
mod version;

use crate::block::{BlockState, Palette, PaletteFull};
use crate::nbt::Compound;
use crate::space::{Bounds, Cell};
use ndarray::Array3;
use std::collections::BTreeMap;

pub use anchor::{Anchor, NoDoor};
pub use diff::{BlockDiff, Diff};
pub use era::Kept;
pub use flood::{Neighbours, components, floating, reached_from_outside};
pub use hash::{BoxHashes, Content};
pub use labelled::{LabelledBox, LabelledBoxes};
pub use metadata::{
    BiomeMap, Biomes, DEFAULT_DATA_VERSION, Dialect, Entity, Metadata, Own, Region, is_named,
};
pub use oddity::Oddity;
pub use replace::Replaced;
pub use version::NotIn;

/// A box of blocks. Every cell holds a number of the palette; 0 is air.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Indexed `[y, z, x]` and in the standard layout, so that memory runs in the order of schematic files.
    cells: Array3<u16>,
    palette: Palette,
    /// Chests, signs and the like, by place, as `[x, y, z]`: as the game keeps them, with `id`
    /// and without their place.
    pub block_entities: BTreeMap<[i32; 3], Compound>,
    pub metadata: Metadata,
    /// What may stand in the same place instead, of the same size: structures of the game have such.
    pub variants: Vec<Grid>,
}

impl Grid {
    /// A grid of air. `size` is not negative.
    pub fn new(size: Cell) -> Grid {
        let [x, y, z] = size.to_array().map(|n| n as usize);
        Grid {
            cells: Array3::zeros((y, z, x)),
            palette: Palette::default(),
            block_entities: BTreeMap::new(),
            metadata: Metadata::default(),
            variants: Vec::new(),
        }
    }

    /// A grid of the given cells, indexed `[y, z, x]`; `None` where one is not a number of the palette.
    pub fn from_cells(cells: Array3<u16>, palette: Palette) -> Option<Grid> {
        // Without a way out early, which would keep the loop from being vectorised. Air is in every palette.
        let highest = cells.iter().fold(0, |highest, &id| highest.max(id));
        let in_range = usize::from(highest) < palette.states().len();
        let cells = if cells.is_standard_layout() { cells } else { cells.as_standard_layout().into_owned() };
        in_range.then(|| Grid {
            cells,
            palette,
            block_entities: BTreeMap::new(),
            metadata: Metadata::default(),
            variants: Vec::new(),
        })
    }

    pub fn size(&self) -> Cell {
        let (y, z, x) = self.cells.dim();
        Cell::new(x as i32, y as i32, z as i32)
    }

    pub fn bounds(&self) -> Bounds {
        Bounds::of_size(self.size())
    }

    pub fn palette(&self) -> &Palette {
        &self.palette
    }

    /// The palette number of `state`, new if need be.
    pub fn intern(&mut self, state: &BlockState) -> Result<u16, PaletteFull> {
        self.palette.intern(state)
    }

    /// The cells as palette numbers, indexed `[y, z, x]`.
    pub fn cells(&self) -> &Array3<u16> {
        &self.cells
    }

    /// The palette number at `cell`, which must be inside.
    pub fn id(&self, cell: Cell) -> u16 {
        self.cells[index(cell)]
    }

    /// The block at `cell`, which must be inside.
    pub fn get(&self, cell: Cell) -> &BlockState {
        self.palette.get(self.id(cell))
    }

    /// Puts the block of palette number `id` at `cell`, which must be inside.
    pub fn set(&mut self, cell: Cell, id: u16) {
        self.cells[index(cell)] = id;
    }

    /// Fills `bounds`, which must be inside, with one block.
    pub fn fill(&mut self, bounds: Bounds, id: u16) {
        let (_, depth, width) = self.cells.dim();
        let [x0, y0, z0] = index3(bounds.min);
        let [x1, y1, z1] = index3(bounds.max);
        // Row by row on the bare memory: slicing the array costs more than filling the few cells of a leaf.
        let cells = self.cells.as_slice_mut().expect("a grid's cells are in the standard layout");
        for y in y0..y1 {
            for z in z0..z1 {
                let row = (y * depth + z) * width;
                cells[row + x0..row + x1].fill(id);
            }
        }
    }

    /// Replaces every block state by what `change` makes of it, here and in the variants.
    pub fn map_states(&mut self, change: impl Fn(&BlockState) -> BlockState) -> Result<(), PaletteFull> {
        self.variants.iter_mut().try_for_each(|variant| variant.map_own_states(&change))?;
        self.map_own_states(&change)
    }

    fn map_own_states(&mut self, change: &impl Fn(&BlockState) -> BlockState) -> Result<(), PaletteFull> {
        let mut palette = Palette::default();
        let changed = self.palette.states().iter().map(|state| palette.intern(&change(state)));
        let ids = changed.collect::<Result<Vec<u16>, PaletteFull>>()?;
        self.cells.mapv_inplace(|id| ids[usize::from(id)]);
        self.palette = palette;
        Ok(())
    }

    /// Whether both hold the same block state in every cell, whatever their palettes' order.
    pub fn same_blocks(&self, other: &Grid) -> bool {
        let translated: Vec<Option<u16>> =
            self.palette.states().iter().map(|state| other.palette.find(state)).collect();
        self.size() == other.size()
            && self.cells.iter().zip(&other.cells).all(|(&a, &b)| translated[usize::from(a)] == Some(b))
    }
}

fn index3(cell: Cell) -> [usize; 3] {
    cell.to_array().map(|n| n as usize)
}

fn index(cell: Cell) -> [usize; 3] {
    let [x, y, z] = index3(cell);
    [y, z, x]
}

#[cfg(test)]
impl Grid {
    /// Blocks side by side on x.
    pub(crate) fn row(states: &[&str]) -> Grid {
        let mut grid = Grid::new(Cell::new(states.len() as i32, 1, 1));
        for (x, state) in (0..).zip(states) {
            let id = grid.intern(&state.parse().unwrap()).unwrap();
            grid.set(Cell::new(x, 0, 0), id);
        }
        grid
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_that_become_equal_are_one_in_the_palette() {
        let state = |text: &str| text.parse::<BlockState>().unwrap();
        let mut grid = Grid::new(Cell::new(3, 1, 1));
        for (x, text) in [(1, "stone"), (2, "dirt")] {
            let id = grid.intern(&state(text)).unwrap();
            grid.set(Cell::new(x, 0, 0), id);
        }
        grid.map_states(|old| if old.is_air() { state("glass") } else { state("stone") }).unwrap();
        let found: Vec<String> = grid.bounds().cells().map(|cell| grid.get(cell).short()).collect();
        assert_eq!(found, ["glass", "stone", "stone"]);
        assert_eq!(grid.palette().states().len(), 3, "air, glass and stone");
    }
}
