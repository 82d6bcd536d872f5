//! Numbers in base 128, low digits first: the arrays of Sponge schematics.

#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum VarintProblem {
    #[error("the varint breaks off at the end of the data")]
    CutOff,
    #[error("the varint does not end within 32 bits")]
    TooLong,
}

/// Numbers of up to 16 bits, decoded from bytes that come in pieces.
pub(super) struct Decoder {
    numbers: Vec<u16>,
    /// The bytes that were announced, and how many are believed.
    announced: usize,
    believed: usize,
    /// As many numbers as there may be.
    limit: usize,
    /// The bytes that came, and those that whole numbers took.
    came: usize,
    decoded: usize,
    /// A number of which only the first digits came.
    begun: u64,
    digits: u32,
    stop: Option<Stop>,
}

/// Why the bytes from some place on are not decoded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stop {
    Broken(VarintProblem),
    /// A number above 16 bits.
    Large(u32),
    /// There are as many numbers as are wanted.
    Full,
}

/// What came of all bytes.
pub(super) struct Varints {
    pub numbers: Vec<u16>,
    pub bytes: usize,
    /// The bytes that the numbers took.
    pub decoded: usize,
    pub stop: Option<Stop>,
}

impl Decoder {
    /// For at most `limit` numbers in `announced` bytes, which are believed where they are not more than `believed`.
    pub fn new(announced: usize, believed: usize, limit: usize) -> Decoder {
        Decoder {
            numbers: Vec::new(),
            announced,
            believed,
            limit,
            came: 0,
            decoded: 0,
            begun: 0,
            digits: 0,
            stop: None,
        }
    }

    /// Decodes the next bytes, unless an earlier one was the last that could be.
    pub fn push(&mut self, bytes: &[u8]) {
        self.came += bytes.len();
        if self.stop.is_none() {
            self.reserve(bytes.len());
            self.stop = self.decode(bytes).err();
        }
    }

    pub fn finish(self) -> Varints {
        let cut_off = (self.decoded < self.came).then_some(Stop::Broken(VarintProblem::CutOff));
        let Decoder { numbers, came, decoded, stop, .. } = self;
        Varints { numbers, bytes: came, decoded, stop: stop.or(cut_off) }
    }

    /// Makes room for the numbers of `more` bytes. Where the announcement can be true there is room at once for all that
    /// the bytes so far promise, as growing may mean to move; else room grows by an eighth at a time.
    fn reserve(&mut self, more: usize) {
        let (len, room) = (self.numbers.len(), self.numbers.capacity());
        if room - len >= more.min(self.limit - len) {
            return;
        }
        let promised = (len as u64 * 9 * self.announced as u64).div_ceil(8 * self.decoded.max(1) as u64);
        let wanted = match self.announced <= self.believed {
            true => usize::try_from(promised).unwrap_or(usize::MAX),
            false => room + room / 8,
        };
        let most = len + (self.announced.saturating_sub(self.decoded)).max(more);
        self.numbers.reserve_exact(wanted.max(len + more).min(most).min(self.limit) - len);
    }

    fn decode(&mut self, bytes: &[u8]) -> Result<(), Stop> {
        let (steps, rest) = bytes.as_chunks::<32>();
        for step in steps {
            // Few files have more than 128 states, and few places of those have a rare one.
            if step.is_ascii() && self.digits == 0 && self.numbers.len() + step.len() <= self.limit {
                self.numbers.extend(step.iter().map(|&byte| u16::from(byte)));
                self.decoded += step.len();
            } else {
                step.iter().try_for_each(|&byte| self.digit(byte))?;
            }
        }
        rest.iter().try_for_each(|&byte| self.digit(byte))
    }

    #[inline]
    fn digit(&mut self, byte: u8) -> Result<(), Stop> {
        const TOO_LONG: Stop = Stop::Broken(VarintProblem::TooLong);
        self.begun |= u64::from(byte & 0x7f) << (7 * self.digits);
        self.digits += 1;
        if byte >= 0x80 {
            return if self.digits < 5 { Ok(()) } else { Err(TOO_LONG) };
        }
        self.put(u32::try_from(self.begun).map_err(|_| TOO_LONG)?)?;
        self.decoded += self.digits as usize;
        (self.begun, self.digits) = (0, 0);
        Ok(())
    }

    #[inline]
    fn put(&mut self, number: u32) -> Result<(), Stop> {
        if self.numbers.len() == self.limit {
            return Err(Stop::Full);
        }
        self.numbers.push(u16::try_from(number).map_err(|_| Stop::Large(number))?);
        Ok(())
    }
}

/// How many bytes a number takes.
pub(super) fn width(number: u16) -> usize {
    match number {
        0..0x80 => 1,
        0x80..0x4000 => 2,
        0x4000.. => 3,
    }
}

pub(super) fn push(out: &mut Vec<u8>, mut number: u16) {
    while number >= 0x80 {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn decode(pieces: &[&[u8]], limit: usize) -> Varints {
        let mut decoder = Decoder::new(pieces.iter().map(|piece| piece.len()).sum(), 0, limit);
        pieces.iter().for_each(|piece| decoder.push(piece));
        decoder.finish()
    }

    #[test]
    fn known_numbers() {
        let broken = |problem| Some(Stop::Broken(problem));
        for (bytes, numbers, stop) in [
            (&[0x00][..], &[0][..], None),
            (&[0x7f], &[127], None),
            (&[0x80, 0x01], &[128], None),
            (&[0xac, 0x02, 0x01], &[300, 1], None),
            (&[0xff, 0xff, 0x03], &[65_535], None),
            (&[0x05, 0x80, 0x80, 0x04, 0x07], &[5], Some(Stop::Large(65_536))),
            (&[0xff, 0xff, 0xff, 0xff, 0x0f], &[], Some(Stop::Large(u32::MAX))),
            (&[0xff, 0xff, 0xff, 0xff, 0x1f], &[], broken(VarintProblem::TooLong)),
            (&[0x80, 0x80, 0x80, 0x80, 0x80, 0x00], &[], broken(VarintProblem::TooLong)),
            (&[0x01, 0x80], &[1], broken(VarintProblem::CutOff)),
            (&[0x01, 0x02, 0x03], &[1, 2], Some(Stop::Full)),
        ] {
            let limit = if stop == Some(Stop::Full) { 2 } else { 9 };
            let found = decode(&[bytes], limit);
            assert_eq!((&found.numbers[..], found.stop), (numbers, stop), "{bytes:x?}");
            assert_eq!(found.bytes, bytes.len());
        }
    }

    #[test]
    fn long_runs_stop_at_the_limit() {
        let found = decode(&[&[1; 100]], 70);
        assert_eq!((found.numbers.len(), found.decoded, found.stop), (70, 70, Some(Stop::Full)));
        assert!(found.numbers.capacity() <= 70);
    }

    proptest! {
        #[test]
        fn numbers_come_back_whatever_the_pieces(numbers: Vec<u16>, at: prop::sample::Index) {
            let mut bytes = Vec::new();
            numbers.iter().for_each(|&n| push(&mut bytes, n));
            prop_assert_eq!(bytes.len(), numbers.iter().map(|&n| width(n)).sum::<usize>());
            let (head, tail) = bytes.split_at(at.index(bytes.len() + 1));
            let found = decode(&[head, tail], usize::MAX);
            prop_assert_eq!(found.stop, None);
            prop_assert_eq!(found.decoded, bytes.len());
            prop_assert_eq!(found.numbers, numbers);
        }
    }
}
