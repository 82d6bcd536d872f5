//! Block entities count from the low corner of their region, entities from its `Position`.

use super::XYZ;
use super::region::Part;
use crate::grid::{Entity, Grid, is_named};
use crate::io::{ReadError, Warning, attached};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};

/// Puts the entities and block entities of all regions into `grid`, whose offset is known.
pub(super) fn read(parts: &[Part], grid: &mut Grid) -> Result<Vec<Warning>, ReadError> {
    let mut outside = 0;
    let mut unnamed = 0;
    for part in parts {
        outside += read_block_entities(part, grid)?;
        unnamed += read_entities(part, grid)?;
    }
    let warnings = [
        (outside > 0).then_some(Warning::BlockEntitiesOutside(outside)),
        (unnamed > 0).then_some(Warning::EntitiesUnnamed(unnamed)),
    ];
    Ok(warnings.into_iter().flatten().collect())
}

/// The number of those that lie outside of their region. Those of blocks that another region has replaced go
/// with them.
fn read_block_entities(part: &Part, grid: &mut Grid) -> Result<usize, ReadError> {
    let low = part.bounds.min - grid.metadata.offset;
    let mut outside = 0;
    for fields in part.fields.list("TileEntities")? {
        let [x, y, z] = XYZ.map(|axis| fields.get::<i32>(axis));
        let place = Cell::new(x?, y?, z?);
        if !Bounds::of_size(part.bounds.size()).contains(place) {
            outside += 1;
        } else if part.state(place) == Some(grid.get(low + place)) {
            let mut data = fields.tags.clone();
            data.retain(|name, _| !XYZ.contains(&name.as_str()));
            grid.block_entities.insert((low + place).to_array(), data);
        }
    }
    Ok(outside)
}

/// The number of those that do not say what they are.
fn read_entities(part: &Part, grid: &mut Grid) -> Result<usize, ReadError> {
    let by = part.position - grid.metadata.offset;
    let mut unnamed = 0;
    for fields in part.fields.list("Entities")? {
        let place = moved(fields.get("Pos")?, by);
        let mut data = fields.tags.clone();
        data.remove("Pos");
        attached::shift(&mut data, by, place);
        match is_named(&data) {
            true => grid.metadata.entities.push(Entity { place, data }),
            false => unnamed += 1,
        }
    }
    Ok(unnamed)
}

/// The block entities within `bounds`. Those without an `id` stay away: clients crash on them.
pub(super) fn write_block_entities(grid: &Grid, bounds: Bounds) -> Tag {
    let entries = grid.block_entities.iter().filter_map(|(&place, data)| {
        let is_written = bounds.contains(Cell::from_array(place)) && is_named(data);
        is_written.then(|| {
            let mut data = data.clone();
            let place = (Cell::from_array(place) - bounds.min).to_array();
            data.extend(XYZ.into_iter().zip(place).map(|(axis, n)| (axis.to_owned(), Tag::Int(n))));
            Tag::Compound(data)
        })
    });
    Tag::List(entries.collect())
}

/// The entity as a region has it whose `Position` is its low corner, `low`.
pub(super) fn write_entity(entity: &Entity, low: Cell) -> Tag {
    let mut data: Compound = entity.data.clone();
    let place = moved(entity.place, -low);
    attached::shift(&mut data, -low, place);
    data.insert("Pos".to_owned(), Tag::List(place.map(Tag::Double).to_vec()));
    Tag::Compound(data)
}

fn moved(place: [f64; 3], by: Cell) -> [f64; 3] {
    (glam::DVec3::from_array(place) + by.as_dvec3()).to_array()
}
