//! What the numeric ids of a file mean.

use crate::block::{BlockState, legacy_id, legacy_state};
use crate::io::ReadError;
use crate::io::fields::{Fields, FromTag};
use crate::nbt::Compound;
use std::collections::BTreeMap;

/// The names that a file gives its ids; those of other files are the game's.
#[derive(Default)]
pub struct Ids<'a>(BTreeMap<u16, &'a str>);

/// Why a state is not quite what the file asks for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unknown {
    /// The id is the game's, but never has such data: the state is that of data 0.
    Data,
    /// Nobody says what block the id is of: the state is named after the number.
    Id,
}

impl<'a> Ids<'a> {
    /// Schematica says which number each name has, as those of mods differ from world to world.
    pub fn read(root: &Fields<'a>) -> Result<Ids<'a>, ReadError> {
        let mapping = root.find::<&Compound>("SchematicaMapping")?;
        let named = mapping.into_iter().flatten().filter_map(|(name, tag)| {
            let id = i32::from_tag(tag).and_then(|id| u16::try_from(id).ok())?;
            Some((id, name.as_str()))
        });
        Ok(Ids(named.collect()))
    }

    pub fn named(&self) -> bool {
        !self.0.is_empty()
    }

    pub fn state(&self, id: u16, data: u8) -> (BlockState, Option<Unknown>) {
        let name = self.0.get(&id).copied();
        match name.map_or_else(|| u8::try_from(id).ok(), legacy_id) {
            Some(known) => legacy(known, data).unwrap_or_else(|| (numbered(id, data), Some(Unknown::Id))),
            None => match name.and_then(|name| modded(name, data)) {
                Some(state) => (state, None),
                None => (numbered(id, data), Some(Unknown::Id)),
            },
        }
    }
}

fn legacy(id: u8, data: u8) -> Option<(BlockState, Option<Unknown>)> {
    if let Some(state) = legacy_state(id, data) {
        return Some((state.clone(), None));
    }
    legacy_state(id, 0).map(|state| (state.clone(), Some(Unknown::Data)))
}

/// A block of a mod. Capital letters in names were legal once.
fn modded(name: &str, data: u8) -> Option<BlockState> {
    BlockState::new(&name.to_ascii_lowercase()).ok().map(|state| with_data(state, data))
}

/// A block that nobody can name keeps its number, so that it can be replaced by name.
fn numbered(id: u16, data: u8) -> BlockState {
    let state = BlockState::new(&format!("legacy:{id}")).expect("digits make a name");
    with_data(state, data)
}

/// What the data say is known to the mod alone.
fn with_data(state: BlockState, data: u8) -> BlockState {
    if data == 0 { state } else { state.with("data", &data.to_string()) }
}
