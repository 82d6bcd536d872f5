use super::arrays::Arrays;
use super::placed::Lists;
use crate::io::Limits;
use crate::nbt::{Compound, Kept, Sink};

/// What is too long in a schematic for a tree of tags, and is taken as its file streams by.
pub struct Incoming {
    pub(super) arrays: Arrays,
    pub(super) block_entities: Lists,
}

impl Incoming {
    /// For a file that unpacks to at most `believed` bytes.
    pub fn new(believed: usize, limits: &Limits) -> Incoming {
        Incoming { arrays: Arrays::new(believed, limits), block_entities: Lists::new() }
    }
}

impl Sink for Incoming {
    fn wants(&mut self, path: &str, len: usize) -> bool {
        self.arrays.wants(path, len)
    }

    fn take(&mut self, bytes: &[u8]) {
        self.arrays.take(bytes);
    }

    fn wants_list(&mut self, path: &str) -> bool {
        self.block_entities.wants_list(path)
    }

    fn entry(&mut self, index: usize, compound: Compound) -> Kept {
        self.block_entities.entry(index, compound)
    }
}
