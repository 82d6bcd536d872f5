use super::arrays::Outgoing;
use super::{KNOWN, WE_OFFSET, biomes, blocks, entities};
use crate::grid::{Dialect, Grid};
use crate::io::error::Size;
use crate::io::{Encoded, Lost, WriteError, gzip};
use crate::nbt::{self, Compound, Compounds, Endian, Name, Source, Tag};
use std::io::{self, Write};

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
    let (palette, blocks) = blocks::encode(grid);
    let mut body = own(grid);
    body.extend(common(grid, extents));
    let (tags, biomes) = biomes::write(grid, version).unzip();
    body.extend(tags.into_iter().flatten().map(named));
    let (name, root) = match version {
        SchemVersion::V2 => ("Schematic", version_2(grid, body, palette)),
        SchemVersion::V3 => ("", version_3(grid, body, palette)),
    };
    let lost = lost(grid, version);
    let unnamed =
        lost.iter().map(|lost| if let Lost::UnnamedBlockEntities(count) = lost { *count } else { 0 });
    let named = grid.block_entities.len() - unnamed.sum::<usize>();
    let long = Long { grid, version, named, blocks, biomes };
    let bytes = gzip::pack(|out| nbt::write_to(out, Endian::Big, name, &root, &long))?;
    Ok(Encoded { bytes, lost })
}

/// What is long in a schematic: it is made as it is written, and empty in the tree.
struct Long<'a> {
    grid: &'a Grid,
    version: SchemVersion,
    /// How many block entities have an `id`.
    named: usize,
    blocks: Outgoing<'a>,
    biomes: Option<Outgoing<'a>>,
}

impl Long<'_> {
    fn array(&self, path: &str) -> Option<&Outgoing<'_>> {
        match (self.version, path) {
            (SchemVersion::V2, "BlockData") | (SchemVersion::V3, "Schematic.Blocks.Data") => {
                Some(&self.blocks)
            }
            (SchemVersion::V2, "BiomeData") | (SchemVersion::V3, "Schematic.Biomes.Data") => {
                self.biomes.as_ref()
            }
            _ => None,
        }
    }
}

impl Source for Long<'_> {
    fn len(&self, path: &str) -> Option<usize> {
        self.array(path).map(Outgoing::len)
    }

    fn write(&self, path: &str, out: &mut dyn Write) -> io::Result<()> {
        self.array(path).map_or(Ok(()), |array| array.write(out))
    }

    fn compounds(&self, path: &str) -> Option<Compounds<'_>> {
        match (self.version, path) {
            (SchemVersion::V2, "BlockEntities") | (SchemVersion::V3, "Schematic.Blocks.BlockEntities") => {
                Some(entities::write_block_entities(self.grid, self.named, self.version))
            }
            (SchemVersion::V2, "Entities") | (SchemVersion::V3, "Schematic.Entities") => {
                Some(entities::write_entities(self.grid, self.version))
            }
            _ => None,
        }
    }
}

fn lost(grid: &Grid, version: SchemVersion) -> Vec<Lost> {
    let lost = [
        Lost::unnamed_block_entities(grid),
        Lost::unnamed_entities(grid),
        biomes::lost(grid, version),
        lost_in_blocks(grid, version),
        Lost::own(grid, Some(Dialect::Sponge)),
        Lost::regions(grid),
        Lost::variants(grid),
    ];
    lost.into_iter().flatten().collect()
}

/// The tags that no version knows.
fn own_tags(grid: &Grid) -> impl Iterator<Item = (&Name, &Tag)> {
    let own = grid.metadata.own.iter().filter(|own| own.dialect == Dialect::Sponge);
    own.flat_map(|own| &own.tags)
}

/// Those beside the sizes.
fn own(grid: &Grid) -> Compound {
    let unknown = own_tags(grid).filter(|(name, _)| !KNOWN.contains(&name.as_str()));
    unknown.map(|(name, tag)| (name.clone(), tag.clone())).collect()
}

/// Those within `Blocks`, which version 2 does not have.
fn own_in_blocks(grid: &Grid) -> Compound {
    match own_tags(grid).find(|(name, _)| *name == "Blocks") {
        Some((_, Tag::Compound(blocks))) => blocks.clone(),
        _ => Compound::new(),
    }
}

fn lost_in_blocks(grid: &Grid, version: SchemVersion) -> Option<Lost> {
    let names: Vec<String> = own_in_blocks(grid).keys().map(String::from).collect();
    (version == SchemVersion::V2 && !names.is_empty()).then_some(Lost::Own(names))
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
        ("DataVersion", Tag::Int(grid.data_version())),
        ("Width", Tag::Short(width)),
        ("Height", Tag::Short(height)),
        ("Length", Tag::Short(length)),
        ("Offset", Tag::IntArray(metadata.offset.to_array().to_vec())),
        // Some readers want the list even where there are none.
        ("Entities", Tag::List(Vec::new())),
    ])
}

fn version_2(grid: &Grid, mut body: Compound, palette: Compound) -> Compound {
    let mut metadata = grid.metadata.tags.clone();
    let offset = grid.metadata.offset.to_array();
    metadata.extend(WE_OFFSET.into_iter().zip(offset.map(Tag::Int)).map(named));
    body.extend(compound([
        ("Version", Tag::Int(2)),
        ("Metadata", Tag::Compound(metadata)),
        ("PaletteMax", Tag::Int(palette.len() as i32)),
        ("Palette", Tag::Compound(palette)),
        ("BlockData", Tag::ByteArray(Vec::new())),
        ("BlockEntities", Tag::List(Vec::new())),
    ]));
    body
}

fn version_3(grid: &Grid, mut body: Compound, palette: Compound) -> Compound {
    let mut blocks = own_in_blocks(grid);
    blocks.extend(compound([
        ("Palette", Tag::Compound(palette)),
        ("Data", Tag::ByteArray(Vec::new())),
        ("BlockEntities", Tag::List(Vec::new())),
    ]));
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
