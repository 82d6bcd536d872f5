//! MCEdit schematics (.schematic), the format of the time before Minecraft 1.13: gzipped NBT, one byte for the
//! numeric id of each block and one for its data.
//!
//! ```text
//! "Schematic": { Width, Height, Length, Materials: "Alpha", Blocks, Data, AddBlocks?, Add?, SchematicaMapping?,
//!                TileEntities: [{ x, y, z, id, .. }], Entities: [{ Pos, id, .. }], WEOffsetX.. }
//! ```
//!
//! Blocks become states of today, and block entities take the form that they have beside those. What a state depends
//! on but its number does not say comes from the block entity (colours, skulls, pots, notes) or from the neighbours.

mod block_entities;
mod blocks;
mod entities;

use super::fields::Fields;
use super::{Limits, ReadError, Warning, legacy, volume};
use crate::block::LEGACY_DATA_VERSION;
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::nbt::Compound;
use crate::neighbours;
use crate::space::Cell;

/// The root tags that the grid holds in its own way.
const KNOWN: [&str; 14] = [
    "Width",
    "Height",
    "Length",
    "Materials",
    "Blocks",
    "Data",
    "AddBlocks",
    "Add",
    "SchematicaMapping",
    "TileEntities",
    "Entities",
    "WEOffsetX",
    "WEOffsetY",
    "WEOffsetZ",
];

pub(super) fn decode(root: &Compound, limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let root = Fields::new("", root);
    check_materials(&root)?;
    let size = volume::size(&root, ["Width", "Height", "Length"])?;
    let (cells, palette, mut warnings) = blocks::read(&root, size, limits)?;
    let mut grid = volume::grid(size, cells, palette);
    warnings.extend(block_entities::read(&root, &mut grid)?);
    legacy::name_upper_halves(&mut grid).map_err(volume::full("Blocks"))?;
    grid.metadata = metadata(&root)?;
    neighbours::settle(&mut grid).map_err(volume::full("Blocks"))?;
    let found = entities::read(&root, size)?;
    warnings.extend(found.warning());
    let old = found.entities.len();
    warnings.extend((old > 0).then_some(Warning::OldEntities(old)));
    grid.metadata.entities = found.entities;
    Ok((grid, warnings))
}

/// Other editions number their blocks otherwise.
fn check_materials(root: &Fields) -> Result<(), ReadError> {
    match root.find::<&str>("Materials")? {
        None | Some("Alpha") => Ok(()),
        Some(other) => Err(ReadError::Materials(other.to_owned())),
    }
}

fn metadata(root: &Fields) -> Result<Metadata, ReadError> {
    let [x, y, z] = ["WEOffsetX", "WEOffsetY", "WEOffsetZ"].map(|name| root.find::<i32>(name));
    let mut own = root.tags.clone();
    own.retain(|name, _| !KNOWN.contains(&name.as_str()));
    Ok(Metadata {
        data_version: Some(LEGACY_DATA_VERSION),
        offset: Cell::new(x?.unwrap_or(0), y?.unwrap_or(0), z?.unwrap_or(0)),
        own: (!own.is_empty()).then_some(Own { dialect: Dialect::Mcedit, tags: own }),
        ..Metadata::default()
    })
}
