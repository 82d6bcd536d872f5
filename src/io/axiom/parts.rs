//! The three parts of a file.

use crate::io::{Limits, ReadError, gzip};
use crate::nbt::{self, Compound, Endian};
use std::io;

pub(super) struct Parts<'a> {
    pub header: Compound,
    /// A PNG, which nobody looks into here.
    pub picture: &'a [u8],
    pub blocks: Compound,
    /// The bytes after the end of the blocks, and after that of their part.
    pub trailing: u64,
}

const MAGIC: usize = 4;

impl<'a> Parts<'a> {
    /// The parts of `bytes`, which start with the magic number.
    pub fn read(bytes: &'a [u8], limits: &Limits) -> Result<Parts<'a>, ReadError> {
        let mut rest = &bytes[MAGIC.min(bytes.len())..];
        let header = part(&mut rest, "header")?;
        let picture = part(&mut rest, "picture")?;
        let mut blocks = gzip::open(part(&mut rest, "blocks")?, limits.max_bytes)?;
        let (_, header) = nbt::read(header, &limits.nbt())?;
        let (_, root, _) = nbt::read_from(&mut blocks, Endian::Big, &limits.nbt(), &mut ())?;
        // To the very end, where gzip keeps its checksum.
        let trailing = io::copy(&mut blocks, &mut io::sink())? + rest.len() as u64;
        Ok(Parts { header, picture, blocks: root, trailing })
    }
}

/// The next part, which stands behind its length.
fn part<'a>(rest: &mut &'a [u8], part: &'static str) -> Result<&'a [u8], ReadError> {
    let cut_off = ReadError::PartCutOff { part, left: rest.len() };
    let Some((length, after)) = rest.split_first_chunk::<4>() else { return Err(cut_off) };
    let length = usize::try_from(u32::from_be_bytes(*length)).unwrap_or(usize::MAX);
    match after.split_at_checked(length) {
        None => Err(cut_off),
        Some((bytes, after)) => {
            *rest = after;
            Ok(bytes)
        }
    }
}
