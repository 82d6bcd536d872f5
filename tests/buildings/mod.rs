//! What a building must have to be used in the game: whole doors with room before them, nothing in the air.

use std::collections::HashSet;
use vox::block::{BlockState, Facing, Shape, shape};
use vox::grid::Grid;
use vox::space::Cell;

/// The block of a cell; outside of the grid there is none.
fn block(grid: &Grid, cell: Cell) -> Option<&BlockState> {
    grid.bounds().contains(cell).then(|| grid.get(cell))
}

fn is_door(state: &BlockState) -> bool {
    matches!(shape(state), Shape::Door(_))
}

fn facing(state: &BlockState) -> Option<Facing> {
    Facing::named(state.get("facing")?)
}

/// The cells whose block is of a kind. It is asked once for each block state of the grid.
fn cells_of(grid: &Grid, is_kind: impl Fn(&BlockState) -> bool) -> impl Iterator<Item = Cell> {
    let states: Vec<bool> = grid.palette().states().iter().map(is_kind).collect();
    grid.bounds().cells().filter(move |&cell| states[usize::from(grid.id(cell))])
}

fn lower_halves(grid: &Grid) -> impl Iterator<Item = Cell> {
    cells_of(grid, |state| is_door(state) && state.get("half") == Some("lower"))
}

pub fn doors(grid: &Grid) -> usize {
    lower_halves(grid).count()
}

/// Halves of doors without the other one, which has to be equal but for its half.
pub fn half_doors(grid: &Grid) -> Vec<Cell> {
    let is_half = |cell: &Cell| {
        let state = grid.get(*cell);
        let (step, other) = match state.get("half") {
            Some("lower") => (Cell::Y, "upper"),
            _ => (-Cell::Y, "lower"),
        };
        block(grid, *cell + step) != Some(&state.clone().with("half", other))
    };
    cells_of(grid, is_door).filter(is_half).collect()
}

/// Doors that stand on nothing, or that one cannot walk up to from both sides at full height.
pub fn blocked_doors(grid: &Grid) -> Vec<Cell> {
    let is_blocked = |cell: &Cell| {
        let has_floor = block(grid, *cell - Cell::Y).is_some_and(|below| shape(below) == Shape::Full);
        let is_reachable = facing(grid.get(*cell)).is_some_and(|inwards| {
            is_passable(grid, *cell + inwards.step()) && is_passable(grid, *cell - inwards.step())
        });
        !(has_floor && is_reachable)
    };
    lower_halves(grid).filter(is_blocked).collect()
}

/// Room for a head, and for feet that may climb stairs or a slab.
fn is_passable(grid: &Grid, cell: Cell) -> bool {
    let at = |cell| block(grid, cell).map_or(Shape::Air, shape);
    at(cell + Cell::Y) == Shape::Air && matches!(at(cell), Shape::Air | Shape::Stairs { .. } | Shape::Slab(_))
}

/// Blocks that no chain of blocks, touching at least at an edge, joins to the lowest layer.
pub fn floating(grid: &Grid) -> Vec<Cell> {
    let bounds = grid.bounds();
    let size = bounds.size();
    let index = |cell: Cell| (cell.x + size.x * (cell.z + size.z * cell.y)) as usize;
    let mut is_loose = vec![false; bounds.volume() as usize];
    cells_of(grid, |state| !state.is_air()).for_each(|cell| is_loose[index(cell)] = true);
    let mut open: Vec<Cell> = bounds.cells().filter(|cell| cell.y == 0).collect();
    while let Some(cell) = open.pop() {
        if std::mem::take(&mut is_loose[index(cell)]) {
            open.extend(touching(cell).filter(|near| bounds.contains(*near) && is_loose[index(*near)]));
        }
    }
    bounds.cells().filter(|cell| is_loose[index(*cell)]).collect()
}

/// The 18 cells that share a face or an edge with a cell.
fn touching(cell: Cell) -> impl Iterator<Item = Cell> {
    let steps = (0..27).map(|n| Cell::new(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
    steps.filter(|step| matches!(step.abs().element_sum(), 1 | 2)).map(move |step| cell + step)
}

/// Ladders, wall torches and lanterns whose wall, or ceiling, is missing, and plants without soil.
pub fn unsupported(grid: &Grid) -> Vec<Cell> {
    let is_held = |cell: &Cell| {
        let step = support(grid.get(*cell)).unwrap_or_default();
        block(grid, *cell + step).is_some_and(|holder| shape(holder) == Shape::Full)
    };
    cells_of(grid, |state| support(state).is_some()).filter(|cell| !is_held(cell)).collect()
}

/// The step to the block that a block hangs on or stands on.
fn support(state: &BlockState) -> Option<Cell> {
    match state.short_name() {
        "ladder" | "wall_torch" => Some(-facing(state)?.step()),
        "lantern" if state.get("hanging") == Some("true") => Some(Cell::Y),
        "poppy" | "cornflower" | "lantern" | "campfire" => Some(-Cell::Y),
        _ => None,
    }
}

/// Halves of beds whose other half is missing.
pub fn half_beds(grid: &Grid) -> Vec<Cell> {
    let is_half = |cell: &Cell| {
        let state = grid.get(*cell);
        let towards_head = facing(state).map_or(Cell::ZERO, Facing::step);
        let (step, other) = match state.get("part") {
            Some("foot") => (towards_head, "head"),
            _ => (-towards_head, "foot"),
        };
        block(grid, *cell + step) != Some(&state.clone().with("part", other))
    };
    cells_of(grid, |state| state.short_name().ends_with("_bed")).filter(is_half).collect()
}

/// Furniture that the air outside reaches without passing a block: the room it stands in has a hole.
pub fn exposed(grid: &Grid) -> Vec<Cell> {
    let outside = outside(grid);
    let near_outside = |cell: &Cell| Facing::ALL.iter().any(|side| outside.contains(&(*cell + side.step())));
    cells_of(grid, is_furniture).filter(near_outside).collect()
}

fn is_furniture(state: &BlockState) -> bool {
    let name = state.short_name();
    name.ends_with("_bed")
        || matches!(name, "furnace" | "crafting_table" | "wall_torch" | "ladder" | "bookshelf")
}

/// The cells of air that are joined by their faces to the sides or the top of the grid.
fn outside(grid: &Grid) -> HashSet<Cell> {
    let bounds = grid.bounds();
    let last = bounds.max - Cell::ONE;
    let is_rim = |cell: &Cell| {
        cell.y == last.y || [0, 2].iter().any(|&axis| cell[axis] == 0 || cell[axis] == last[axis])
    };
    let mut open: Vec<Cell> = bounds.cells().filter(is_rim).collect();
    let mut outside = HashSet::new();
    while let Some(cell) = open.pop() {
        if grid.get(cell).is_air() && outside.insert(cell) {
            open.extend(
                Facing::ALL.map(|side| cell + side.step()).into_iter().filter(|near| bounds.contains(*near)),
            );
        }
    }
    outside
}
