//! Which shapes enclose something (seed 3, "Enclosure constraint").

use super::layer::Layer;
use super::part::Parts;
use super::production::{Placed, Production};
use crate::grid::{Neighbours, reached_from_outside};
use crate::space::{Axis, Bounds, Cell};
use ndarray::Array3;

/// Marks the shapes, from one on, whose both sides the outside of their example reaches: production leaves them alone.
pub fn mark_open(parts: &mut Parts, first: usize) {
    let mut production = Production::new(parts);
    let placed = parts.parts[first..].iter().map(|part| Placed {
        form: part.form,
        placement: part.placement,
        is_open: false,
    });
    placed.for_each(|placed| production.push(placed));
    let open = open(&production);
    for index in open {
        parts.parts[first + index].is_open = true;
    }
}

/// Removes shapes that enclose nothing and did so in their examples, until nothing changes: what is removed may open others.
/// The first shape may go as well.
pub fn enclose(production: &mut Production<'_>) {
    loop {
        let mut open = open(production);
        open.retain(|index| !production.placed()[*index].is_open);
        if open.is_empty() {
            return;
        }
        for index in open.into_iter().rev() {
            production.remove(index);
        }
    }
}

/// How many free places within the box around a production the outside does not reach: the rooms.
pub fn enclosed(production: &Production<'_>) -> usize {
    let Some(outside) = Outside::of(production) else { return 0 };
    let cells = outside.bounds.cells();
    cells.filter(|cell| production.is_free(*cell) && !outside.reaches(*cell)).count()
}

/// The plane shapes that the outside reaches on both sides. A row of blocks has two pairs of sides: it is open where the outside
/// reaches both of one pair. Solid shapes have no sides.
fn open(production: &Production<'_>) -> Vec<usize> {
    let Some(outside) = Outside::of(production) else { return Vec::new() };
    let is_open = |placed: &Placed| {
        let reaches = |side: Cell| production.blocks(placed).any(|(cell, _)| outside.reaches(cell + side));
        flat(production, placed).any(|axis| reaches(-axis.unit()) && reaches(axis.unit()))
    };
    let placed = production.placed().iter().enumerate();
    placed.filter(|(_, placed)| is_open(placed)).map(|(index, _)| index).collect()
}

/// The axes along which a shape is one block thick.
fn flat(production: &Production<'_>, placed: &Placed) -> impl Iterator<Item = Axis> + use<> {
    let is_solid = matches!(production.parts().forms[placed.form].layer, Layer::Solid(_));
    let cells = production.blocks(placed).map(|(cell, _)| cell);
    let bounds = Bounds::around(cells).unwrap_or(Bounds::of_size(Cell::ZERO));
    Axis::ALL.into_iter().filter(move |axis| !is_solid && bounds.len(*axis) == 1)
}

/// The free places that can be reached from outside through free places that share a face.
struct Outside {
    bounds: Bounds,
    /// Indexed `[y, z, x]`, from the low corner of the box.
    reached: Array3<bool>,
}

impl Outside {
    /// Of a box with one free layer around the production, but not below it: buildings stand on the ground.
    fn of(production: &Production<'_>) -> Option<Outside> {
        let extent = production.extent()?;
        let bounds = Bounds::new(extent.min - Cell::new(1, 0, 1), extent.max + 1);
        let [width, height, depth] = bounds.size().to_array().map(|n| n as usize);
        let is_open = Array3::from_shape_fn((height, depth, width), |(y, z, x)| {
            production.is_free(bounds.min + Cell::new(x as i32, y as i32, z as i32))
        });
        Some(Outside { bounds, reached: reached_from_outside(&is_open, Neighbours::Faces) })
    }

    fn reaches(&self, cell: Cell) -> bool {
        // A negative number becomes one that is far outside.
        let [x, y, z] = (cell - self.bounds.min).to_array().map(|n| n as usize);
        self.reached.get([y, z, x]) == Some(&true)
    }
}
