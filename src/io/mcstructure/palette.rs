//! The palette of a structure, in the names of Java Edition.

use crate::block::{BlockState, bedrock_state, known};
use crate::io::fields::Fields;
use crate::io::{ReadError, states};
use crate::nbt::{Compound, Tag};
use std::collections::BTreeMap;

/// One block of the palette.
pub(super) struct Entry {
    pub state: BlockState,
    /// Neither the table nor Java Edition knows the block.
    pub unknown: bool,
}

pub(super) fn read(default: &Fields) -> Result<Vec<Entry>, ReadError> {
    default.get::<&[Tag]>("block_palette")?;
    default.list("block_palette")?.iter().map(entry).collect()
}

fn entry(fields: &Fields) -> Result<Entry, ReadError> {
    let name = fields.get::<&str>("name")?;
    let states = fields.find::<&Compound>("states")?.map(texts).unwrap_or_default();
    match bedrock_state(name, &states) {
        Some(state) => Ok(Entry { state, unknown: false }),
        None => foreign(fields, name, &states),
    }
}

/// A block that the table does not know: one of Java Edition where the name is, else whatever the file says.
fn foreign(fields: &Fields, name: &str, states: &BTreeMap<String, String>) -> Result<Entry, ReadError> {
    let name = name.to_ascii_lowercase();
    let path = || fields.path("name");
    if known(&name).is_some() {
        return Ok(Entry { state: states::parse(&name, path)?, unknown: false });
    }
    let pairs: Vec<String> = states.iter().map(|(key, value)| format!("{key}={value}")).collect();
    let state = states::parse(&format!("{name}[{}]", pairs.join(",")), path)?;
    Ok(Entry { state, unknown: true })
}

/// The states with their values as text: `1` for a Byte or an Int of 1.
fn texts(states: &Compound) -> BTreeMap<String, String> {
    let text = |tag: &Tag| match tag {
        Tag::Byte(n) => Some(n.to_string()),
        Tag::Short(n) => Some(n.to_string()),
        Tag::Int(n) => Some(n.to_string()),
        Tag::String(text) => Some(text.clone()),
        _ => None,
    };
    states.iter().filter_map(|(key, tag)| Some((String::from(key), text(tag)?))).collect()
}
