//! Terminals of houses without labels: the largest cuboids of one block state.

use crate::block::Palette;
use crate::grid::Grid;
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// Looks at single cells that the search for the largest cuboids may spend: about half a second.
const SEARCH_STEPS: u64 = 1 << 27;

/// Parts all cells but air into cuboids of one block state, each with its palette number.
///
/// The largest cuboid of the cells still free is taken first, so that walls and floors go from end to
/// end and what they leave is cut cleanly by them; a wall that loses its corners to another loses both,
/// which keeps symmetric houses symmetric. Of equal volumes the lowest corner is taken first (by y, then
/// z, then x), and at one corner the cuboid with the longest edge. No cuboid could be extended over free
/// cells of its state when it was taken.
///
/// Where huge solid bodies make that search too long, the cells still free after [`SEARCH_STEPS`] are
/// taken in the order of their places, each with the longest run on x, then z, then y.
pub fn cuboids(grid: &Grid) -> Vec<(Bounds, u32)> {
    let mut free = Free::new(grid);
    let mut found = take_largest(&mut free, SEARCH_STEPS);
    take_in_order(&mut free, &mut found);
    found
}

/// By a volume that no cuboid at them exceeds, low corners of cuboids.
type Queue = BTreeMap<u64, Vec<usize>>;

/// Volumes only shrink as cells are taken, so that the first corner whose cuboid is as large as its
/// place in the queue says has the largest of all.
fn take_largest(free: &mut Free, steps: u64) -> Vec<(Bounds, u32)> {
    let mut found = Vec::new();
    let mut queue = free.corners();
    while let Some((volume, mut corners)) = queue.pop_last() {
        corners.sort();
        for corner in corners {
            if free.steps >= steps {
                return found;
            }
            match free.largest_at(corner) {
                size if size.volume() == volume => found.push(free.take(corner, size)),
                Size { x: 0, .. } => {}
                smaller => queue.entry(smaller.volume()).or_default().push(corner),
            }
        }
    }
    found
}

fn take_in_order(free: &mut Free, found: &mut Vec<(Bounds, u32)>) {
    for corner in 0..free.ids.len() {
        if free.ids[corner] != Palette::AIR {
            let size = free.longest_at(corner);
            found.push(free.take(corner, size));
        }
    }
}

/// The size of a cuboid; none has no cells, and x then is 0.
#[derive(Clone, Copy, Default)]
struct Size {
    x: usize,
    y: usize,
    z: usize,
}

impl Size {
    fn volume(self) -> u64 {
        self.x as u64 * self.y as u64 * self.z as u64
    }

    /// The order of preference among the cuboids at one corner.
    fn rank(self) -> (u64, usize) {
        (self.volume(), self.x.max(self.y).max(self.z))
    }
}

/// The cells not yet taken, x fastest, then z, then y.
struct Free {
    size: Size,
    /// The palette number of each cell; that of air where the cell is taken.
    ids: Vec<u16>,
    /// How many cells from each on are of its state, towards higher x.
    runs: Vec<u32>,
    /// Looks at single cells so far.
    steps: u64,
    /// By distance on z from the corner at hand: the run common to the rows of all layers so far.
    common: Vec<u32>,
}

impl Free {
    fn new(grid: &Grid) -> Free {
        let (y, z, x) = grid.cells().dim();
        let ids: Vec<u16> = grid.cells().iter().copied().collect();
        let mut runs = vec![0; ids.len()];
        for (ids, runs) in ids.chunks(x.max(1)).zip(runs.chunks_mut(x.max(1))) {
            measure_runs(ids, runs);
        }
        Free { size: Size { x, y, z }, ids, runs, steps: 0, common: Vec::new() }
    }

    /// Every cell that is not air, by the product of the runs from it along the three axes.
    fn corners(&self) -> Queue {
        let Size { x: row, z, .. } = self.size;
        let mut queue = Queue::new();
        let mut above = vec![0u64; row * z];
        let mut beside = vec![0u64; row];
        for corner in (0..self.ids.len()).rev() {
            let continued = |next: usize| self.ids.get(next) == Some(&self.ids[corner]);
            let run = |cells: u64, next| 1 + if continued(next) { cells } else { 0 };
            let (layer, last_row) = (corner % (row * z), corner / row % z + 1 == z);
            above[layer] = run(above[layer], corner + row * z);
            beside[layer % row] = if last_row { 1 } else { run(beside[layer % row], corner + row) };
            if self.ids[corner] != Palette::AIR {
                let bound = u64::from(self.runs[corner]) * above[layer] * beside[layer % row];
                queue.entry(round_up(bound)).or_default().push(corner);
            }
        }
        queue
    }

    /// The largest cuboid of free cells of one state with its low corner at this cell.
    fn largest_at(&mut self, corner: usize) -> Size {
        let mut best = Size::default();
        if self.ids[corner] == Palette::AIR {
            return best;
        }
        let place = self.place(corner);
        self.common.clear();
        self.common.resize(self.size.z - place.z, u32::MAX);
        for y in 1..=self.size.y - place.y {
            self.narrow(self.ids[corner], corner + (y - 1) * self.size.x * self.size.z);
            if self.common.is_empty() {
                break;
            }
            best = self.common_sizes(y).fold(best, better);
        }
        best
    }

    /// Brings the rows of one more layer into the common runs, as far on z as the state goes.
    fn narrow(&mut self, id: u16, first_row: usize) {
        let rows = (first_row..).step_by(self.size.x);
        let inside = self.common.iter_mut().zip(rows).take_while(|&(_, row)| self.ids[row] == id);
        let depth = inside.map(|(run, row)| *run = self.runs[row].min(*run)).count();
        self.common.truncate(depth);
        self.steps += depth as u64 + 1;
    }

    /// The longest cuboids of this height at the corner at hand, one for each length on z.
    fn common_sizes(&self, y: usize) -> impl Iterator<Item = Size> {
        let runs = self.common.iter().scan(u32::MAX, |least, &run| {
            *least = run.min(*least);
            Some(*least as usize)
        });
        runs.zip(1..).map(move |(x, z)| Size { x, y, z })
    }

    /// The cuboid with its low corner at this cell, which is free, that is longest on x, then z, then y.
    fn longest_at(&self, corner: usize) -> Size {
        let (id, place) = (self.ids[corner], self.place(corner));
        let Size { x: row, z: rows, .. } = self.size;
        let x = self.runs[corner];
        let fits = |cell: usize| self.ids[cell] == id && self.runs[cell] >= x;
        let z = (place.z..rows).take_while(|z| fits(corner + (z - place.z) * row)).count();
        let layer_fits = |layer: usize| (0..z).all(|z| fits(layer + z * row));
        let y =
            (place.y..self.size.y).take_while(|y| layer_fits(corner + (y - place.y) * row * rows)).count();
        Size { x: x as usize, y, z }
    }

    /// Takes the cells of a cuboid, which are free and of one state.
    fn take(&mut self, corner: usize, size: Size) -> (Bounds, u32) {
        let id = self.ids[corner];
        for y in 0..size.y {
            for z in 0..size.z {
                self.take_row(corner + (y * self.size.z + z) * self.size.x, size.x);
            }
        }
        (bounds(self.place(corner), size), u32::from(id))
    }

    fn take_row(&mut self, first: usize, len: usize) {
        let id = self.ids[first];
        self.ids[first..first + len].fill(Palette::AIR);
        self.runs[first..first + len].fill(0);
        let row_start = first - first % self.size.x;
        let before = self.ids[row_start..first].iter().rev().take_while(|&&other| other == id).count();
        for (run, cell) in (1..).zip((first - before..first).rev()) {
            self.runs[cell] = run;
        }
        self.steps += (before + len) as u64;
    }

    fn place(&self, cell: usize) -> Size {
        let Size { x, z, .. } = self.size;
        Size { x: cell % x, y: cell / (x * z), z: cell / x % z }
    }
}

/// Rounds up to five binary digits: bounds need not be exact, and few distinct ones make a short queue.
fn round_up(bound: u64) -> u64 {
    let unit = 1 << bound.ilog2().saturating_sub(4);
    bound.next_multiple_of(unit)
}

/// The first of two cuboids at a corner, unless the second is to be preferred.
fn better(first: Size, second: Size) -> Size {
    if second.rank() > first.rank() { second } else { first }
}

/// The runs of one row towards its end; air has none.
fn measure_runs(ids: &[u16], runs: &mut [u32]) {
    for x in (0..ids.len()).rev() {
        let next = if ids.get(x + 1) == Some(&ids[x]) { runs[x + 1] } else { 0 };
        runs[x] = if ids[x] == Palette::AIR { 0 } else { next + 1 };
    }
}

fn bounds(place: Size, size: Size) -> Bounds {
    let cell = |at: Size| Cell::new(at.x as i32, at.y as i32, at.z as i32);
    Bounds::new(cell(place), cell(place) + cell(size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::BlockState;
    use proptest::prelude::*;

    fn grid(size: Cell, ids: &[u16]) -> Grid {
        let mut grid = Grid::new(size);
        for name in ["stone", "oak_planks", "glass"] {
            grid.intern(&BlockState::new(name).unwrap()).unwrap();
        }
        grid.bounds().cells().zip(ids).for_each(|(cell, &id)| grid.set(cell, id));
        grid
    }

    fn small_grid() -> impl Strategy<Value = Grid> {
        prop::array::uniform3(0..6i32).prop_flat_map(|size| {
            let cells = size.iter().product::<i32>() as usize;
            let id = prop_oneof![3 => Just(1u16), 1 => 0..4u16];
            prop::collection::vec(id, cells).prop_map(move |ids| grid(Cell::from(size), &ids))
        })
    }

    fn is_uniform(grid: &Grid, bounds: Bounds, id: u16) -> bool {
        grid.bounds().contains_box(&bounds) && bounds.cells().all(|cell| grid.id(cell) == id)
    }

    /// Takes the cuboids out of the grid in their order, each time after `check`.
    fn replay(mut grid: Grid, cuboids: &[(Bounds, u32)], check: impl Fn(&Grid, Bounds, u16)) {
        for &(bounds, label) in cuboids {
            let id = label as u16;
            assert!(id != Palette::AIR && is_uniform(&grid, bounds, id));
            check(&grid, bounds, id);
            grid.fill(bounds, Palette::AIR);
        }
        assert!(grid.cells().iter().all(|&id| id == Palette::AIR));
    }

    fn assert_maximal(grid: &Grid, bounds: Bounds, id: u16) {
        for unit in Cell::AXES {
            assert!(!is_uniform(grid, Bounds::new(bounds.min - unit, bounds.max), id));
            assert!(!is_uniform(grid, Bounds::new(bounds.min, bounds.max + unit), id));
        }
    }

    /// The volume of the largest uniform box that is not of air, by trying all.
    fn largest_volume(grid: &Grid) -> Option<u64> {
        let boxes =
            |min: Cell| Bounds::new(min, grid.size()).cells().map(move |last| (min, last + Cell::ONE));
        let all = grid.bounds().cells().flat_map(boxes).map(|(min, max)| Bounds::new(min, max));
        all.filter(|b| grid.id(b.min) != Palette::AIR && is_uniform(grid, *b, grid.id(b.min)))
            .map(|b| b.volume())
            .max()
    }

    proptest! {
        #[test]
        fn the_largest_is_taken_first(grid in small_grid()) {
            replay(grid.clone(), &cuboids(&grid), |free, bounds, _| {
                assert_eq!(Some(bounds.volume()), largest_volume(free));
            });
        }

        #[test]
        fn cuboids_are_maximal_however_long_the_search(grid in small_grid(), steps in 0..200u64) {
            let mut free = Free::new(&grid);
            let mut found = take_largest(&mut free, steps);
            take_in_order(&mut free, &mut found);
            replay(grid, &found, assert_maximal);
        }
    }

    #[test]
    fn a_ring_of_walls_is_two_long_and_two_short_ones() {
        let mut walls = grid(Cell::new(5, 3, 5), &[1; 75]);
        walls.fill(Bounds::new(Cell::new(1, 0, 1), Cell::new(4, 3, 4)), Palette::AIR);
        let wall = |min: [i32; 3], max: [i32; 3]| (Bounds::new(Cell::from(min), Cell::from(max)), 1);
        let expected = [
            wall([0, 0, 0], [5, 3, 1]),
            wall([0, 0, 4], [5, 3, 5]),
            wall([0, 0, 1], [1, 3, 4]),
            wall([4, 0, 1], [5, 3, 4]),
        ];
        assert_eq!(cuboids(&walls), expected);
    }
}
