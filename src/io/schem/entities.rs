//! Block entities and entities. In the grid both are as the game keeps them; versions differ in where
//! the data stand, and in what places count from.
//!
//! | | v1, v2 | v3 |
//! |---|---|---|
//! | data | beside `Pos` and `Id` | in `Data` |
//! | place of an entity | in the world, where the low corner is at `Offset` | from the low corner |

use super::SchemVersion;
use crate::grid::{Entity, Grid};
use crate::io::fields::Fields;
use crate::io::{ReadError, Warning};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// The game's data by place.
type BlockEntities = BTreeMap<[i32; 3], Compound>;

/// The block entities of `blocks` by place. `corner` is where the file says its low corner is: some
/// tools count places from there.
pub(super) fn read_block_entities(
    blocks: &Fields,
    bounds: Bounds,
    corner: Cell,
) -> Result<(BlockEntities, Option<Warning>), ReadError> {
    let mut block_entities = BTreeMap::new();
    let mut outside = 0;
    for list in ["TileEntities", "BlockEntities"] {
        for fields in blocks.list(list)? {
            let place = Cell::from_array(fields.get("Pos")?);
            let places = [Some(place), place.checked_sub(corner)];
            match places.into_iter().flatten().find(|&place| bounds.contains(place)) {
                None => outside += 1,
                Some(place) => {
                    block_entities.insert(place.to_array(), read_data(&fields)?);
                }
            }
        }
    }
    let warning = (outside > 0).then_some(Warning::BlockEntitiesOutside(outside));
    Ok((block_entities, warning))
}

/// The entities of a schematic. `origin` is where its places count from, seen from its low corner.
pub(super) fn read_entities(
    body: &Fields,
    origin: Cell,
) -> Result<(Vec<Entity>, Option<Warning>), ReadError> {
    let mut entities = Vec::new();
    for fields in body.list("Entities")? {
        let place = shift(fields.get("Pos")?, -origin.as_dvec3());
        entities.push(Entity { place, data: read_data(&fields)? });
    }
    let found = entities.len();
    entities.retain(|entity| entity.data.contains_key("id"));
    let unnamed = found - entities.len();
    Ok((entities, (unnamed > 0).then_some(Warning::EntitiesUnnamed(unnamed))))
}

/// The data in the game's form: with `id`, without a place.
fn read_data(fields: &Fields) -> Result<Compound, ReadError> {
    let mut data = fields.find::<&Compound>("Data")?.unwrap_or(fields.tags).clone();
    if let Some(id) = fields.find::<&str>("Id")? {
        data.insert("id".to_owned(), Tag::String(id.to_owned()));
    }
    for name in ["Id", "Pos", "ContentVersion"] {
        data.remove(name);
    }
    Ok(data)
}

fn shift(place: [f64; 3], by: glam::DVec3) -> [f64; 3] {
    (glam::DVec3::from_array(place) + by).to_array()
}

/// The block entities of `grid`. Those without an `id` stay away: clients crash on them.
pub(super) fn write_block_entities(grid: &Grid, version: SchemVersion) -> Tag {
    let entries = grid
        .block_entities
        .iter()
        .filter_map(|(place, data)| write_data(Tag::IntArray(place.to_vec()), data, version));
    Tag::List(entries.collect())
}

pub(super) fn write_entities(grid: &Grid, version: SchemVersion) -> Option<Tag> {
    let corner = match version {
        SchemVersion::V2 => grid.metadata.offset,
        SchemVersion::V3 => Cell::ZERO,
    };
    let entries = grid.metadata.entities.iter().filter_map(|entity| {
        let place = shift(entity.place, corner.as_dvec3()).map(Tag::Double);
        write_data(Tag::List(place.to_vec()), &entity.data, version)
    });
    let entries: Vec<Tag> = entries.collect();
    (!entries.is_empty()).then_some(Tag::List(entries))
}

/// `None` where the data do not say what they are of.
fn write_data(place: Tag, data: &Compound, version: SchemVersion) -> Option<Tag> {
    let mut data = data.clone();
    let id = data.remove("id")?;
    let mut entry = match version {
        SchemVersion::V2 => data,
        SchemVersion::V3 => Compound::from([("Data".to_owned(), Tag::Compound(data))]),
    };
    entry.insert("Id".to_owned(), id);
    entry.insert("Pos".to_owned(), place);
    Some(Tag::Compound(entry))
}
