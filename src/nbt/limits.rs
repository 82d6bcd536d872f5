/// What a tree of tags may cost before reading it is given up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// How many lists and compounds may stand in each other. The game itself stops at 512.
    pub max_depth: usize,
    /// The memory of the tree, in bytes. A list of bytes costs 32 times its length in the file.
    pub max_memory: u64,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { max_depth: 512, max_memory: 1 << 30 }
    }
}
