//! Boxes inside one another, each higher and narrower than the one around it.

use crate::space::{Axis, Bounds, Cell};

/// What is taken from a box to get to the box of the next course.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Peel {
    /// The height of a course.
    pub rise: i32,
    /// By how much the next one is narrower at the low end and at the high end, along x and along z.
    pub runs: [(i32, i32); 2],
}

impl Peel {
    /// Every way to peel: on one side, on two, and on all four; flat, even and steep.
    pub fn all() -> impl Iterator<Item = Peel> {
        let one = [(1, 1), (1, 0), (0, 1)].into_iter().flat_map(|run| [(1, run), (2, run)]);
        let one = one.chain([(1, (2, 2))]);
        let by_axis =
            one.flat_map(|(rise, run)| [[run, (0, 0)], [(0, 0), run]].map(|runs| Peel { rise, runs }));
        by_axis.chain([1, 2].map(|rise| Peel { rise, runs: [(1, 1); 2] }))
    }

    /// The axes on which courses get narrower, with by how much at both ends.
    pub fn runs(&self) -> impl Iterator<Item = (Axis, (i32, i32))> + Clone + use<> {
        [Axis::X, Axis::Z].into_iter().zip(self.runs).filter(|(_, run)| *run != (0, 0))
    }

    /// How much shorter the next box is.
    pub fn step(&self, axis: Axis) -> i32 {
        let [x, z] = self.runs.map(|(low, high)| low + high);
        axis.of(Cell::new(x, self.rise, z))
    }

    /// What is left of a box of that size behind so many courses.
    pub fn left(&self, size: Cell, courses: i32) -> Bounds {
        let [(west, east), (north, south)] = self.runs;
        Bounds::new(Cell::new(west, self.rise, north) * courses, size - Cell::new(east, 0, south) * courses)
    }

    /// What is left behind so many courses, before it gets narrower again: all above the course.
    pub fn above(&self, size: Cell, courses: i32) -> Bounds {
        let left = self.left(size, courses);
        left.slab(Axis::Y, left.min.y + self.rise, left.max.y)
    }

    pub fn course(&self, size: Cell, courses: i32) -> Bounds {
        let left = self.left(size, courses);
        left.slab(Axis::Y, left.min.y, left.min.y + self.rise)
    }
}
