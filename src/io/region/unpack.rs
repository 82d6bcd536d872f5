use super::lz4;
use crate::io::ReadError;
use flate2::bufread::{MultiGzDecoder, ZlibDecoder};
use std::borrow::Cow;
use std::io::Read;

/// Why a chunk of a region cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ChunkProblem {
    #[error("the table says sector {sector}, but the file holds {sectors}")]
    Outside { sector: usize, sectors: usize },
    #[error("its length is {len}, but {left} bytes are left of the file")]
    Length { len: u32, left: usize },
    #[error("its compression is {0}: expected 1 (gzip), 2 (zlib), 3 (none) or 4 (LZ4)")]
    Packing(u8),
    #[error("its packed data are damaged: {0}")]
    Damaged(String),
    #[error("the chunks of the region unpack to more than {0} bytes, the limit")]
    TooLarge(u64),
    #[error("it is kept in a file of its own, `c.<x>.<z>.mcc` beside the region, which cannot be read")]
    Beside,
    #[error(transparent)]
    Content(Box<ReadError>),
}

/// How a chunk is packed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Packing {
    Gzip,
    Zlib,
    None,
    Lz4,
}

impl Packing {
    pub fn numbered(number: u8) -> Result<Packing, ChunkProblem> {
        match number {
            1 => Ok(Packing::Gzip),
            2 => Ok(Packing::Zlib),
            3 => Ok(Packing::None),
            4 => Ok(Packing::Lz4),
            _ => Err(ChunkProblem::Packing(number)),
        }
    }

    /// The content of `bytes`, of which `most` bytes are allowed.
    pub fn unpack(self, bytes: &[u8], most: u64) -> Result<Cow<'_, [u8]>, ChunkProblem> {
        let plain = match self {
            Packing::Gzip => Cow::Owned(inflate(MultiGzDecoder::new(bytes), most)?),
            Packing::Zlib => Cow::Owned(inflate(ZlibDecoder::new(bytes), most)?),
            Packing::None => Cow::Borrowed(bytes),
            Packing::Lz4 => Cow::Owned(lz4::unpack(bytes, most)?),
        };
        match plain.len() as u64 > most {
            true => Err(ChunkProblem::TooLarge(most)),
            false => Ok(plain),
        }
    }
}

fn inflate(decoder: impl Read, most: u64) -> Result<Vec<u8>, ChunkProblem> {
    let mut plain = Vec::new();
    let read = decoder.take(most.saturating_add(1)).read_to_end(&mut plain);
    read.map_err(|error| ChunkProblem::Damaged(error.to_string()))?;
    Ok(plain)
}
