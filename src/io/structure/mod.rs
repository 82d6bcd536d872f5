//! Structures of the game (.nbt): gzipped NBT, a palette and the list of the blocks that are there.
//!
//! ```text
//! { DataVersion, size: [x, y, z], palette: [{ Name, Properties }], blocks: [{ pos, state, nbt }],
//!   entities: [{ pos, blockPos, nbt }] }
//! ```
//!
//! Where no block is, the world is left alone. Structures with several looks have a list `palettes` instead,
//! of which the game takes one by chance.

mod blocks;
mod entities;
mod jigsaw;
mod joint;
mod read;
mod write;

pub(super) use blocks::Incoming;
pub(super) use read::decode;
pub use write::encode_structure;

/// At the root, beside what only some mod knows.
const ROOT_TAGS: [&str; 7] = ["DataVersion", "size", "palette", "palettes", "blocks", "entities", "author"];
