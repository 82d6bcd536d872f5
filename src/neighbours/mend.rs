//! Repairs what does not go together. What goes together stays, also where a player would not have got it.

use super::joint::{Joint, bare};
use super::settle;
use crate::block::{self, BlockState, Facing, PaletteFull};
use crate::grid::Grid;
use crate::space::Cell;
use std::fmt;

/// How many blocks were mended, by kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Mended {
    /// Sides of fences, panes, walls, dust and the like.
    pub sides: usize,
    /// Stairs.
    pub corners: usize,
    /// Halves of doors, beds and tall plants.
    pub halves: usize,
    pub chests: usize,
}

impl fmt::Display for Mended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.sides, "block that joins others", "blocks that join others"),
            (self.corners, "corner of stairs", "corners of stairs"),
            (self.halves, "half of a door, bed or plant", "halves of doors, beds or plants"),
            (self.chests, "chest", "chests"),
        ];
        let found = kinds.iter().filter(|(count, ..)| *count > 0);
        let words =
            found.map(|(count, one, many)| format!("{count} {}", if *count == 1 { one } else { many }));
        let words: Vec<String> = words.collect();
        f.write_str(&if words.is_empty() { "nothing to mend".to_owned() } else { words.join(", ") })
    }
}

/// Mends the grid and its variants. What lies beside cells left alone and past the border is not known: sides that
/// face it stay as they are.
pub fn mend(grid: &mut Grid) -> Result<Mended, PaletteFull> {
    let mut mended = Mended::default();
    let mut variants = std::mem::take(&mut grid.variants);
    for grid in variants.iter_mut().chain([&mut *grid]) {
        settle(grid)?;
        mended.halves += halves(grid)?;
        mended.chests += chests(grid)?;
        joints(grid, &mut mended)?;
    }
    grid.variants = variants;
    Ok(mended)
}

/// The cells whose block depends on its neighbours in one of these ways.
fn cells_of(grid: &Grid, joints: &[Joint]) -> Vec<(Cell, Joint)> {
    let of = |state| Joint::of(state).filter(|joint| joints.contains(joint));
    let joints: Vec<Option<Joint>> = grid.palette().states().iter().map(of).collect();
    let cells = grid.bounds().cells().zip(grid.cells());
    cells.filter_map(|(cell, id)| Some((cell, joints[usize::from(*id)]?))).collect()
}

/// What is at `cell`; `None` outside and where the world is left alone.
fn at(grid: &Grid, cell: Cell) -> Option<&BlockState> {
    let inside = grid.bounds().contains(cell).then(|| grid.get(cell));
    inside.filter(|state| state.name() != "minecraft:structure_void")
}

fn put(grid: &mut Grid, cell: Cell, state: &BlockState) -> Result<(), PaletteFull> {
    let id = grid.intern(state)?;
    grid.set(cell, id);
    Ok(())
}

fn facing(state: &BlockState) -> Option<Facing> {
    state.get("facing").and_then(Facing::named)
}

/// Gives halves that stand alone their other half where there is room for it, and takes them away where not; makes
/// halves that belong together say the same.
fn halves(grid: &mut Grid) -> Result<usize, PaletteFull> {
    let mut mended = 0;
    for (cell, _) in cells_of(grid, &[Joint::Door, Joint::Plant, Joint::Bed]) {
        let Some((place, state)) = whole(grid, cell) else { continue };
        if *grid.get(place) != state {
            if place == cell && state.name() != grid.get(cell).name() {
                grid.block_entities.remove(&cell.to_array());
            }
            put(grid, place, &state)?;
            mended += 1;
        }
    }
    Ok(mended)
}

/// What is to stand where, for the half at `cell` to be part of a whole.
fn whole(grid: &Grid, cell: Cell) -> Option<(Cell, BlockState)> {
    let own = grid.get(cell);
    let (step, half) = block::other_half(own)?;
    let other = at(grid, cell + step)?;
    if block::is_other_half(own, other) {
        return Some((cell, agreed(own, other)));
    }
    let placed = block::placed_half(half, other).map(|half| (cell + step, half));
    Some(placed.unwrap_or_else(|| (cell, block::left_behind(own))))
}

/// The lower half of a door knows where it faces and whether it is open, the upper one the rest.
fn agreed(own: &BlockState, other: &BlockState) -> BlockState {
    let keys: &[&str] = match own.get("half") {
        Some("upper") => &["facing", "open"],
        Some("lower") => &["hinge", "powered"],
        _ => &[],
    };
    let others = keys.iter().filter_map(|key| Some((*key, own.get(key).and(other.get(key))?)));
    others.fold(own.clone(), |state, (key, value)| state.with(key, value))
}

/// Halves of chests whose other half is not there become single, or two such become a pair.
fn chests(grid: &mut Grid) -> Result<usize, PaletteFull> {
    let cells = cells_of(grid, &[Joint::Chest]);
    let odd: Vec<Cell> =
        cells.into_iter().map(|(cell, _)| cell).filter(|cell| !is_paired(grid, *cell)).collect();
    for cell in &odd {
        let open = grid.get(*cell).clone().without("type");
        put(grid, *cell, &open)?;
    }
    settle(grid)?;
    Ok(odd.len())
}

/// Whether a chest is single or has its other half, as far as is known.
fn is_paired(grid: &Grid, cell: Cell) -> bool {
    let own = grid.get(cell);
    let Some(facing) = facing(own) else { return true };
    let (side, half) = match own.get("type") {
        Some("left") => (facing.right(), "right"),
        Some("right") => (facing.left(), "left"),
        _ => return true,
    };
    let is_other = |other: &BlockState| {
        other.name() == own.name() && self::facing(other) == Some(facing) && other.get("type") == Some(half)
    };
    at(grid, cell + side.step()).is_none_or(is_other)
}

const JOINTS: [Joint; 9] = [
    Joint::Fence,
    Joint::Pane,
    Joint::Wall,
    Joint::Gate,
    Joint::Stairs,
    Joint::Wire,
    Joint::Tripwire,
    Joint::Chorus,
    Joint::Snowy,
];

fn joints(grid: &mut Grid, mended: &mut Mended) -> Result<(), PaletteFull> {
    let cells = cells_of(grid, &JOINTS);
    let mut asked = grid.clone();
    for (cell, _) in &cells {
        put(&mut asked, *cell, &bare(grid.get(*cell)))?;
    }
    settle(&mut asked)?;
    for (cell, joint) in cells {
        let state = known_part(grid, cell, joint, asked.get(cell));
        if *grid.get(cell) == state || is_dot(grid.get(cell), &state) {
            continue;
        }
        put(grid, cell, &state)?;
        match joint {
            Joint::Stairs => mended.corners += 1,
            _ => mended.sides += 1,
        }
    }
    Ok(())
}

/// What is asked of the block at `cell` as far as it depends on cells that are known.
fn known_part(grid: &Grid, cell: Cell, joint: Joint, asked: &BlockState) -> BlockState {
    let own = grid.get(cell);
    let is_unknown = |side: &Facing| at(grid, cell + side.step()).is_none();
    let unknown = joint.keys().iter().filter(|key| asks(joint, key).iter().any(is_unknown));
    unknown.fold(asked.clone(), |state, key| match own.get(key) {
        Some(value) => state.with(key, value),
        None => state,
    })
}

/// The sides that a property depends on.
fn asks(joint: Joint, key: &str) -> Vec<Facing> {
    let round = Facing::HORIZONTAL.into_iter();
    match (joint, Facing::named(key)) {
        (Joint::Wall, Some(Facing::Up)) => round.chain([Facing::Up]).collect(),
        (Joint::Wall, Some(side)) => vec![side, Facing::Up],
        (_, Some(side)) => vec![side],
        (Joint::Snowy, None) => vec![Facing::Up],
        (_, None) => round.collect(),
    }
}

/// Dust that leads nowhere may be a dot or a cross, as the player likes.
fn is_dot(own: &BlockState, asked: &BlockState) -> bool {
    let all =
        |state: &BlockState, value| Facing::HORIZONTAL.iter().all(|s| state.get(s.name()) == Some(value));
    all(own, "none") && all(asked, "side")
}
