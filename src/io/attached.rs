//! Paintings, item frames and the like say a second time where they are: by the block they hang in. In a grid
//! that counts from the low corner, as their place does.

use crate::nbt::{Compound, Tag};
use crate::space::Cell;

const TILE: [&str; 3] = ["TileX", "TileY", "TileZ"];
/// Since Minecraft 1.21.5.
const BLOCK_POS: &str = "block_pos";

/// The game takes no block for its own that lies farther away.
const REACH: f64 = 16.0;

/// The block that the data of an entity name, moved by `by`. The entity is then at `place`, and where its
/// data name no block, or one far away as it stood in some world, it is the block of that.
pub(super) fn block(data: &Compound, by: Cell, place: [f64; 3]) -> Cell {
    let place = glam::DVec3::from_array(place);
    let near = |cell: &Cell| (cell.as_dvec3() - place).abs().max_element() <= REACH;
    named(data).map(|cell| cell.wrapping_add(by)).filter(near).unwrap_or_else(|| place.floor().as_ivec3())
}

fn named(data: &Compound) -> Option<Cell> {
    let int = |tag: &Tag| if let Tag::Int(n) = *tag { Some(n) } else { None };
    let [x, y, z] = TILE.map(|name| data.get(name).and_then(int));
    match data.get(BLOCK_POS) {
        Some(Tag::IntArray(numbers)) => numbers.as_slice().try_into().ok().map(Cell::from_array),
        _ => Some(Cell::new(x?, y?, z?)),
    }
}

/// Lets data that name a block name `cell`.
pub(super) fn set_block(data: &mut Compound, cell: Cell) {
    for (name, n) in TILE.into_iter().zip(cell.to_array()) {
        data.entry(name.to_owned()).and_modify(|tag| *tag = Tag::Int(n));
    }
    data.entry(BLOCK_POS.to_owned()).and_modify(|tag| *tag = Tag::IntArray(cell.to_array().to_vec()));
}

/// Moves an entity that is then at `place`.
pub(super) fn shift(data: &mut Compound, by: Cell, place: [f64; 3]) {
    let cell = block(data, by, place);
    set_block(data, cell);
}
