//! Blocks of Structurize that stand for something else.
//!
//! | block | what it asks for | in a grid |
//! |---|---|---|
//! | `blocksubstitution` | whatever is there already | `structure_void` |
//! | `blocksolidsubstitution` | whatever is there, if it is solid; else some ground | stays |
//! | `blockfluidsubstitution` | whatever is there, if it is a liquid; else the sea | stays |
//! | `blocktagsubstitution` | whatever is there, with a label for the builder | stays |
//!
//! Only the first says no more than "leave alone". What the others ask for only a world can answer, so they stay as
//! they are, and a warning tells of them.

use crate::block::BlockState;
use crate::grid::Grid;
use crate::io::{Warning, states};

const ASKING: [&str; 3] = [
    "structurize:blocksolidsubstitution",
    "structurize:blockfluidsubstitution",
    "structurize:blocktagsubstitution",
];

/// A state of the file in the terms of a grid.
pub(super) fn understood(state: BlockState) -> BlockState {
    if state.name() == "structurize:blocksubstitution" { states::leave_alone() } else { state }
}

pub(super) fn warning(grid: &Grid) -> Option<Warning> {
    let asks: Vec<bool> =
        grid.palette().states().iter().map(|state| ASKING.contains(&state.name())).collect();
    let count = grid.cells().iter().filter(|&&id| asks[usize::from(id)]).count();
    (count > 0).then_some(Warning::Placeholders(count))
}
