//! The blocks of a cube of 16 x 16 x 16.

use super::packing::{self, bits};
use crate::block::BlockState;
use crate::io::fields::Fields;
use crate::io::legacy::{self, Ids, Strangers};
use crate::io::{ReadError, states, volume};

pub(super) const CELLS: usize = 16 * 16 * 16;

/// The fewest bits of a packed index into the states of a section.
pub(super) const LEAST_BITS: usize = 4;

/// Blocks by numbers of their states, x fastest, then z, then y.
pub(super) struct Section {
    pub states: Vec<BlockState>,
    /// Empty where all cells hold the first state.
    pub ids: Vec<u32>,
}

/// `None` where a section holds light alone. Numbers that stand for nothing are added to `strangers`.
pub(super) fn read(section: &Fields, strangers: &mut Strangers) -> Result<Option<Section>, ReadError> {
    if let Some(blocks) = section.inner("block_states")? {
        return of_palette(&blocks, "palette", "data").map(Some);
    }
    if section.tags.contains_key("Palette") {
        return of_palette(section, "Palette", "BlockStates").map(Some);
    }
    if is_numbered(section) {
        return of_numbers(section, strangers).map(Some);
    }
    Ok(None)
}

/// Whether blocks are told by numbers, as before Minecraft 1.13.
pub(super) fn is_numbered(section: &Fields) -> bool {
    section.tags.contains_key("Blocks") && !section.tags.contains_key("Palette")
}

fn of_numbers(section: &Fields, strangers: &mut Strangers) -> Result<Section, ReadError> {
    let blocks = bytes(section, "Blocks", CELLS)?;
    let data = bytes(section, "Data", CELLS / 2)?;
    let add = section.find::<&[i8]>("Add")?.map(|_| bytes(section, "Add", CELLS / 2)).transpose()?;
    let number = |(at, &low): (usize, &i8)| {
        let high = add.map_or(0, |add| u16::from(half(add, at)));
        (high << 8 | u16::from(low.cast_unsigned()), half(data, at))
    };
    let numbers = blocks.iter().enumerate().map(number);
    let (ids, palette) =
        legacy::states(numbers, &Ids::default(), strangers).map_err(volume::full(section.path("Blocks")))?;
    Ok(Section { states: palette.states().to_vec(), ids: ids.into_iter().map(u32::from).collect() })
}

/// As many bytes as a section has.
fn bytes<'a>(section: &Fields<'a>, name: &str, count: usize) -> Result<&'a [i8], ReadError> {
    let bytes = section.get::<&[i8]>(name)?;
    let short = || ReadError::ShortArray { path: section.path(name), found: bytes.len() };
    bytes.get(..count).ok_or_else(short)
}

/// Half a byte for each block, the low half first.
fn half(bytes: &[i8], at: usize) -> u8 {
    let byte = bytes[at / 2].cast_unsigned();
    if at.is_multiple_of(2) { byte & 15 } else { byte >> 4 }
}

fn of_palette(fields: &Fields, palette: &str, data: &str) -> Result<Section, ReadError> {
    let states =
        fields.list(palette)?.iter().map(states::read).collect::<Result<Vec<BlockState>, ReadError>>()?;
    let ids = indices(fields, data, states.len(), LEAST_BITS, CELLS)?;
    let path = || fields.path(data);
    match ids.iter().position(|&id| id as usize >= states.len()) {
        _ if states.is_empty() => Err(ReadError::NoStates { path: fields.path(palette) }),
        Some(at) => Err(ReadError::PackedIndex { path: path(), at, index: ids[at], entries: states.len() }),
        None => Ok(Section { states, ids }),
    }
}

/// The packed indices `name`; none where there is only one value to choose from.
pub(super) fn indices(
    fields: &Fields,
    name: &str,
    entries: usize,
    least: usize,
    count: usize,
) -> Result<Vec<u32>, ReadError> {
    match fields.find::<&[i64]>(name)? {
        None if entries <= 1 => Ok(Vec::new()),
        None => fields.get::<&[i64]>(name).map(|_| Vec::new()),
        Some([]) if entries <= 1 => Ok(Vec::new()),
        Some(longs) => packing::unpack(longs, bits(entries).max(least), count).ok_or_else(|| {
            ReadError::PackedLength { path: fields.path(name), longs: longs.len(), count, entries }
        }),
    }
}
