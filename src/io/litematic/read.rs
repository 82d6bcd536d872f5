use super::region::Part;
use super::{entities, merge, metadata};
use crate::grid::Grid;
use crate::io::error::Size;
use crate::io::fields::Fields;
use crate::io::{Limits, ReadError, Warning};
use crate::nbt::Compound;
use crate::space::{Bounds, Cell};

/// The first version of today's layout, the first with states of Minecraft 1.13, and the last one known.
const OLDEST: i32 = 2;
const FLATTENED: i32 = 5;
const NEWEST: i32 = 7;

/// The grid around all regions, or that of the one called `region`. Cells in no region are left alone.
pub fn decode(
    root: &Compound,
    limits: &Limits,
    region: Option<&str>,
) -> Result<(Grid, Vec<Warning>), ReadError> {
    let root = Fields::new("", root);
    let mut warnings: Vec<Warning> = version(&root)?.into_iter().collect();
    let parts = parts(&root, region)?;
    let all = around(&parts, limits)?;
    let strange = parts.iter().filter(|part| part.palette.first().is_none_or(|state| !state.is_air()));
    warnings.extend(strange.map(|part| Warning::PaletteWithoutAir(part.name.to_owned())));

    let (mut grid, overlaps) = merge::grid(&parts, all)?;
    warnings.extend(overlaps);
    grid.metadata = metadata::read(&root)?;
    grid.metadata.offset = all.min;
    grid.metadata.regions = parts.iter().map(|part| part.region(all.min)).collect();
    warnings.extend(entities::read(&parts, &mut grid)?);
    Ok((grid, warnings))
}

fn version(root: &Fields) -> Result<Option<Warning>, ReadError> {
    match root.find::<i32>("Version")? {
        Some(found) if found < OLDEST => Err(ReadError::OldLitematic { path: root.path("Version"), found }),
        Some(found) if found < FLATTENED => Ok(Some(Warning::OldStates)),
        Some(found) if found > NEWEST => Ok(Some(Warning::NewVersion { found, known: NEWEST })),
        _ => Ok(None),
    }
}

/// The regions in the order of their names, or the one of the name `only`.
fn parts<'a>(root: &Fields<'a>, only: Option<&str>) -> Result<Vec<Part<'a>>, ReadError> {
    let path = root.path("Regions");
    let regions = Fields::new(&path, root.get::<&Compound>("Regions")?);
    let names = regions.tags.keys().filter(|name| only.is_none_or(|only| only == name.as_str()));
    let parts =
        names.map(|name| Part::read(name, Fields::new(regions.path(name), regions.get::<&Compound>(name)?)));
    let parts = parts.collect::<Result<Vec<Part>, ReadError>>()?;
    match only {
        Some(name) if parts.is_empty() => Err(ReadError::NoRegion {
            name: name.to_owned(),
            names: regions.tags.keys().map(String::from).collect(),
        }),
        None if parts.is_empty() => {
            Err(ReadError::WrongType { path, expected: "at least one region", found: "empty".to_owned() })
        }
        _ => Ok(parts),
    }
}

/// The box around all regions, which may lie anywhere.
fn around(parts: &[Part], limits: &Limits) -> Result<Bounds, ReadError> {
    let low = parts.iter().map(|part| part.bounds.min).reduce(Cell::min).unwrap_or_default();
    let high = parts.iter().map(|part| part.bounds.max).reduce(Cell::max).unwrap_or_default();
    let size =
        (high.as_i64vec3() - low.as_i64vec3()).to_array().map(|n| i32::try_from(n).unwrap_or(i32::MAX));
    let size = Size(Cell::from_array(size));
    match size.cells() {
        cells if cells <= limits.max_cells => Ok(Bounds::new(low, high)),
        cells => Err(too_large(parts, size, cells, limits.max_cells)),
    }
}

fn too_large(parts: &[Part], size: Size, cells: u64, limit: u64) -> ReadError {
    if let Some(part) = parts.iter().find(|part| part.size().cells() > limit) {
        let size = part.size();
        return ReadError::TooManyCells { size, cells: size.cells(), limit };
    }
    let axis = size.0.to_array().into_iter().zip(0..3).max().map_or(0, |(_, axis)| axis);
    let ends = parts
        .iter()
        .min_by_key(|part| part.bounds.min[axis])
        .zip(parts.iter().max_by_key(|part| part.bounds.max[axis]));
    let Some((first, last)) = ends else { return ReadError::TooManyCells { size, cells, limit } };
    ReadError::FarApart {
        first: first.name.to_owned(),
        last: last.name.to_owned(),
        apart: (i64::from(last.bounds.min[axis]) - i64::from(first.bounds.max[axis])).max(0),
        axis: ["x", "y", "z"][axis],
        size,
        cells,
        limit,
    }
}
