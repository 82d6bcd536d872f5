use super::metadata::{self, Totals, xyz};
use super::pieces::{self, Piece};
use super::{PENDING, blocks, entities};
use crate::grid::{Dialect, Grid};
use crate::io::entities::Frame;
use crate::io::error::Size;
use crate::io::states::Complete;
use crate::io::{self, Encoded, Lost, WriteError, gzip};
use crate::nbt::{self, Compound, Endian, Tag};
use crate::space::Cell;

/// The versions of the format that are written. They differ only in the game's data, which are left alone.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LitematicVersion {
    /// Of Minecraft 1.18 to 1.20.4. Every later Litematica reads it, too.
    #[default]
    V6,
    /// Since Minecraft 1.20.5. Earlier ones refuse it.
    V7,
}

/// The file of `grid` as a Litematica schematic with the regions of its metadata, or one around everything
/// where they leave blocks out. The same grid always gives the same bytes.
pub fn encode_litematic(grid: &Grid, version: LitematicVersion) -> Result<Encoded, WriteError> {
    if grid.bounds().is_empty() {
        return Err(WriteError::Empty(Size(grid.size())));
    }
    let (pieces, lost_regions) = pieces::of(grid);
    let (regions, totals) = regions(grid, &pieces)?;
    let mut root = metadata::root(grid, version);
    root.insert("Metadata".to_owned(), Tag::Compound(metadata::write(grid, &totals)));
    root.insert("Regions".to_owned(), Tag::Compound(regions));
    let lost = [
        Lost::unnamed_block_entities(grid),
        Lost::unnamed_entities(grid),
        Lost::biomes(grid),
        Lost::own(grid, Some(Dialect::Litematica)),
        lost_regions,
        Lost::variants(grid),
    ];
    let bytes = gzip::pack(|out| nbt::write_to(out, Endian::Big, "", &root, &()))?;
    Ok(Encoded { bytes, lost: lost.into_iter().flatten().collect() })
}

fn regions(grid: &Grid, pieces: &[Piece]) -> Result<(Compound, Totals), WriteError> {
    let complete = Complete::of(grid.palette(), grid.version());
    let entities = entities_by_piece(grid, pieces);
    let mut totals = Totals { regions: pieces.len(), ..Totals::default() };
    let mut regions = Compound::new();
    for (piece, entities) in pieces.iter().zip(entities) {
        let blocks = blocks::encode(&grid.cells().slice(pieces::slice(piece.bounds)), &complete);
        totals.blocks += blocks.count;
        totals.volume += piece.bounds.volume() as usize;
        let mut tags = placed(grid, piece)?;
        tags.insert("BlockStatePalette".to_owned(), blocks.palette);
        tags.insert("BlockStates".to_owned(), blocks.indices);
        tags.insert("Entities".to_owned(), Tag::List(entities));
        regions.insert(piece.name.clone().into_owned(), Tag::Compound(tags));
    }
    let around = pieces.iter().map(|piece| piece.bounds).reduce(|all, next| all.union(&next));
    totals.size = around.map_or(Cell::ZERO, |all| all.size());
    Ok((regions, totals))
}

/// A region without what is in it, but with its block entities, which have their places there.
fn placed(grid: &Grid, piece: &Piece) -> Result<Compound, WriteError> {
    let offset = grid.metadata.offset;
    let corners = [piece.bounds.min, piece.bounds.max].map(|corner| corner.checked_add(offset));
    let [Some(position), Some(_)] = corners else { return Err(WriteError::Offset(offset)) };
    let mut tags = piece.tags.cloned().unwrap_or_default();
    for name in PENDING {
        tags.insert_missing(name, || Tag::List(Vec::new()));
    }
    tags.insert("Position".to_owned(), xyz(position));
    tags.insert("Size".to_owned(), xyz(piece.bounds.size()));
    tags.insert("TileEntities".to_owned(), entities::write_block_entities(grid, piece.bounds));
    Ok(tags)
}

/// Every entity once: with the first piece that it is in, or the first of all.
fn entities_by_piece(grid: &Grid, pieces: &[Piece]) -> Vec<Vec<Tag>> {
    let version = grid.data_version();
    let mut by_piece = vec![Vec::new(); pieces.len()];
    for entity in grid.metadata.named_entities() {
        let home = pieces.iter().position(|piece| piece.bounds.contains(entity.home())).unwrap_or_default();
        let frame = Frame::at(-pieces[home].bounds.min);
        by_piece[home].push(io::entities::write(entity, frame, version));
    }
    by_piece
}
