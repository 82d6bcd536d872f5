//! Biomes: one per column up to version 2, one per block in version 3.

use super::SchemVersion;
use super::arrays::{Arrays, Outgoing};
use crate::grid::{BiomeMap, Biomes, Grid};
use crate::io::fields::{Fields, FromTag};
use crate::io::{Lost, ReadError, Warning};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;
use ndarray::{Array2, Array3, ArrayView, Axis, Dimension};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The biomes of a schematic; `None` where there are none, or, with a warning, where they do not fit the size.
pub(super) fn read(
    body: &Fields,
    arrays: &mut Arrays,
    size: Cell,
    warnings: &mut Vec<Warning>,
) -> Result<Option<Biomes>, ReadError> {
    let [x, y, z] = size.to_array().map(|n| n as usize);
    let (numbered, shape) = match body.inner("Biomes")? {
        Some(biomes) => (numbered(&biomes, "Palette", "Data", arrays)?, Shape::Cells([y, z, x])),
        None if PARTS.iter().any(|name| body.tags.contains_key(name)) => {
            (numbered(body, PARTS[0], PARTS[1], arrays)?, Shape::Columns([z, x]))
        }
        None => return Ok(None),
    };
    let biomes = numbered.and_then(|(names, ids)| Some(Biomes { names, map: shape.map(ids)? }));
    if biomes.is_none() {
        warnings.push(Warning::Biomes);
    }
    Ok(biomes)
}

/// Where version 2 keeps them.
const PARTS: [&str; 2] = ["BiomePalette", "BiomeData"];

enum Shape {
    Columns([usize; 2]),
    Cells([usize; 3]),
}

impl Shape {
    /// `None` where there are more or fewer numbers than places.
    fn map(self, ids: Vec<u16>) -> Option<BiomeMap> {
        match self {
            Shape::Columns(shape) => Array2::from_shape_vec(shape, ids).ok().map(BiomeMap::Columns),
            Shape::Cells(shape) => Array3::from_shape_vec(shape, ids).ok().map(BiomeMap::Cells),
        }
    }
}

/// Names in order of first use, and their numbers.
type Numbered = (Vec<String>, Vec<u16>);

/// The biomes at these names; `None` where there is only half of what they take, or an index
/// without a name.
fn numbered(
    fields: &Fields,
    palette: &str,
    data: &str,
    arrays: &mut Arrays,
) -> Result<Option<Numbered>, ReadError> {
    let (palette, data) = (fields.find::<&Compound>(palette)?, arrays.find(fields, data)?);
    Ok(palette.zip(data.filter(|data| data.stop.is_none())).and_then(|(palette, data)| {
        let mut numbers = data.numbers;
        let names = number(&by_index(palette)?, &mut numbers)?;
        Some((names, numbers))
    }))
}

/// The names of a palette by their indices; `None` where one is no index.
fn by_index(palette: &Compound) -> Option<BTreeMap<u16, &str>> {
    palette
        .iter()
        .map(|(name, tag)| Some((u16::try_from(i32::from_tag(tag)?).ok()?, name.as_str())))
        .collect()
}

/// Numbers the names anew in order of first use; `None` where an index has no name.
fn number(names: &BTreeMap<u16, &str>, indices: &mut [u16]) -> Option<Vec<String>> {
    let most = names.last_key_value().map_or(0, |(&last, _)| usize::from(last) + 1);
    let mut ids = vec![None; most];
    let mut used = Vec::new();
    for index in indices {
        let id = ids.get_mut(usize::from(*index))?;
        *index = match *id {
            Some(id) => id,
            None => {
                used.push((*names.get(index)?).to_owned());
                *id.insert((used.len() - 1) as u16)
            }
        };
    }
    Some(used)
}

/// Blocks of one column have one biome in version 2: the lowest counts where they differ.
pub(super) fn lost(grid: &Grid, version: SchemVersion) -> Option<Lost> {
    match &grid.metadata.biomes.as_ref()?.map {
        BiomeMap::Cells(cells) if version == SchemVersion::V2 => {
            let lowest = cells.index_axis(Axis(0), 0);
            cells.outer_iter().any(|layer| layer != lowest).then_some(Lost::Biomes)
        }
        _ => None,
    }
}

/// The tags of the biomes, by name, to put into a schematic of `version`; and their array.
pub(super) fn write(grid: &Grid, version: SchemVersion) -> Option<(Vec<(&'static str, Tag)>, Outgoing<'_>)> {
    let biomes = grid.metadata.biomes.as_ref()?;
    let names = biomes.names.iter().zip(0..).map(|(name, id)| (name.clone(), Tag::Int(id)));
    let palette: Compound = names.collect();
    let data = Tag::ByteArray(Vec::new());
    let tags = match version {
        SchemVersion::V2 => vec![
            ("BiomePaletteMax", Tag::Int(palette.len() as i32)),
            ("BiomePalette", Tag::Compound(palette)),
            ("BiomeData", data),
        ],
        SchemVersion::V3 => {
            let tags = [("Palette", Tag::Compound(palette)), ("Data", data)];
            vec![("Biomes", Tag::Compound(tags.map(|(name, tag)| (name.to_owned(), tag)).into()))]
        }
    };
    Some((tags, outgoing(biomes, grid.size(), version)))
}

fn outgoing(biomes: &Biomes, size: Cell, version: SchemVersion) -> Outgoing<'_> {
    let table = (0..biomes.names.len()).map(|id| id as u16).collect();
    let (numbers, times) = match (&biomes.map, version) {
        (BiomeMap::Columns(columns), SchemVersion::V2) => (in_order(columns.view()), 1),
        (BiomeMap::Columns(columns), SchemVersion::V3) => (in_order(columns.view()), size.y as usize),
        (BiomeMap::Cells(cells), SchemVersion::V2) => (in_order(cells.index_axis(Axis(0), 0)), 1),
        (BiomeMap::Cells(cells), SchemVersion::V3) => (in_order(cells.view()), 1),
    };
    Outgoing::new(numbers, table, times)
}

/// Numbers in the order of files.
fn in_order<D: Dimension>(numbers: ArrayView<'_, u16, D>) -> Cow<'_, [u16]> {
    match numbers.to_slice() {
        Some(slice) => Cow::Borrowed(slice),
        None => Cow::Owned(numbers.iter().copied().collect()),
    }
}
