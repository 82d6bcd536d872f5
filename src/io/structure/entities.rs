use crate::grid::Grid;
use crate::io::ReadError;
use crate::io::entities::{self, Found, Frame};
use crate::io::fields::Fields;
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

pub(super) fn read(root: &Fields) -> Result<Found, ReadError> {
    let mut found = Found::default();
    for fields in root.list("entities")? {
        let place = fields.get("pos")?;
        let mut data = fields.get::<&Compound>("nbt")?.clone();
        // The game writes the block as in the structure beside the data, which keep that in the world.
        let beside = fields.find("blockPos")?.map(Cell::from_array);
        let block = entities::take_block(&mut data).map(|within| beside.unwrap_or(within));
        found.add(entities::with_block(place, block, data));
    }
    Ok(found)
}

pub(super) fn write(grid: &Grid) -> Tag {
    let version = grid.data_version();
    let entries = grid.metadata.named_entities().map(|entity| {
        let data = entities::data(entity, Frame::LOW, version);
        Tag::Compound(Compound::from([
            ("pos".to_owned(), entities::place(entity, Frame::LOW)),
            ("blockPos".to_owned(), Tag::List(entity.home().to_array().map(Tag::Int).to_vec())),
            ("nbt".to_owned(), Tag::Compound(data)),
        ]))
    });
    Tag::List(entries.collect())
}
