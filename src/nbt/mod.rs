//! Named binary tags: the tree of values that the game's files are made of.
//!
//! Both ways work on streams. Where a file is mostly one long array, a [`Sink`] takes it as it is read and a [`Source`]
//! gives it as it is written, and the tree is small.

mod again;
mod compound;
mod endian;
mod error;
mod input;
mod limits;
mod path;
mod read;
mod seen;
mod stream;
mod tag;
mod write;

pub use compound::{Compound, Iter, Name};
pub use endian::Endian;
pub use error::{NbtError, NbtProblem};
pub use limits::Limits;
pub use read::{read, read_as, read_first, read_from};
pub use seen::Seen;
pub use stream::{Compounds, Kept, Part, Sink, Source, View};
pub use tag::Tag;
pub use write::{WriteError, write, write_as, write_to};
