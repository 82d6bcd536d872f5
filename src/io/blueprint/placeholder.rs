//! Blocks of Structurize that stand for something else.
//!
//! | block | what it asks for |
//! |---|---|
//! | `blocksubstitution` | whatever is there |
//! | `blocksolidsubstitution` | whatever is there, if it is solid; else some ground |
//! | `blockfluidsubstitution` | whatever is there, if it is a liquid; else the sea's |
//!
//! In a grid all three say "leave alone": only a world can answer more, and a block that no game but one with the mod
//! knows would be pasted as air, a pit around every house. That the last two ask for more, a warning tells.

use crate::block::BlockState;

const NOTHING: &str = "structurize:blocksubstitution";
const GROUND: [&str; 2] = ["structurize:blocksolidsubstitution", "structurize:blockfluidsubstitution"];

pub(super) fn is_ground(state: &BlockState) -> bool {
    GROUND.contains(&state.name())
}

/// A state of the file in the terms of a grid.
pub(super) fn understood(state: BlockState) -> BlockState {
    if state.name() == NOTHING || is_ground(&state) { BlockState::structure_void() } else { state }
}
