use super::{Compound, Tag};
use std::io::{self, Write};

/// Takes byte arrays and lists of compounds as they are read, so that no tree holds them. Empty ones stand in their
/// place.
pub trait Sink {
    /// Whether the array of `len` bytes at `path` (`Schematic.Blocks.Data`) is taken. Neither is to be believed: fewer
    /// bytes may come, and a path may come again, which then counts instead.
    fn wants(&mut self, _path: &str, _len: usize) -> bool {
        false
    }

    /// The next bytes of the array that was wanted last.
    fn take(&mut self, _bytes: &[u8]) {}

    /// Whether the list of compounds at `path` is taken. A path may come again, which then counts instead.
    fn wants_list(&mut self, _path: &str) -> bool {
        false
    }

    /// The compound number `index` of the list that was wanted last. What is kept of it counts against the limit.
    fn entry(&mut self, _index: usize, _compound: Compound) -> Kept {
        Kept::Nothing
    }
}

/// How much of a compound is kept.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kept {
    /// No more than a few numbers.
    Nothing,
    All,
}

/// Leaves everything to the tree.
impl Sink for () {}

/// Gives byte arrays and lists of compounds as they are written, so that no tree holds them. Empty ones stand in their
/// place.
pub trait Source {
    /// The length of the array at `path`; `None` for those that the tree holds.
    fn len(&self, path: &str) -> Option<usize>;

    /// Writes the array at `path`: exactly as many bytes as were announced.
    fn write(&self, path: &str, out: &mut dyn Write) -> io::Result<()>;

    /// The entries of the list at `path`; `None` for those that the tree holds.
    fn compounds(&self, _path: &str) -> Option<Compounds<'_>> {
        None
    }
}

/// Compounds that are made one by one.
pub struct Compounds<'a> {
    /// How many there will be.
    pub len: usize,
    pub each: Box<dyn Iterator<Item = View<'a>> + 'a>,
}

/// A compound put together of tags that stand elsewhere. No name comes twice.
pub type View<'a> = Vec<(&'a str, Part<'a>)>;

pub enum Part<'a> {
    Tag(&'a Tag),
    New(Tag),
    Compound(View<'a>),
}

/// The tree holds everything.
impl Source for () {
    fn len(&self, _: &str) -> Option<usize> {
        None
    }

    fn write(&self, _: &str, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}
