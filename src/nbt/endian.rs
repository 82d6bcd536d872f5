/// Which byte of a number comes first. Texts follow suit: big-endian files are Java's and write its modified form of
/// UTF-8, little-endian ones are Bedrock's and write plain UTF-8. Either form is read in both.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Endian {
    #[default]
    Big,
    Little,
}

impl Endian {
    /// The bytes of a number in this order, given (or made) high byte first.
    pub(super) fn arrange<const N: usize>(self, mut bytes: [u8; N]) -> [u8; N] {
        if self == Endian::Little {
            bytes.reverse();
        }
        bytes
    }
}
