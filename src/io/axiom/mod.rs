//! Blueprints of Axiom (.bp): a header, a picture and the blocks, each behind its length.
//!
//! ```text
//! 0x0AE5BB36
//! Int, NBT      { Version, Name, Author, Tags, .. }
//! Int, PNG      a picture
//! Int, gzip NBT { DataVersion, BlockRegion: [{ X, Y, Z, BlockStates: { palette, data? } }],
//!                 BlockEntities: [{ x, y, z, id, .. }] }
//! ```
//!
//! Regions are sections of 16 x 16 x 16 blocks, and only those are there that hold something. The grid is the smallest
//! box around what they hold.

mod parts;
mod section;

use super::fields::Fields;
use super::{Limits, ReadError, Warning, volume};
use crate::block::{BlockState, Palette};
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::io::error::Size;
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use parts::Parts;
use section::Section;

pub(super) fn decode(plain: &[u8], limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let parts = Parts::read(plain, limits)?;
    let header = Fields::new("header", &parts.header);
    let blocks = Fields::new("blocks", &parts.blocks);

    let mut palette = Palette::default();
    let nothing = palette.intern(&BlockState::structure_void()).map_err(volume::full("BlockRegion"))?;
    let empty = empty_state(&header)?;
    blocks.get::<&[Tag]>("BlockRegion")?;
    let regions = blocks.list("BlockRegion")?;
    check_count(regions.len(), limits)?;
    let sections = regions.iter().map(|region| Section::read(region, &empty, &mut palette));
    let sections: Vec<Section> = sections.collect::<Result<_, _>>()?;
    let bounds = bounds(&sections, nothing);
    check_size(bounds.size(), limits)?;

    let mut grid = fill(&sections, bounds, palette, nothing);
    let outside = block_entities(&blocks, &mut grid, bounds.min)?;
    grid.metadata = metadata(&header, &blocks, parts.picture, bounds.min)?;
    let trailing = (parts.trailing > 0).then_some(Warning::Trailing(parts.trailing));
    Ok((grid, outside.into_iter().chain(trailing).collect()))
}

/// A section takes few bytes in a file and all its cells in memory.
fn check_count(sections: usize, limits: &Limits) -> Result<(), ReadError> {
    let limit = limits.max_cells / section::CELLS as u64;
    match sections as u64 > limit {
        true => Err(ReadError::TooManySections { sections, limit }),
        false => Ok(()),
    }
}

/// What says "nothing here" in sections: a kind of air since version 2.
fn empty_state(header: &Fields) -> Result<BlockState, ReadError> {
    let name = match header.find::<i32>("Version")? {
        Some(2..) => "void_air",
        _ => "structure_void",
    };
    Ok(BlockState::new(name).expect("a legal name"))
}

/// The smallest box around everything; where there is nothing, that around all sections, or one cell.
fn bounds(sections: &[Section], nothing: u16) -> Bounds {
    let union = |boxes: &mut dyn Iterator<Item = Bounds>| boxes.reduce(|all, next| all.union(&next));
    union(&mut sections.iter().filter_map(|section| section.held(nothing)))
        .or_else(|| union(&mut sections.iter().map(Section::bounds)))
        .unwrap_or(Bounds::of_size(Cell::ONE))
}

fn check_size(size: Cell, limits: &Limits) -> Result<(), ReadError> {
    let cells = Bounds::of_size(size).volume();
    match cells > limits.max_cells {
        true => Err(ReadError::TooManyCells { size: Size(size), cells, limit: limits.max_cells }),
        false => Ok(()),
    }
}

fn fill(sections: &[Section], bounds: Bounds, palette: Palette, nothing: u16) -> Grid {
    let cells = vec![nothing; bounds.volume() as usize];
    let mut grid = volume::grid(bounds.size(), cells, palette);
    for section in sections {
        for (cell, id) in section.cells().filter(|&(_, id)| id != nothing) {
            grid.set(cell - bounds.min, id);
        }
    }
    grid
}

fn block_entities(blocks: &Fields, grid: &mut Grid, min: Cell) -> Result<Option<Warning>, ReadError> {
    let mut outside = 0;
    for fields in blocks.list("BlockEntities")? {
        let place = Cell::new(fields.get("x")?, fields.get("y")?, fields.get("z")?);
        let place = place.checked_sub(min).filter(|&place| grid.bounds().contains(place));
        let mut data = fields.tags.clone();
        data.retain(|name, _| !["x", "y", "z"].contains(&name.as_str()));
        match place {
            Some(place) => drop(grid.block_entities.insert(place.to_array(), data)),
            None => outside += 1,
        }
    }
    Ok((outside > 0).then_some(Warning::BlockEntitiesOutside(outside)))
}

/// The blocks count from the point of copying.
fn metadata(header: &Fields, blocks: &Fields, picture: &[u8], min: Cell) -> Result<Metadata, ReadError> {
    let tags = ["Name", "Author"].map(|name| (name, header.tags.get(name)));
    let tags = tags.into_iter().filter_map(|(name, tag)| Some((name.to_owned(), tag?.clone())));
    Ok(Metadata {
        data_version: blocks.find("DataVersion")?,
        offset: min,
        tags: tags.collect(),
        own: own(header, blocks, picture),
        ..Metadata::default()
    })
}

fn own(header: &Fields, blocks: &Fields, picture: &[u8]) -> Option<Own> {
    const KNOWN: [&str; 6] = ["Version", "Name", "Author", "DataVersion", "BlockRegion", "BlockEntities"];
    let all = header.tags.iter().chain(blocks.tags);
    let unknown = all.filter(|(name, _)| !KNOWN.contains(&name.as_str()));
    let mut tags: Compound = unknown.map(|(name, tag)| (name.clone(), tag.clone())).collect();
    if !picture.is_empty() {
        let bytes = picture.iter().map(|byte| byte.cast_signed()).collect();
        tags.insert("Thumbnail".to_owned(), Tag::ByteArray(bytes));
    }
    (!tags.is_empty()).then_some(Own { dialect: Dialect::Axiom, tags })
}
