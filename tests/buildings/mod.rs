//! What a building must have to be used in the game: whole doors with room before them, nothing in the air.

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

fn is_half(state: &BlockState, half: &str) -> bool {
    is_door(state) && state.get("half") == Some(half)
}

fn facing(state: &BlockState) -> Option<Facing> {
    Facing::named(state.get("facing")?)
}

fn cells_with(grid: &Grid, wanted: impl Fn(Cell, &BlockState) -> bool) -> Vec<Cell> {
    grid.bounds().cells().filter(|&cell| wanted(cell, grid.get(cell))).collect()
}

pub fn doors(grid: &Grid) -> usize {
    cells_with(grid, |_, state| is_half(state, "lower")).len()
}

/// Halves of doors without the other one, which has to be equal but for its half.
pub fn half_doors(grid: &Grid) -> Vec<Cell> {
    cells_with(grid, |cell, state| {
        let (step, other) = if is_half(state, "lower") { (Cell::Y, "upper") } else { (-Cell::Y, "lower") };
        is_door(state) && block(grid, cell + step) != Some(&state.clone().with("half", other))
    })
}

/// Doors that stand on nothing, or that one cannot walk up to from both sides at full height.
pub fn blocked_doors(grid: &Grid) -> Vec<Cell> {
    cells_with(grid, |cell, state| {
        is_half(state, "lower")
            && !(block(grid, cell - Cell::Y).is_some_and(|below| shape(below) == Shape::Full)
                && facing(state).is_some_and(|inwards| {
                    is_passable(grid, cell + inwards.step()) && is_passable(grid, cell - inwards.step())
                }))
    })
}

/// Room for a head, and for feet that may climb stairs or a slab.
fn is_passable(grid: &Grid, cell: Cell) -> bool {
    let at = |cell| block(grid, cell).map_or(Shape::Air, shape);
    at(cell + Cell::Y) == Shape::Air && matches!(at(cell), Shape::Air | Shape::Stairs { .. } | Shape::Slab(_))
}

/// Blocks that no chain of blocks, touching at least at an edge, joins to the lowest layer.
pub fn floating(grid: &Grid) -> Vec<Cell> {
    let bounds = grid.bounds();
    let index = |cell: Cell| (cell.x + bounds.size().x * (cell.z + bounds.size().z * cell.y)) as usize;
    let mut is_joined = vec![false; bounds.volume() as usize];
    let mut open = cells_with(grid, |cell, state| cell.y == 0 && !state.is_air());
    open.iter().for_each(|&cell| is_joined[index(cell)] = true);
    while let Some(cell) = open.pop() {
        for near in touching(cell).filter(|near| bounds.contains(*near)) {
            if !is_joined[index(near)] && !grid.get(near).is_air() {
                is_joined[index(near)] = true;
                open.push(near);
            }
        }
    }
    cells_with(grid, |cell, state| !state.is_air() && !is_joined[index(cell)])
}

/// The 18 cells that share a face or an edge with a cell.
fn touching(cell: Cell) -> impl Iterator<Item = Cell> {
    let steps = (0..27).map(|n| Cell::new(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
    steps.filter(|step| matches!(step.abs().element_sum(), 1 | 2)).map(move |step| cell + step)
}

/// Ladders, wall torches and lanterns whose wall, or ceiling, is missing, and plants without soil.
pub fn unsupported(grid: &Grid) -> Vec<Cell> {
    cells_with(grid, |cell, state| {
        support(state).is_some_and(|step| {
            !block(grid, cell + step).is_some_and(|held_by| {
                shape(held_by) == Shape::Full || held_by.short_name().ends_with("_leaves")
            })
        })
    })
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
pub fn missing_halves(grid: &Grid) -> Vec<Cell> {
    cells_with(grid, |cell, state| {
        let Some(part) = state.get("part").filter(|_| state.short_name().ends_with("_bed")) else {
            return false;
        };
        let (sign, other) = if part == "foot" { (1, "head") } else { (-1, "foot") };
        let step = facing(state).map_or(Cell::ZERO, Facing::step) * sign;
        block(grid, cell + step) != Some(&state.clone().with("part", other))
    })
}
