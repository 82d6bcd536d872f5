//! Integer space: axes, half-open boxes, quarter turns, and scopes. Knows nothing of blocks.

mod axis;
mod bounds;
mod turn;

pub use axis::Axis;
pub use bounds::Bounds;
pub use turn::Turn;

/// The place of one block, or a vector between two places.
pub type Cell = glam::IVec3;
