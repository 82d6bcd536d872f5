//! What a set of shapes costs as it is kept.

use super::alike;
use super::building::{Block, Building};
use super::layer::Layer;
use super::price::{Price, Sum};
use super::settings::{Cost, Settings};
use super::tally::Tally;
use crate::space::Cell;
use std::collections::BTreeSet;

/// The cost of shapes under the settings.
pub fn cost<'a>(
    building: &Building,
    settings: &Settings,
    shapes: impl Iterator<Item = (Layer, &'a [Block])>,
) -> f64 {
    let price = Price { cost: settings.cost, alpha: settings.alpha };
    let mut seen = BTreeSet::new();
    let mut sum = Sum::default();
    for (layer, blocks) in shapes {
        let low = blocks.iter().map(|block| building.cell(*block)).reduce(Cell::min).unwrap_or_default();
        let is_alike = settings.cost == Cost::Alike
            && !seen.insert(alike::look(building, layer, low, blocks.iter().copied()));
        if !is_alike {
            let tally = Tally::of(blocks.iter().map(|block| building.kind(*block)));
            sum = Sum { count: sum.count + 1, measure: sum.measure + price.measure(&tally) };
        }
    }
    price.of(sum)
}
