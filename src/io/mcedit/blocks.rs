//! The numbers of the blocks, and the states they stand for.

use crate::block::Palette;
use crate::io::fields::Fields;
use crate::io::legacy::{self, Ids, Strangers};
use crate::io::{Limits, ReadError, Warning, volume};
use crate::space::Cell;

/// Palette numbers in the order y, z, x, their palette, and what had to be put right.
type Read = (Vec<u16>, Palette, Vec<Warning>);

pub(super) fn read(root: &Fields, size: Cell, limits: &Limits) -> Result<Read, ReadError> {
    let blocks = root.get::<&[i8]>("Blocks")?;
    let data = root.get::<&[i8]>("Data")?;
    let volume = volume::cells(size, root.path("Blocks"), blocks.len(), limits)?;
    volume::cells(size, root.path("Data"), data.len(), limits)?;
    let ids = Ids::read(root)?;
    let high = High::read(root, volume, &ids)?;

    let number = |(at, (&block, &data)): (usize, (&i8, &i8))| {
        (u16::from(block.cast_unsigned()) | high.of(at) << 8, data.cast_unsigned() & 15)
    };
    let numbers = blocks.iter().zip(data).enumerate().take(volume).map(number);
    let mut strangers = Strangers::default();
    let (cells, palette) = legacy::states(numbers, &ids, &mut strangers).map_err(volume::full("Blocks"))?;
    let warnings = strangers.warnings().chain(high.warning()).collect();
    Ok((cells, palette, warnings))
}

/// The bits of the ids beyond the eighth.
enum High<'a> {
    None,
    /// A byte for each block.
    Bytes(&'a [i8]),
    /// Half a byte for each block, the low half first.
    WorldEdit(&'a [i8]),
    /// The high half first.
    Schematica(&'a [i8]),
}

impl High<'_> {
    /// Nothing in a file tells the two orders of halves apart; but only Schematica writes names of its ids.
    fn read<'a>(root: &Fields<'a>, volume: usize, ids: &Ids) -> Result<High<'a>, ReadError> {
        if let Some(halves) = root.find::<&[i8]>("AddBlocks")? {
            let enough = halves.get(..volume.div_ceil(2)).ok_or_else(|| short(root, "AddBlocks", halves))?;
            return Ok(if ids.named() { High::Schematica(enough) } else { High::WorldEdit(enough) });
        }
        match root.find::<&[i8]>("Add")? {
            None => Ok(High::None),
            Some(bytes) => bytes.get(..volume).map(High::Bytes).ok_or_else(|| short(root, "Add", bytes)),
        }
    }

    fn of(&self, at: usize) -> u16 {
        let half = |bytes: &[i8], low: bool| {
            let byte = u16::from(bytes[at / 2].cast_unsigned());
            if low { byte & 15 } else { byte >> 4 }
        };
        match self {
            High::None => 0,
            High::Bytes(bytes) => u16::from(bytes[at].cast_unsigned()) & 15,
            High::WorldEdit(bytes) => half(bytes, at.is_multiple_of(2)),
            High::Schematica(bytes) => half(bytes, !at.is_multiple_of(2)),
        }
    }

    fn warning(&self) -> Option<Warning> {
        match self {
            High::WorldEdit(bytes) => bytes.iter().any(|&byte| byte != 0).then_some(Warning::HalvesOfIds),
            _ => None,
        }
    }
}

fn short(root: &Fields, name: &str, bytes: &[i8]) -> ReadError {
    ReadError::ShortArray { path: root.path(name), found: bytes.len() }
}
