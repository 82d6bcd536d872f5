//! Blueprints of Structurize (.blueprint), which MineColonies builds from: gzipped NBT.
//!
//! ```text
//! "": { version: 1, size_x, size_y, size_z, palette: [{ Name, Properties }], blocks: two indices an Int,
//!       tile_entities: [{ x, y, z, id, .. }], entities: [{ Pos, id, .. }], mcversion, name?, architects?,
//!       required_mods, optional_data: { structurize: { primary_offset: { x, y, z } } } }
//! ```

mod placeholder;

use super::entities::{Found, Frame};
use super::error::Size;
use super::fields::Fields;
use super::{Limits, ReadError, Warning, states, volume};
use crate::block::Palette;
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

/// The root tags that the grid holds in its own way.
const KNOWN: [&str; 11] = [
    "version",
    "size_x",
    "size_y",
    "size_z",
    "palette",
    "blocks",
    "tile_entities",
    "entities",
    "mcversion",
    "name",
    "architects",
];

pub(super) fn decode(root: &Compound, limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let root = Fields::new("", root);
    check_version(&root)?;
    let size = volume::size(&root, ["size_x", "size_y", "size_z"])?;
    let Blocks { cells, palette, ground } = Blocks::read(&root, size, limits)?;
    let mut grid = volume::grid(size, cells, palette);
    let outside = block_entities(&root, &mut grid)?;
    grid.metadata = metadata(&root)?;
    let mut found = Found::default();
    found.add_list(&root.list("entities")?, Frame::LOW)?;
    let ground = (ground > 0).then_some(Warning::Ground(ground));
    let warnings = [outside, ground, found.warning()];
    grid.metadata.entities = found.entities;
    Ok((grid, warnings.into_iter().flatten().collect()))
}

fn check_version(root: &Fields) -> Result<(), ReadError> {
    match root.find::<i32>("version")? {
        None | Some(1) => Ok(()),
        Some(found) => Err(ReadError::OnlyVersion { path: root.path("version"), found, known: 1 }),
    }
}

struct Blocks {
    /// In the order y, z, x.
    cells: Vec<u16>,
    palette: Palette,
    /// How many cells ask for ground or a liquid.
    ground: usize,
}

impl Blocks {
    fn read(root: &Fields, size: Cell, limits: &Limits) -> Result<Blocks, ReadError> {
        let pairs = root.get::<&[i32]>("blocks")?;
        let volume = volume::cells(size, root.path("blocks"), pairs.len().saturating_mul(2), limits)?;
        let entries = states::read_palette(&root.path("palette"), root.get("palette")?)?;
        let is_ground: Vec<bool> = entries.iter().map(placeholder::is_ground).collect();
        let mut palette = Palette::default();
        let ids = entries.into_iter().map(|state| palette.intern(&placeholder::understood(state)));
        let ids = ids.collect::<Result<Vec<u16>, _>>().map_err(volume::full("palette"))?;

        let (mut cells, mut ground) = (Vec::with_capacity(volume), 0);
        for index in pairs.iter().flat_map(|pair| halves(*pair)).take(volume) {
            let Some(&id) = ids.get(usize::from(index)) else {
                let (path, cell) = (root.path("blocks"), Size(size).cell(cells.len()));
                return Err(ReadError::NotInPalette { path, cell, index: index.into(), entries: ids.len() });
            };
            cells.push(id);
            ground += usize::from(is_ground[usize::from(index)]);
        }
        Ok(Blocks { cells, palette, ground })
    }
}

/// The high half comes first.
fn halves(pair: i32) -> [u16; 2] {
    let pair = pair.cast_unsigned();
    [(pair >> 16) as u16, pair as u16]
}

fn block_entities(root: &Fields, grid: &mut Grid) -> Result<Option<Warning>, ReadError> {
    let mut outside = 0;
    for fields in root.list("tile_entities")? {
        let place = Cell::new(fields.get("x")?, fields.get("y")?, fields.get("z")?);
        let mut data = fields.tags.clone();
        data.retain(|name, _| !["x", "y", "z"].contains(&name.as_str()));
        match grid.bounds().contains(place) {
            true => drop(grid.block_entities.insert(place.to_array(), data)),
            false => outside += 1,
        }
    }
    Ok((outside > 0).then_some(Warning::BlockEntitiesOutside(outside)))
}

fn metadata(root: &Fields) -> Result<Metadata, ReadError> {
    let mut own = root.tags.clone();
    own.retain(|name, _| !KNOWN.contains(&name.as_str()));
    Ok(Metadata {
        data_version: root.find("mcversion")?,
        offset: offset(root)?,
        tags: tags(root)?,
        own: (!own.is_empty()).then_some(Own { dialect: Dialect::Blueprint, tags: own }),
        ..Metadata::default()
    })
}

/// The anchor, which builders place the blueprint by, is the point of copying.
fn offset(root: &Fields) -> Result<Cell, ReadError> {
    let structurize =
        root.inner("optional_data")?.map(|data| data.inner("structurize")).transpose()?.flatten();
    let anchor = structurize.map(|data| data.inner("primary_offset")).transpose()?.flatten();
    match anchor {
        None => Ok(Cell::ZERO),
        Some(anchor) => {
            let anchor = Cell::new(anchor.get("x")?, anchor.get("y")?, anchor.get("z")?);
            Ok(Cell::ZERO.saturating_sub(anchor))
        }
    }
}

fn tags(root: &Fields) -> Result<Compound, ReadError> {
    let name = root.find::<&str>("name")?.map(str::to_owned);
    let architects = root.find::<&[Tag]>("architects")?.unwrap_or_default();
    let names = architects
        .iter()
        .filter_map(|tag| if let Tag::String(name) = tag { Some(name.as_str()) } else { None });
    let names = names.collect::<Vec<_>>().join(", ");
    let author = (!names.is_empty()).then_some(names);
    let tags = [("Name", name), ("Author", author)];
    Ok(tags.into_iter().filter_map(|(key, value)| Some((key.to_owned(), Tag::String(value?)))).collect())
}
