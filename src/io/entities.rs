//! Entities as files have them. Paintings, item frames and leash knots say there a second time where they are: by the
//! block they hang in. The game goes by that block, and hangs them elsewhere where it is not the right one. Files
//! count it from the low corner of a region, from the middle of the world or from where the build was once saved.

use super::fields::Fields;
use super::{ReadError, Warning};
use crate::grid::{Entity, is_named};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;
use glam::DVec3;

const TILE: [&str; 3] = ["TileX", "TileY", "TileZ"];

/// In place of the three since Minecraft 1.21.5.
const BLOCK_POS: &str = "block_pos";
const BLOCK_POS_SINCE: i32 = 4325;

/// Where the low corner of the grid is in the numbers of a file.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    /// As places of entities count.
    pub places: Cell,
    /// As the blocks count that entities hang in.
    pub blocks: Cell,
}

impl Frame {
    /// Of a file that counts both from the low corner.
    pub const LOW: Frame = Frame::at(Cell::ZERO);

    pub const fn at(low: Cell) -> Frame {
        Frame { places: low, blocks: low }
    }
}

/// The entities of a list, and how many there were beside that do not say what they are.
#[derive(Default)]
pub(super) struct Found {
    pub entities: Vec<Entity>,
    pub unnamed: usize,
}

impl Found {
    /// Adds those of a list that has `Pos` beside the data.
    pub fn add_list(&mut self, list: &[Fields], frame: Frame) -> Result<(), ReadError> {
        for fields in list {
            self.add(read(fields.get("Pos")?, fields.tags.clone(), frame));
        }
        Ok(())
    }

    pub fn add(&mut self, entity: Entity) {
        match is_named(&entity.data) {
            true => self.entities.push(entity),
            false => self.unnamed += 1,
        }
    }

    pub fn warning(&self) -> Option<Warning> {
        (self.unnamed > 0).then_some(Warning::EntitiesUnnamed(self.unnamed))
    }
}

/// The entity that a file has at `place`.
pub(super) fn read(place: [f64; 3], mut data: Compound, frame: Frame) -> Entity {
    let block = take_block(&mut data).map(|block| block.wrapping_sub(frame.blocks));
    let place = DVec3::from_array(place) - frame.places.as_dvec3();
    with_block(place.to_array(), block, data)
}

/// The entity at `place`, from the low corner of the grid. The block it is said to hang in is believed where it is near:
/// tools that copy builds leave the numbers as they were where the build stood.
pub(super) fn with_block(place: [f64; 3], block: Option<Cell>, mut data: Compound) -> Entity {
    const NEAR: f64 = 2.0;
    data.remove("Pos");
    let mut entity = Entity { place, block, data };
    let is_near =
        |block: Cell| (block.as_dvec3() + 0.5 - DVec3::from_array(place)).abs().max_element() <= NEAR;
    if block.is_some_and(|block| !is_near(block)) {
        entity.block = Some(entity.seat());
    }
    entity
}

/// Takes the block out of the data that they name.
pub(super) fn take_block(data: &mut Compound) -> Option<Cell> {
    let int = |tag: &Tag| if let Tag::Int(n) = *tag { Some(n) } else { None };
    let block = match (data.get(BLOCK_POS), TILE.map(|name| data.get(name).and_then(int))) {
        (Some(Tag::IntArray(numbers)), _) => Some(Cell::from_array(numbers.as_slice().try_into().ok()?)),
        (_, [Some(x), Some(y), Some(z)]) => Some(Cell::new(x, y, z)),
        _ => None,
    }?;
    TILE.iter().chain([&BLOCK_POS]).for_each(|&name| drop(data.remove(name)));
    Some(block)
}

/// The tags that name the block of an entity, in the form of a version of the game.
pub(super) fn block_tags(entity: &Entity, frame: Frame, data_version: i32) -> Vec<(&'static str, Tag)> {
    let Some(block) = entity.block.map(|block| block.wrapping_add(frame.blocks).to_array()) else {
        return Vec::new();
    };
    match data_version {
        BLOCK_POS_SINCE.. => vec![(BLOCK_POS, Tag::IntArray(block.to_vec()))],
        _ => TILE.into_iter().zip(block.map(Tag::Int)).collect(),
    }
}

/// The place of an entity in a file.
pub(super) fn place(entity: &Entity, frame: Frame) -> Tag {
    let place = DVec3::from_array(entity.place) + frame.places.as_dvec3();
    Tag::List(place.to_array().map(Tag::Double).to_vec())
}

/// The data of an entity in a file, without its place.
pub(super) fn data(entity: &Entity, frame: Frame, data_version: i32) -> Compound {
    let mut data = entity.data.clone();
    data.extend(
        block_tags(entity, frame, data_version).into_iter().map(|(name, tag)| (name.to_owned(), tag)),
    );
    data
}

/// The data of an entity in a file, with its place beside them.
pub(super) fn write(entity: &Entity, frame: Frame, data_version: i32) -> Tag {
    let mut data = data(entity, frame, data_version);
    data.insert("Pos".to_owned(), place(entity, frame));
    Tag::Compound(data)
}
