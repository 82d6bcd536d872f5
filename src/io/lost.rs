use crate::grid::{Dialect, Grid, is_named};
use crate::nbt::Name;
use crate::space::Cell;
use std::collections::BTreeSet;
use std::fmt;
use std::mem::discriminant;

/// What of a grid has no place in a format.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Lost {
    BlockEntities(usize),
    /// Clients crash on them.
    UnnamedBlockEntities(usize),
    Entities(usize),
    /// No format says what they are.
    UnnamedEntities(usize),
    Biomes,
    Offset(Cell),
    /// The names of the tags.
    Metadata(Vec<String>),
    /// Tags that only the format knows which the grid came in, by name.
    Own(Vec<String>),
    /// Their blocks are kept, as one whole.
    Regions {
        count: usize,
        /// The names of the tags that they have.
        tags: Vec<String>,
    },
    Variants(usize),
    /// Cells that were to be left alone and become air.
    LeftAlone(usize),
    /// Blocks below -64 or above 319.
    OutsideHeights,
    /// All that is not colour.
    States,
    /// Colours that a palette has no room for.
    Colors {
        found: usize,
        kept: usize,
    },
}

/// A format picks from these what it cannot hold.
impl Lost {
    pub(super) fn block_entities(grid: &Grid) -> Option<Lost> {
        some(grid.block_entities.len(), Lost::BlockEntities)
    }

    pub(super) fn unnamed_block_entities(grid: &Grid) -> Option<Lost> {
        let unnamed = grid.block_entities.values().filter(|data| !is_named(data));
        some(unnamed.count(), Lost::UnnamedBlockEntities)
    }

    pub(super) fn entities(grid: &Grid) -> Option<Lost> {
        some(grid.metadata.entities.len(), Lost::Entities)
    }

    pub(super) fn unnamed_entities(grid: &Grid) -> Option<Lost> {
        let unnamed = grid.metadata.entities.iter().filter(|entity| !is_named(&entity.data));
        some(unnamed.count(), Lost::UnnamedEntities)
    }

    pub(super) fn biomes(grid: &Grid) -> Option<Lost> {
        grid.metadata.biomes.as_ref().map(|_| Lost::Biomes)
    }

    pub(super) fn offset(grid: &Grid) -> Option<Lost> {
        let offset = grid.metadata.offset;
        (offset != Cell::ZERO).then_some(Lost::Offset(offset))
    }

    pub(super) fn metadata(grid: &Grid) -> Option<Lost> {
        let names: Vec<String> = grid.metadata.tags.keys().map(String::from).collect();
        (!names.is_empty()).then_some(Lost::Metadata(names))
    }

    /// As [`Lost::metadata`], where the format has a place for the tags `kept`.
    pub(super) fn metadata_but(grid: &Grid, kept: &[&str]) -> Option<Lost> {
        let names = grid.metadata.tags.keys().filter(|name| !kept.contains(&name.as_str()));
        let names: Vec<String> = names.map(String::from).collect();
        (!names.is_empty()).then_some(Lost::Metadata(names))
    }

    /// The tags of other dialects than the one that is written.
    pub(super) fn own(grid: &Grid, written: Option<Dialect>) -> Option<Lost> {
        let own = grid.metadata.own.as_ref().filter(|own| Some(own.dialect) != written)?;
        let names: Vec<String> = own.tags.keys().map(String::from).collect();
        (!names.is_empty()).then_some(Lost::Own(names))
    }

    /// A single region without tags is lost by its name only, which is no loss to tell of.
    pub(super) fn regions(grid: &Grid) -> Option<Lost> {
        let regions = &grid.metadata.regions;
        let is_told = regions.len() > 1 || regions.iter().any(|region| !region.tags.is_empty());
        is_told.then(|| Lost::all_regions(grid))
    }

    pub(super) fn all_regions(grid: &Grid) -> Lost {
        let regions = &grid.metadata.regions;
        let tags: BTreeSet<&Name> = regions.iter().flat_map(|region| region.tags.keys()).collect();
        Lost::Regions { count: regions.len(), tags: tags.into_iter().map(String::from).collect() }
    }

    pub(super) fn variants(grid: &Grid) -> Option<Lost> {
        some(grid.variants.len(), Lost::Variants)
    }

    /// What the pieces of one build have lost together.
    pub fn of_pieces(pieces: impl IntoIterator<Item = Lost>) -> Vec<Lost> {
        let mut all: Vec<Lost> = Vec::new();
        for lost in pieces {
            match all.iter_mut().find(|known| discriminant(*known) == discriminant(&lost)) {
                Some(known) => known.add(lost),
                None => all.push(lost),
            }
        }
        all
    }

    /// Adds a loss of the same kind. What is not counted is lost once.
    fn add(&mut self, other: Lost) {
        match (self, other) {
            (Lost::BlockEntities(count), Lost::BlockEntities(more))
            | (Lost::UnnamedBlockEntities(count), Lost::UnnamedBlockEntities(more))
            | (Lost::Entities(count), Lost::Entities(more))
            | (Lost::LeftAlone(count), Lost::LeftAlone(more)) => *count += more,
            _ => {}
        }
    }
}

fn some(count: usize, lost: impl Fn(usize) -> Lost) -> Option<Lost> {
    (count > 0).then(|| lost(count))
}

impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Lost::BlockEntities(count) => write!(f, "{}", counted(*count, "block entity", "block entities")),
            Lost::UnnamedBlockEntities(count) => {
                write!(f, "{} without an `id`", counted(*count, "block entity", "block entities"))
            }
            Lost::Entities(count) => write!(f, "{}", counted(*count, "entity", "entities")),
            Lost::UnnamedEntities(count) => {
                write!(f, "{} without an `id`", counted(*count, "entity", "entities"))
            }
            Lost::Biomes => write!(f, "biomes"),
            Lost::Offset(Cell { x, y, z }) => write!(f, "the offset ({x}, {y}, {z})"),
            Lost::Metadata(names) => write!(f, "metadata ({})", listed(names)),
            Lost::Own(names) => write!(f, "tags of its former format ({})", listed(names)),
            Lost::Regions { count, tags } => {
                write!(f, "the bounds of {}", counted(*count, "region", "regions"))?;
                if tags.is_empty() { Ok(()) } else { write!(f, " with tags ({})", listed(tags)) }
            }
            Lost::LeftAlone(count) => {
                write!(f, "{} to be left alone, now air", counted(*count, "cell", "cells"))
            }
            Lost::OutsideHeights => {
                write!(f, "blocks below -64 or above 319, where only worlds of unusual height have a place")
            }
            Lost::States => write!(f, "the names, properties and shapes of blocks: voxels have colours only"),
            Lost::Colors { found, kept } => {
                write!(
                    f,
                    "{} colours of {found}, joined with the nearest of the {kept} most used",
                    found - kept
                )
            }
            Lost::Variants(count) => write!(f, "{}", counted(*count, "further variant", "further variants")),
        }
    }
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn listed(names: &[String]) -> String {
    const SHOWN: usize = 6;
    let more = if names.len() > SHOWN { ", ..." } else { "" };
    format!("{}{more}", names[..names.len().min(SHOWN)].join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_pieces_lose_is_told_once() {
        let pieces = [Lost::Biomes, Lost::Entities(1), Lost::Biomes, Lost::Entities(2)];
        assert_eq!(Lost::of_pieces(pieces), [Lost::Biomes, Lost::Entities(3)]);
    }
}
