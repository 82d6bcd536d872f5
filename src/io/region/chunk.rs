//! A chunk: a column of 16 x 16 blocks, whatever version of the game saved it.

use super::section::{self, Section};
use super::{CHUNK, EDGE, REGION};
use crate::block::LEGACY_DATA_VERSION;
use crate::io::ReadError;
use crate::io::fields::Fields;
use crate::io::legacy::Strangers;
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};

/// How blocks are told.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Blocks {
    States,
    /// Before Minecraft 1.13.
    Numbers,
}

/// The data version of the snapshot 17w47a.
const FIRST_WITH_STATES: i32 = 1451;

/// The tags of a chunk.
pub(super) struct Chunk<'a> {
    /// In chunks from the middle of the world, along x and z.
    pub place: [i32; 2],
    pub data_version: Option<i32>,
    /// The compound that holds the blocks.
    body: Fields<'a>,
    /// The one around it, up to 1.17.
    around: Option<Fields<'a>>,
}

impl<'a> Chunk<'a> {
    pub fn of(root: &'a Compound) -> Result<Chunk<'a>, ReadError> {
        let root = Fields::new("", root);
        let data_version = root.find("DataVersion")?;
        let (body, around) = match root.inner("Level")? {
            Some(level) => (level, Some(root)),
            None => (root, None),
        };
        let place = match body.find::<&[i32]>("Position")? {
            Some(&[x, z]) => [x, z],
            _ => [body.get("xPos")?, body.get("zPos")?],
        };
        Ok(Chunk { place, data_version, body, around })
    }

    /// All that tags of the chunk stand in, its lists aside.
    pub fn compounds(&self) -> impl Iterator<Item = &Fields<'a>> {
        std::iter::once(&self.body).chain(&self.around)
    }

    /// The place of the chunk within its region.
    pub fn slot(&self) -> [i32; 2] {
        self.place.map(|n| n.rem_euclid(REGION))
    }

    /// `None` where the game has not made any blocks yet, or so far away that no world reaches there.
    pub fn column(&self) -> Result<Option<Column>, ReadError> {
        const EMPTY: [&str; 4] = ["empty", "structure_starts", "structure_references", "biomes"];
        let status = self.body.find::<&str>("Status")?.unwrap_or_default();
        let status = status.strip_prefix("minecraft:").unwrap_or(status);
        Ok(Column::at(self.place).filter(|_| !EMPTY.contains(&status)))
    }

    /// The sections with their heights, in sections from height 0.
    pub fn sections(&self) -> Result<Vec<(i32, Fields<'a>)>, ReadError> {
        let name = if self.body.tags.contains_key("sections") { "sections" } else { "Sections" };
        let sections = self.body.list(name)?.into_iter();
        sections.map(|fields| Ok((fields.get::<SectionHeight>("Y")?.0, fields))).collect()
    }

    /// How the game that saved the chunk tells its blocks.
    pub fn told_by(&self, sections: &[(i32, Fields)]) -> Blocks {
        let is_old = self.data_version.is_some_and(|version| version < FIRST_WITH_STATES);
        match is_old || sections.iter().any(|(_, fields)| section::is_numbered(fields)) {
            true => Blocks::Numbers,
            false => Blocks::States,
        }
    }

    /// The version of the states that the chunk's blocks are read as.
    pub fn states_version(&self, told_by: Blocks) -> Option<i32> {
        match told_by {
            Blocks::Numbers => Some(LEGACY_DATA_VERSION),
            Blocks::States => self.data_version,
        }
    }

    /// Up to 1.17 a chunk holds the numbers of its biomes.
    pub fn has_numbered_biomes(&self) -> bool {
        self.body.tags.contains_key("Biomes")
    }

    pub fn block_entities(&self) -> Result<Vec<Fields<'a>>, ReadError> {
        let mut list = self.body.list("block_entities")?;
        list.extend(self.body.list("TileEntities")?);
        Ok(list)
    }

    pub fn entities(&self) -> Result<Vec<Fields<'a>>, ReadError> {
        let mut list = self.body.list("entities")?;
        list.extend(self.body.list("Entities")?);
        Ok(list)
    }
}

/// Where a chunk stands in the world, along x and z.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Column {
    pub x: i32,
    pub z: i32,
}

impl Column {
    /// The column of a chunk; `None` beyond the edge of the world.
    pub fn at(chunk: [i32; 2]) -> Option<Column> {
        let [x, z] = chunk;
        let inside = |n: &i32| (-EDGE / CHUNK..EDGE / CHUNK).contains(n);
        chunk.iter().all(inside).then(|| Column { x: x * CHUNK, z: z * CHUNK })
    }

    pub fn chunk(self) -> [i32; 2] {
        [self.x, self.z].map(|n| n.div_euclid(CHUNK))
    }

    /// The column through all heights of `part`.
    pub fn within(self, part: Bounds) -> Bounds {
        let low = Cell::new(self.x, part.min.y, self.z);
        let high = Cell::new(self.x + CHUNK, part.max.y, self.z + CHUNK);
        Bounds::new(low, high).intersect(&part)
    }

    pub fn section(self, height: i32) -> Bounds {
        let low = Cell::new(self.x, height * CHUNK, self.z);
        Bounds::new(low, low + CHUNK)
    }
}

/// In a Byte, as worlds are at most 4,096 blocks high.
struct SectionHeight(i32);

impl crate::io::fields::FromTag<'_> for SectionHeight {
    const EXPECTED: &'static str = "a Byte";

    fn from_tag(tag: &Tag) -> Option<SectionHeight> {
        i32::from_tag(tag).filter(|&n| i8::try_from(n).is_ok()).map(SectionHeight)
    }
}

/// The blocks of a section and the part of the world that they fill. One section at a time: unpacked they take eight
/// times the memory.
pub(super) fn blocks(
    column: Column,
    (height, fields): &(i32, Fields),
    strangers: &mut Strangers,
) -> Result<Option<(Bounds, Section)>, ReadError> {
    let section = section::read(fields, strangers)?;
    Ok(section.map(|section| (column.section(*height), section)))
}
