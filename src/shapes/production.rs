//! A building that is grown: shapes put side by side (seed 3, "Production of Similar Structures").

use super::part::{FormId, Parts, Placement};
use crate::space::{Bounds, Cell};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// A shape of a production.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Placed {
    pub form: FormId,
    pub placement: Placement,
    /// Whether it encloses nothing in the example that it comes from.
    pub is_open: bool,
}

/// The places that share a face with one.
pub fn around(cell: Cell) -> impl Iterator<Item = Cell> {
    Cell::AXES.into_iter().flat_map(move |step| [cell - step, cell + step])
}

/// Shapes that stand somewhere, in the order in which they came. Where two hold one place, they agree on its block.
#[derive(Debug)]
pub struct Production<'a> {
    parts: &'a Parts,
    placed: Vec<Placed>,
    /// The number of each shape: how many came before it, whatever has gone since.
    numbers: Vec<usize>,
    pushed: usize,
    there: BTreeSet<(FormId, Placement)>,
    /// The block at each place, and how many shapes hold it.
    cells: FxHashMap<Cell, (u32, u32)>,
}

impl<'a> Production<'a> {
    pub fn new(parts: &'a Parts) -> Production<'a> {
        Production {
            parts,
            placed: Vec::new(),
            numbers: Vec::new(),
            pushed: 0,
            there: BTreeSet::new(),
            cells: FxHashMap::default(),
        }
    }

    pub fn parts(&self) -> &'a Parts {
        self.parts
    }

    pub fn placed(&self) -> &[Placed] {
        &self.placed
    }

    /// How many shapes came before one of those that are there.
    pub fn number(&self, index: usize) -> usize {
        self.numbers[index]
    }

    /// Where the shape of a number is among those that are there.
    pub fn index(&self, number: usize) -> Option<usize> {
        self.numbers.binary_search(&number).ok()
    }

    /// The number of blocks.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// The block at a place.
    pub fn at(&self, cell: Cell) -> Option<u32> {
        self.cells.get(&cell).map(|(state, _)| *state)
    }

    pub fn is_free(&self, cell: Cell) -> bool {
        !self.cells.contains_key(&cell)
    }

    /// The box around all shapes; `None` of nothing.
    pub fn extent(&self) -> Option<Bounds> {
        Bounds::around(self.cells.keys().copied())
    }

    /// The blocks of one of the shapes.
    pub fn blocks(&self, placed: &Placed) -> impl Iterator<Item = (Cell, u32)> + use<'a> {
        self.parts.blocks(placed.form, placed.placement)
    }

    /// Whether a shape can stand there: it adds a block, changes none, and leaves room for the other halves of doors, beds and
    /// tall plants.
    pub fn fits(&self, placed: &Placed) -> bool {
        !self.there.contains(&(placed.form, placed.placement))
            && self.blocks(placed).all(|(cell, state)| self.may_be(cell, state))
            && self.blocks(placed).any(|(cell, _)| self.is_free(cell))
    }

    fn may_be(&self, cell: Cell, state: u32) -> bool {
        match self.at(cell) {
            Some(other) => other == state,
            None => {
                self.has_room(cell, state) && around(cell).all(|beside| self.leaves_room(beside, cell, state))
            }
        }
    }

    /// Whether nothing but its other half is where a half needs it.
    fn has_room(&self, cell: Cell, state: u32) -> bool {
        let states = &self.parts.states;
        let place = states.step_to_other_half(state).and_then(|step| self.at(cell + step));
        place.is_none_or(|other| states.are_halves(state, other))
    }

    /// Whether the block at `beside`, if it is a half, has not its other half at `cell`, or `state` is that.
    fn leaves_room(&self, beside: Cell, cell: Cell, state: u32) -> bool {
        let states = &self.parts.states;
        let half = self.at(beside).filter(|half| states.step_to_other_half(*half) == Some(cell - beside));
        half.is_none_or(|half| states.are_halves(half, state))
    }

    pub fn push(&mut self, placed: Placed) {
        for (cell, state) in self.blocks(&placed) {
            self.cells.entry(cell).or_insert((state, 0)).1 += 1;
        }
        self.there.insert((placed.form, placed.placement));
        self.placed.push(placed);
        self.numbers.push(self.pushed);
        self.pushed += 1;
    }

    /// Takes back the last shape, and its number.
    pub fn pop(&mut self) -> Option<Placed> {
        let last = self.placed.len().checked_sub(1)?;
        self.pushed = self.numbers[last];
        Some(self.remove(last))
    }

    pub fn remove(&mut self, index: usize) -> Placed {
        let placed = self.placed.remove(index);
        self.numbers.remove(index);
        self.there.remove(&(placed.form, placed.placement));
        for (cell, _) in self.blocks(&placed) {
            let held = self.cells.get_mut(&cell).expect("what was put there is there");
            held.1 -= 1;
            if held.1 == 0 {
                self.cells.remove(&cell);
            }
        }
        placed
    }
}
