use std::fmt;

/// Why bytes are not an NBT tree, and where.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NbtError {
    /// The byte at which the broken value starts.
    pub offset: usize,
    /// From the broken tag outwards: steps are added as the reader unwinds.
    steps: Vec<Step>,
    pub problem: NbtProblem,
}

#[derive(Clone, PartialEq, Eq, Debug)]
enum Step {
    Name(String),
    Index(usize),
}

#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NbtProblem {
    #[error("{what} takes {needed} bytes, but only {left} are left")]
    CutOff { what: &'static str, needed: u64, left: usize },
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
    Trailing(usize),
}

impl NbtError {
    pub(crate) fn new(offset: usize, problem: NbtProblem) -> NbtError {
        NbtError { offset, steps: Vec::new(), problem }
    }

    pub(super) fn in_tag(mut self, name: &str) -> NbtError {
        self.steps.push(Step::Name(name.to_owned()));
        self
    }

    pub(super) fn in_entry(mut self, index: usize) -> NbtError {
        self.steps.push(Step::Index(index));
        self
    }

    /// The names from the root to the broken tag, as in `Schematic.BlockEntities[3].Pos`.
    pub fn path(&self) -> String {
        let mut path = String::new();
        for step in self.steps.iter().rev() {
            match step {
                Step::Index(index) => path += &format!("[{index}]"),
                Step::Name(name) if path.is_empty() => path += name,
                Step::Name(name) => path += &format!(".{name}"),
            }
        }
        path
    }
}

impl fmt::Display for NbtError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path();
        let place = if path.is_empty() { path } else { format!(", in `{path}`") };
        write!(f, "broken NBT at byte {}{place}: {}", self.offset, self.problem)
    }
}

impl std::error::Error for NbtError {}
