use super::{Entity, Grid};
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

impl Grid {
    /// The pieces of this build in [`Grid::boxes`]. An entity outside of the build goes with the nearest of them.
    pub fn pieces(&self, edge: u16) -> impl Iterator<Item = (Cell, Grid)> {
        let mut entities = self.entities_by_piece(edge);
        self.boxes(edge).map(move |(number, bounds)| {
            (number, self.cropped_with(bounds, entities.remove(&number.to_array()).unwrap_or_default()))
        })
    }

    fn entities_by_piece(&self, edge: u16) -> BTreeMap<[i32; 3], Vec<&Entity>> {
        let (last, edge) = (self.size() - 1, i32::from(edge.max(1)));
        let mut by_piece: BTreeMap<[i32; 3], Vec<&Entity>> = BTreeMap::new();
        for entity in &self.metadata.entities {
            let number = entity.home().min(last).max(Cell::ZERO) / edge;
            by_piece.entry(number.to_array()).or_default().push(entity);
        }
        by_piece
    }

    /// Boxes of at most `edge` blocks along each axis that make up this build: each with its number along x, y and z.
    pub fn boxes(&self, edge: u16) -> impl Iterator<Item = (Cell, Bounds)> {
        let (size, edge) = (self.size(), i32::from(edge.max(1)));
        let counts = (size + edge - 1) / edge;
        Bounds::of_size(counts).cells().map(move |number| {
            let low = number * edge;
            (number, Bounds::new(low, (low + edge).min(size)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_fill_the_build_without_overlap() {
        for (size, edge, count) in [([96, 48, 49], 48, 4), ([1, 1, 1], 48, 1), ([5, 2, 3], 1, 30)] {
            let grid = Grid::new(Cell::from_array(size));
            let boxes: Vec<(Cell, Bounds)> = grid.boxes(edge).collect();
            assert_eq!(boxes.len(), count);
            assert_eq!(boxes.iter().map(|(_, bounds)| bounds.volume()).sum::<u64>(), grid.bounds().volume());
            assert!(boxes.iter().all(|(_, bounds)| grid.bounds().contains_box(bounds)));
            let last = boxes.last().unwrap();
            assert_eq!(last.1.min, last.0 * i32::from(edge));
        }
    }
}
