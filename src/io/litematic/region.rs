//! A region of a file: where it is, and its blocks.

use super::{PENDING, REGION_TAGS, XYZ, bits};
use crate::block::{BlockState, PaletteFull};
use crate::grid::Region;
use crate::io::error::Size;
use crate::io::fields::Fields;
use crate::io::{ReadError, states};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use std::ops::Range;

pub(super) struct Part<'a> {
    pub name: &'a str,
    pub fields: Fields<'a>,
    /// Where its entities count from.
    pub position: Cell,
    /// From the point of copying.
    pub bounds: Bounds,
    pub palette: Vec<BlockState>,
    /// As many as the blocks take.
    words: &'a [i64],
}

impl<'a> Part<'a> {
    /// The region `name`. Nothing is allocated for its size, and the bytes of its blocks are there.
    pub fn read(name: &'a str, fields: Fields<'a>) -> Result<Part<'a>, ReadError> {
        let position = xyz(&fields, "Position")?;
        let bounds = bounds(&fields, position, xyz(&fields, "Size")?)?;
        let palette = palette(&fields)?;
        let words = fields.get::<&[i64]>("BlockStates")?;
        let part = Part { name, fields, position, bounds, palette, words };
        match part.size().cells() {
            cells if bits::words(cells, part.width()) != words.len() as u64 => Err(part.wrong_length(cells)),
            _ => Ok(part),
        }
    }

    pub fn size(&self) -> Size {
        Size(self.bounds.size())
    }

    fn width(&self) -> u32 {
        bits::width(self.palette.len())
    }

    fn wrong_length(&self, cells: u64) -> ReadError {
        ReadError::WordCount {
            path: self.fields.path("BlockStates"),
            found: self.words.len(),
            expected: bits::words(cells, self.width()),
            size: self.size(),
            bits: self.width(),
        }
    }

    /// What the file keeps of the region beside its blocks and entities. `low` is the low corner of the grid.
    pub fn region(&self, low: Cell) -> Region {
        let empty = |tag: &Tag| matches!(tag, Tag::List(entries) if entries.is_empty());
        let is_kept = |name: &str, tag: &Tag| match PENDING.contains(&name) {
            true => !empty(tag),
            false => !REGION_TAGS.contains(&name),
        };
        let tags = self.fields.tags.iter().filter(|(name, tag)| is_kept(name, tag));
        Region {
            name: self.name.to_owned(),
            bounds: Bounds::new(self.bounds.min - low, self.bounds.max - low),
            tags: tags.map(|(name, tag)| (name.clone(), tag.clone())).collect::<Compound>(),
        }
    }

    /// The block at `cell`, from the low corner of the region.
    pub fn state(&self, cell: Cell) -> Option<&BlockState> {
        let [x, y, z] = cell.to_array().map(|n| n as usize);
        let [width, _, length] = self.size().0.to_array().map(|n| n as usize);
        self.palette.get(usize::from(bits::number(self.words, self.width(), x + width * (z + length * y))))
    }

    /// The indices of all blocks, each within the palette.
    pub fn indices(&self) -> Result<Vec<u16>, ReadError> {
        let indices = bits::unpack(self.words, self.width(), self.size().cells() as usize);
        let entries = self.palette.len();
        // The largest is found many times faster than the first that is too large.
        if indices.iter().max().is_some_and(|&index| usize::from(index) >= entries) {
            let strange = indices.iter().position(|&index| usize::from(index) >= entries).unwrap_or_default();
            return Err(ReadError::NotInPalette {
                path: self.fields.path("BlockStates"),
                cell: self.size().cell(strange),
                index: indices[strange].into(),
                entries,
            });
        }
        Ok(indices)
    }
}

/// A palette whose indices are not too large for a grid.
fn palette(fields: &Fields) -> Result<Vec<BlockState>, ReadError> {
    let path = fields.path("BlockStatePalette");
    match states::read_palette(&path, fields.get("BlockStatePalette")?)? {
        palette if palette.len() > bits::ENTRIES => {
            Err(ReadError::PaletteFull { path, problem: PaletteFull })
        }
        palette => Ok(palette),
    }
}

fn xyz(fields: &Fields, name: &str) -> Result<Cell, ReadError> {
    let place = Fields::new(fields.path(name), fields.get::<&Compound>(name)?);
    let [x, y, z] = XYZ.map(|axis| place.get::<i32>(axis));
    Ok(Cell::new(x?, y?, z?))
}

fn bounds(fields: &Fields, position: Cell, size: Cell) -> Result<Bounds, ReadError> {
    if size.to_array().contains(&0) {
        return Err(ReadError::WrongType {
            path: fields.path("Size"),
            expected: "at least one block along each axis, to either side",
            found: Size(size).to_string(),
        });
    }
    let spans = [0, 1, 2].map(|axis| span(position[axis], size[axis]));
    let [Some(x), Some(y), Some(z)] = spans else {
        return Err(ReadError::FarOut { path: fields.path("Position"), position, size: Size(size) });
    };
    Ok(Bounds::new(Cell::new(x.start, y.start, z.start), Cell::new(x.end, y.end, z.end)))
}

/// The blocks from `start` on, to the side that the sign of `len` says, as far as numbers reach.
fn span(start: i32, len: i32) -> Option<Range<i32>> {
    let (start, len) = (i64::from(start), i64::from(len));
    let low = if len < 0 { start + len + 1 } else { start };
    i32::try_from(len.abs()).ok()?;
    Some(low.try_into().ok()?..(low + len.abs()).try_into().ok()?)
}
