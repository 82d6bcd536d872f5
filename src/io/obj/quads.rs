//! The outside of things made of cubes, as rectangles with their corners counter-clockwise.

use crate::block::Facing;
use crate::space::{Axis, Bounds, Cell};

/// The corners of the unit cube, numbered by the bits x, y, z.
pub(super) const CORNERS: [Cell; 8] = [
    Cell::new(0, 0, 0),
    Cell::new(1, 0, 0),
    Cell::new(0, 1, 0),
    Cell::new(1, 1, 0),
    Cell::new(0, 0, 1),
    Cell::new(1, 0, 1),
    Cell::new(0, 1, 1),
    Cell::new(1, 1, 1),
];

/// The sides of a cube in the order of [`FACES`].
const SIDES: [Facing; 6] =
    [Facing::West, Facing::East, Facing::Down, Facing::Up, Facing::North, Facing::South];

/// The faces of a cube by their corners.
pub(super) const FACES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// A rectangle on the outside of cells of one material.
pub(super) struct Quad {
    pub material: usize,
    pub facing: Facing,
    pub corners: [Cell; 4],
}

/// The faces between cells with a material and cells without one, each as few rectangles.
pub(super) fn outside(bounds: Bounds, material: impl Fn(Cell) -> Option<usize>) -> Vec<Quad> {
    let material = |cell: Cell| if bounds.contains(cell) { material(cell) } else { None };
    merged(bounds, |cell, facing| material(cell).filter(|_| material(cell + facing.step()).is_none()))
}

/// The faces of cells that `face` gives a material, as few rectangles.
pub(super) fn merged(bounds: Bounds, face: impl Fn(Cell, Facing) -> Option<usize>) -> Vec<Quad> {
    let mut quads = Vec::new();
    for facing in SIDES {
        let axis = facing.axis();
        for layer in axis.of(bounds.min)..axis.of(bounds.max) {
            let slab = bounds.slab(axis, layer, layer + 1);
            for (material, rectangle) in rectangles(slab, axis, |cell| face(cell, facing)) {
                quads.push(Quad { material, facing, corners: corners(rectangle, facing) });
            }
        }
    }
    quads
}

/// Covers the faces of a layer with rectangles, each grown first along one axis and then the other.
fn rectangles(slab: Bounds, axis: Axis, face: impl Fn(Cell) -> Option<usize>) -> Vec<(usize, Bounds)> {
    let [first, second] = axis.others();
    let mut layer = Layer { slab, first, second, faces: slab.cells().map(face).collect() };
    let mut rectangles = Vec::new();
    for start in slab.cells() {
        if let Some(material) = layer.faces[layer.index(start)] {
            let rectangle = layer.grow(start, material);
            rectangle.cells().for_each(|cell| layer.take(cell));
            rectangles.push((material, rectangle));
        }
    }
    rectangles
}

/// A layer of cells, with the material of the faces that are still to be covered.
struct Layer {
    slab: Bounds,
    first: Axis,
    second: Axis,
    faces: Vec<Option<usize>>,
}

impl Layer {
    /// As [`Bounds::cells`] runs.
    fn index(&self, cell: Cell) -> usize {
        let (at, size) = (cell - self.slab.min, self.slab.size());
        (at.x + size.x * (at.z + size.z * at.y)) as usize
    }

    fn take(&mut self, cell: Cell) {
        let index = self.index(cell);
        self.faces[index] = None;
    }

    fn is_all(&self, bounds: Bounds, material: usize) -> bool {
        self.slab.contains_box(&bounds)
            && bounds.cells().all(|cell| self.faces[self.index(cell)] == Some(material))
    }

    fn grow(&self, start: Cell, material: usize) -> Bounds {
        let mut grown = Bounds::new(start, start + Cell::ONE);
        for axis in [self.first, self.second] {
            let mut end = axis.of(grown.max);
            while self.is_all(grown.slab(axis, end, end + 1), material) {
                end += 1;
            }
            grown = grown.slab(axis, axis.of(grown.min), end);
        }
        grown
    }
}

fn corners(rectangle: Bounds, facing: Facing) -> [Cell; 4] {
    let face = SIDES.iter().position(|&side| side == facing).unwrap_or_default();
    FACES[face].map(|corner| rectangle.min + rectangle.size() * CORNERS[corner])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_look_outwards() {
        for (face, corners) in FACES.iter().enumerate() {
            let [a, b, c, _] = corners.map(|corner| CORNERS[corner]);
            assert_eq!((b - a).cross(c - b), SIDES[face].step(), "face {face}");
        }
    }

    #[test]
    fn a_wall_is_six_rectangles() {
        let bounds = Bounds::of_size(Cell::new(5, 3, 1));
        assert_eq!(outside(bounds, |_| Some(0)).len(), 6);
    }

    #[test]
    fn materials_part_rectangles_and_hide_the_faces_between() {
        let bounds = Bounds::of_size(Cell::new(2, 1, 1));
        assert_eq!(outside(bounds, |cell| Some(cell.x as usize)).len(), 10);
    }

    #[test]
    fn the_area_is_that_of_all_outer_faces() {
        let bounds = Bounds::of_size(Cell::new(4, 4, 4));
        let solid = |cell: Cell| {
            (bounds.contains(cell) && (cell.x * 7 + cell.y * 5 + cell.z * 3) % 4 != 0).then_some(0)
        };
        let steps = Axis::ALL.map(Axis::unit).into_iter().flat_map(|unit| [unit, -unit]).collect::<Vec<_>>();
        let open = |cell: Cell| steps.iter().filter(|&&step| solid(cell + step).is_none()).count() as i32;
        let expected: i32 = bounds.cells().filter(|&cell| solid(cell).is_some()).map(open).sum();
        let area = |quad: &Quad| {
            let [a, b, c, _] = quad.corners;
            (b - a).cross(c - b).abs().element_sum()
        };
        assert_eq!(outside(bounds, solid).iter().map(area).sum::<i32>(), expected);
    }
}
