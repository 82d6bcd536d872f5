//! Block entities count from the low corner of their region, entities from its `Position`.

use super::XYZ;
use super::region::Part;
use crate::grid::{Grid, is_named};
use crate::io::entities::{Found, Frame};
use crate::io::{ReadError, Warning};
use crate::nbt::Tag;
use crate::space::{Bounds, Cell};

/// Puts the entities and block entities of all regions into `grid`, whose offset is known.
pub(super) fn read(parts: &[Part], grid: &mut Grid) -> Result<Vec<Warning>, ReadError> {
    let mut outside = 0;
    let mut found = Found::default();
    for part in parts {
        outside += read_block_entities(part, grid)?;
        let low = grid.metadata.offset.wrapping_sub(part.position);
        found.add_list(&part.fields.list("Entities")?, Frame::at(low))?;
    }
    let warnings = [(outside > 0).then_some(Warning::BlockEntitiesOutside(outside)), found.warning()];
    grid.metadata.entities = found.entities;
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
