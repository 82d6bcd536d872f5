//! Several regions as one grid.
//!
//! Where they overlap, the last block counts in the order of their names. Air is none and takes none away.

use super::region::Part;
use crate::block::{BlockState, Palette};
use crate::grid::Grid;
use crate::io::{ReadError, Warning};
use crate::space::Bounds;
use ndarray::{Array3, Zip, s};

/// The blocks of `parts` within `all`, the box around them.
pub(super) fn grid(parts: &[Part], all: Bounds) -> Result<(Grid, Vec<Warning>), ReadError> {
    let mut palette = Palette::default();
    let (cells, warnings) = match parts {
        [part] => (cells(part, &mut palette)?, Vec::new()),
        _ => merged(parts, all, &mut palette)?,
    };
    Ok((Grid::from_cells(cells, palette).expect("cells hold numbers of their palette"), warnings))
}

/// The blocks of one region, by their numbers in `palette`.
fn cells(part: &Part, palette: &mut Palette) -> Result<Array3<u16>, ReadError> {
    let ids = part.palette.iter().map(|state| palette.intern(state)).collect::<Result<Vec<u16>, _>>();
    let full = |problem| ReadError::PaletteFull { path: part.fields.path("BlockStatePalette"), problem };
    let ids = ids.map_err(full)?;
    let mut cells = part.indices()?;
    // The palette of the only region is mostly that of the grid.
    if ids.iter().zip(0..=u16::MAX).any(|(&id, index)| id != index) {
        cells.iter_mut().for_each(|cell| *cell = ids[usize::from(*cell)]);
    }
    let [x, y, z] = part.bounds.size().to_array().map(|n| n as usize);
    Ok(Array3::from_shape_vec((y, z, x), cells).expect("as many cells as the size makes"))
}

fn merged(
    parts: &[Part],
    all: Bounds,
    palette: &mut Palette,
) -> Result<(Array3<u16>, Vec<Warning>), ReadError> {
    let nobodys = palette.intern(&BlockState::structure_void()).expect("the palette was empty");
    let [x, y, z] = all.size().to_array().map(|n| n as usize);
    let mut merged = Array3::from_elem((y, z, x), nobodys);
    let (mut warnings, mut nothing) = (Vec::new(), Vec::new());
    for part in parts {
        let cells = cells(part, palette)?;
        nothing.extend(palette.states()[nothing.len()..].iter().map(BlockState::is_nothing));
        let [x0, y0, z0] = (part.bounds.min - all.min).to_array().map(|n| n as usize);
        let [x1, y1, z1] = (part.bounds.max - all.min).to_array().map(|n| n as usize);
        let mut replaced = 0;
        Zip::from(merged.slice_mut(s![y0..y1, z0..z1, x0..x1])).and(&cells).for_each(|old, &new| {
            let is_block = !nothing[usize::from(new)];
            replaced += usize::from(is_block && *old != new && !nothing[usize::from(*old)]);
            if is_block || *old == nobodys {
                *old = new;
            }
        });
        let region = part.name.to_owned();
        warnings.extend((replaced > 0).then_some(Warning::RegionsOverlap { region, blocks: replaced }));
    }
    Ok((merged, warnings))
}
