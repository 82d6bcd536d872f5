//! Block states as the game's own files hold them: `{ Name: "minecraft:oak_log", Properties: { axis: "y" } }`.

use super::ReadError;
use super::fields::Fields;
use crate::block::BlockState;
use crate::nbt::Tag;

/// The states of the list `name`, in its order.
pub(super) fn read_palette(fields: &Fields, name: &str) -> Result<Vec<BlockState>, ReadError> {
    fields.get::<&[Tag]>(name)?;
    fields.list(name)?.iter().map(read).collect()
}

fn read(entry: &Fields) -> Result<BlockState, ReadError> {
    let mut text = entry.get::<&str>("Name")?.to_owned();
    if let Some(properties) = entry.inner("Properties")? {
        let pairs = properties.tags.keys().map(|key| Ok(format!("{key}={}", properties.get::<&str>(key)?)));
        text += &format!("[{}]", pairs.collect::<Result<Vec<_>, ReadError>>()?.join(","));
    }
    parse(&text, || entry.path("Name"))
}

/// The state that `text` at `path` says.
pub(super) fn parse(text: &str, path: impl Fn() -> String) -> Result<BlockState, ReadError> {
    text.parse().map_err(|problem| ReadError::PaletteEntry { path: path(), entry: text.to_owned(), problem })
}

/// What a cell holds that says to leave the world as it is.
pub(super) fn leave_alone() -> BlockState {
    BlockState::new("structure_void").expect("a legal name")
}
