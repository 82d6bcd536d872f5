//! Block entities and entities. In the grid both are as the game keeps them; versions differ in where
//! the data stand, and in what places count from.
//!
//! | | v1, v2 | v3 |
//! |---|---|---|
//! | data | beside `Pos` and `Id` | in `Data` |
//! | place of an entity | in the world, where the low corner is at `Offset` | from the low corner |

use super::SchemVersion;
use super::body::Entry;
use crate::grid::{Entity, Grid, is_named};
use crate::io::{ReadError, Warning};
use crate::nbt::{Compound, Compounds, Part, Tag, View};
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// The game's data by place.
type BlockEntities = BTreeMap<[i32; 3], Compound>;

/// Block entities by place. `corner` is where the file says its low corner is: some tools count places from there.
pub(super) fn block_entities(
    entries: Vec<Entry>,
    bounds: Bounds,
    corner: Cell,
    warnings: &mut Vec<Warning>,
) -> Result<BlockEntities, ReadError> {
    let mut block_entities = BTreeMap::new();
    let mut outside = 0;
    for entry in entries {
        let place = Cell::from_array(entry.fields().get("Pos")?);
        let places = [Some(place), place.checked_sub(corner)];
        match places.into_iter().flatten().find(|&place| bounds.contains(place)) {
            None => outside += 1,
            Some(place) => {
                block_entities.insert(place.to_array(), data(entry)?);
            }
        }
    }
    warnings.extend((outside > 0).then_some(Warning::BlockEntitiesOutside(outside)));
    Ok(block_entities)
}

/// The entities of a schematic. `origin` is where its places count from, seen from its low corner.
pub(super) fn entities(
    entries: Vec<Entry>,
    origin: Cell,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Entity>, ReadError> {
    let mut entities = Vec::new();
    for entry in entries {
        let place = shift(entry.fields().get("Pos")?, -origin.as_dvec3());
        entities.push(Entity { place, data: data(entry)? });
    }
    let found = entities.len();
    entities.retain(|entity| is_named(&entity.data));
    let unnamed = found - entities.len();
    warnings.extend((unnamed > 0).then_some(Warning::EntitiesUnnamed(unnamed)));
    Ok(entities)
}

/// The data in the game's form: with `id`, without a place.
fn data(entry: Entry) -> Result<Compound, ReadError> {
    let id = entry.fields().find::<&str>("Id")?.map(str::to_owned);
    let mut data = entry.data();
    data.extend(id.map(|id| ("id".to_owned(), Tag::String(id))));
    for name in ["Id", "Pos", "ContentVersion"] {
        data.remove(name);
    }
    Ok(data)
}

fn shift(place: [f64; 3], by: glam::DVec3) -> [f64; 3] {
    (glam::DVec3::from_array(place) + by).to_array()
}

/// The `named` block entities of `grid`. Those without an `id` stay away: clients crash on them.
pub(super) fn write_block_entities(grid: &Grid, named: usize, version: SchemVersion) -> Compounds<'_> {
    let entries = grid
        .block_entities
        .iter()
        .filter_map(move |(place, data)| view(Tag::IntArray(place.to_vec()), data, version));
    Compounds { len: named, each: Box::new(entries) }
}

/// The entities of `grid` that have an `id`.
pub(super) fn write_entities(grid: &Grid, version: SchemVersion) -> Compounds<'_> {
    let corner = match version {
        SchemVersion::V2 => grid.metadata.offset,
        SchemVersion::V3 => Cell::ZERO,
    };
    let entities = &grid.metadata.entities;
    let entries = entities.iter().filter_map(move |entity| {
        let place = shift(entity.place, corner.as_dvec3()).map(Tag::Double);
        view(Tag::List(place.to_vec()), &entity.data, version)
    });
    let len = entities.iter().filter(|entity| is_named(&entity.data)).count();
    Compounds { len, each: Box::new(entries) }
}

/// `None` where the data do not say what they are of.
fn view(place: Tag, data: &Compound, version: SchemVersion) -> Option<View<'_>> {
    let mut id = None;
    let mut rest = Vec::with_capacity(data.len() + 1);
    for (name, tag) in data {
        match name.as_str() {
            "id" => id = is_named(data).then_some(tag),
            "Id" | "Pos" => {}
            name => rest.push((name, Part::Tag(tag))),
        }
    }
    let mut entry = match version {
        SchemVersion::V2 => rest,
        SchemVersion::V3 => vec![("Data", Part::Compound(rest))],
    };
    entry.extend([("Id", Part::Tag(id?)), ("Pos", Part::New(place))]);
    Some(entry)
}
