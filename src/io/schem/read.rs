use super::arrays::Arrays;
use super::blocks::{self, Palettes};
use super::body::Body;
use super::incoming::Incoming;
use super::{WE_OFFSET, biomes, entities};
use crate::grid::{Grid, Metadata};
use crate::io::error::Size;
use crate::io::fields::{Fields, FromTag};
use crate::io::varint::Varints;
use crate::io::{Limits, ReadError, Warning, volume};
use crate::nbt::Compound;
use crate::space::{Bounds, Cell};

/// The grid of a schematic of any version, by where its tags stand: the version it claims is often
/// absent or wrong. `long` has the arrays and block entities that `root` lacks.
pub fn decode(root: Compound, long: Incoming, limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let Incoming { mut arrays, mut block_entities } = long;
    let mut body = Body::of(root)?;
    let mut warnings = Vec::new();
    let mut grid = grid(&body, &mut arrays, limits, &mut warnings)?;
    let fields = body.fields();
    let corner = corner(&fields)?;
    grid.metadata = metadata(&fields, corner)?;
    grid.metadata.biomes = biomes::read(&fields, &mut arrays, grid.size(), &mut warnings)?;

    let frame = entities::frame(body.layout(), corner, &grid.metadata.tags);
    let found = entities::entities(&mut body, frame)?;
    warnings.extend(found.warning());
    grid.metadata.entities = found.entities;
    let placed = body.take_block_entities(&mut block_entities)?.into_iter().flatten();
    grid.block_entities = entities::block_entities(placed, grid.bounds(), corner, &mut warnings)?;
    grid.metadata.own = body.own();
    Ok((grid, warnings))
}

fn grid(
    body: &Body,
    arrays: &mut Arrays,
    limits: &Limits,
    warnings: &mut Vec<Warning>,
) -> Result<Grid, ReadError> {
    let fields = body.fields();
    check_version(&fields)?;
    let size = volume::size(&fields, ["Width", "Height", "Length"])?;
    let (blocks, key) = match fields.inner("Blocks")? {
        Some(blocks) => (blocks, "Data"),
        None => (fields.clone(), "BlockData"),
    };
    let path = blocks.path(key);
    let data = arrays.find(&blocks, key)?;
    let data = data.ok_or_else(|| ReadError::Missing { path: path.clone(), expected: <&[i8]>::EXPECTED })?;
    check_cells(size, &path, &data, limits)?;
    let palettes = Palettes::read(&blocks)?;
    warnings.extend(palette_max(&fields, &palettes)?);
    let cells = blocks::decode(&path, data, size, &palettes)?;
    Ok(palettes.grid(size, cells))
}

fn corner(body: &Fields) -> Result<Cell, ReadError> {
    Ok(body.find("Offset")?.map_or(Cell::ZERO, Cell::from_array))
}

fn check_version(body: &Fields) -> Result<(), ReadError> {
    match body.find::<i32>("Version")? {
        None | Some(1..=3) => Ok(()),
        Some(found) => Err(ReadError::Version { path: body.path("Version"), found }),
    }
}

/// A size is not believed without its bytes: every block takes one at least.
fn check_cells(size: Cell, path: &str, data: &Varints, limits: &Limits) -> Result<(), ReadError> {
    let cells = Bounds::of_size(size).volume();
    let size = Size(size);
    if cells > data.bytes as u64 {
        return Err(ReadError::TooFewBytes { size, cells, path: path.to_owned(), bytes: data.bytes });
    }
    match cells > limits.max_cells {
        true => Err(ReadError::TooManyCells { size, cells, limit: limits.max_cells }),
        false => Ok(()),
    }
}

fn palette_max(body: &Fields, palettes: &Palettes) -> Result<Option<Warning>, ReadError> {
    let said = body.find::<i32>("PaletteMax")?;
    let found = palettes.entries;
    Ok(said.filter(|&said| said != found as i32).map(|said| Warning::PaletteMax { said, found }))
}

fn metadata(body: &Fields, corner: Cell) -> Result<Metadata, ReadError> {
    let mut tags = body.find::<&Compound>("Metadata")?.cloned().unwrap_or_default();
    let offset = worldedit_offset(&Fields::new(body.path("Metadata"), &tags))?.unwrap_or(corner);
    tags.retain(|name, _| !WE_OFFSET.contains(&name.as_str()));
    Ok(Metadata { data_version: body.find("DataVersion")?, offset, tags, ..Metadata::default() })
}

fn worldedit_offset(metadata: &Fields) -> Result<Option<Cell>, ReadError> {
    let [x, y, z] = WE_OFFSET.map(|name| metadata.find::<i32>(name));
    Ok(match (x?, y?, z?) {
        (Some(x), Some(y), Some(z)) => Some(Cell::new(x, y, z)),
        _ => None,
    })
}
