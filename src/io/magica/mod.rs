//! MagicaVoxel models (.vox): coloured voxels in models of at most 256 along each axis, placed by a scene.
//!
//! ```text
//! "VOX ", version, MAIN { SIZE, XYZI: a model, .., nTRN, nGRP, nSHP: the scene, RGBA: the palette }
//! bytes --chunks--> models, scene, palette --read--> Grid, every colour the plain block nearest to it
//! ```
//!
//! Up is z there: the cell (x, y, z) of a grid is the voxel (x, -z, y).

mod chunks;
mod colors;
mod error;
mod paints;
mod read;
mod scene;
mod write;

pub use error::MagicaError;
pub(super) use read::decode;
pub use write::encode_vox;

/// Voxels along a model, at most.
const MOST: i32 = 256;
