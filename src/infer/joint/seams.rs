//! Which blocks stand beside one another in the examples: neighbourhoods of two cells on an axis, or of one where a
//! box is that thin.

use super::volume::Volume;
use crate::space::{Axis, Bounds, Cell};
use rustc_hash::FxHashSet;

/// Every neighbourhood of at most 2 x 2 x 2 cells that some example shows.
#[derive(Debug)]
pub struct Seams(FxHashSet<u64>);

impl Seams {
    pub fn of(volumes: &[Volume]) -> Seams {
        let mut seams = Seams(FxHashSet::default());
        volumes.iter().for_each(|volume| seams.add(volume));
        seams
    }

    /// Takes what a volume shows for seen.
    pub fn add(&mut self, volume: &Volume) {
        for shape in shapes() {
            let starts = Bounds::of_size(volume.size() - shape + Cell::ONE);
            let mut last = None;
            for at in starts.cells() {
                let own = window(shape, |step| volume.get(at + step));
                if last.replace(own) != Some(own) {
                    self.0.insert(own);
                }
            }
        }
    }

    /// Whether the last slice of `left` and the first of `right` show only what the examples show. Both have the
    /// same size across the axis.
    pub fn fit(&self, (one, left): (&Volume, Bounds), (other, right): (&Volume, Bounds), axis: Axis) -> bool {
        let last = axis.of(left.max) - 1;
        let first = axis.of(right.min);
        let last = left.slab(axis, last, last + 1);
        let first = right.slab(axis, first, first + 1);
        let mut shape = last.size().min(Cell::splat(2));
        shape[axis.index()] = 2;
        let mut starts = last.size() - shape + Cell::ONE;
        starts[axis.index()] = 1;
        Bounds::of_size(starts).cells().all(|at| {
            let cell = |step: Cell| {
                let mut across = at + step;
                across[axis.index()] = 0;
                if axis.of(step) == 0 { one.get(last.min + across) } else { other.get(first.min + across) }
            };
            self.0.contains(&window(shape, cell))
        })
    }
}

/// All sizes of neighbourhoods of two cells or more.
fn shapes() -> impl Iterator<Item = Cell> {
    (1..8).map(|bits: i32| Cell::new(1 + (bits & 1), 1 + (bits >> 1 & 1), 1 + (bits >> 2)))
}

/// The hash of a neighbourhood of that size.
pub fn window(shape: Cell, cell: impl Fn(Cell) -> u32) -> u64 {
    let start = shape.x as u64 + 3 * shape.y as u64 + 9 * shape.z as u64;
    Bounds::of_size(shape).cells().fold(start, |hash, step| {
        (hash.rotate_left(23) ^ u64::from(cell(step)).wrapping_add(1)).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;

    #[test]
    fn what_the_examples_do_not_show_side_by_side_does_not_fit() {
        let row = Volume::new(Array3::from_shape_vec((1, 1, 4), vec![1, 2, 1, 1]).unwrap(), &[]);
        let seams = Seams::of(std::slice::from_ref(&row));
        let at = |x: i32| (&row, Bounds::new(Cell::new(x, 0, 0), Cell::new(x + 1, 1, 1)));
        assert!(seams.fit(at(0), at(1), Axis::X));
        assert!(seams.fit(at(1), at(0), Axis::X));
        assert!(seams.fit(at(0), at(0), Axis::X));
        assert!(!seams.fit(at(1), at(1), Axis::X));
    }
}
