//! Block entities and entities. In the grid both are as the game keeps them; versions differ in where
//! the data stand, and in what places count from.
//!
//! | | v1, v2 | v3 |
//! |---|---|---|
//! | data | beside `Pos` and `Id` | in `Data` |
//! | place of an entity | in the world, where the low corner is at `Offset` | from the low corner |
//! | block that it hangs in | as its place | in the world, where the low corner is at `Offset` from `Origin` |

use super::SchemVersion;
use super::body::Body;
use super::entry::Layout;
use super::placed::Placed;
use crate::grid::{Grid, is_named};
use crate::io::entities::{self, Found, Frame};
use crate::io::{ReadError, Warning};
use crate::nbt::{Compound, Compounds, Part, Tag, View};
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// The game's data by place.
type BlockEntities = BTreeMap<[i32; 3], Compound>;

/// Block entities by place. `corner` is where the file says its low corner is: some tools count places from there.
pub(super) fn block_entities(
    placed: impl Iterator<Item = Placed>,
    bounds: Bounds,
    corner: Cell,
    warnings: &mut Vec<Warning>,
) -> Result<BlockEntities, ReadError> {
    let mut block_entities = BTreeMap::new();
    let mut outside = 0;
    for Placed { place, data } in placed {
        let places = [Some(place), place.checked_sub(corner)];
        match places.into_iter().flatten().find(|&place| bounds.contains(place)) {
            None => outside += 1,
            Some(place) => {
                block_entities.insert(place.to_array(), data.map_err(|problem| *problem)?);
            }
        }
    }
    warnings.extend((outside > 0).then_some(Warning::BlockEntitiesOutside(outside)));
    Ok(block_entities)
}

/// Where the low corner is at `corner`, by a layout. `metadata` are those of the file.
pub(super) fn frame(layout: Layout, corner: Cell, metadata: &Compound) -> Frame {
    match layout {
        Layout::Flat => Frame::at(corner),
        Layout::Nested => Frame { places: Cell::ZERO, blocks: corner.wrapping_add(origin(metadata)) },
    }
}

/// Where in its world a build was copied, as WorldEdit says in files of version 3. It moves no entity to its low corner but
/// in place: the blocks that they hang in stay as they were in that world.
fn origin(metadata: &Compound) -> Cell {
    let origin = match metadata.get("WorldEdit") {
        Some(Tag::Compound(worldedit)) => worldedit.get("Origin"),
        _ => None,
    };
    match origin {
        Some(Tag::IntArray(origin)) => origin.as_slice().try_into().map_or(Cell::ZERO, Cell::from_array),
        _ => Cell::ZERO,
    }
}

/// The entities of a schematic.
pub(super) fn entities(body: &mut Body, frame: Frame) -> Result<Found, ReadError> {
    let mut found = Found::default();
    for (place, data) in body.take_entities(|entry| Ok((entry.get("Pos")?, entry.data()?)))? {
        found.add(entities::read(place, data, frame));
    }
    Ok(found)
}

/// The `named` block entities of `grid`. Those without an `id` stay away: clients crash on them.
pub(super) fn write_block_entities(grid: &Grid, named: usize, version: SchemVersion) -> Compounds<'_> {
    let entries = grid
        .block_entities
        .iter()
        .filter_map(move |(place, data)| view(Tag::IntArray(place.to_vec()), data, Vec::new(), version));
    Compounds { len: named, each: Box::new(entries) }
}

/// The entities of `grid` that have an `id`.
pub(super) fn write_entities(grid: &Grid, version: SchemVersion) -> Compounds<'_> {
    let layout = match version {
        SchemVersion::V2 => Layout::Flat,
        SchemVersion::V3 => Layout::Nested,
    };
    let (metadata, data_version) = (&grid.metadata, grid.data_version());
    let frame = frame(layout, metadata.offset, &metadata.tags);
    let entries = metadata.named_entities().filter_map(move |entity| {
        let block = entities::block_tags(entity, frame, data_version);
        view(entities::place(entity, frame), &entity.data, block, version)
    });
    let len = metadata.named_entities().count();
    Compounds { len, each: Box::new(entries) }
}

/// `None` where the data do not say what they are of. `block` are tags beside the data.
fn view<'a>(
    place: Tag,
    data: &'a Compound,
    block: Vec<(&'static str, Tag)>,
    version: SchemVersion,
) -> Option<View<'a>> {
    let mut id = None;
    let mut rest = Vec::with_capacity(data.len() + 1);
    for (name, tag) in data {
        match name.as_str() {
            "id" => id = is_named(data).then_some(tag),
            "Id" | "Pos" => {}
            name => rest.push((name, Part::Tag(tag))),
        }
    }
    rest.extend(block.into_iter().map(|(name, tag)| (name, Part::New(tag))));
    let mut entry = match version {
        SchemVersion::V2 => rest,
        SchemVersion::V3 => vec![("Data", Part::Compound(rest))],
    };
    entry.extend([("Id", Part::Tag(id?)), ("Pos", Part::New(place))]);
    Some(entry)
}
