//! What a shape can know of the others: whether they cover it, whether it sees them, and which planes they mark
//! (seed 2, sections 3.2 to 3.4). Everything is exact on whole blocks.

mod configuration;
mod cover;
mod index;
mod occlusion;
mod sight;
mod snap;

pub use configuration::{Boxes, Configuration, Label, Shape, ShapeId, Snapshot, State};
pub use occlusion::{Against, Asker, Occlusion};
pub use snap::{Planes, Region, sections, snapped};
