//! Sections: cubes of 16 blocks a side with a palette of their own, as in the game's worlds.

use crate::block::{BlockState, Palette};
use crate::io::error::Size;
use crate::io::fields::Fields;
use crate::io::{ReadError, states, volume};
use crate::nbt::Compound;
use crate::space::{Bounds, Cell};

const SIDE: i32 = 16;
pub(super) const CELLS: usize = 4096;

/// The game's own bound on places.
const FARTHEST: i32 = 1 << 21;

pub(super) struct Section {
    /// The low corner.
    corner: Cell,
    /// Palette numbers in the order y, z, x.
    ids: Box<[u16]>,
}

impl Section {
    /// Reads a section. Cells of the state `empty` are those to leave alone.
    pub fn read(region: &Fields, empty: &BlockState, palette: &mut Palette) -> Result<Section, ReadError> {
        let [x, y, z] = ["X", "Y", "Z"].map(|name| coordinate(region, name));
        let corner = Cell::new(x?, y?, z?) * SIDE;
        let path = region.path("BlockStates");
        let blocks = Fields::new(path, region.get::<&Compound>("BlockStates")?);
        let own = states::read_palette(&blocks.path("palette"), blocks.get("palette")?)?;
        let understood =
            |state: BlockState| if state == *empty { BlockState::structure_void() } else { state };
        let ids = own.into_iter().map(|state| palette.intern(&understood(state)));
        let ids = ids.collect::<Result<Vec<u16>, _>>().map_err(volume::full(blocks.path("palette")))?;
        let indices = indices(&blocks, ids.len())?;
        let cells = indices.iter().enumerate().map(|(at, &index)| {
            ids.get(index).copied().ok_or_else(|| ReadError::NotInPalette {
                path: blocks.path("data"),
                cell: Size(Cell::splat(SIDE)).cell(at),
                index: index as u32,
                entries: ids.len(),
            })
        });
        Ok(Section { corner, ids: cells.collect::<Result<_, _>>()? })
    }

    pub fn bounds(&self) -> Bounds {
        Bounds::new(self.corner, self.corner + Cell::splat(SIDE))
    }

    /// All cells with their palette numbers.
    pub fn cells(&self) -> impl Iterator<Item = (Cell, u16)> {
        let place = |at| self.corner + Size(Cell::splat(SIDE)).cell(at);
        self.ids.iter().enumerate().map(move |(at, &id)| (place(at), id))
    }

    /// The box around the cells of other numbers than `nothing`.
    pub fn held(&self, nothing: u16) -> Option<Bounds> {
        let held = self.cells().filter(|&(_, id)| id != nothing).map(|(cell, _)| (cell, cell));
        let (min, max) = held.reduce(|(min, max), (cell, _)| (min.min(cell), max.max(cell)))?;
        Some(Bounds::new(min, max + Cell::ONE))
    }
}

fn coordinate(region: &Fields, name: &str) -> Result<i32, ReadError> {
    match region.get(name)? {
        found if (-FARTHEST..FARTHEST).contains(&found) => Ok(found),
        found => Err(ReadError::FarAway { path: region.path(name), found }),
    }
}

/// The indices of all cells. They are packed into Longs, low bits first, and none spans two; a palette of one state
/// needs none.
fn indices(blocks: &Fields, entries: usize) -> Result<Vec<usize>, ReadError> {
    let longs = match blocks.find::<&[i64]>("data")? {
        Some(longs) if entries != 1 => longs,
        _ => return Ok(vec![0; CELLS]),
    };
    let bits = (usize::BITS - entries.saturating_sub(1).leading_zeros()).max(4);
    let per_long = (64 / bits) as usize;
    let needed = CELLS.div_ceil(per_long);
    if longs.len() < needed {
        return Err(ReadError::TooFewLongs { path: blocks.path("data"), needed, found: longs.len() });
    }
    let index = |at: usize| {
        let long = longs[at / per_long].cast_unsigned() >> ((at % per_long) as u32 * bits);
        (long & ((1 << bits) - 1)) as usize
    };
    Ok((0..CELLS).map(index).collect())
}
