//! One shape of a set that is searched.

use crate::shapes::building::{Block, Building};
use crate::shapes::layer::Layer;
use crate::shapes::tally::Tally;
use crate::space::{Axis, Bounds};

/// Connected blocks, with what steps ask of them.
#[derive(Clone, Debug)]
pub struct Piece {
    pub layer: Layer,
    pub blocks: Vec<Block>,
    /// The box around it.
    pub bounds: Bounds,
    pub tally: Tally,
}

impl Piece {
    pub fn new(building: &Building, layer: Layer, blocks: Vec<Block>) -> Piece {
        let cells = blocks.iter().map(|block| building.cell(*block));
        let bounds = Bounds::around(cells).expect("a piece holds blocks");
        let tally = Tally::of(blocks.iter().map(|block| building.kind(*block)));
        Piece { layer, blocks, bounds, tally }
    }

    /// The blocks of both, which are of one layer.
    pub fn joined(&self, other: &Piece) -> Piece {
        Piece {
            layer: self.layer,
            blocks: [self.blocks.as_slice(), &other.blocks].concat(),
            bounds: self.bounds.union(&other.bounds),
            tally: self.tally.plus(&other.tally),
        }
    }

    /// Whether this and another of its layer that it touches may be one shape.
    pub fn may_join(&self, other: &Piece) -> bool {
        let blocks = (self.blocks.len() + other.blocks.len()) as u64;
        !self.layer.is_rectangular() || self.bounds.union(&other.bounds).volume() == blocks
    }

    /// Where it can be cut: the axis, and the first layer of the second part.
    pub fn cuts(&self) -> impl Iterator<Item = (Axis, i32)> + use<> {
        let Bounds { min, max } = self.bounds;
        let places = move |axis: Axis| (axis.of(min) + 1..axis.of(max)).map(move |at| (axis, at));
        self.layer.axes().iter().flat_map(move |axis| places(*axis))
    }

    /// What lies on both sides of a cut.
    pub fn parts(&self, building: &Building, (axis, at): (Axis, i32)) -> [Vec<Block>; 2] {
        let (below, above) = self.blocks.iter().partition(|block| axis.of(building.cell(**block)) < at);
        [below, above]
    }
}
