//! Named binary tags: the tree of values that the game's files are made of.

mod endian;
mod error;
mod limits;
mod read;
mod tag;
mod write;

pub use endian::Endian;
pub use error::{NbtError, NbtProblem};
pub use limits::Limits;
pub use read::{read, read_as, read_first};
pub use tag::{Compound, Tag};
pub use write::{WriteError, write};
