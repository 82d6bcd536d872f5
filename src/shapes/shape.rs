use super::building::{Block, Building};
use super::layer::Layer;
use super::tally::Tally;

/// A shape: connected blocks of a building (seed 3, "Definitions").
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Shape {
    pub layer: Layer,
    /// In the order in which they were joined. Never empty.
    pub blocks: Vec<Block>,
}

impl Shape {
    pub fn tally(&self, building: &Building) -> Tally {
        Tally::of(self.blocks.iter().map(|block| building.kind(*block)))
    }
}
