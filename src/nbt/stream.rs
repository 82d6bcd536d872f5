use super::Tag;
use std::io::{self, Write};

/// Takes byte arrays as they are read, so that no tree holds them. An empty one stands in their place.
pub trait Sink {
    /// Whether the array of `len` bytes at `path` (`Schematic.Blocks.Data`) is taken. Neither is to be believed: fewer
    /// bytes may come, and a path may come again, which then counts instead.
    fn wants(&mut self, path: &str, len: usize) -> bool;

    /// The next bytes of the array that was wanted last.
    fn take(&mut self, bytes: &[u8]);
}

/// Leaves everything to the tree.
impl Sink for () {
    fn wants(&mut self, _: &str, _: usize) -> bool {
        false
    }

    fn take(&mut self, _: &[u8]) {}
}

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
