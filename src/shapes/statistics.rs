//! What the authors measure of a set of shapes (seed 3, "Shape Inference Evaluation").

use super::alike;
use super::building::{Block, Building};
use super::shape::Shape;
use super::tally::Kind;
use fixedbitset::FixedBitSet;
use std::collections::BTreeSet;

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Statistics {
    /// The number of shapes.
    pub shapes: usize,
    /// Blocks of a shape.
    pub mean_size: f64,
    pub median_size: f64,
    pub largest: usize,
    pub smallest: usize,
    /// Block types of a shape, over its blocks, on average: a measure of its complexity.
    pub complexity: f64,
    /// Shapes that look like one before them.
    pub redundant: usize,
    /// Blocks that no shape holds.
    pub uncovered: usize,
}

impl Statistics {
    pub fn of(building: &Building, shapes: &[Shape]) -> Statistics {
        let mut sizes: Vec<usize> = shapes.iter().map(|shape| shape.blocks.len()).collect();
        sizes.sort_unstable();
        let mean = |sum: f64| if shapes.is_empty() { 0.0 } else { sum / shapes.len() as f64 };
        let complexity =
            shapes.iter().map(|shape| shape.tally(building).kinds() as f64 / shape.blocks.len() as f64);
        Statistics {
            shapes: shapes.len(),
            mean_size: mean(sizes.iter().sum::<usize>() as f64),
            median_size: median(&sizes),
            largest: sizes.last().copied().unwrap_or(0),
            smallest: sizes.first().copied().unwrap_or(0),
            complexity: mean(complexity.sum()),
            redundant: redundant(building, shapes),
            uncovered: uncovered(building, shapes),
        }
    }

    /// The share of shapes that look like one before them, in percent.
    pub fn matching_percent(&self) -> f64 {
        if self.shapes == 0 { 0.0 } else { 100.0 * self.redundant as f64 / self.shapes as f64 }
    }
}

fn median(sorted: &[usize]) -> f64 {
    let middle = sorted.len() / 2;
    match sorted.len() {
        0 => 0.0,
        odd if odd % 2 == 1 => sorted[middle] as f64,
        _ => (sorted[middle - 1] + sorted[middle]) as f64 / 2.0,
    }
}

fn uncovered(building: &Building, shapes: &[Shape]) -> usize {
    let mut covered = FixedBitSet::with_capacity(building.len());
    shapes.iter().flat_map(|shape| &shape.blocks).for_each(|block| covered.insert(*block as usize));
    building.len() - covered.count_ones(..)
}

/// How many shapes look like one before them, as the authors' program counts: the same number of blocks, and each block of
/// the one has its like in the other, seen from the last joined of the blocks whose coordinates have the least sum. Solid
/// shapes are seen from the south.
fn redundant(building: &Building, shapes: &[Shape]) -> usize {
    let looks: Vec<_> = shapes.iter().map(|shape| seen_from_anchor(building, shape)).collect();
    let mut is_grouped = vec![false; looks.len()];
    let mut redundant = 0;
    for first in 0..looks.len() {
        if std::mem::replace(&mut is_grouped[first], true) {
            continue;
        }
        for other in first + 1..looks.len() {
            let size = |index: usize| shapes[index].blocks.len();
            if !is_grouped[other] && size(first) == size(other) && looks[first].is_subset(&looks[other]) {
                is_grouped[other] = true;
                redundant += 1;
            }
        }
    }
    redundant
}

fn seen_from_anchor(building: &Building, shape: &Shape) -> BTreeSet<(i32, i32, Kind)> {
    let cells = shape.blocks.iter().map(|block: &Block| building.cell(*block));
    let anchor = cells.rev().min_by_key(|cell| cell.element_sum()).unwrap_or_default();
    alike::look(building, shape.layer, anchor, shape.blocks.iter().copied()).into_iter().collect()
}
