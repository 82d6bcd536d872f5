//! The sets of shapes that are searched side by side.

use super::settings::Specification;
use crate::space::{Axis, Turn};

/// What shapes a block is part of in a search: each block is in one shape of each layer. When a block has joined others in
/// one plane, it can still be part of a shape in another (seed 3, "Local search").
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Layer {
    /// Rectangles across an axis.
    Rectangular(Axis),
    /// Plane shapes across an axis.
    Planar(Axis),
    /// Solid shapes. They are seen along an axis where they are compared as the authors' program does.
    Solid(Axis),
}

/// The planes in the order of the authors' program.
const PLANES: [Axis; 3] = [Axis::Z, Axis::Y, Axis::X];

impl Layer {
    /// The layers of a specification, in the order in which each block enters them.
    pub fn of(specification: Specification) -> Vec<Layer> {
        let rectangular = || PLANES.map(Layer::Rectangular);
        let planar = || PLANES.map(Layer::Planar);
        match specification {
            Specification::Rectangular => rectangular().to_vec(),
            Specification::Planar => planar().to_vec(),
            Specification::Solid => vec![Layer::Solid(Axis::Z)],
            Specification::Mixed => [&rectangular()[..], &planar(), &[Layer::Solid(Axis::Z)]].concat(),
        }
    }

    /// The axes along which the shapes of this layer extend.
    pub fn axes(self) -> &'static [Axis] {
        match self.across() {
            Some(Axis::X) => &[Axis::Y, Axis::Z],
            Some(Axis::Y) => &[Axis::X, Axis::Z],
            Some(Axis::Z) => &[Axis::X, Axis::Y],
            None => &Axis::ALL,
        }
    }

    /// The axis across its planes; none where shapes are solid.
    pub fn across(self) -> Option<Axis> {
        match self {
            Layer::Rectangular(across) | Layer::Planar(across) => Some(across),
            Layer::Solid(_) => None,
        }
    }

    /// The axis along which its shapes are seen.
    pub fn seen_along(self) -> Axis {
        let (Layer::Rectangular(axis) | Layer::Planar(axis) | Layer::Solid(axis)) = self;
        axis
    }

    /// This layer of a building that is turned.
    pub fn turned(self, turn: Turn) -> Layer {
        let across = |axis: Axis| match (axis, turn.count() % 2) {
            (Axis::X, 1) => Axis::Z,
            (Axis::Z, 1) => Axis::X,
            _ => axis,
        };
        match self {
            Layer::Rectangular(axis) => Layer::Rectangular(across(axis)),
            Layer::Planar(axis) => Layer::Planar(across(axis)),
            Layer::Solid(axis) => Layer::Solid(axis),
        }
    }

    pub fn is_rectangular(self) -> bool {
        matches!(self, Layer::Rectangular(_))
    }

    /// Its place among all layers that there are.
    pub fn index(self) -> usize {
        match self {
            Layer::Rectangular(across) => across.index(),
            Layer::Planar(across) => 3 + across.index(),
            Layer::Solid(axis) => 6 + axis.index(),
        }
    }

    /// The number of layers that there are.
    pub const COUNT: usize = 9;
}
