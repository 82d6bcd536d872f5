//! Biomes: one per column up to version 2, one per block in version 3.

use super::SchemVersion;
use crate::grid::{BiomeMap, Biomes, Grid};
use crate::io::fields::{Fields, FromTag};
use crate::io::varint::{self, Varints};
use crate::io::{Lost, ReadError};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;
use ndarray::{Array2, Array3, Axis};
use std::borrow::Cow;

/// The biomes of a schematic; `None` where there are none, or they do not fit the size.
pub(super) fn read(body: &Fields, size: Cell) -> Result<Option<Biomes>, ReadError> {
    let [x, y, z] = size.to_array().map(|n| n as usize);
    if let Some(biomes) = body.inner("Biomes")? {
        let found = part(&biomes, "Palette", "Data")?;
        return Ok(found.and_then(|(names, ids)| {
            Some(Biomes { names, map: BiomeMap::Cells(Array3::from_shape_vec((y, z, x), ids).ok()?) })
        }));
    }
    let found = part(body, "BiomePalette", "BiomeData")?;
    Ok(found.and_then(|(names, ids)| {
        Some(Biomes { names, map: BiomeMap::Columns(Array2::from_shape_vec((z, x), ids).ok()?) })
    }))
}

/// Names in order of first use, and their numbers.
type Numbered = (Vec<String>, Vec<u16>);

/// `None` where there are no biomes, only half of what they take, or an index without a name.
fn part(fields: &Fields, palette: &str, data: &str) -> Result<Option<Numbered>, ReadError> {
    let (palette, data) = (fields.find::<&Compound>(palette)?, fields.find::<&[i8]>(data)?);
    Ok(palette.zip(data).and_then(|(palette, data)| numbered(palette, data)))
}

fn numbered(palette: &Compound, data: &[i8]) -> Option<Numbered> {
    let named = palette.iter().map(|(name, tag)| Some((u32::try_from(i32::from_tag(tag)?).ok()?, name)));
    let mut named: Vec<(u32, &String)> = named.collect::<Option<_>>()?;
    named.sort_unstable();
    let mut ids = vec![None; named.len()];
    let mut names = Vec::new();
    let number = |index: Result<u32, _>| {
        let at = named.binary_search_by_key(&index.ok()?, |&(index, _)| index).ok()?;
        if ids[at].is_none() {
            ids[at] = Some(u16::try_from(names.len()).ok()?);
            names.push(named[at].1.clone());
        }
        ids[at]
    };
    let numbers = Varints::new(data).map(number).collect::<Option<_>>()?;
    Some((names, numbers))
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

/// The tags of the biomes, by name, to put into a schematic of `version`.
pub(super) fn write(grid: &Grid, version: SchemVersion) -> Vec<(&'static str, Tag)> {
    let Some(biomes) = &grid.metadata.biomes else { return Vec::new() };
    let names = biomes.names.iter().zip(0..).map(|(name, id)| (name.clone(), Tag::Int(id)));
    let palette: Compound = names.collect();
    match version {
        SchemVersion::V2 => vec![
            ("BiomePaletteMax", Tag::Int(palette.len() as i32)),
            ("BiomePalette", Tag::Compound(palette)),
            ("BiomeData", data(columns(&biomes.map).iter())),
        ],
        SchemVersion::V3 => {
            let data = match &biomes.map {
                BiomeMap::Cells(cells) => data(cells.iter()),
                BiomeMap::Columns(columns) => data((0..grid.size().y).flat_map(|_| columns.iter())),
            };
            let tags = [("Palette", Tag::Compound(palette)), ("Data", data)];
            vec![("Biomes", Tag::Compound(tags.map(|(name, tag)| (name.to_owned(), tag)).into()))]
        }
    }
}

fn columns(map: &BiomeMap) -> Cow<'_, Array2<u16>> {
    match map {
        BiomeMap::Columns(columns) => Cow::Borrowed(columns),
        BiomeMap::Cells(cells) => Cow::Owned(cells.index_axis(Axis(0), 0).to_owned()),
    }
}

fn data<'a>(ids: impl Iterator<Item = &'a u16>) -> Tag {
    let mut data = Vec::new();
    ids.for_each(|&id| varint::push(&mut data, id.into()));
    Tag::ByteArray(data)
}
