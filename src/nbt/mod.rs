//! Named binary tags: the tree of values that the game's files are made of.

mod tag;

pub use tag::{Compound, Tag};
