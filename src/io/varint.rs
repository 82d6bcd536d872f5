//! Numbers in base 128, low digits first: the block data of Sponge schematics.

#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum VarintProblem {
    #[error("the varint breaks off at the end of the data")]
    CutOff,
    #[error("the varint does not end within 32 bits")]
    TooLong,
}

pub(super) struct Varints<'a> {
    bytes: &'a [i8],
    at: usize,
}

impl<'a> Varints<'a> {
    pub fn new(bytes: &'a [i8]) -> Varints<'a> {
        Varints { bytes, at: 0 }
    }

    /// The byte at which the next number starts.
    pub fn offset(&self) -> usize {
        self.at
    }

    pub fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn long(&mut self) -> Result<u32, VarintProblem> {
        let mut number = 0u64;
        for digit in 0..5 {
            let byte = self.bytes.get(self.at + digit).ok_or(VarintProblem::CutOff)?.cast_unsigned();
            number |= u64::from(byte & 0x7f) << (7 * digit);
            if byte < 0x80 {
                self.at += digit + 1;
                return u32::try_from(number).map_err(|_| VarintProblem::TooLong);
            }
        }
        Err(VarintProblem::TooLong)
    }
}

/// Stands still at a broken number.
impl Iterator for Varints<'_> {
    type Item = Result<u32, VarintProblem>;

    #[inline]
    fn next(&mut self) -> Option<Result<u32, VarintProblem>> {
        let first = *self.bytes.get(self.at)?;
        if let Ok(number) = u32::try_from(first) {
            self.at += 1;
            return Some(Ok(number));
        }
        Some(self.long())
    }
}

pub(super) fn push(out: &mut Vec<i8>, mut number: u32) {
    while number >= 0x80 {
        out.push((number as u8 | 0x80).cast_signed());
        number >>= 7;
    }
    out.push((number as u8).cast_signed());
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(bytes: &[u8]) -> Option<Result<u32, VarintProblem>> {
        let signed: Vec<i8> = bytes.iter().map(|b| b.cast_signed()).collect();
        Varints::new(&signed).next()
    }

    #[test]
    fn known_numbers() {
        for (bytes, number) in [
            (&[0x00][..], Ok(0)),
            (&[0x7f], Ok(127)),
            (&[0x80, 0x01], Ok(128)),
            (&[0xac, 0x02], Ok(300)),
            (&[0xff, 0xff, 0xff, 0xff, 0x0f], Ok(u32::MAX)),
            (&[0xff, 0xff, 0xff, 0xff, 0x1f], Err(VarintProblem::TooLong)),
            (&[0x80, 0x80, 0x80, 0x80, 0x80, 0x00], Err(VarintProblem::TooLong)),
            (&[0x80], Err(VarintProblem::CutOff)),
        ] {
            assert_eq!(read(bytes), Some(number), "{bytes:x?}");
        }
        assert_eq!(read(&[]), None);
    }

    proptest! {
        #[test]
        fn numbers_come_back(numbers: Vec<u32>) {
            let mut bytes = Vec::new();
            numbers.iter().for_each(|&n| push(&mut bytes, n));
            let back: Result<Vec<u32>, _> = Varints::new(&bytes).collect();
            prop_assert_eq!(back, Ok(numbers));
        }
    }
}
