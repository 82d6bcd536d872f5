//! The adjacency constraint: blocks stand beside one another only as they do in an example (seed 3, "Shape Grammar
//! Induction": r-similarity, here of 2x2x2 blocks).

use super::part::{Parts, Placement};
use super::production::Production;
use crate::grid::Grid;
use crate::space::{Bounds, Cell, Turn};
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// What stands below a building.
const GROUND: u32 = u32::MAX;

/// Two blocks by two by two, by state; none for air.
type Around = [Option<u32>; 8];

/// The neighbourhoods of the examples, in each of the four turns.
#[derive(Debug)]
pub struct Seen {
    whole: FxHashSet<Around>,
    /// By which of the eight places are looked at, as bits: the neighbourhoods with all other places free. Made when they are
    /// asked for.
    in_part: [OnceLock<FxHashSet<Around>>; 256],
}

impl Default for Seen {
    fn default() -> Seen {
        Seen { whole: FxHashSet::default(), in_part: std::array::from_fn(|_| OnceLock::new()) }
    }
}

pub const CORNERS: Bounds = Bounds { min: Cell::ZERO, max: Cell::splat(2) };

fn around(low: Cell, at: impl Fn(Cell) -> Option<u32>) -> Around {
    let mut around = [None; 8];
    CORNERS.cells().zip(&mut around).for_each(|(step, state)| *state = at(low + step));
    around
}

/// The low corners of all neighbourhoods that hold one of the cells.
fn lows(cells: impl Iterator<Item = Cell>) -> impl Iterator<Item = [i32; 3]> {
    cells.flat_map(|cell| CORNERS.cells().map(move |step| (cell - step).to_array()))
}

impl Seen {
    /// Enters the neighbourhoods of an example, those at its border included: around it is air, and below it the ground.
    pub fn enter(&mut self, parts: &Parts, grid: &Grid) {
        let states: Vec<Option<u32>> = {
            let states = grid.palette().states().iter();
            states.map(|state| if state.is_nothing() { None } else { parts.states.known(state) }).collect()
        };
        let at = |cell: Cell| match grid.bounds().contains(cell) {
            true => states[usize::from(grid.id(cell))],
            false => (cell.y < 0).then_some(GROUND),
        };
        let lows = Bounds::new(Cell::splat(-1), grid.size());
        for turn in Turn::ALL {
            let back = Placement { turn: turn.inverse(), offset: [0; 3] };
            for low in lows.cells() {
                let turned_state =
                    |state| if state == GROUND { state } else { parts.states.turned(state, turn) };
                let turned = |cell: Cell| at(low + back.apply(cell)).map(turned_state);
                // The corners of a turned box: its low corner is elsewhere.
                let corner =
                    CORNERS.cells().map(|step| turn.apply(step)).reduce(Cell::min).unwrap_or_default();
                self.whole.insert(around(corner, turned));
            }
        }
    }

    /// Whether every neighbourhood that holds one of the cells can become one of an example when what is free in it is filled.
    pub fn may_become(&self, production: &Production<'_>, cells: impl Iterator<Item = Cell>) -> bool {
        let lows: BTreeSet<[i32; 3]> = lows(cells).collect();
        lows.into_iter().all(|low| self.is_part(&around(Cell::from_array(low), |cell| production.at(cell))))
    }

    fn is_part(&self, part: &Around) -> bool {
        let places = part.iter().enumerate().filter(|(_, state)| state.is_some());
        let bits = places.fold(0, |bits, (place, _)| bits | 1 << place);
        let in_part = self.in_part[bits].get_or_init(|| {
            let masked =
                |whole: &Around| std::array::from_fn(|place| whole[place].filter(|_| bits >> place & 1 == 1));
            self.whole.iter().map(masked).collect()
        });
        in_part.contains(part)
    }

    /// The low corners of neighbourhoods of a production that no example shows.
    pub fn unseen(&self, production: &Production<'_>) -> BTreeSet<[i32; 3]> {
        let held = production.placed().iter().flat_map(|placed| production.blocks(placed));
        self.unseen_near(production, held.map(|(cell, _)| cell))
    }

    /// Those among them that hold one of the given cells.
    pub fn unseen_near(
        &self,
        production: &Production<'_>,
        cells: impl Iterator<Item = Cell>,
    ) -> BTreeSet<[i32; 3]> {
        let ground = production.extent().map_or(0, |extent| extent.min.y);
        let at = |cell: Cell| if cell.y < ground { Some(GROUND) } else { production.at(cell) };
        let lows: BTreeSet<[i32; 3]> = lows(cells).collect();
        let is_unseen = |low: &[i32; 3]| !self.whole.contains(&around(Cell::from_array(*low), at));
        lows.into_iter().filter(is_unseen).collect()
    }
}
