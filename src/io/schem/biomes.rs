//! Biomes: one per column up to version 2, one per block in version 3. They are carried, not read.

use super::SchemVersion;
use crate::grid::{BiomeExtent, Biomes, Grid};
use crate::io::ReadError;
use crate::io::fields::Fields;
use crate::nbt::{Compound, Tag};

/// The biomes of a schematic; `None` where there are none, or only half of what they take.
pub(super) fn read(body: &Fields) -> Result<Option<Biomes>, ReadError> {
    if let Some(biomes) = body.inner("Biomes")? {
        return part(&biomes, BiomeExtent::Cell, "Palette", "Data");
    }
    part(body, BiomeExtent::Column, "BiomePalette", "BiomeData")
}

fn part(
    fields: &Fields,
    extent: BiomeExtent,
    palette: &str,
    data: &str,
) -> Result<Option<Biomes>, ReadError> {
    let (palette, data) = (fields.find::<&Compound>(palette)?, fields.find::<&[i8]>(data)?);
    Ok(palette.zip(data).map(|(palette, data)| Biomes {
        extent,
        palette: palette.clone(),
        data: data.to_vec(),
    }))
}

/// Whether `version` has a place for the biomes of `grid`, and they fit its size.
pub(super) fn fit(grid: &Grid, biomes: &Biomes, version: SchemVersion) -> bool {
    let size = grid.size().as_u64vec3();
    let (extent, count) = match version {
        SchemVersion::V2 => (BiomeExtent::Column, size.x * size.z),
        SchemVersion::V3 => (BiomeExtent::Cell, size.x * size.y * size.z),
    };
    biomes.extent == extent && entries(&biomes.data) == count
}

/// The last byte of a varint is the one that is not negative.
fn entries(varints: &[i8]) -> u64 {
    varints.iter().filter(|&&byte| byte >= 0).count() as u64
}

/// The tags of the biomes, by name, to put into a schematic of `version`.
pub(super) fn write(grid: &Grid, version: SchemVersion) -> Vec<(&'static str, Tag)> {
    let Some(biomes) = grid.metadata.biomes.as_ref().filter(|biomes| fit(grid, biomes, version)) else {
        return Vec::new();
    };
    let (palette, data) = (Tag::Compound(biomes.palette.clone()), Tag::ByteArray(biomes.data.clone()));
    match version {
        SchemVersion::V2 => vec![
            ("BiomePaletteMax", Tag::Int(biomes.palette.len() as i32)),
            ("BiomePalette", palette),
            ("BiomeData", data),
        ],
        SchemVersion::V3 => {
            let tags = [("Palette", palette), ("Data", data)];
            vec![("Biomes", Tag::Compound(tags.map(|(name, tag)| (name.to_owned(), tag)).into()))]
        }
    }
}
