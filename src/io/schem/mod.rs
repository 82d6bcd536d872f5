//! Sponge schematics (.schem), versions 1 to 3: gzipped NBT, one varint of the palette per block.
//!
//! ```text
//! 1, 2  "Schematic": { Palette, BlockData, BlockEntities: [{ Pos, Id, .. }], .. }
//! 3     "": { Schematic: { Blocks: { Palette, Data, BlockEntities: [{ Pos, Id, Data: { .. } }] }, .. } }
//! ```
//!
//! Where the point of copying lies is told in two ways. Version 3 says it in `Offset`. WorldEdit's
//! version 2 puts world coordinates there and says it in `Metadata.WEOffsetX` and so on, which count
//! here wherever they stand. Both are written alike, so that either kind of reader agrees.

mod arrays;
mod biomes;
mod blocks;
mod body;
mod entities;
mod entry;
mod incoming;
mod placed;
mod read;
mod write;

pub(super) use incoming::Incoming;
pub(super) use read::decode;
pub use write::{SchemVersion, encode_schem};

/// Where WorldEdit's version 2 keeps the offset, within `Metadata`.
const WE_OFFSET: [&str; 3] = ["WEOffsetX", "WEOffsetY", "WEOffsetZ"];

/// The tags that some version has, beside its sizes and within `Blocks`. All others are kept as they are.
const KNOWN: [&str; 18] = [
    "Biomes",
    "BiomeData",
    "BiomePalette",
    "BiomePaletteMax",
    "BlockData",
    "BlockEntities",
    "Blocks",
    "DataVersion",
    "Entities",
    "Height",
    "Length",
    "Metadata",
    "Offset",
    "Palette",
    "PaletteMax",
    "TileEntities",
    "Version",
    "Width",
];
const KNOWN_IN_BLOCKS: [&str; 4] = ["BlockEntities", "Data", "Palette", "TileEntities"];
