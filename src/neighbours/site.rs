use super::joint::{Joint, is_open};
use crate::block::{
    BlockState, Bottom, PaletteFull, Shape, Sides, Version, bottom, filled_in, shape, sturdy,
};
use crate::grid::Grid;
use crate::space::Cell;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::cell::RefCell;
use std::rc::Rc;

/// The properties that a rule gives to a block.
pub type Answer = SmallVec<[(&'static str, &'static str); 6]>;

/// What the rules ask of a block.
pub struct Block {
    pub joint: Option<Joint>,
    pub open: bool,
    pub shape: Shape,
    pub sturdy: Sides,
    /// The sturdy sides that fences, panes and walls join to.
    pub joins: Sides,
    pub bottom: Bottom,
}

/// Blocks with whole sides that nothing joins to.
const UNJOINED: [&str; 5] = ["barrier", "carved_pumpkin", "jack_o_lantern", "melon", "pumpkin"];

/// Blocks that a thread remembers, at the most: their names are looked up in long tables.
const MOST_REMEMBERED: usize = 1 << 13;

thread_local! {
    static REMEMBERED: RefCell<FxHashMap<BlockState, Rc<Block>>> = RefCell::default();
}

impl Block {
    /// What was found when the state was last asked for.
    fn remembered(state: &BlockState) -> Rc<Block> {
        REMEMBERED.with_borrow_mut(|known| {
            if let Some(block) = known.get(state) {
                return block.clone();
            }
            if known.len() >= MOST_REMEMBERED {
                known.clear();
            }
            let block = Rc::new(Block::of(state));
            known.insert(state.clone(), block.clone());
            block
        })
    }

    fn of(state: &BlockState) -> Block {
        let name = state.short_name();
        let unjoined = UNJOINED.contains(&name) || name.ends_with("shulker_box") || name.ends_with("_leaves");
        let sturdy = sturdy(state);
        Block {
            joint: Joint::of(state),
            open: is_open(state),
            shape: shape(state),
            sturdy,
            joins: if unjoined { Sides::default() } else { sturdy },
            bottom: bottom(state),
        }
    }
}

/// A grid at work: what is known of its blocks, and the answers given so far.
pub struct Site<'g> {
    grid: &'g mut Grid,
    /// What the states are of; the rules speak as the newest version does.
    version: Version,
    blocks: Vec<Rc<Block>>,
    answers: FxHashMap<(u16, Answer), u16>,
}

impl<'g> Site<'g> {
    pub fn new(grid: &'g mut Grid, version: Version) -> Site<'g> {
        let blocks = grid.palette().states().iter().map(Block::remembered).collect();
        Site { grid, version, blocks, answers: FxHashMap::default() }
    }

    fn id(&self, cell: Cell) -> u16 {
        // Number 0 is air.
        if self.grid.bounds().contains(cell) { self.grid.id(cell) } else { 0 }
    }

    /// What is known of the block at `cell`; outside of the grid there is air.
    pub fn block(&self, cell: Cell) -> &Block {
        &self.blocks[usize::from(self.id(cell))]
    }

    /// The block state at `cell`; outside of the grid there is air.
    pub fn state(&self, cell: Cell) -> &BlockState {
        self.grid.palette().get(self.id(cell))
    }

    /// Asks `rule` for every open block of these joints, from the top down.
    pub fn each(
        &mut self,
        joints: &[Joint],
        rule: impl Fn(&Site<'_>, Cell) -> Answer,
    ) -> Result<(), PaletteFull> {
        for y in self.layers(joints).rev() {
            for cell in self.open_in(y, joints) {
                let answer = rule(self, cell);
                self.answer(cell, answer)?;
            }
        }
        Ok(())
    }

    /// The layers to look for open blocks of these joints in: none where the palette has no such block.
    pub fn layers(&self, joints: &[Joint]) -> std::ops::Range<i32> {
        let any = self.blocks.iter().any(|block| block.is_open_of(joints));
        if any { 0..self.grid.size().y } else { 0..0 }
    }

    /// The open blocks of these joints in one layer. Takes as long as the layer is large, whatever the palette is.
    pub fn open_in(&self, y: i32, joints: &[Joint]) -> Vec<Cell> {
        let layer = self.grid.cells().index_axis(ndarray::Axis(0), y as usize);
        let found = layer.indexed_iter().filter(|(_, id)| self.blocks[usize::from(**id)].is_open_of(joints));
        found.map(|((z, x), _)| Cell::new(x as i32, y, z as i32)).collect()
    }

    /// All cells in a row along `step` that hold a block `like` that at `cell`, from the first one on.
    pub fn run(&self, cell: Cell, step: Cell, like: impl Fn(&BlockState) -> bool) -> Vec<Cell> {
        let mut first = cell;
        while like(self.state(first - step)) {
            first -= step;
        }
        let cells = std::iter::successors(Some(first), |cell| Some(cell + step));
        cells.take_while(|cell| like(self.state(*cell))).collect()
    }

    /// Gives the block at `cell` the properties of `answer` that it has not.
    fn answer(&mut self, cell: Cell, answer: Answer) -> Result<(), PaletteFull> {
        let key = (self.id(cell), answer);
        let id = match self.answers.get(&key) {
            Some(&id) => id,
            None => {
                let (own, answer) = (self.state(cell), &key.1);
                let state = filled_in(own, self.version, |own| filled(own, answer));
                let id = self.intern(&state)?;
                self.answers.insert(key, id);
                id
            }
        };
        self.grid.set(cell, id);
        Ok(())
    }

    /// Puts `state` at `cell`, which must be inside.
    pub fn put(&mut self, cell: Cell, state: &BlockState) -> Result<(), PaletteFull> {
        let id = self.intern(state)?;
        self.grid.set(cell, id);
        Ok(())
    }

    fn intern(&mut self, state: &BlockState) -> Result<u16, PaletteFull> {
        let id = self.grid.intern(state)?;
        if usize::from(id) == self.blocks.len() {
            self.blocks.push(Block::remembered(state));
        }
        Ok(id)
    }
}

/// `own` with the properties of `answer` that it has not.
fn filled(own: &BlockState, answer: &Answer) -> BlockState {
    let absent = answer.iter().filter(|(key, _)| own.get(key).is_none());
    absent.fold(own.clone(), |state, (key, value)| state.with(key, value))
}

impl Block {
    fn is_open_of(&self, joints: &[Joint]) -> bool {
        self.open && self.joint.is_some_and(|joint| joints.contains(&joint))
    }
}
