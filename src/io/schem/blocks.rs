//! The palette and the block indices.

use crate::block::{BlockState, Palette};
use crate::grid::Grid;
use crate::io::ReadError;
use crate::io::error::PALETTE_INDEX_MAX;
use crate::io::fields::{Fields, FromTag};
use crate::io::varint::{self, Varints};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use ndarray::Array3;

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
}

/// The entries of a palette by index, each index once.
fn entries<'a>(path: &str, tags: &'a Compound) -> Result<Vec<(usize, &'a str)>, ReadError> {
    let each = tags.iter().map(|(entry, tag)| {
        let index = i32::from_tag(tag).filter(|index| (0..=PALETTE_INDEX_MAX).contains(index));
        let found = || match tag {
            Tag::Int(index) => {
                ReadError::PaletteIndex { path: path.to_owned(), entry: entry.clone(), index: *index }
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

/// The palette numbers of all cells. `data` holds at least one byte for each.
pub(super) fn decode(
    path: &str,
    data: &[i8],
    size: Cell,
    palettes: &Palettes,
) -> Result<Vec<u16>, ReadError> {
    let volume = Bounds::of_size(size).volume();
    let mut cells = Vec::with_capacity(volume as usize);
    let mut varints = Varints::new(data);
    while (cells.len() as u64) < volume {
        let cell = || cell_at(cells.len(), size);
        let index = match varints.next() {
            Some(Ok(index)) => index,
            Some(Err(problem)) => {
                let (path, offset) = (path.to_owned(), varints.offset());
                return Err(ReadError::Varint { path, offset, cell: cell(), problem });
            }
            None => {
                let (path, found) = (path.to_owned(), cells.len() as u64);
                return Err(ReadError::TooFewBlocks { path, found, cells: volume });
            }
        };
        let Some(&Some(id)) = palettes.ids.get(index as usize) else {
            let (path, entries) = (path.to_owned(), palettes.entries);
            return Err(ReadError::NotInPalette { path, cell: cell(), index, entries });
        };
        cells.push(id);
    }
    match varints.left() {
        0 => Ok(cells),
        bytes => Err(ReadError::TooManyBlocks { path: path.to_owned(), bytes, cells: volume }),
    }
}

/// The place of the cell `at` in the order of the file: x fastest, then z, then y.
fn cell_at(at: usize, size: Cell) -> Cell {
    let [width, _, length] = size.to_array().map(|n| n as usize);
    Cell::new((at % width) as i32, (at / width / length) as i32, (at / width % length) as i32)
}

/// A grid's blocks as a file holds them.
pub(super) struct Encoded {
    /// Indices by block state.
    pub palette: Compound,
    pub data: Vec<i8>,
}

/// The blocks of `grid`, their states numbered in order of first use: what the grid's own palette
/// holds beside them, and in which order, does not show.
pub(super) fn encode(grid: &Grid) -> Encoded {
    let cells = grid.cells().as_standard_layout();
    let cells = cells.as_slice().expect("the standard layout is contiguous");
    let states = grid.palette().states();
    let (indices, used) = number(cells, states.len());
    let named =
        used.iter().zip(0..).map(|(&id, index)| (states[usize::from(id)].to_string(), Tag::Int(index)));
    Encoded { palette: named.collect(), data: indexed(cells, &indices, used.len()) }
}

/// Indices by palette number, and the numbers used in order of their indices.
fn number(cells: &[u16], states: usize) -> (Vec<u32>, Vec<u16>) {
    const UNUSED: u32 = u32::MAX;
    let mut indices = vec![UNUSED; states];
    let mut used = Vec::new();
    for &id in cells {
        let index = &mut indices[usize::from(id)];
        if *index == UNUSED {
            *index = used.len() as u32;
            used.push(id);
        }
    }
    (indices, used)
}

fn indexed(cells: &[u16], indices: &[u32], used: usize) -> Vec<i8> {
    if used <= 0x80 {
        return cells.iter().map(|&id| indices[usize::from(id)] as i8).collect();
    }
    let mut data = Vec::with_capacity(2 * cells.len());
    for &id in cells {
        varint::push(&mut data, indices[usize::from(id)]);
    }
    data
}
