//! Neighbourhoods: the small cubes of cells that a building is made of, and how often each stands in it.

use super::cells::{Cells, OUTSIDE};

/// The cells of a cube, in the order of their places `[y, z, x]`.
pub type Pattern<const N: usize> = [u32; N];

/// Every cube of `SIDE` cells a side, of `N` cells, with its count, in order. Buildings have a border of one
/// cell that is outside.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Patterns<const SIDE: usize, const N: usize> {
    counts: Vec<(Pattern<N>, u64)>,
    total: u64,
}

/// Cubes of 2 x 2 x 2: which blocks stand beside which.
pub type Seams = Patterns<2, 8>;

/// Cubes of 3 x 3 x 3.
pub type Surroundings = Patterns<3, 27>;

impl<const SIDE: usize, const N: usize> Patterns<SIDE, N> {
    const IS_A_CUBE: () = assert!(SIDE * SIDE * SIDE == N);

    /// All that stand in these buildings.
    pub fn of<'c>(buildings: impl IntoIterator<Item = &'c Cells>) -> Patterns<SIDE, N> {
        let () = Self::IS_A_CUBE;
        let mut all: Vec<Pattern<N>> = buildings.into_iter().flat_map(cubes::<SIDE, N>).collect();
        all.sort_unstable();
        let total = all.len() as u64;
        let counts = all.chunk_by(|a, b| a == b).map(|same| (same[0], same.len() as u64)).collect();
        Patterns { counts, total }
    }

    /// How many cubes there are, equal ones counted as often as they stand there.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Each with its count, in order.
    pub fn counts(&self) -> &[(Pattern<N>, u64)] {
        &self.counts
    }

    /// How often a cube stands there.
    pub fn count(&self, pattern: &Pattern<N>) -> u64 {
        match self.counts.binary_search_by(|(known, _)| known.cmp(pattern)) {
            Ok(at) => self.counts[at].1,
            Err(_) => 0,
        }
    }
}

/// The cubes of one building with its border.
fn cubes<const SIDE: usize, const N: usize>(cells: &Cells) -> impl Iterator<Item = Pattern<N>> + '_ {
    let (y, z, x) = cells.dim();
    // A cube begins in the border and ends in it: one cell before, and one past the last.
    let corners = |length: usize| 0..(length + 3).saturating_sub(SIDE);
    corners(y).flat_map(move |y| {
        corners(z).flat_map(move |z| corners(x).map(move |x| cube::<SIDE, N>(cells, [y, z, x])))
    })
}

/// The cube with its low corner at a place that counts from the border.
fn cube<const SIDE: usize, const N: usize>(cells: &Cells, [y, z, x]: [usize; 3]) -> Pattern<N> {
    std::array::from_fn(|at| {
        let place = [y + at / (SIDE * SIDE), z + at / SIDE % SIDE, x + at % SIDE];
        cells.get(place.map(|n| n.wrapping_sub(1))).copied().unwrap_or(OUTSIDE)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;

    #[test]
    fn a_lone_cell_stands_in_eight_corners() {
        let seams = Seams::of([&Array3::from_elem((1, 1, 1), 7)]);
        assert_eq!(seams.total(), 8);
        assert_eq!(seams.counts().len(), 8);
        assert!(seams.counts().iter().all(|(cube, _)| cube.iter().filter(|cell| **cell == 7).count() == 1));
    }

    #[test]
    fn equal_cubes_are_counted_together() {
        let surroundings = Surroundings::of([&Array3::from_elem((5, 5, 5), 1)]);
        assert_eq!(surroundings.total(), 125);
        assert_eq!(surroundings.count(&[1; 27]), 27);
        assert_eq!(surroundings.count(&[2; 27]), 0);
    }
}
