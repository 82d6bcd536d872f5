//! Biomes, one for every cube of 4 x 4 x 4 blocks since 1.18. Before, they had numbers and not names.

use super::packing::{bits, pack};
use super::section::indices;
use crate::grid::{BiomeMap, Biomes, Grid};
use crate::io::ReadError;
use crate::io::fields::Fields;
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use ndarray::{Array2, Array3, Axis};
use std::collections::BTreeMap;

/// Blocks along a cube of one biome.
const CUBE: i32 = 4;
const CUBES: usize = 4 * 4 * 4;

/// What is written where a grid says nothing.
const PLAINS: &str = "minecraft:plains";

/// The biomes of a part of the world while its chunks are read.
pub(super) struct Gathered {
    part: Bounds,
    names: Vec<String>,
    numbers: BTreeMap<String, u16>,
    /// By cubes, where known; indexed `[y, z, x]`.
    cubes: Array3<Option<u16>>,
}

impl Gathered {
    pub fn new(part: Bounds) -> Gathered {
        let [x, y, z] = cubes(part).size().to_array().map(|n| n as usize);
        let cubes = Array3::from_elem((y, z, x), None);
        Gathered { part, names: Vec::new(), numbers: BTreeMap::new(), cubes }
    }

    /// Takes the biomes of a section, if they have names.
    pub fn add(&mut self, at: Bounds, section: &Fields) -> Result<(), ReadError> {
        let Some(fields) = section.inner("biomes")? else { return Ok(()) };
        let names: Vec<&str> = strings(&fields, "palette")?;
        let ids = indices(&fields, "data", names.len(), 1, CUBES)?;
        let low = cubes(self.part).min;
        for (place, cube) in cubes(at).cells().enumerate() {
            let id = ids.get(place).map_or(0, |&id| id as usize);
            let entries = names.len();
            let name = names.get(id).ok_or_else(|| ReadError::PackedIndex {
                path: fields.path("data"),
                at: place,
                index: id as u32,
                entries,
            })?;
            if cubes(self.part).contains(cube) {
                let [x, y, z] = (cube - low).to_array().map(|n| n as usize);
                self.cubes[[y, z, x]] = self.number(name);
            }
        }
        Ok(())
    }

    /// `None` for more names than a map of biomes holds.
    fn number(&mut self, name: &str) -> Option<u16> {
        if let Some(&number) = self.numbers.get(name) {
            return Some(number);
        }
        let number = u16::try_from(self.names.len()).ok()?;
        self.names.push(name.to_owned());
        self.numbers.insert(name.to_owned(), number);
        Some(number)
    }

    /// The biome of most cubes, which those of chunks that are not made get: none of theirs is known.
    fn most(&self) -> Option<u16> {
        let mut counts = vec![0; self.names.len()];
        self.cubes.iter().flatten().for_each(|&number| counts[usize::from(number)] += 1);
        let most = (0..=u16::MAX).zip(&counts).rev().max_by_key(|(_, count)| **count);
        most.map(|(number, _)| number)
    }

    /// The biomes of all cells; by columns where they are the same from bottom to top.
    pub fn finish(mut self) -> Option<Biomes> {
        self.cubes.iter().flatten().next()?;
        let most = self.most()?;
        self.cubes.mapv_inplace(|number| number.or(Some(most)));
        let low = cubes(self.part).min;
        let number = |cell: Cell| {
            let [x, y, z] = (cube_of(self.part.min + cell) - low).to_array().map(|n| n as usize);
            self.cubes[[y, z, x]].unwrap_or_default()
        };
        let cell = |x: usize, y: usize, z: usize| Cell::new(x as i32, y as i32, z as i32);
        let [x, y, z] = self.part.size().to_array().map(|n| n as usize);
        let lowest = self.cubes.index_axis(Axis(0), 0);
        let map = match self.cubes.outer_iter().all(|layer| layer == lowest) {
            true => BiomeMap::Columns(Array2::from_shape_fn((z, x), |(z, x)| number(cell(x, 0, z)))),
            false => BiomeMap::Cells(Array3::from_shape_fn((y, z, x), |(y, z, x)| number(cell(x, y, z)))),
        };
        Some(in_order(self.names, map))
    }
}

/// The same biomes with the names that are used, in order of first use.
fn in_order(names: Vec<String>, mut map: BiomeMap) -> Biomes {
    let mut numbers = vec![None; names.len()];
    let mut used = Vec::new();
    let mut renumber = |number: &mut u16| {
        let new = numbers[usize::from(*number)].get_or_insert_with(|| {
            used.push(names[usize::from(*number)].clone());
            (used.len() - 1) as u16
        });
        *number = *new;
    };
    match &mut map {
        BiomeMap::Columns(columns) => columns.iter_mut().for_each(&mut renumber),
        BiomeMap::Cells(cells) => cells.iter_mut().for_each(&mut renumber),
    }
    Biomes { names: used, map }
}

fn strings<'a>(fields: &Fields<'a>, name: &str) -> Result<Vec<&'a str>, ReadError> {
    let each = fields.get::<&[Tag]>(name)?.iter().enumerate().map(|(index, tag)| match tag {
        Tag::String(text) => Ok(text.as_str()),
        other => Err(ReadError::WrongType {
            path: format!("{}[{index}]", fields.path(name)),
            expected: "a String",
            found: other.kind().to_owned(),
        }),
    });
    each.collect()
}

fn cube_of(cell: Cell) -> Cell {
    cell.div_euclid(Cell::splat(CUBE))
}

/// The cubes that `part` touches.
fn cubes(part: Bounds) -> Bounds {
    Bounds::new(cube_of(part.min), cube_of(part.max - 1) + 1)
}

/// The biomes of the section at `section`, where the low corner of `grid` is at `at`.
pub(super) fn write(grid: &Grid, at: Cell, section: Bounds) -> Compound {
    let mut names: Vec<&str> = Vec::new();
    let ids: Vec<u16> = cubes(section)
        .cells()
        .map(|cube| {
            let name = of_cube(grid, at, cube).next().unwrap_or(PLAINS);
            let id = names.iter().position(|&other| other == name).unwrap_or_else(|| {
                names.push(name);
                names.len() - 1
            });
            id as u16
        })
        .collect();
    let palette = names.iter().map(|&name| Tag::String(name.to_owned())).collect();
    let mut tags = Compound::from([("palette".to_owned(), Tag::List(palette))]);
    if names.len() > 1 {
        tags.insert("data".to_owned(), Tag::LongArray(pack(&ids, bits(names.len()))));
    }
    tags
}

/// Whether some cube holds more than one biome, of which only the first is written.
pub(super) fn are_finer_than_cubes(grid: &Grid, at: Cell) -> bool {
    let part = Bounds::new(at, at + grid.size());
    grid.metadata.biomes.is_some()
        && cubes(part).cells().any(|cube| {
            let mut names = of_cube(grid, at, cube);
            let first = names.next();
            names.any(|name| Some(name) != first)
        })
}

/// The names of the biomes of the grid's cells in a cube.
fn of_cube(grid: &Grid, at: Cell, cube: Cell) -> impl Iterator<Item = &str> {
    let low = cube * CUBE;
    let cells = Bounds::new(low - at, low - at + CUBE).intersect(&grid.bounds());
    let biomes = grid.metadata.biomes.as_ref();
    biomes.into_iter().flat_map(move |biomes| cells.cells().filter_map(|cell| name_at(biomes, cell)))
}

fn name_at(biomes: &Biomes, cell: Cell) -> Option<&str> {
    let [x, y, z] = cell.to_array().map(|n| n as usize);
    let id = match &biomes.map {
        BiomeMap::Columns(columns) => columns.get([z, x]),
        BiomeMap::Cells(cells) => cells.get([y, z, x]),
    };
    biomes.names.get(usize::from(*id?)).map(String::as_str)
}
