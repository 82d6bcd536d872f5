//! Integer space: axes, half-open boxes, quarter turns, scopes, and the fitting of real sizes to
//! whole blocks. Knows nothing of blocks.

mod axis;
mod bounds;
mod fit;
mod frame;
mod scope;
mod turn;

pub use axis::Axis;
pub use bounds::Bounds;
pub use fit::{Length, Misfit, clip, fit, shares};
pub use frame::{Frame, Up};
pub use scope::Scope;
pub use turn::Turn;

/// The place of one block, or a vector between two places.
pub type Cell = glam::IVec3;
