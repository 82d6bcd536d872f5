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

/// What was mended, and what was not for want of knowledge.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Mending {
    pub mended: Mended,
    /// Blocks that depend on what lies past the border, or in cells left alone.
    pub border: Places,
    /// Blocks that nothing is known of.
    pub unknown: Places,
}

/// How many places there are, and the first of them.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Places {
    pub count: usize,
    pub first: Vec<Cell>,
}

impl Places {
    fn add(&mut self, cell: Cell) {
        const SHOWN: usize = 3;
        self.count += 1;
        if self.first.len() < SHOWN {
            self.first.push(cell);
        }
    }
}

/// Mends the grid and its variants. What lies beside cells left alone and past the border is not known: sides that
/// face it stay as they are.
pub fn mend(grid: &mut Grid) -> Result<Mending, PaletteFull> {
    let mut mending = Mending::default();
    let mut variants = std::mem::take(&mut grid.variants);
    for grid in variants.iter_mut().chain([&mut *grid]) {
        settle(grid)?;
        halves(grid, &mut mending)?;
        chests(grid, &mut mending)?;
        joints(grid, &mut mending)?;
        unknown(grid).into_iter().for_each(|cell| mending.unknown.add(cell));
    }
    grid.variants = variants;
    Ok(mending)
}

/// The cells of blocks that nothing is known of.
fn unknown(grid: &Grid) -> Vec<Cell> {
    let states = grid.palette().states().iter();
    let is_unknown: Vec<bool> = states.map(|state| block::known(state.name()).is_none()).collect();
    if !is_unknown.contains(&true) {
        return Vec::new();
    }
    let cells = grid.bounds().cells().zip(grid.cells());
    cells.filter(|(_, id)| is_unknown[usize::from(**id)]).map(|(cell, _)| cell).collect()
}

/// The cells whose block depends on its neighbours in one of these ways.
pub(super) fn cells_of(grid: &Grid, joints: &[Joint]) -> Vec<(Cell, Joint)> {
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

pub(super) fn put(grid: &mut Grid, cell: Cell, state: &BlockState) -> Result<(), PaletteFull> {
    let id = grid.intern(state)?;
    grid.set(cell, id);
    Ok(())
}

fn facing(state: &BlockState) -> Option<Facing> {
    state.get("facing").and_then(Facing::named)
}

/// Gives halves that stand alone their other half where there is room for it, and takes them away where not; makes
/// halves that belong together say the same.
fn halves(grid: &mut Grid, mending: &mut Mending) -> Result<(), PaletteFull> {
    for (cell, _) in cells_of(grid, &[Joint::Door, Joint::Plant, Joint::Bed]) {
        let Some((place, state)) = whole(grid, cell) else {
            if block::other_half(grid.get(cell)).is_some() {
                mending.border.add(cell);
            }
            continue;
        };
        if *grid.get(place) != state {
            if place == cell && state.name() != grid.get(cell).name() {
                grid.block_entities.remove(&cell.to_array());
            }
            put(grid, place, &state)?;
            mending.mended.halves += 1;
        }
    }
    Ok(())
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
fn chests(grid: &mut Grid, mending: &mut Mending) -> Result<(), PaletteFull> {
    let mut odd = Vec::new();
    for (cell, _) in cells_of(grid, &[Joint::Chest]) {
        match is_paired(grid, cell) {
            Some(true) => {}
            Some(false) => odd.push(cell),
            None => mending.border.add(cell),
        }
    }
    for cell in &odd {
        let open = grid.get(*cell).clone().without("type");
        put(grid, *cell, &open)?;
    }
    mending.mended.chests += odd.len();
    settle(grid)
}

/// Whether a chest is single or has its other half; `None` where that is not known.
fn is_paired(grid: &Grid, cell: Cell) -> Option<bool> {
    let own = grid.get(cell);
    let Some(facing) = facing(own) else { return Some(true) };
    let (side, half) = match own.get("type") {
        Some("left") => (facing.right(), "right"),
        Some("right") => (facing.left(), "left"),
        _ => return Some(true),
    };
    let is_other = |other: &BlockState| {
        other.name() == own.name() && self::facing(other) == Some(facing) && other.get("type") == Some(half)
    };
    at(grid, cell + side.step()).map(is_other)
}

/// What one block can be asked for by itself.
pub(super) const JOINTS: [Joint; 9] = [
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

fn joints(grid: &mut Grid, mending: &mut Mending) -> Result<(), PaletteFull> {
    let cells = cells_of(grid, &JOINTS);
    let asked = asked(grid, &cells)?;
    for (cell, joint) in cells {
        let state = known_part(grid, cell, joint, asked.get(cell));
        if state != *asked.get(cell) && !is_dot(&state, asked.get(cell)) {
            mending.border.add(cell);
        }
        if *grid.get(cell) == state || is_dot(grid.get(cell), &state) {
            continue;
        }
        put(grid, cell, &state)?;
        match joint {
            Joint::Stairs => mending.mended.corners += 1,
            _ => mending.mended.sides += 1,
        }
    }
    Ok(())
}

/// The grid with what neighbours ask of these cells, whatever is written there.
pub(super) fn asked(grid: &Grid, cells: &[(Cell, Joint)]) -> Result<Grid, PaletteFull> {
    let mut asked = grid.clone();
    for (cell, _) in cells {
        put(&mut asked, *cell, &bare(grid.get(*cell)))?;
    }
    settle(&mut asked)?;
    Ok(asked)
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
