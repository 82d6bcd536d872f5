use super::blocks::{self, Palettes};
use super::{WE_OFFSET, biomes, entities};
use crate::grid::{Grid, Metadata};
use crate::io::error::Size;
use crate::io::fields::{Extent, Fields};
use crate::io::{Limits, ReadError, Warning};
use crate::nbt::Compound;
use crate::space::{Bounds, Cell};

/// The grid of a schematic of any version, by where its tags stand: the version it claims is often
/// absent or wrong.
pub fn decode(root: &Compound, limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let root = Fields::new("", root);
    let body = root.inner("Schematic")?.unwrap_or(root);
    let corner = body.find("Offset")?.map_or(Cell::ZERO, Cell::from_array);
    let parts = Parts::of(&body, corner)?;
    let size = size(&body)?;
    let data = parts.data()?;
    check_cells(size, &parts.blocks.path(parts.data_key), data, limits)?;

    let mut warnings = Vec::new();
    let palettes = Palettes::read(&parts.blocks)?;
    warnings.extend(palette_max(&body, &palettes)?);
    let cells = blocks::decode(&parts.blocks.path(parts.data_key), data, size, &palettes)?;
    let mut grid = palettes.grid(size, cells);

    let (block_entities, warning) = entities::read_block_entities(&parts.blocks, grid.bounds(), corner)?;
    warnings.extend(warning);
    grid.block_entities = block_entities;
    grid.metadata = metadata(&body, corner, size)?;
    let (entities, warning) = entities::read_entities(&body, parts.origin)?;
    warnings.extend(warning);
    grid.metadata.entities = entities;
    Ok((grid, warnings))
}

/// Where a layout keeps its parts.
struct Parts<'a> {
    /// Holds the palette, the indices and the block entities.
    blocks: Fields<'a>,
    data_key: &'static str,
    /// Where the places of entities count from.
    origin: Cell,
}

impl<'a> Parts<'a> {
    fn of(body: &Fields<'a>, corner: Cell) -> Result<Parts<'a>, ReadError> {
        if let Some(version) = body.find::<i32>("Version")?
            && !(1..=3).contains(&version)
        {
            return Err(ReadError::Version { path: body.path("Version"), found: version });
        }
        Ok(match body.inner("Blocks")? {
            Some(blocks) => Parts { blocks, data_key: "Data", origin: Cell::ZERO },
            None => Parts { blocks: body.clone(), data_key: "BlockData", origin: corner },
        })
    }

    fn data(&self) -> Result<&'a [i8], ReadError> {
        self.blocks.get(self.data_key)
    }
}

fn size(body: &Fields) -> Result<Cell, ReadError> {
    let extent = |name| match body.get(name)? {
        Extent(0) => Err(ReadError::ZeroSize { path: body.path(name) }),
        Extent(n) => Ok(i32::from(n)),
    };
    Ok(Cell::new(extent("Width")?, extent("Height")?, extent("Length")?))
}

/// Nothing is allocated for a size whose bytes are not there: every block takes one at least.
fn check_cells(size: Cell, path: &str, data: &[i8], limits: &Limits) -> Result<(), ReadError> {
    let cells = Bounds::of_size(size).volume();
    let size = Size(size);
    if cells > data.len() as u64 {
        return Err(ReadError::TooFewBytes { size, cells, path: path.to_owned(), bytes: data.len() });
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

fn metadata(body: &Fields, corner: Cell, size: Cell) -> Result<Metadata, ReadError> {
    let mut tags = body.find::<&Compound>("Metadata")?.cloned().unwrap_or_default();
    let offset = worldedit_offset(&Fields::new(body.path("Metadata"), &tags))?.unwrap_or(corner);
    tags.retain(|name, _| !WE_OFFSET.contains(&name.as_str()));
    let data_version = body.find("DataVersion")?;
    Ok(Metadata { data_version, offset, tags, biomes: biomes::read(body, size)?, ..Metadata::default() })
}

fn worldedit_offset(metadata: &Fields) -> Result<Option<Cell>, ReadError> {
    let [x, y, z] = WE_OFFSET.map(|name| metadata.find::<i32>(name));
    Ok(match (x?, y?, z?) {
        (Some(x), Some(y), Some(z)) => Some(Cell::new(x, y, z)),
        _ => None,
    })
}
