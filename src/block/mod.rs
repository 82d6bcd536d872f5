//! Block states and what is known of blocks. Knows nothing of grids, text or files.

mod palette;
mod state;

pub use palette::{Palette, PaletteFull};
pub use state::{BadBlockState, BlockState};
