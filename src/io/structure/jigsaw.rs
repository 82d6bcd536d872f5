//! Jigsaw blocks: the game joins structures by them, and leaves another block behind.

use crate::block::BlockState;
use crate::io::{ReadError, states};
use crate::nbt::{Compound, Tag};

/// The block that stays of a block `state` with the data `nbt`; `None` where it is no jigsaw, or one without
/// data, which the game leaves as it is, too.
pub(super) fn final_state(
    state: &BlockState,
    nbt: Option<&Compound>,
    path: impl Fn() -> String,
) -> Result<Option<BlockState>, ReadError> {
    let Some(nbt) = nbt.filter(|_| state.name() == "minecraft:jigsaw") else { return Ok(None) };
    let Some(Tag::String(text)) = nbt.get("final_state") else { return Ok(Some(BlockState::air())) };
    // The data of a block entity may follow, as in commands. The game takes none of them either.
    let text = text.split('{').next().unwrap_or_default();
    states::parse(text, || format!("{}.final_state", path())).map(Some)
}
