use crate::grid::{Entity, Grid, is_named};
use crate::io::fields::Fields;
use crate::io::{ReadError, attached};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

/// The entities of a structure, and how many do not say what they are.
pub(super) fn read(root: &Fields) -> Result<(Vec<Entity>, usize), ReadError> {
    let mut entities = Vec::new();
    let mut unnamed = 0;
    for fields in root.list("entities")? {
        let place = fields.get("pos")?;
        let mut data = fields.get::<&Compound>("nbt")?.clone();
        data.remove("Pos");
        if let Some(block) = fields.find("blockPos")? {
            attached::set_block(&mut data, Cell::from_array(block));
        }
        match is_named(&data) {
            true => entities.push(Entity { place, data }),
            false => unnamed += 1,
        }
    }
    Ok((entities, unnamed))
}

pub(super) fn write(grid: &Grid) -> Tag {
    let entries = grid.metadata.entities.iter().map(|Entity { place, data }| {
        let block = attached::block(data, Cell::ZERO, *place);
        Tag::Compound(Compound::from([
            ("pos".to_owned(), Tag::List(place.map(Tag::Double).to_vec())),
            ("blockPos".to_owned(), Tag::List(block.to_array().map(Tag::Int).to_vec())),
            ("nbt".to_owned(), Tag::Compound(data.clone())),
        ]))
    });
    Tag::List(entries.collect())
}
