//! The description length of examples under a grammar.

use super::cells::Alphabet;
use super::compressed::zlib_bits;
use super::explained::Explained;
use super::model::model_bits;
use crate::graph::OpGraph;
use crate::grid::Grid;

/// How many bits it takes to say some buildings.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Length {
    /// The grammar.
    pub model: f64,
    /// The cheapest derivations of the buildings under it.
    pub data: f64,
    /// The same buildings as zlib packs them.
    pub zlib: f64,
}

impl Length {
    /// `None` where the grammar does not reproduce every building.
    pub fn of(graph: &OpGraph, explained: &Explained, buildings: &[Grid]) -> Option<Length> {
        let zlib = zlib_bits(&Alphabet::default().all(buildings));
        Some(Length { model: model_bits(graph), data: explained.bits()?, zlib })
    }

    /// Grammar and derivations beside what zlib makes of the same.
    pub fn ratio(self) -> f64 {
        (self.model + self.data) / self.zlib
    }
}
