//! The palette and the block indices.

use super::arrays::{Outgoing, RUN, uniform};
use crate::block::{BlockState, Palette, complete_in};
use crate::grid::Grid;
use crate::io::ReadError;
use crate::io::error::PALETTE_INDEX_MAX;
use crate::io::fields::{Fields, FromTag};
use crate::io::varint::{Stop, Varints};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use ndarray::Array3;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The states of a file, and their numbers by the indices that the file gives them.
pub(super) struct Palettes {
    palette: Palette,
    /// `None` at indices that the file leaves out.
    ids: Vec<Option<u16>>,
    pub entries: usize,
}

impl Palettes {
    /// The palette of `blocks`, numbered in the order of the file's indices.
    pub fn read(blocks: &Fields) -> Result<Palettes, ReadError> {
        let path = blocks.path("Palette");
        let entries = entries(&path, blocks.get("Palette")?)?;
        let mut palette = Palette::default();
        let mut ids = vec![None; entries.last().map_or(0, |&(last, _)| last + 1)];
        for &(index, entry) in &entries {
            let state: BlockState = entry.parse().map_err(|problem| ReadError::PaletteEntry {
                path: path.clone(),
                entry: entry.to_owned(),
                problem,
            })?;
            let id = palette.intern(&state);
            ids[index] = Some(id.map_err(|problem| ReadError::PaletteFull { path: path.clone(), problem })?);
        }
        Ok(Palettes { palette, ids, entries: entries.len() })
    }

    /// A grid of `cells`, which came from these palettes and fill `size`.
    pub fn grid(self, size: Cell, cells: Vec<u16>) -> Grid {
        let [x, y, z] = size.to_array().map(|n| n as usize);
        let cells = Array3::from_shape_vec((y, z, x), cells).expect("as many cells as the size makes");
        Grid::from_cells(cells, self.palette).expect("cells hold numbers of their palette")
    }

    /// Replaces the file's indices by the numbers of their states; else the place of the first that has none.
    fn resolve(&self, indices: &mut [u16]) -> Result<(), usize> {
        let whole = self.ids.iter().all(Option::is_some);
        let known = |index: u16| matches!(self.ids.get(usize::from(index)), Some(Some(_)));
        let highest = indices.iter().fold(0, |highest, &index| highest.max(index));
        if !whole || !known(highest) {
            indices.iter().position(|&index| !known(index)).map_or(Ok(()), Err)?;
        }
        if self.ids.iter().zip(0..=u16::MAX).any(|(&id, index)| id != Some(index)) {
            let ids: Vec<u16> = self.ids.iter().map(|id| id.unwrap_or_default()).collect();
            indices.iter_mut().for_each(|index| *index = ids[usize::from(*index)]);
        }
        Ok(())
    }
}

/// The entries of a palette by index, each index once.
fn entries<'a>(path: &str, tags: &'a Compound) -> Result<Vec<(usize, &'a str)>, ReadError> {
    let each = tags.iter().map(|(entry, tag)| {
        let index = i32::from_tag(tag).filter(|index| (0..=PALETTE_INDEX_MAX).contains(index));
        let found = || match tag {
            Tag::Int(index) => {
                ReadError::PaletteIndex { path: path.to_owned(), entry: entry.to_string(), index: *index }
            }
            _ => ReadError::WrongType {
                path: format!("{path}.{entry}"),
                expected: i32::EXPECTED,
                found: tag.kind().to_owned(),
            },
        };
        Ok((index.ok_or_else(found)? as usize, entry.as_str()))
    });
    let mut entries = each.collect::<Result<Vec<_>, ReadError>>()?;
    entries.sort_unstable();
    match entries.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        None => Ok(entries),
        Some(twice) => Err(ReadError::PaletteTwice {
            path: path.to_owned(),
            first: twice[0].1.to_owned(),
            second: twice[1].1.to_owned(),
            index: twice[0].0 as i32,
        }),
    }
}

/// The palette numbers of all cells. `data`, which stands at `path`, has at least one byte for each.
pub(super) fn decode(
    path: &str,
    data: Varints,
    size: Cell,
    palettes: &Palettes,
) -> Result<Vec<u16>, ReadError> {
    let volume = Bounds::of_size(size).volume();
    let Varints { mut numbers, bytes, decoded, stop } = data;
    let missing = |at, index| {
        let (path, cell, entries) = (path.to_owned(), cell_at(at, size), palettes.entries);
        ReadError::NotInPalette { path, cell, index, entries }
    };
    let cells = numbers.len().min(volume as usize);
    palettes.resolve(&mut numbers[..cells]).map_err(|at| missing(at, u32::from(numbers[at])))?;
    let goes_on = numbers.len() as u64 > volume || (numbers.len() as u64 == volume && decoded < bytes);
    if goes_on {
        return Err(ReadError::TooManyBlocks { path: path.to_owned(), cells: volume });
    }
    match stop {
        None if numbers.len() as u64 == volume => Ok(numbers),
        // Numbers are counted up to a limit that the volume keeps to.
        None | Some(Stop::Full) => {
            Err(ReadError::TooFewBlocks { path: path.to_owned(), found: cells as u64, cells: volume })
        }
        Some(Stop::Large(index)) => Err(missing(cells, index)),
        Some(Stop::Broken(problem)) => {
            let cell = cell_at(cells, size);
            Err(ReadError::Varint { path: path.to_owned(), offset: decoded, cell, problem })
        }
    }
}

/// The place of the cell `at` in the order of the file: x fastest, then z, then y.
fn cell_at(at: usize, size: Cell) -> Cell {
    let [width, _, length] = size.to_array().map(|n| n as usize);
    Cell::new((at % width) as i32, (at / width / length) as i32, (at / width % length) as i32)
}

/// A grid's blocks as a file holds them: indices by block state, and the index of each cell.
///
/// States are numbered in order of first use: what the grid's own palette holds beside them, and in which order, does not
/// show. All properties of their version are written, since readers differ in what they take absent ones for.
pub(super) fn encode(grid: &Grid) -> (Compound, Outgoing<'_>) {
    let cells = grid.cells().as_slice().expect("a grid's cells are in the standard layout");
    let states = grid.palette().states();
    let mut indices = BTreeMap::new();
    let mut table = vec![0; states.len()];
    let version = grid.version();
    for id in used(cells, states.len()) {
        let state = complete_in(&states[usize::from(id)], version).to_string();
        let next = indices.len() as u16;
        // States that are one once complete share an index.
        table[usize::from(id)] = *indices.entry(state).or_insert(next);
    }
    let palette = indices.into_iter().map(|(state, index)| (state, Tag::Int(index.into()))).collect();
    (palette, Outgoing::new(Cow::Borrowed(cells), table, 1))
}

/// The palette numbers that stand in `cells`, in order of first use.
fn used(cells: &[u16], states: usize) -> Vec<u16> {
    let mut seen = vec![false; states];
    let mut used = Vec::new();
    let mut see = |id: u16| {
        if !std::mem::replace(&mut seen[usize::from(id)], true) {
            used.push(id);
        }
    };
    let (runs, rest) = cells.as_chunks::<RUN>();
    for run in runs {
        match uniform(run) {
            Some(id) => see(id),
            None => run.iter().for_each(|&id| see(id)),
        }
    }
    rest.iter().for_each(|&id| see(id));
    used
}
