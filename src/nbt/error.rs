use super::path::Mark;
use std::{fmt, io};

/// Why bytes are not an NBT tree, and where.
#[derive(Debug)]
pub struct NbtError {
    /// The byte at which the broken value starts.
    pub offset: u64,
    path: String,
    pub problem: NbtProblem,
}

#[derive(Debug, thiserror::Error)]
pub enum NbtProblem {
    #[error("{what} takes {needed} bytes, but only {left} are left")]
    CutOff { what: &'static str, needed: u64, left: u64 },
    #[error("there is no tag type {0}: expected 1 to 12")]
    TagType(u8),
    #[error("expected a compound (tag type 10) at the root, found tag type {0}")]
    Root(u8),
    #[error("{what} has the negative length {len}")]
    NegativeLength { what: &'static str, len: i32 },
    #[error("a list of {0} entries has no entry type")]
    UntypedList(i32),
    #[error("the text is not UTF-8, neither plain nor in the modified form of Java")]
    Text,
    #[error("more than {0} lists and compounds stand in each other")]
    TooDeep(usize),
    #[error("the tags take more than {0} bytes of memory")]
    TooLarge(u64),
    #[error("{0} bytes follow after the end of the root compound")]
    Trailing(u64),
    /// The bytes themselves could not be read.
    #[error("{0}")]
    Input(io::Error),
}

impl NbtError {
    pub(super) fn new(offset: u64, path: &str, problem: NbtProblem) -> NbtError {
        NbtError { offset, path: path.to_owned(), problem }
    }

    /// Tells the number of the entry in the list whose step in the path starts at `mark`.
    pub(super) fn in_entry(mut self, mark: &Mark, index: usize) -> NbtError {
        self.path.insert_str(mark.0 + 1, &index.to_string());
        self
    }

    /// The same of an array of `len` bytes where it is told of the part after the first `before`.
    pub(super) fn in_array(mut self, before: usize, len: usize) -> NbtError {
        if let NbtProblem::CutOff { needed, left, .. } = &mut self.problem {
            (*needed, *left) = (len as u64, *left + before as u64);
            self.offset -= before as u64;
        }
        self
    }

    /// The names from the root to the broken tag, as in `Schematic.BlockEntities[3].Pos`.
    pub fn path(&self) -> &str {
        &self.path
    }
}

impl fmt::Display for NbtError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = if self.path.is_empty() { String::new() } else { format!(", in `{}`", self.path) };
        write!(f, "broken NBT at byte {}{place}: {}", self.offset, self.problem)
    }
}

impl std::error::Error for NbtError {}
