//! Regions (.mca): the worlds of the game, 32 x 32 chunks a file.
//!
//! ```text
//! bytes --table--> packed chunk --unpack--> NBT --chunk--> sections --read--> Grid
//!                                                          section: palette + packed indices
//! ```
//!
//! | since | blocks stand in | indices |
//! |---|---|---|
//! | 1.18 | `sections[].block_states` | whole in their longs |
//! | 1.16 | `Level.Sections[]`: `Palette`, `BlockStates` | whole in their longs |
//! | 1.13 | the same | across longs |
//! | before | `Level.Sections[]`: `Blocks`, `Data`, `Add` | numbers of blocks, see `io/legacy` |
//!
//! Since 1.17 entities stand in region files of their own, in a folder `entities` beside `region`.

mod biomes;
mod chunk;
mod leftovers;
mod lz4;
mod packing;
mod read;
mod section;
mod table;
mod unpack;
mod versions;
mod world;
mod write;

pub(super) use read::decode_region;
pub use read::read_world;
pub use unpack::ChunkProblem;
pub use write::{EncodedRegions, encode_regions};

/// Blocks along a chunk or section.
const CHUNK: i32 = 16;

/// Chunks along a region.
const REGION: i32 = 32;

/// No world goes further than so many blocks from its middle; chunks at the edge stand out a little.
const EDGE: i32 = 30_000_000 + CHUNK;
