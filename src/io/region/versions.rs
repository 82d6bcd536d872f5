//! Chunks of several versions of the game.

use super::chunk::Column;
use crate::block::{BlockState, PaletteFull, Version, translated};
use crate::grid::Grid;
use crate::space::Bounds;
use std::collections::BTreeMap;

/// Brings the states of older columns to the highest version of all. The low corner of `grid` is that of `part`.
pub(super) fn bring_to_highest(
    grid: &mut Grid,
    part: Bounds,
    columns: &BTreeMap<Column, Option<Version>>,
) -> Result<(), PaletteFull> {
    let Some(highest) = columns.values().flatten().max().copied() else { return Ok(()) };
    let mut by_version: BTreeMap<Version, Vec<Column>> = BTreeMap::new();
    for (&column, version) in columns {
        if let Some(version) = version.filter(|version| *version < highest) {
            by_version.entry(version).or_default().push(column);
        }
    }
    for (version, columns) in by_version {
        let states: Vec<BlockState> = grid.palette().states().to_vec();
        let new = |state| translated(state, version, highest).unwrap_or_else(|_| BlockState::clone(state));
        let ids = states.iter().map(|state| grid.intern(&new(state)));
        let ids = ids.collect::<Result<Vec<u16>, PaletteFull>>()?;
        for cell in columns.iter().flat_map(|column| column.within(part).cells()) {
            let cell = cell - part.min;
            grid.set(cell, ids[usize::from(grid.id(cell))]);
        }
    }
    Ok(())
}
