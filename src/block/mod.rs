//! Block states and what is known of blocks. Knows nothing of grids, text or files.

mod bedrock;
mod boxes;
mod color;
mod counterpart;
mod facing;
mod family;
mod item;
mod known;
mod legacy;
mod palette;
mod pattern;
mod replacement;
mod shape;
mod state;
mod sturdy;
mod suggest;
mod turn;

pub use bedrock::bedrock_state;
pub use boxes::{Cuboid, boxes};
pub use color::{Rgba, color};
pub use counterpart::{counterpart, is_material};
pub use facing::Facing;
pub use family::Family;
pub use item::{items, stack};
pub use known::{BadProperty, Known, Property, all, check, complete, known};
pub use legacy::{DYES, LEGACY_DATA_VERSION, legacy_id, legacy_state};
pub use palette::{Palette, PaletteFull};
pub use replacement::{BadReplacement, Replacement};
pub use shape::{Arm, Bend, Half, Hung, Leaves, Plant, Post, Shape, Sides, Slope, shape};
pub use state::{BadBlockState, BlockState};
pub use sturdy::{Bottom, bottom, sturdy};
pub use suggest::suggest;
pub use turn::{Mirror, Motion};
