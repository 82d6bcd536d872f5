//! Neighbourhoods of 2 x 2 x 2 cells: what stands beside what in the examples.

use super::example::{Example, Terminals};
use crate::space::Cell;
use ndarray::Array3;
use rustc_hash::FxHashMap;

/// The terminals of 2 x 2 x 2 cells, in the order of their places.
pub type Neighbourhood = [u32; 8];

/// A place in an array: `[y, z, x]`.
pub type Place = [usize; 3];

/// What lies outside of an example.
pub const OUTSIDE: u32 = u32::MAX;

/// The neighbourhoods that the examples show, those at their borders with what lies outside.
#[derive(Default, Debug)]
pub struct Seen {
    /// How often each is shown.
    counts: FxHashMap<Neighbourhood, u32>,
    /// In order of first sight.
    all: Vec<Neighbourhood>,
}

impl Seen {
    /// Those of arrays with a border.
    pub fn of<'a>(bordered: impl IntoIterator<Item = &'a Array3<u32>>) -> Seen {
        let mut seen = Seen::default();
        let all = bordered
            .into_iter()
            .flat_map(|cells| corners(cells.dim()).map(|corner| neighbourhood(cells, corner)));
        all.for_each(|shown| seen.add(shown));
        seen
    }

    pub fn contains(&self, neighbourhood: &Neighbourhood) -> bool {
        self.counts.contains_key(neighbourhood)
    }

    pub fn count(&self, neighbourhood: &Neighbourhood) -> u32 {
        self.counts.get(neighbourhood).copied().unwrap_or(0)
    }

    /// Each once, in order of first sight.
    pub fn all(&self) -> &[Neighbourhood] {
        &self.all
    }

    fn add(&mut self, shown: Neighbourhood) {
        let count = self.counts.entry(shown).or_insert(0);
        *count += 1;
        if *count == 1 {
            self.all.push(shown);
        }
    }
}

/// Examples of blocks as arrays of terminals, and what they show.
#[derive(Debug)]
pub struct Shown {
    /// How many there are. Buildings that show nothing further may come after them.
    pub examples: usize,
    pub cells: Vec<Array3<u32>>,
    /// The same with a border one cell wide.
    pub bordered: Vec<Array3<u32>>,
    pub seen: Seen,
}

impl Shown {
    /// What `images` show counts as seen as well. `None` for labelled boxes.
    pub fn by(examples: &[Example], images: &[Example], terminals: &mut Terminals) -> Option<Shown> {
        let cells = examples.iter().map(|example| example.cells(terminals)).collect::<Option<Vec<_>>>()?;
        let bordered: Vec<Array3<u32>> = cells.iter().map(bordered).collect();
        let images: Vec<Array3<u32>> =
            images.iter().filter_map(|image| Some(self::bordered(&image.cells(terminals)?))).collect();
        let seen = Seen::of(bordered.iter().chain(&images));
        Some(Shown { examples: cells.len(), cells, bordered, seen })
    }

    /// Adds buildings that show nothing which the examples do not.
    pub fn add(&mut self, further: Vec<Array3<u32>>) {
        self.bordered.extend(further.iter().map(bordered));
        self.cells.extend(further);
    }
}

/// The cells of an example with a border one cell wide.
pub fn bordered(cells: &Array3<u32>) -> Array3<u32> {
    let (y, z, x) = cells.dim();
    let inside = |place: Place| place.map(|n| n.wrapping_sub(1));
    Array3::from_shape_fn((y + 2, z + 2, x + 2), |(y, z, x)| {
        cells.get(inside([y, z, x])).copied().unwrap_or(OUTSIDE)
    })
}

/// The low corners of all neighbourhoods in an array.
pub fn corners((y, z, x): (usize, usize, usize)) -> impl Iterator<Item = Place> {
    (1..y).flat_map(move |y| (1..z).flat_map(move |z| (1..x).map(move |x| [y - 1, z - 1, x - 1])))
}

/// The place of a cell of an example in its array with a border.
pub fn place(cell: Cell) -> Place {
    [cell.y, cell.z, cell.x].map(|n| n as usize + 1)
}

/// The cell of an example that a place in its array with a border stands for.
pub fn cell([y, z, x]: Place) -> Cell {
    Cell::new(x as i32, y as i32, z as i32) - Cell::ONE
}

/// The cells of the neighbourhood at a corner, in order.
pub fn places([y, z, x]: Place) -> [Place; 8] {
    std::array::from_fn(|at| [y + at / 4, z + at / 2 % 2, x + at % 2])
}

/// The neighbourhood at a corner.
pub fn neighbourhood(cells: &Array3<u32>, corner: Place) -> Neighbourhood {
    places(corner).map(|place| cells[place])
}

/// The corners of the neighbourhoods that a cell is part of, in an array with a border: the cell lies inside.
pub fn corners_around([y, z, x]: Place) -> [Place; 8] {
    std::array::from_fn(|at| [y - at / 4, z - at / 2 % 2, x - at % 2])
}
