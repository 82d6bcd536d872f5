//! Block states as the game's own files hold them: `{ Name: "oak_log", Properties: { axis: "y" } }`.

use super::ReadError;
use super::fields::{self, Fields};
use crate::block::{BlockState, Palette, Version, complete_in};
use crate::nbt::{Compound, Tag};

/// The states of the list at `path`, in its order.
pub(super) fn read_palette(path: &str, entries: &[Tag]) -> Result<Vec<BlockState>, ReadError> {
    let entries = fields::values(path, entries);
    entries.map(|entry| entry.and_then(|(path, tags)| read(&Fields::new(path, tags)))).collect()
}

/// The state of an entry of a palette.
pub(super) fn read(entry: &Fields) -> Result<BlockState, ReadError> {
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

pub(super) fn write(state: &BlockState) -> Tag {
    let mut entry = Compound::from([("Name".to_owned(), Tag::String(state.name().to_owned()))]);
    if state.properties().len() > 0 {
        let properties =
            state.properties().map(|(key, value)| (key.to_owned(), Tag::String(value.to_owned())));
        entry.insert("Properties".to_owned(), Tag::Compound(properties.collect()));
    }
    Tag::Compound(entry)
}

/// The states of a palette with all properties that they have in a version of the game, each once.
pub(super) struct Complete {
    pub states: Vec<BlockState>,
    /// Their numbers by those of the palette they come from.
    pub numbers: Vec<u16>,
}

impl Complete {
    pub fn of(palette: &Palette, version: Version) -> Complete {
        let mut complete = Palette::default();
        let numbers = palette.states().iter().map(|state| complete.intern(&complete_in(state, version)));
        let numbers = numbers.collect::<Result<_, _>>().expect("no more states than in a full palette");
        Complete { states: complete.states().to_vec(), numbers }
    }
}
