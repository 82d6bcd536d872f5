use super::{DEFAULT_DATA_VERSION, WE_OFFSET, biomes, blocks, entities};
use crate::grid::{Dialect, Grid};
use crate::io::error::Size;
use crate::io::{Encoded, Lost, WriteError, gzip};
use crate::nbt::{self, Compound, Tag};

/// The versions of the format that are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum SchemVersion {
    /// What every program since Minecraft 1.13 reads.
    #[default]
    V2,
    V3,
}

/// The file of `grid` as a Sponge schematic. The same grid always gives the same bytes.
pub fn encode_schem(grid: &Grid, version: SchemVersion) -> Result<Encoded, WriteError> {
    let extents = extents(grid)?;
    let blocks = blocks::encode(grid);
    let mut body = common(grid, extents);
    body.extend(biomes::write(grid, version).into_iter().map(named));
    body.extend(entities::write_entities(grid, version).map(|tag| named(("Entities", tag))));
    let block_entities = entities::write_block_entities(grid, version);
    let plain = match version {
        SchemVersion::V2 => nbt::write("Schematic", &version_2(grid, body, blocks, block_entities))?,
        SchemVersion::V3 => nbt::write("", &version_3(grid, body, blocks, block_entities))?,
    };
    Ok(Encoded { bytes: gzip::pack(&plain)?, lost: lost(grid, version) })
}

fn lost(grid: &Grid, version: SchemVersion) -> Vec<Lost> {
    let lost = [
        Lost::unnamed_block_entities(grid),
        biomes::lost(grid, version),
        Lost::own(grid, Some(Dialect::Sponge)),
        Lost::regions(grid),
        Lost::variants(grid),
    ];
    lost.into_iter().flatten().collect()
}

/// Width, height and length in the unsigned form of the format.
fn extents(grid: &Grid) -> Result<[i16; 3], WriteError> {
    let size = grid.size();
    let extents = size.to_array().map(|n| u16::try_from(n).ok().filter(|&n| n > 0));
    match extents {
        [Some(width), Some(height), Some(length)] => Ok([width, height, length].map(u16::cast_signed)),
        _ => Err(WriteError::Size(Size(size))),
    }
}

fn common(grid: &Grid, [width, height, length]: [i16; 3]) -> Compound {
    let metadata = &grid.metadata;
    compound([
        ("DataVersion", Tag::Int(metadata.data_version.unwrap_or(DEFAULT_DATA_VERSION))),
        ("Width", Tag::Short(width)),
        ("Height", Tag::Short(height)),
        ("Length", Tag::Short(length)),
        ("Offset", Tag::IntArray(metadata.offset.to_array().to_vec())),
    ])
}

fn version_2(grid: &Grid, mut body: Compound, blocks: blocks::Encoded, block_entities: Tag) -> Compound {
    let mut metadata = grid.metadata.tags.clone();
    let offset = grid.metadata.offset.to_array();
    metadata.extend(WE_OFFSET.into_iter().zip(offset.map(Tag::Int)).map(named));
    body.extend(compound([
        ("Version", Tag::Int(2)),
        ("Metadata", Tag::Compound(metadata)),
        ("PaletteMax", Tag::Int(blocks.palette.len() as i32)),
        ("Palette", Tag::Compound(blocks.palette)),
        ("BlockData", Tag::ByteArray(blocks.data)),
        ("BlockEntities", block_entities),
    ]));
    body
}

fn version_3(grid: &Grid, mut body: Compound, blocks: blocks::Encoded, block_entities: Tag) -> Compound {
    let blocks = compound([
        ("Palette", Tag::Compound(blocks.palette)),
        ("Data", Tag::ByteArray(blocks.data)),
        ("BlockEntities", block_entities),
    ]);
    body.extend(compound([
        ("Version", Tag::Int(3)),
        ("Metadata", Tag::Compound(grid.metadata.tags.clone())),
        ("Blocks", Tag::Compound(blocks)),
    ]));
    compound([("Schematic", Tag::Compound(body))])
}

fn compound<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
    tags.map(named).into()
}

fn named((name, tag): (&str, Tag)) -> (String, Tag) {
    (name.to_owned(), tag)
}
