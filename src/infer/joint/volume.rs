//! One example as an array of terminals, whose boxes are compared in constant time.

use crate::grid::{BoxHashes, Content};
use crate::space::{Axis, Bounds, Cell};
use ndarray::Array3;

/// Cells of terminals, the contents of their boxes, and the wholes of two blocks among them.
#[derive(Clone, Debug)]
pub struct Volume {
    cells: Array3<u32>,
    contents: BoxHashes,
    /// By axis: how many wholes of two blocks lie across each face to the next cell, as prefix sums;
    /// nothing where there are none.
    bonds: [Array3<u32>; 3],
    wholes: Vec<(Axis, Cell)>,
}

impl Volume {
    /// Of cells indexed `[y, z, x]`; `wholes` are the cells whose other half is the next one on the axis.
    pub fn new(cells: Array3<u32>, wholes: &[(Axis, Cell)]) -> Volume {
        let (y, z, x) = cells.dim();
        let contents = BoxHashes::new(Cell::new(x as i32, y as i32, z as i32), cells.iter().copied());
        let bonds = Axis::ALL.map(|axis| {
            if !wholes.iter().any(|(other, _)| *other == axis) {
                return Array3::zeros((0, 0, 0));
            }
            let mut across = Array3::<u32>::zeros(cells.dim());
            let own = wholes.iter().filter(|(other, _)| *other == axis);
            own.for_each(|(_, at)| across[index(*at)] = 1);
            prefix_sums(&across)
        });
        Volume { cells, contents, bonds, wholes: wholes.to_vec() }
    }

    /// A box of it with other terminals.
    pub fn recoloured(&self, bounds: Bounds, terminal: impl Fn(u32) -> u32) -> Volume {
        let [x, y, z] = bounds.size().to_array().map(|len| len as usize);
        let cells = bounds.cells().map(|cell| terminal(self.get(cell))).collect();
        let cells = Array3::from_shape_vec((y, z, x), cells).unwrap_or_default();
        let inside =
            |(axis, at): &&(Axis, Cell)| bounds.contains(*at) && axis.of(*at) + 1 < axis.of(bounds.max);
        let wholes: Vec<(Axis, Cell)> =
            self.wholes.iter().filter(inside).map(|(axis, at)| (*axis, *at - bounds.min)).collect();
        Volume::new(cells, &wholes)
    }

    pub fn size(&self) -> Cell {
        let (y, z, x) = self.cells.dim();
        Cell::new(x as i32, y as i32, z as i32)
    }

    pub fn get(&self, cell: Cell) -> u32 {
        self.cells[index(cell)]
    }

    /// What is in a box, wherever it stands.
    pub fn content(&self, bounds: Bounds) -> Content {
        self.contents.content(bounds)
    }

    /// Whether a plane across `axis` below cell `at` goes through a door, a bed or the like in the box.
    pub fn is_whole_across(&self, bounds: Bounds, axis: Axis, at: i32) -> bool {
        let layer = bounds.slab(axis, at - 1, at);
        let sums = &self.bonds[axis.index()];
        if sums.is_empty() {
            return false;
        }
        let count = corners(layer).into_iter().fold(0u32, |count, (sign, corner)| {
            let own = sums[index(corner)];
            if sign { count.wrapping_add(own) } else { count.wrapping_sub(own) }
        });
        count > 0
    }
}

fn index(cell: Cell) -> [usize; 3] {
    [cell.y as usize, cell.z as usize, cell.x as usize]
}

/// The corners of a box with the signs of their prefix sums: true adds, false takes away.
fn corners(bounds: Bounds) -> [(bool, Cell); 8] {
    let Bounds { min, max } = bounds;
    std::array::from_fn(|corner| {
        let pick = |axis: Axis, bit: usize| if corner & bit == 0 { axis.of(max) } else { axis.of(min) };
        (corner.count_ones() % 2 == 0, Cell::new(pick(Axis::X, 1), pick(Axis::Y, 2), pick(Axis::Z, 4)))
    })
}

/// The sums over all cells before a corner, one longer than the cells on each axis.
fn prefix_sums(own: &Array3<u32>) -> Array3<u32> {
    let (y, z, x) = own.dim();
    let mut sums = Array3::zeros((y + 1, z + 1, x + 1));
    for at_y in 0..y {
        let mut layer = vec![0; x];
        for at_z in 0..z {
            let mut row = 0u32;
            for at_x in 0..x {
                row += own[[at_y, at_z, at_x]];
                layer[at_x] += row;
                sums[[at_y + 1, at_z + 1, at_x + 1]] = sums[[at_y, at_z + 1, at_x + 1]] + layer[at_x];
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_through_wholes_are_known() {
        let cells = Array3::zeros((3, 2, 2));
        let volume = Volume::new(cells, &[(Axis::Y, Cell::new(1, 0, 0))]);
        let all = Bounds::of_size(volume.size());
        assert!(volume.is_whole_across(all, Axis::Y, 1));
        assert!(!volume.is_whole_across(all, Axis::Y, 2));
        assert!(!volume.is_whole_across(all, Axis::X, 1));
        assert!(!volume.is_whole_across(all.slab(Axis::X, 0, 1), Axis::Y, 1));
    }
}
