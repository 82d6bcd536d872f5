//! Shapes as things that can be put elsewhere: which match, and where each stands (seed 3, "Definitions").

use super::building::Building;
use super::layer::Layer;
use super::shape::Shape;
use crate::block::{BlockState, is_other_half, other_half};
use crate::grid::Grid;
use crate::space::{Cell, Turn};
use std::collections::BTreeMap;

/// A place and a way to stand there: turned about the origin, then moved (seed 3, equation 1).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Placement {
    pub turn: Turn,
    /// x, y, z.
    pub offset: [i32; 3],
}

impl Placement {
    pub fn apply(self, cell: Cell) -> Cell {
        self.turn.apply(cell) + Cell::from_array(self.offset)
    }

    /// First `inner`, then this.
    pub fn after(self, inner: Placement) -> Placement {
        let offset = self.apply(Cell::from_array(inner.offset)).to_array();
        Placement { turn: self.turn + inner.turn, offset }
    }

    pub fn inverse(self) -> Placement {
        let turn = self.turn.inverse();
        Placement { turn, offset: (-turn.apply(Cell::from_array(self.offset))).to_array() }
    }
}

/// The block states of all examples, each with a number.
#[derive(Debug, Default)]
pub struct States {
    list: Vec<BlockState>,
    numbers: BTreeMap<BlockState, u32>,
    /// The number of each state after each turn.
    turned: Vec<[u32; 4]>,
    /// The step from each half of a door, a bed or a tall plant to its other half.
    steps: Vec<Option<Cell>>,
}

impl States {
    /// The number of a state; those that it becomes when it is turned are numbered with it.
    pub fn number(&mut self, state: &BlockState) -> u32 {
        if let Some(number) = self.numbers.get(state) {
            return *number;
        }
        let states = Turn::ALL.map(|turn| state.turned(turn));
        let numbers = states.map(|state| self.enter(state));
        for (quarters, number) in numbers.into_iter().enumerate() {
            self.turned[number as usize] = std::array::from_fn(|turn| numbers[(quarters + turn) % 4]);
        }
        numbers[0]
    }

    fn enter(&mut self, state: BlockState) -> u32 {
        let next = self.list.len() as u32;
        if let Some(number) = self.numbers.get(&state) {
            return *number;
        }
        self.list.push(state.clone());
        self.turned.push([next; 4]);
        self.steps.push(other_half(&state).map(|(step, _)| step));
        self.numbers.insert(state, next);
        next
    }

    /// The number of a state that has one.
    pub fn known(&self, state: &BlockState) -> Option<u32> {
        self.numbers.get(state).copied()
    }

    pub fn get(&self, number: u32) -> &BlockState {
        &self.list[number as usize]
    }

    /// Where the other half of a state belongs, if it is a half of something.
    pub fn step_to_other_half(&self, number: u32) -> Option<Cell> {
        self.steps[number as usize]
    }

    pub fn are_halves(&self, one: u32, other: u32) -> bool {
        is_other_half(self.get(one), self.get(other))
    }

    pub fn turned(&self, number: u32, turn: Turn) -> u32 {
        self.turned[number as usize][usize::from(turn.count())]
    }
}

/// What matching shapes have in common: blocks and where they are, from the low corner of the box around them.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Form {
    /// Whether its sides can be told apart: the axis across a plane shape, when it stands as here.
    pub layer: Layer,
    /// By place, `[x, y, z]`.
    pub blocks: Vec<([i32; 3], u32)>,
}

/// The number of a form.
pub type FormId = usize;

/// A shape of an example.
#[derive(Clone, Debug)]
pub struct Part {
    /// Which of the examples it is of.
    pub example: usize,
    pub form: FormId,
    /// How its form stands in the example.
    pub placement: Placement,
    /// Whether in the example outside reaches both of its sides, so that it encloses nothing there.
    pub is_open: bool,
}

/// The shapes of all examples. Shapes match that have one form.
#[derive(Debug, Default)]
pub struct Parts {
    pub states: States,
    pub forms: Vec<Form>,
    pub parts: Vec<Part>,
    numbers: BTreeMap<Form, FormId>,
}

impl Parts {
    /// Enters the shapes of one more example.
    pub fn enter(&mut self, example: usize, grid: &Grid, building: &Building, shapes: &[Shape]) {
        let states: Vec<u32> =
            grid.palette().states().iter().map(|state| self.states.number(state)).collect();
        for shape in shapes {
            let cells = shape.blocks.iter().map(|block| building.cell(*block));
            let blocks: Vec<(Cell, u32)> =
                cells.map(|cell| (cell, states[usize::from(grid.id(cell))])).collect();
            let (form, placement) = self.form(shape.layer, &blocks);
            let form = self.number(form);
            self.parts.push(Part { example, form, placement, is_open: false });
        }
    }

    /// The form of blocks and how it stands to give them: of the four turns, the one whose blocks are the least.
    fn form(&self, layer: Layer, blocks: &[(Cell, u32)]) -> (Form, Placement) {
        let forms = Turn::ALL.map(|turn| {
            let turned = || blocks.iter().map(|(cell, _)| turn.apply(*cell));
            let low = turned().reduce(Cell::min).unwrap_or_default();
            let states = blocks.iter().map(|(_, state)| self.states.turned(*state, turn));
            let mut blocks: Vec<_> = turned().map(|cell| (cell - low).to_array()).zip(states).collect();
            blocks.sort_unstable();
            let there = Placement { turn, offset: (-low).to_array() };
            (Form { layer: layer.turned(turn), blocks }, there.inverse())
        });
        let mut forms = forms.into_iter();
        let first = forms.next().expect("there are four turns");
        forms.fold(first, |least, form| if form.0 < least.0 { form } else { least })
    }

    fn number(&mut self, form: Form) -> FormId {
        let next = self.forms.len();
        let number = *self.numbers.entry(form.clone()).or_insert(next);
        if number == next {
            self.forms.push(form);
        }
        number
    }

    /// The block states, by number.
    pub fn states(&self) -> impl Iterator<Item = &BlockState> {
        self.states.list.iter()
    }

    /// The blocks of a form that stands somewhere.
    pub fn blocks(&self, form: FormId, placement: Placement) -> impl Iterator<Item = (Cell, u32)> {
        self.forms[form].blocks.iter().map(move |(cell, state)| {
            (placement.apply(Cell::from_array(*cell)), self.states.turned(*state, placement.turn))
        })
    }

    /// The blocks of a shape, where it stands in its example.
    pub fn blocks_of(&self, part: &Part) -> impl Iterator<Item = (Cell, u32)> {
        self.blocks(part.form, part.placement)
    }

    /// How many shapes have each form.
    pub fn counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.forms.len()];
        self.parts.iter().for_each(|part| counts[part.form] += 1);
        counts
    }
}
