//! Whether a building with swaps still holds together, and looks like the examples once all blocks stand.

use super::Swap;
use crate::block::{self, Shape};
use crate::grid::{Grid, Neighbours, components, floating, reached_from_outside};
use crate::infer::example::{Example, Terminal, Terminals};
use crate::infer::neighbourhood::{Place, Seen, bordered, corners, corners_around, neighbourhood, place};
use crate::neighbours::settle;
use crate::space::{Bounds, Cell};
use ndarray::Array3;
use std::collections::BTreeSet;

/// How far from a swap blocks can have a say in how those near it stand.
const AROUND: i32 = 5;

/// What the examples show once their neighbours have decided how blocks stand.
#[derive(Debug)]
pub struct Settled {
    terminals: Terminals,
    seen: Seen,
}

impl Settled {
    pub fn by<'a>(examples: impl IntoIterator<Item = &'a Example>) -> Settled {
        let mut terminals = Terminals::default();
        let grids = examples.into_iter().filter_map(|example| example.clone().into_grid());
        let cells: Vec<Array3<u32>> = grids.filter_map(|grid| settled(grid, &mut terminals)).collect();
        Settled { seen: Seen::of(&cells), terminals }
    }

    /// Whether an example with swaps shows nothing around them that no example shows. `states` are those of the
    /// terminals of the swaps.
    pub fn shows(&mut self, example: &Grid, states: &[Terminal], swaps: &[&Swap]) -> bool {
        let all = swaps.iter().map(|swap| swap.bounds()).reduce(|all, next| all.union(&next));
        let Some(all) = all else { return true };
        let part = Bounds::new(all.min - Cell::splat(AROUND), all.max + Cell::splat(AROUND));
        let part = part.intersect(&example.bounds());
        let swapped = swapped(example.cropped(part), part.min, states, swaps);
        let Some(cells) = swapped.and_then(|grid| settled(grid, &mut self.terminals)) else { return false };
        let cells_of = swaps.iter().flat_map(|swap| swap.cells());
        // A block stands as those beside it ask for, so that one more cell around may change.
        let corners = cells_of.flat_map(|(cell, _)| corners_around(place(cell - part.min)));
        let around: BTreeSet<Place> = corners.flat_map(|corner| near(corner, cells.dim())).collect();
        around.into_iter().all(|corner| self.seen.contains(&neighbourhood(&cells, corner)))
    }

    /// Whether a building shows nothing that no example shows.
    pub fn shows_all(&mut self, building: Grid) -> bool {
        let cells = settled(building, &mut self.terminals);
        cells.is_some_and(|cells| {
            corners(cells.dim()).all(|corner| self.seen.contains(&neighbourhood(&cells, corner)))
        })
    }
}

/// The array of a grid once its blocks stand as their neighbours ask for, with a border; `None` if its palette has no
/// room for that.
fn settled(mut grid: Grid, terminals: &mut Terminals) -> Option<Array3<u32>> {
    settle(&mut grid).ok()?;
    Some(bordered(&Example::Blocks(grid).cells(terminals)?))
}

/// A part of an example that begins at `low`, with swaps.
fn swapped(mut part: Grid, low: Cell, states: &[Terminal], swaps: &[&Swap]) -> Option<Grid> {
    for (cell, terminal) in swaps.iter().flat_map(|swap| swap.cells()) {
        let Terminal::Block(state) = &states[terminal as usize] else { return None };
        let id = part.intern(state).ok()?;
        part.set(cell - low, id);
    }
    Some(part)
}

/// The corners of neighbourhoods next to one, and itself.
fn near(corner: Place, (ys, zs, xs): (usize, usize, usize)) -> Vec<Place> {
    let ends = [ys, zs, xs].map(|len| len - 2);
    let range = |axis: usize| corner[axis].saturating_sub(1)..=(corner[axis] + 1).min(ends[axis]);
    range(0).flat_map(|y| range(1).flat_map(move |z| range(2).map(move |x| [y, z, x]))).collect()
}

/// What stands of an example whichever swaps are made, and what is open whichever are.
#[derive(Clone, Debug)]
pub struct Standing {
    always_solid: Array3<bool>,
    /// The pieces of that which float.
    floating: usize,
    ever_open: Array3<bool>,
    /// Air that is not reached from outside.
    indoors: Array3<bool>,
}

impl Standing {
    /// Of an example with a border, which is open. `is_nothing` is by terminal.
    pub fn new(cells: &Array3<u32>, is_nothing: &[bool]) -> Standing {
        let is_open = cells.mapv(|terminal| is_nothing.get(terminal as usize).copied().unwrap_or(true));
        let always_solid = is_open.mapv(|open| !open);
        let reached = reached_from_outside(&is_open, Neighbours::Faces);
        let mut indoors = is_open.clone();
        indoors.zip_mut_with(&reached, |indoors, reached| *indoors &= !reached);
        Standing { floating: floating(&always_solid), always_solid, ever_open: is_open, indoors }
    }

    /// With one more swap that may be made; `None` if something could then float, or a room would lie open.
    pub fn with(&self, swap: &Swap, is_nothing: &[bool]) -> Option<Standing> {
        let mut next = self.clone();
        for (place, terminal) in &swap.0 {
            let is_open = is_nothing[*terminal as usize];
            next.always_solid[*place] &= !is_open;
            next.ever_open[*place] |= is_open;
        }
        let reached = reached_from_outside(&next.ever_open, Neighbours::Faces);
        let lets_in = next.indoors.iter().zip(&reached).any(|(indoors, reached)| *indoors && *reached);
        next.floating = floating(&next.always_solid);
        let floats = next.floating.max(floating(&next.with_blocks_of(swap, is_nothing)));
        (!lets_in && floats <= self.floating).then_some(next)
    }

    /// What stands whichever other swaps are made.
    fn with_blocks_of(&self, swap: &Swap, is_nothing: &[bool]) -> Array3<bool> {
        let mut solid = self.always_solid.clone();
        swap.0.iter().for_each(|(place, terminal)| solid[*place] |= !is_nothing[*terminal as usize]);
        solid
    }
}

/// What tells whether a building is as sound as another one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Frame {
    floating: usize,
    /// How many pieces of air there are that are not reached from outside while all doors are shut.
    rooms: u32,
    /// How many cells of doors and of beds there are.
    fixtures: [usize; 2],
}

impl Frame {
    /// Of a building with a border, which is open. `is_nothing` is by terminal.
    pub fn of(cells: &Array3<u32>, is_nothing: &[bool], states: &[Terminal]) -> Frame {
        let standing = Standing::new(cells, is_nothing);
        let rooms = components(&standing.indoors, Neighbours::Faces).iter().max().copied().unwrap_or(0);
        let shapes: Vec<Option<Shape>> = states.iter().map(shape).collect();
        let count = |is: fn(Shape) -> bool| {
            let shapes = cells.iter().filter_map(|terminal| *shapes.get(*terminal as usize)?);
            shapes.filter(|shape| is(*shape)).count()
        };
        Frame { floating: standing.floating, rooms, fixtures: FIXTURES.map(count) }
    }

    /// Whether it has as many rooms, doors and beds, and floats no more.
    pub fn is_as_sound_as(&self, other: &Frame) -> bool {
        self.rooms == other.rooms && self.fixtures == other.fixtures && self.floating <= other.floating
    }
}

/// What a house has to have as often as the examples.
const FIXTURES: [fn(Shape) -> bool; 2] =
    [|shape| matches!(shape, Shape::Door(_)), |shape| matches!(shape, Shape::Bed(_))];

/// Whether as many doors and beds stand in an example with a swap as without it.
pub fn keeps_fixtures(cells: &Array3<u32>, swap: &Swap, states: &[Terminal]) -> bool {
    FIXTURES.into_iter().all(|is| {
        let (before, after): (Vec<bool>, Vec<bool>) =
            changes(cells, swap, states).map(|(old, new)| (old.is_some_and(is), new.is_some_and(is))).unzip();
        before.iter().filter(|is| **is).count() == after.iter().filter(|is| **is).count()
    })
}

/// Whether a swap puts no block that fills its cell where nothing stands, and leaves nothing where one stands.
pub fn keeps_body(cells: &Array3<u32>, swap: &Swap, states: &[Terminal]) -> bool {
    let (full, air) = (Some(Shape::Full), Some(Shape::Air));
    changes(cells, swap, states).all(|change| change != (full, air) && change != (air, full))
}

fn shape(terminal: &Terminal) -> Option<Shape> {
    match terminal {
        Terminal::Block(state) if state.is_nothing() => Some(Shape::Air),
        Terminal::Block(state) => Some(block::shape(state)),
        Terminal::Label(_) => None,
    }
}

/// The shapes of what stands in the cells of a swap without it and with it.
fn changes<'a>(
    cells: &'a Array3<u32>,
    swap: &'a Swap,
    states: &'a [Terminal],
) -> impl Iterator<Item = (Option<Shape>, Option<Shape>)> + 'a {
    let shape = |terminal: u32| shape(&states[terminal as usize]);
    swap.0.iter().map(move |(place, terminal)| (shape(cells[*place]), shape(*terminal)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::infer::neighbourhood::bordered;

    const IS_NOTHING: [bool; 2] = [true, false];

    fn swap(place: Place, terminal: u32) -> Swap {
        Swap::new(vec![(place, terminal)])
    }

    #[test]
    fn what_holds_others_up_stays() {
        let post = bordered(&Array3::from_elem((3, 1, 1), 1));
        let standing = Standing::new(&post, &IS_NOTHING);
        assert!(standing.with(&swap([2, 1, 1], 0), &IS_NOTHING).is_none());
        assert!(standing.with(&swap([3, 1, 1], 0), &IS_NOTHING).is_some());
    }

    #[test]
    fn of_two_posts_that_can_go_alone_one_stays() {
        // The ground goes on beside it.
        let table = Array3::from_shape_vec((2, 1, 5), vec![1, 0, 1, 0, 1, 1, 1, 1, 0, 0]).unwrap();
        let standing = Standing::new(&bordered(&table), &IS_NOTHING);
        let without_one = standing.with(&swap([1, 1, 1], 0), &IS_NOTHING).unwrap();
        assert!(without_one.with(&swap([1, 1, 3], 0), &IS_NOTHING).is_none());
    }

    #[test]
    fn rooms_stay_closed() {
        let mut room = Array3::from_elem((3, 3, 3), 1);
        room[[1, 1, 1]] = 0;
        let standing = Standing::new(&bordered(&room), &IS_NOTHING);
        assert!(standing.with(&swap([2, 1, 2], 0), &IS_NOTHING).is_none(), "a wall");
        assert!(standing.with(&swap([1, 1, 1], 0), &IS_NOTHING).is_some(), "a corner");
    }
}
