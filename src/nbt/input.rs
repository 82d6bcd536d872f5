use std::io::{self, BufRead, ErrorKind};

/// Bytes that come in pieces, and how many have come.
pub(super) struct Input<R> {
    bytes: R,
    pub at: u64,
}

impl<R: BufRead> Input<R> {
    pub fn new(bytes: R) -> Input<R> {
        Input { bytes, at: 0 }
    }

    /// Hands up to `most` bytes on, piece by piece, and says how many there were: fewer at the end only.
    pub fn pass(&mut self, most: usize, mut piece: impl FnMut(&[u8])) -> io::Result<usize> {
        let mut passed = 0;
        while passed < most {
            let buffer = match self.bytes.fill_buf() {
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                other => other?,
            };
            let len = buffer.len().min(most - passed);
            if len == 0 {
                break;
            }
            piece(&buffer[..len]);
            self.bytes.consume(len);
            self.at += len as u64;
            passed += len;
        }
        Ok(passed)
    }

    /// The next bytes that are there already, without the error that may come instead of more.
    #[inline]
    pub fn ahead(&mut self) -> &[u8] {
        self.bytes.fill_buf().unwrap_or_default()
    }

    /// Leaves out `len` bytes of those ahead.
    #[inline]
    pub fn skip(&mut self, len: usize) {
        self.bytes.consume(len);
        self.at += len as u64;
    }

    /// Fills `target` as far as there are bytes, and says how far.
    #[inline]
    pub fn fill(&mut self, target: &mut [u8]) -> io::Result<usize> {
        if let Ok(buffer) = self.bytes.fill_buf()
            && let Some(bytes) = buffer.get(..target.len())
        {
            target.copy_from_slice(bytes);
            self.bytes.consume(target.len());
            self.at += target.len() as u64;
            return Ok(target.len());
        }
        self.fill_from_pieces(target)
    }

    fn fill_from_pieces(&mut self, target: &mut [u8]) -> io::Result<usize> {
        let mut filled = 0;
        self.pass(target.len(), |piece| {
            target[filled..filled + piece.len()].copy_from_slice(piece);
            filled += piece.len();
        })?;
        Ok(filled)
    }
}
