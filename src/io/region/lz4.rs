//! The blocks that Java's LZ4 streams are made of, as the game packs chunks since 1.20.5:
//!
//! ```text
//! "LZ4Block", method and level: u8, packed: u32, plain: u32, checksum: u32, then the packed bytes
//! ```
//!
//! Numbers have their low byte first. A block without bytes ends the stream.

use super::ChunkProblem;
use twox_hash::XxHash32;

const MAGIC: &[u8] = b"LZ4Block";
const HEADER: usize = MAGIC.len() + 1 + 3 * 4;
const SEED: u32 = 0x9747_b28c;

/// The upper half of the byte behind the magic.
mod method {
    pub const RAW: u8 = 1;
    pub const LZ4: u8 = 2;
}

pub(super) fn unpack(mut bytes: &[u8], most: u64) -> Result<Vec<u8>, ChunkProblem> {
    let mut plain = Vec::new();
    while let Some((header, rest)) = bytes.split_first_chunk::<HEADER>() {
        let header = Header::of(header)?;
        if header.plain == 0 {
            break;
        }
        let (packed, rest) = rest.split_at_checked(header.packed).ok_or_else(|| damaged("breaks off"))?;
        if plain.len() as u64 + header.plain as u64 > most {
            return Err(ChunkProblem::TooLarge(most));
        }
        plain.extend(header.unpack(packed)?);
        bytes = rest;
    }
    Ok(plain)
}

struct Header {
    method: u8,
    packed: usize,
    plain: usize,
    checksum: u32,
}

impl Header {
    fn of(bytes: &[u8; HEADER]) -> Result<Header, ChunkProblem> {
        let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| damaged("does not begin with `LZ4Block`"))?;
        let (numbers, _) = rest[1..].as_chunks::<4>();
        let [packed, plain, checksum] = [0, 1, 2].map(|at| u32::from_le_bytes(numbers[at]));
        Ok(Header { method: rest[0] >> 4, packed: packed as usize, plain: plain as usize, checksum })
    }

    fn unpack(&self, packed: &[u8]) -> Result<Vec<u8>, ChunkProblem> {
        let plain = match self.method {
            method::RAW if self.packed == self.plain => packed.to_vec(),
            method::LZ4 if self.is_possible() => lz4_flex::block::decompress(packed, self.plain)
                .map_err(|error| ChunkProblem::Damaged(error.to_string()))?,
            _ => return Err(damaged("has a header that cannot be")),
        };
        // Java leaves the upper four bits of the checksum out.
        let checksum = XxHash32::oneshot(SEED, &plain) & 0x0fff_ffff;
        match plain.len() == self.plain && checksum == self.checksum {
            true => Ok(plain),
            false => Err(damaged("does not fit its checksum")),
        }
    }

    /// A byte unfolds to 255 at most, so nothing is allocated for bytes that are not there.
    fn is_possible(&self) -> bool {
        self.plain / 255 <= self.packed
    }
}

fn damaged(what: &str) -> ChunkProblem {
    ChunkProblem::Damaged(format!("a block of LZ4 {what}"))
}
