//! Sizes in headers, which are not believed before the bytes of their blocks are there.

use super::error::Size;
use super::fields::{Extent, Fields};
use super::{Limits, ReadError};
use crate::block::{Palette, PaletteFull};
use crate::grid::Grid;
use crate::space::{Bounds, Cell};
use ndarray::Array3;

/// The size that the tags called `names` give along x, y and z; no side is 0.
pub(super) fn size(fields: &Fields, names: [&str; 3]) -> Result<Cell, ReadError> {
    let [x, y, z] = names.map(|name| match fields.get(name)? {
        Extent(0) => Err(ReadError::ZeroSize { path: fields.path(name) }),
        Extent(n) => Ok(i32::from(n)),
    });
    Ok(Cell::new(x?, y?, z?))
}

/// The number of cells of `size`, for which the tag at `path` holds enough: `found` entries of one cell each.
pub(super) fn cells(size: Cell, path: String, found: usize, limits: &Limits) -> Result<usize, ReadError> {
    let cells = Bounds::of_size(size).volume();
    if cells > limits.max_cells {
        return Err(ReadError::TooManyCells { size: Size(size), cells, limit: limits.max_cells });
    }
    match cells > found as u64 {
        true => Err(ReadError::TooFewEntries { size: Size(size), cells, path, found }),
        false => Ok(cells as usize),
    }
}

/// A grid of `cells`, which are in the order y, z, x, fill `size` and hold numbers of `palette`.
pub(super) fn grid(size: Cell, cells: Vec<u16>, palette: Palette) -> Grid {
    let [x, y, z] = size.to_array().map(|n| n as usize);
    let cells = Array3::from_shape_vec((y, z, x), cells).expect("as many cells as the size makes");
    Grid::from_cells(cells, palette).expect("cells hold numbers of their palette")
}

pub(super) fn full(path: impl Into<String>) -> impl Fn(PaletteFull) -> ReadError {
    let path = path.into();
    move |problem| ReadError::PaletteFull { path: path.clone(), problem }
}
