//! Swaps with what another example holds in the same place.
//!
//! Where two examples are laid over one another, the cells that differ fall into pieces. One piece can be taken
//! from the other example and the rest left as it is: every neighbourhood around it is then as in the other one.

use super::Swap;
use crate::grid::{Neighbours, components};
use crate::infer::neighbourhood::{OUTSIDE, Place};
use ndarray::Array3;

/// The swaps of `own` with `other`, which lie with one of their corners in the same place. Both have a border.
pub fn aligned(own: &Array3<u32>, other: &Array3<u32>) -> Vec<Swap> {
    let shifts: [Vec<isize>; 3] = std::array::from_fn(|axis| {
        let gap = own.shape()[axis] as isize - other.shape()[axis] as isize;
        if gap == 0 { vec![0] } else { vec![0, gap] }
    });
    let [ys, zs, xs] = shifts;
    let mut all = Vec::new();
    for y in ys {
        for z in &zs {
            xs.iter().for_each(|x| all.extend(pieces(own, other, [y, *z, *x])));
        }
    }
    all
}

/// The pieces in which `own` differs from `other` where that is moved `by` so many cells.
fn pieces(own: &Array3<u32>, other: &Array3<u32>, by: [isize; 3]) -> Vec<Swap> {
    let moved = |place: Place| {
        let at: Place = std::array::from_fn(|axis| place[axis].wrapping_add_signed(-by[axis]));
        other.get(at).copied().unwrap_or(OUTSIDE)
    };
    let differs = Array3::from_shape_fn(own.dim(), |(y, z, x)| own[[y, z, x]] != moved([y, z, x]));
    let numbers = components(&differs, Neighbours::Corners);
    let count = numbers.iter().max().map_or(0, |last| *last as usize);
    let mut cells: Vec<Vec<(Place, u32)>> = vec![Vec::new(); count];
    let mut is_inside = vec![true; count];
    for ((y, z, x), number) in numbers.indexed_iter().filter(|(_, number)| **number > 0) {
        let (piece, at) = (*number as usize - 1, [y, z, x]);
        is_inside[piece] &= own[at] != OUTSIDE && moved(at) != OUTSIDE;
        cells[piece].push((at, moved(at)));
    }
    // All that differs at once is the other example.
    let is_copy = count == 1 && own.dim() == other.dim();
    let inside = cells.into_iter().zip(is_inside).filter(|(_, is_inside)| *is_inside && !is_copy);
    inside.map(|(cells, _)| Swap::new(cells)).collect()
}
