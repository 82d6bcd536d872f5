//! Integer space: axes, half-open boxes, quarter turns, scopes, footprints, and the fitting of real sizes to
//! whole blocks. Knows nothing of blocks.

mod axis;
mod bounds;
mod corners;
mod fit;
mod footprint;
mod frame;
mod rect;
mod scope;
mod turn;
mod view;

pub use axis::Axis;
pub use bounds::Bounds;
pub use corners::Corners;
pub use fit::{Length, Misfit, clip, fit, shares};
pub use footprint::{Corner, Depths, Footprint, Wall, shape_h, shape_l, shape_o, shape_t, shape_u};
pub use frame::{Frame, Up};
pub use rect::{Rect, SIDES, Spot};
pub use scope::Scope;
pub use turn::Turn;
pub use view::View;

/// The place of one block, or a vector between two places.
pub type Cell = glam::IVec3;
