//! Litematica schematics (.litematic): gzipped NBT of named regions, each with a palette and packed indices.
//!
//! ```text
//! { Version, SubVersion, MinecraftDataVersion, Metadata: { Name, Author, TimeCreated, .. },
//!   Regions: { name: { Position, Size, BlockStatePalette, BlockStates, TileEntities, Entities, .. } } }
//! ```
//!
//! A region reaches from `Position` as far as `Size` says, which may be negative. Blocks and block entities
//! count from its low corner wherever `Position` is, entities from `Position`.

mod bits;
mod blocks;
mod entities;
mod merge;
mod metadata;
mod pieces;
mod read;
mod region;
mod write;

pub(super) use read::decode;
pub use write::{LitematicVersion, encode_litematic};

/// The tags of a region that are no others than of a grid.
const REGION_TAGS: [&str; 6] =
    ["Position", "Size", "BlockStatePalette", "BlockStates", "TileEntities", "Entities"];

/// Lists that every region has. Their places count from its low corner, and empty ones say nothing.
const PENDING: [&str; 2] = ["PendingBlockTicks", "PendingFluidTicks"];

/// Where the numbers of a place stand.
const XYZ: [&str; 3] = ["x", "y", "z"];
