//! One shape of a set that is searched.

use crate::shapes::building::{Block, Building};
use crate::shapes::layer::Layer;
use crate::shapes::tally::Tally;
use crate::space::{Axis, Cell};

/// Connected blocks, with what steps ask of them.
#[derive(Clone, Debug)]
pub struct Piece {
    pub layer: Layer,
    pub blocks: Vec<Block>,
    /// The corners of the box around it, both inside.
    pub low: Cell,
    pub high: Cell,
    pub tally: Tally,
}

impl Piece {
    pub fn new(building: &Building, layer: Layer, blocks: Vec<Block>) -> Piece {
        let cells = blocks.iter().map(|block| building.cell(*block));
        let (low, high) =
            cells.fold((Cell::MAX, Cell::MIN), |(low, high), cell| (low.min(cell), high.max(cell)));
        let tally = Tally::of(blocks.iter().map(|block| building.kind(*block)));
        Piece { layer, blocks, low, high, tally }
    }

    /// The blocks of both, which are of one layer.
    pub fn joined(&self, other: &Piece) -> Piece {
        Piece {
            layer: self.layer,
            blocks: [self.blocks.as_slice(), &other.blocks].concat(),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            tally: self.tally.plus(&other.tally),
        }
    }

    /// Whether this and another of its layer that it touches may be one shape.
    pub fn may_join(&self, other: &Piece) -> bool {
        let size = (self.high.max(other.high) - self.low.min(other.low) + Cell::ONE).as_i64vec3();
        !self.layer.is_rectangular()
            || size.element_product() == (self.blocks.len() + other.blocks.len()) as i64
    }

    /// Where it can be cut: the axis, and the first layer of the second part.
    pub fn cuts(&self) -> impl Iterator<Item = (Axis, i32)> + use<> {
        let (low, high) = (self.low, self.high);
        self.layer
            .axes()
            .iter()
            .flat_map(move |axis| (axis.of(low) + 1..=axis.of(high)).map(move |at| (*axis, at)))
    }

    /// What lies on both sides of a cut.
    pub fn parts(&self, building: &Building, (axis, at): (Axis, i32)) -> [Vec<Block>; 2] {
        let (below, above) = self.blocks.iter().partition(|block| axis.of(building.cell(**block)) < at);
        [below, above]
    }
}
