//! Shapes that are alike as the authors' program sees it: the same types of blocks at the same places in their planes.

use super::building::{Block, Building};
use super::layer::Layer;
use super::tally::Kind;
use crate::space::{Axis, Cell};
use rustc_hash::FxHashMap;

/// What a shape looks like: the types of its blocks and where they are in its plane, from its lowest corner. Where it
/// stands and which plane it is in do not count, nor how deep solid shapes are.
pub type Look = Vec<(i32, i32, Kind)>;

/// The two axes of a layer's planes, those that match one another in the same order.
pub fn axes(layer: Layer) -> [Axis; 2] {
    match layer.seen_along() {
        Axis::X => [Axis::Z, Axis::Y],
        Axis::Y => [Axis::X, Axis::Z],
        Axis::Z => [Axis::X, Axis::Y],
    }
}

pub fn look(building: &Building, layer: Layer, low: Cell, blocks: impl Iterator<Item = Block>) -> Look {
    let [u, v] = axes(layer);
    let mut look: Look = blocks
        .map(|block| {
            let cell = building.cell(block) - low;
            (u.of(cell), v.of(cell), building.kind(block))
        })
        .collect();
    look.sort_unstable();
    look
}

/// Groups of shapes that are alike, with how many shapes each has.
#[derive(Debug, Default)]
pub struct Groups {
    numbers: FxHashMap<Look, usize>,
    counts: Vec<u32>,
    measures: Vec<f64>,
}

impl Groups {
    /// The group of a look. Shapes that are alike measure the same.
    pub fn number(&mut self, look: Look, measure: f64) -> usize {
        let next = self.counts.len();
        let number = *self.numbers.entry(look).or_insert(next);
        if number == next {
            self.counts.push(0);
            self.measures.push(measure);
        }
        number
    }

    pub fn enter(&mut self, group: usize) {
        self.counts[group] += 1;
    }

    pub fn leave(&mut self, group: usize) {
        self.counts[group] -= 1;
    }

    /// How much a cost rises that counts each group once, when shapes leave and others enter.
    pub fn rise(&self, leaving: &[usize], entering: &[usize], per_shape: f64) -> f64 {
        let mut touched = [leaving, entering].concat();
        touched.sort_unstable();
        touched.dedup();
        let of =
            |group: usize, groups: &[usize]| groups.iter().filter(|other| **other == group).count() as u32;
        let change = |group: usize| {
            let before = self.counts[group];
            let after = before + of(group, entering) - of(group, leaving);
            f64::from(u8::from(after > 0)) - f64::from(u8::from(before > 0))
        };
        touched.into_iter().map(|group| change(group) * (per_shape + self.measures[group])).sum()
    }
}
