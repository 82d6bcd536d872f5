//! Faces: 2 x 2 cells across an axis. A neighbourhood is two faces, one behind the other.

use crate::infer::exchange::array_axis;
use crate::infer::neighbourhood::{Neighbourhood, Seen};
use crate::space::Axis;
use ndarray::{Array2, Array3};
use rustc_hash::FxHashMap;

/// The terminals of 2 x 2 cells, in the order of their places in an array of cells.
pub type Face = [u32; 4];

/// The faces across one axis that the examples show.
#[derive(Debug)]
pub struct Faces {
    /// In order of first sight.
    all: Vec<Face>,
    /// By face, those that stand behind it somewhere, in order.
    behind: Vec<Vec<u32>>,
    /// By face, those that stand before it somewhere, in order.
    before: Vec<Vec<u32>>,
    numbers: FxHashMap<Face, u32>,
}

impl Faces {
    pub fn across(axis: Axis, seen: &Seen) -> Faces {
        let (all, behind, before) = (Vec::new(), Vec::new(), Vec::new());
        let mut faces = Faces { all, behind, before, numbers: FxHashMap::default() };
        for shown in seen.all() {
            let [low, high] = halves(shown, axis).map(|face| faces.number(face));
            faces.behind[low as usize].push(high);
            faces.before[high as usize].push(low);
        }
        faces.behind.iter_mut().chain(&mut faces.before).for_each(|others| others.sort_unstable());
        faces
    }

    fn number(&mut self, face: Face) -> u32 {
        *self.numbers.entry(face).or_insert_with(|| {
            self.all.push(face);
            self.behind.push(Vec::new());
            self.before.push(Vec::new());
            self.all.len() as u32 - 1
        })
    }

    /// The layers of an array with a border, each as the numbers of its faces. All it shows has to be known.
    pub fn layers(&self, cells: &Array3<u32>, axis: Axis) -> Vec<Array2<u32>> {
        let layers = cells.axis_iter(ndarray::Axis(array_axis(axis)));
        let faces = layers.map(|layer| {
            let (rows, columns) = layer.dim();
            Array2::from_shape_fn((rows - 1, columns - 1), |(row, column)| {
                let places = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(u, v)| (row + u, column + v));
                self.numbers[&places.map(|place| layer[place])]
            })
        });
        faces.collect()
    }

    pub fn cells(&self, face: u32) -> Face {
        self.all[face as usize]
    }

    pub fn behind(&self, face: u32) -> &[u32] {
        &self.behind[face as usize]
    }

    pub fn before(&self, face: u32) -> &[u32] {
        &self.before[face as usize]
    }

    pub fn may_follow(&self, low: u32, high: u32) -> bool {
        self.behind(low).binary_search(&high).is_ok()
    }
}

/// The face of a neighbourhood at the low end of an axis, and the other one.
fn halves(neighbourhood: &Neighbourhood, axis: Axis) -> [Face; 2] {
    let bit = 4 >> array_axis(axis);
    let low: [usize; 4] = std::array::from_fn(|at| (at & (bit - 1)) | ((at & !(bit - 1)) << 1));
    [low, low.map(|cell| cell | bit)].map(|cells| cells.map(|cell| neighbourhood[cell]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_those_across_the_axis() {
        let cells = [0, 1, 2, 3, 4, 5, 6, 7];
        assert_eq!(halves(&cells, Axis::Y), [[0, 1, 2, 3], [4, 5, 6, 7]]);
        assert_eq!(halves(&cells, Axis::Z), [[0, 1, 4, 5], [2, 3, 6, 7]]);
        assert_eq!(halves(&cells, Axis::X), [[0, 2, 4, 6], [1, 3, 5, 7]]);
    }
}
