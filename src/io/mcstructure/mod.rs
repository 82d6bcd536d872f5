//! Structures of Bedrock Edition (.mcstructure): plain NBT with the low byte first.
//!
//! ```text
//! "": { format_version: 1, size: [x, y, z], structure_world_origin: [x, y, z],
//!       structure: { block_indices: [[Int; cells], [Int; cells]], entities,
//!                    palette: { default: { block_palette: [{ name, states, version }],
//!                                          block_position_data: { "<cell>": { block_entity_data } } } } } }
//! ```
//!
//! Cells run in the order x, y, z. The second layer holds the water that blocks stand in. Blocks get the names and
//! properties of Java Edition; the file's data version counts otherwise than Java's, so a grid has none.

mod block_entities;
mod blocks;
mod palette;

use super::entities::{self, Found, Frame};
use super::fields::Fields;
use super::{Limits, ReadError, Warning, volume};
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::nbt::{self, Compound, Endian, Tag};
use crate::neighbours;
use crate::space::Cell;

/// The root tags that the grid holds in its own way.
const KNOWN: [&str; 3] = ["format_version", "size", "structure"];

pub(super) fn decode(plain: &[u8], limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let mut rest = plain;
    let (_, root, _) = nbt::read_from(&mut rest, Endian::Little, &limits.nbt(), &mut ())?;
    let root = Fields::new("", &root);
    check_version(&root)?;
    let size = size(&root)?;
    let structure = required(&root, "structure")?;
    let palettes = required(&structure, "palette")?;
    let default = required(&palettes, "default")?;

    let palette = palette::read(&default)?;
    let (cells, mut warnings) = blocks::read(&structure, size, &palette, limits)?;
    let mut grid = volume::grid(size, cells.numbers, cells.palette);
    let block_entities::Found { outside, mut foreign, ticks, unknown } =
        block_entities::read(&default, &mut grid)?;
    neighbours::settle(&mut grid).map_err(volume::full(default.path("block_palette")))?;
    grid.metadata = metadata(&root);
    let found = entities(&root, &structure)?;
    warnings.extend(found.warning());
    grid.metadata.entities = found.entities;
    foreign += grid.metadata.entities.len();
    warnings.extend((outside > 0).then_some(Warning::BlockEntitiesOutside(outside)));
    warnings.extend((foreign > 0).then_some(Warning::BedrockData(foreign)));
    warnings.extend((ticks > 0).then_some(Warning::TicksDropped(ticks)));
    let dropped = unknown_tags(&structure, &palettes, &default).into_iter().chain(unknown).collect();
    warnings.extend(Warning::tags_dropped(&dropped));
    warnings.extend((!rest.is_empty()).then_some(Warning::Trailing(rest.len() as u64)));
    Ok((grid, warnings))
}

/// The tags within the structure that nothing is known of.
fn unknown_tags(structure: &Fields, palettes: &Fields, default: &Fields) -> Vec<String> {
    let known: [(&Fields, &[&str]); 3] = [
        (structure, &["block_indices", "entities", "palette"]),
        (palettes, &["default"]),
        (default, &["block_palette", "block_position_data"]),
    ];
    let unknown = known.iter().flat_map(|(fields, known)| {
        let names = fields.tags.keys().filter(|name| !known.contains(&name.as_str()));
        names.map(|name| fields.path(name))
    });
    unknown.collect()
}

fn check_version(root: &Fields) -> Result<(), ReadError> {
    match root.find::<i32>("format_version")? {
        None | Some(1) => Ok(()),
        Some(found) => Err(ReadError::OnlyVersion { path: root.path("format_version"), found, known: 1 }),
    }
}

/// The compound `name`, which must be there.
fn required<'a>(fields: &Fields<'a>, name: &str) -> Result<Fields<'a>, ReadError> {
    Ok(Fields::new(fields.path(name), fields.get::<&Compound>(name)?))
}

fn size(root: &Fields) -> Result<Cell, ReadError> {
    let size = root.get::<[i32; 3]>("size")?;
    match size.iter().position(|side| !(1..=0xffff).contains(side)) {
        None => Ok(Cell::from_array(size)),
        Some(at) => Err(ReadError::Side { path: format!("{}[{at}]", root.path("size")), found: size[at] }),
    }
}

fn metadata(root: &Fields) -> Metadata {
    let mut own = root.tags.clone();
    own.retain(|name, _| !KNOWN.contains(&name.as_str()));
    let own = (!own.is_empty()).then_some(Own { dialect: Dialect::Bedrock, tags: own });
    Metadata { own, ..Metadata::default() }
}

/// Entities stand where they stood in the world.
fn entities(root: &Fields, structure: &Fields) -> Result<Found, ReadError> {
    let origin = root.find("structure_world_origin")?.map_or(Cell::ZERO, Cell::from_array);
    let mut found = Found::default();
    for fields in structure.list("entities")? {
        let mut data = fields.tags.clone();
        if let Some(Tag::String(id)) = data.remove("identifier") {
            data.insert("id".to_owned(), Tag::String(id));
        }
        found.add(entities::read(fields.get("Pos")?, data, Frame::at(origin)));
    }
    Ok(found)
}
