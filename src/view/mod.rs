//! Pictures of grids.
//!
//! ```text
//! Grid --turn--> Scene --project--> Canvas --develop--> RgbaImage --> PNG, contact sheet
//! ```

mod camera;
mod canvas;
mod develop;
mod drawing;
mod isometric;
mod options;
mod png;
mod scene;
mod sheet;
mod side;
mod text;
mod texture;

pub use drawing::drawing;
pub use isometric::{isometric, isometric_colors};
pub use options::{Corner, Scale, ViewOptions};
pub use png::png;
pub use sheet::sheet;
