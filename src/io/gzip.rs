//! Packing and unpacking as streams, with an eye on small files that unfold to anything.

use flate2::Compression;
use flate2::bufread::MultiGzDecoder;
use flate2::write::GzEncoder;
use std::io::{self, BufRead, BufReader, BufWriter, Cursor, ErrorKind, Read};

#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum GzipError {
    #[error("the gzip data break off: the file is cut short ({unpacked} bytes could be unpacked)")]
    CutOff { unpacked: u64 },
    #[error("the gzip data are damaged: {problem} ({unpacked} bytes could be unpacked)")]
    Damaged { problem: String, unpacked: u64 },
    #[error("the file unpacks to more than {0} bytes, the limit")]
    TooLarge(u64),
}

/// A build of 128 x 18 x 128 blocks and 1,028 states packs in 0.4 ms at level 1, 1.1 ms at 4 and 2.1 ms
/// at 6, to 43, 32 and 30 kB; one of 64 x 96 x 64 and two states in 0.1 ms at each of them.
const LEVEL: Compression = Compression::new(4);

/// Files packed twice by hand exist; more layers are no accident.
const MAX_LAYERS: usize = 2;

/// What is unpacked, or packed, at a time.
pub(super) const CHUNK: usize = 64 << 10;

pub(super) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// The content of `bytes`, which may be plain, unpacked as it is read. Several gzip members one after the other are one
/// content. Errors of the stream hold a [`GzipError`].
pub(super) fn open(bytes: &[u8], max_bytes: u64) -> io::Result<Box<dyn BufRead + '_>> {
    let mut content: Box<dyn BufRead> = Box::new(bytes);
    for _ in 0..MAX_LAYERS {
        let (head, whole) = peek(content, 2)?;
        if !is_gzip(&head) {
            return Ok(whole);
        }
        let layer = Layer { packed: MultiGzDecoder::new(whole), unpacked: 0, max_bytes };
        content = Box::new(BufReader::with_capacity(CHUNK, layer));
    }
    Ok(content)
}

/// What `packed` bytes can unfold to in one layer: no code of theirs is shorter than two bits for 258 bytes.
pub(super) fn most_unpacked(packed: usize) -> usize {
    packed.saturating_mul(1032)
}

/// Up to `most` bytes that `content` starts with, and all of it.
pub(super) fn peek<'a>(
    mut content: Box<dyn BufRead + 'a>,
    most: u64,
) -> io::Result<(Vec<u8>, Box<dyn BufRead + 'a>)> {
    let mut head = Vec::new();
    content.by_ref().take(most).read_to_end(&mut head)?;
    let whole = Cursor::new(head.clone()).chain(content);
    Ok((head, Box::new(whole)))
}

struct Layer<R> {
    packed: MultiGzDecoder<R>,
    unpacked: u64,
    max_bytes: u64,
}

impl<R: BufRead> Read for Layer<R> {
    fn read(&mut self, target: &mut [u8]) -> io::Result<usize> {
        let len = self.packed.read(target).map_err(|error| broken(error, self.unpacked))?;
        self.unpacked += len as u64;
        match self.unpacked > self.max_bytes {
            true => Err(io::Error::other(GzipError::TooLarge(self.max_bytes))),
            false => Ok(len),
        }
    }
}

fn broken(error: io::Error, unpacked: u64) -> io::Error {
    io::Error::other(match error.kind() {
        // The layer below has said what is wrong.
        ErrorKind::Other => return error,
        ErrorKind::UnexpectedEof => GzipError::CutOff { unpacked },
        _ => GzipError::Damaged { problem: error.to_string(), unpacked },
    })
}

pub(super) type Packed = BufWriter<GzEncoder<Vec<u8>>>;

/// What `write` writes, packed, always to the same result: no time and no name go in.
pub(super) fn pack<E: From<io::Error>>(
    write: impl FnOnce(&mut Packed) -> Result<(), E>,
) -> Result<Vec<u8>, E> {
    let mut packed = BufWriter::with_capacity(CHUNK, GzEncoder::new(Vec::new(), LEVEL));
    write(&mut packed)?;
    let encoder = packed.into_inner().map_err(io::IntoInnerError::into_error)?;
    Ok(encoder.finish()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    fn pack(bytes: &[u8]) -> Vec<u8> {
        super::pack(|out| out.write_all(bytes)).unwrap()
    }

    fn unpack(bytes: &[u8], max_bytes: u64) -> Result<Vec<u8>, GzipError> {
        let mut plain = Vec::new();
        let read = open(bytes, max_bytes).and_then(|mut content| content.read_to_end(&mut plain));
        read.map(|_| plain).map_err(|error| error.downcast::<GzipError>().unwrap())
    }

    #[test]
    fn plain_single_double_and_nested() {
        let packed = pack(b"house");
        let two_members = [packed.clone(), packed.clone()].concat();
        let two_layers = pack(&packed);
        for (bytes, content) in [
            (b"".to_vec(), &b""[..]),
            (b"house".to_vec(), b"house"),
            (packed, b"house"),
            (two_members, b"househouse"),
            (two_layers, b"house"),
        ] {
            assert_eq!(unpack(&bytes, 100).unwrap(), content);
        }
    }

    #[test]
    fn layers_start_anywhere() {
        let (head, tail) = (pack(b"house"), pack(b"house"));
        let in_two_members = [pack(&head[..1]), pack(&head[1..]), pack(&tail)].concat();
        assert_eq!(unpack(&in_two_members, 100).unwrap(), b"househouse");
    }

    #[test]
    fn bombs_stop_at_the_limit() {
        let bomb = pack(&vec![0; 1 << 20]);
        assert_eq!(unpack(&bomb, 1000), Err(GzipError::TooLarge(1000)));
        assert_eq!(unpack(&pack(&bomb), 2000), Err(GzipError::TooLarge(2000)));
        assert_eq!(unpack(&bomb, 1 << 20).unwrap().len(), 1 << 20);
    }

    #[test]
    fn every_truncation_is_an_error() {
        for packed in [pack(b"a house is a house"), pack(&pack(b"a house is a house"))] {
            for len in 2..packed.len() {
                let error = unpack(&packed[..len], 1000).unwrap_err();
                assert!(matches!(error, GzipError::CutOff { .. }), "{len}: {error}");
            }
        }
    }

    #[test]
    fn damage_says_how_far_it_got() {
        let mut packed = pack(b"a house is a house");
        let checksum = packed.len() - 8;
        packed[checksum] ^= 1;
        let error = unpack(&packed, 1000).unwrap_err();
        assert!(matches!(error, GzipError::Damaged { unpacked: 18, .. }), "{error}");
        let trailing = [pack(b"house"), b"rubble, not gzip".to_vec()].concat();
        let error = unpack(&trailing, 1000).unwrap_err();
        assert!(matches!(error, GzipError::Damaged { unpacked: 5, .. }), "{error}");
    }
}
