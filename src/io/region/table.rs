//! The table at the head of a region: where its chunks lie, in sectors of 4 KiB. Behind it stand the times
//! of their last changes, which vox has no use for.

use super::unpack::Packing;
use super::{ChunkProblem, REGION};
use crate::io::ReadError;

pub(super) const SECTOR: usize = 4096;

/// The table and the times.
pub(super) const HEAD: usize = 2 * SECTOR;

/// An entry of the table.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    /// Along x and z, from 0 to 31.
    pub slot: [i32; 2],
    sector: usize,
}

/// A chunk as it lies in its file.
pub(super) enum Stored<'a> {
    Here(Packing, &'a [u8]),
    /// In a file of its own, as it is too long for the table.
    Beside(Packing),
}

/// The entries of the table; none in an empty file, which the game leaves where nothing was saved yet.
pub(super) fn entries(bytes: &[u8]) -> Result<Vec<Entry>, ReadError> {
    if bytes.is_empty() {
        return Ok(Vec::new());
    }
    let table = bytes.get(..HEAD).ok_or(ReadError::RegionHead(bytes.len()))?;
    let (numbers, _) = table[..SECTOR].as_chunks::<4>();
    let entry = |(at, number): (usize, &[u8; 4])| {
        let sector = (u32::from_be_bytes(*number) >> 8) as usize;
        let slot = [at as i32 % REGION, at as i32 / REGION];
        (*number != [0; 4]).then_some(Entry { slot, sector })
    };
    Ok(numbers.iter().enumerate().filter_map(entry).collect())
}

impl Entry {
    /// What the entry points to in the region `bytes`. How many sectors it claims does not matter: the chunk
    /// tells its own length.
    pub fn stored(self, bytes: &[u8]) -> Result<Stored<'_>, ChunkProblem> {
        const BESIDE: u8 = 128;
        let outside = || ChunkProblem::Outside { sector: self.sector, sectors: bytes.len().div_ceil(SECTOR) };
        let start = self.sector.checked_mul(SECTOR).filter(|&start| start >= HEAD).ok_or_else(outside)?;
        let rest = bytes.get(start..).ok_or_else(outside)?;
        let (len, rest) = rest.split_first_chunk::<4>().ok_or_else(outside)?;
        let len = u32::from_be_bytes(*len);
        let content = rest.get(..len as usize).and_then(<[u8]>::split_first);
        let (&kind, packed) = content.ok_or(ChunkProblem::Length { len, left: rest.len() })?;
        let packing = Packing::numbered(kind & !BESIDE)?;
        Ok(if kind & BESIDE == 0 { Stored::Here(packing, packed) } else { Stored::Beside(packing) })
    }
}
