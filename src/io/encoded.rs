use super::Lost;

/// A file, and what of the grid it has no place for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Encoded {
    pub bytes: Vec<u8>,
    pub lost: Vec<Lost>,
}
