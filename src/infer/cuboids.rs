//! Terminals of houses without labels: the largest cuboids of one block state.

use crate::block::Palette;
use crate::grid::Grid;
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// Looks at single cells that the search for the largest cuboids may spend, some seconds at most.
const SEARCH_STEPS: u64 = 1 << 29;

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
        corners.sort_unstable();
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
    /// By distance on z from the corner at hand: the run common to all rows up to the height at hand.
    common: Vec<usize>,
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
                queue.entry(bound).or_default().push(corner);
            }
        }
        queue
    }

    /// The largest cuboid of free cells of one state with its low corner at this cell.
    fn largest_at(&mut self, corner: usize) -> Size {
        let (id, place) = (self.ids[corner], self.place(corner));
        let mut best = Size::default();
        if id == Palette::AIR {
            return best;
        }
        self.common.clear();
        self.common.resize(self.size.z - place.z, usize::MAX);
        let mut depth = self.common.len();
        for y in 0..self.size.y - place.y {
            let layer = corner + y * self.size.x * self.size.z;
            let mut x = usize::MAX;
            let mut z = 0;
            while z < depth && self.ids[layer + z * self.size.x] == id {
                self.common[z] = self.common[z].min(self.runs[layer + z * self.size.x] as usize);
                x = x.min(self.common[z]);
                z += 1;
                best = better(best, Size { x, y: y + 1, z });
            }
            self.steps += z as u64 + 1;
            depth = z;
            if depth == 0 {
                break;
            }
        }
        best
    }

    /// The cuboid with its low corner at this cell, which is free, that is longest on x, then z, then y.
    fn longest_at(&self, corner: usize) -> Size {
        let (id, place) = (self.ids[corner], self.place(corner));
        let Size { x: row, z: rows, .. } = self.size;
        let x = self.runs[corner];
        let fits = |cell: usize| self.ids[cell] == id && self.runs[cell] >= x;
        let z = (place.z..rows).take_while(|z| fits(corner + (z - place.z) * row)).count();
        let layer_fits = |layer: usize| (0..z).all(|z| fits(layer + z * row));
        let y = (place.y..self.size.y).take_while(|y| layer_fits(corner + (y - place.y) * row * rows)).count();
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
