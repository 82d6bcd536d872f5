//! Parsing buildings under a grammar: which derivation of an op graph gives this grid, block for block?
//!
//! The search goes from the root down as a run does, and looks at the target instead of drawing. Equal parts of the
//! target are parsed once under each operation, whatever their place.

mod any;
mod chart;
mod cost;
mod coverage;
mod derivation;
mod draw;
mod free;
mod lengths;
mod looks;
mod needs;
mod overlay;
mod search;
mod split;
mod stack;
mod start;
mod states;
mod surroundings;
mod target;
mod value;
mod widened;

use crate::block::{PaletteFull, Version};
use crate::graph::OpGraph;
use crate::grid::{Grid, LabelledBoxes};
use crate::run::Library;
use crate::space::{Frame, Scope, Turn};
use chart::{Chart, Rigour};
use cost::Cost;
use looks::Looks;
use rustc_hash::FxHashMap;
use search::{Aim, Memory, Rules, Search};
use states::States;
use std::cell::{RefCell, RefMut};
use std::collections::BTreeMap;
use surroundings::{Known, tables};
use target::{Blocks, Placed, Target};

pub use chart::Choice;
pub use coverage::{Reason, Unexplained};
pub use derivation::{Derivation, Step};
pub use stack::stacked;

/// Which lengths a part may have.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Laws {
    /// Those that the grammar says.
    AsWritten,
    /// Any: parts and repetitions come in the order of the grammar, but absolute ones may measure any number of blocks
    /// from one on, floating ones any at all.
    Widened,
    /// Those that the grammar says, where they will do; else any, as if widened, at a price that keeps such places few. So
    /// are rules taken whose conditions do not hold.
    Stretched,
}

/// The label that each constant stands for, by the constant's name.
pub type Labels = BTreeMap<String, String>;

/// Operations that one search may look at.
pub const MOST_STEPS: u64 = 1 << 22;

/// How exact a derivation is to be, and which one is looked for.
type How = (Rigour, Aim);
const EXACT: How = (Rigour::Exact, Aim::Cheapest);
const ANY: How = (Rigour::Exact, Aim::Any);
const NEAREST: How = (Rigour::Nearest, Aim::Cheapest);

static NO_LIBRARY: Library = Library::new();
static NO_LABELS: Labels = Labels::new();

/// Finds derivations under one graph. What it learns from one building helps it with the next.
#[derive(Debug)]
pub struct Parser<'g> {
    rules: Rules<'g>,
    memory: RefCell<Memory>,
    steps: u64,
}

/// The cheapest derivation that a search found, and where it starts.
struct Best {
    cost: Cost,
    /// The same as in the search.
    start: surroundings::Around,
}

impl<'g> Parser<'g> {
    pub fn new(graph: &'g OpGraph, laws: Laws) -> Parser<'g> {
        let needs = needs::needs(graph);
        let rules = Rules { graph, laws, needs, library: &NO_LIBRARY, labels: &NO_LABELS };
        Parser { rules, memory: RefCell::new(Memory::of(Version::newest())), steps: MOST_STEPS }
    }

    /// With the schematic files that the graph names.
    pub fn with_library(mut self, library: &'g Library) -> Parser<'g> {
        self.rules.library = library;
        self
    }

    /// With the labels that constants stand for in labelled boxes.
    pub fn with_labels(mut self, labels: &'g Labels) -> Parser<'g> {
        self.rules.labels = labels;
        self
    }

    /// With another limit on the operations that a search looks at.
    pub fn with_steps(self, steps: u64) -> Parser<'g> {
        Parser { steps, ..self }
    }

    /// The cheapest derivation of a grid, on a scope of its size; or what no derivation explains.
    pub fn parse(&self, grid: &Grid) -> Result<Derivation, Unexplained> {
        let version = grid.data_version();
        let mut memory = self.ready(version);
        let blocks =
            Blocks::of(grid, version, &mut memory.states).map_err(|PaletteFull| Unexplained::unread(grid))?;
        self.parse_target(&mut memory, &Target::Blocks(blocks))
    }

    /// The derivation of the grid that differs from this one in the fewest cells; `None` where the search found none.
    pub fn nearest(&self, grid: &Grid) -> Option<Derivation> {
        let version = grid.data_version();
        let mut memory = self.ready(version);
        let blocks = Blocks::of(grid, version, &mut memory.states).ok()?;
        let target = Target::Blocks(blocks);
        let best = self.search(&mut memory, &target, NEAREST).ok()?;
        Some(self.listed(&mut memory, &target, &best, NEAREST))
    }

    /// As [`Parser::parse`], for labelled boxes. Cells count as blocks.
    pub fn parse_boxes(&self, boxes: &LabelledBoxes) -> Result<Derivation, Unexplained> {
        let mut memory = self.memory.borrow_mut();
        memory.chart = Chart::default();
        let parsed = self.parse_target(&mut memory, &Target::Boxes(Placed::of(boxes)));
        memory.chart = Chart::default();
        parsed
    }

    /// Some derivation of labelled boxes, which need not be the cheapest: far sooner found where there are many.
    pub fn any_of_boxes(&self, boxes: &LabelledBoxes) -> Option<Derivation> {
        let mut memory = self.memory.borrow_mut();
        memory.chart = Chart::default();
        let target = Target::Boxes(Placed::of(boxes));
        let found = self.search(&mut memory, &target, ANY).ok();
        let derivation = found.map(|found| self.listed(&mut memory, &target, &found, ANY));
        memory.chart = Chart::default();
        derivation
    }

    /// Whether there is a derivation of a grid: cheaper than to find out what is not explained.
    pub fn derives(&self, grid: &Grid) -> bool {
        let version = grid.data_version();
        let mut memory = self.ready(version);
        let blocks = Blocks::of(grid, version, &mut memory.states);
        blocks.is_ok_and(|blocks| self.search(&mut memory, &Target::Blocks(blocks), EXACT).is_ok())
    }

    /// As [`Parser::derives`], for labelled boxes.
    pub fn derives_boxes(&self, boxes: &LabelledBoxes) -> bool {
        let mut memory = self.memory.borrow_mut();
        memory.chart = Chart::default();
        let found = self.search(&mut memory, &Target::Boxes(Placed::of(boxes)), ANY);
        memory.chart = Chart::default();
        found.is_ok()
    }

    /// The memory for a building of that version; what is remembered of others does not hold for it.
    fn ready(&self, data_version: i32) -> RefMut<'_, Memory> {
        let mut memory = self.memory.borrow_mut();
        let version = Version::of_data(data_version).unwrap_or(Version::oldest());
        if memory.states.version() != version || memory.chart.is_full() {
            *memory = Memory::of(version);
        }
        memory
    }

    fn parse_target(&self, memory: &mut Memory, target: &Target<'_>) -> Result<Derivation, Unexplained> {
        match self.search(memory, target, EXACT) {
            Ok(best) => Ok(self.listed(memory, target, &best, EXACT)),
            Err(reason) => Err(self.unexplained(memory, target, reason)),
        }
    }

    /// What the derivation that comes nearest leaves open.
    fn unexplained(&self, memory: &mut Memory, target: &Target<'_>, reason: Reason) -> Unexplained {
        let nearest = self.search(memory, target, NEAREST);
        let nearest = nearest.map(|best| self.listed(memory, target, &best, NEAREST));
        coverage::unexplained(&self.rules, memory, target, reason, nearest.ok())
    }

    fn listed(&self, memory: &mut Memory, target: &Target<'_>, best: &Best, how: How) -> Derivation {
        let mut search = Search::new(&self.rules, memory, target, how, self.steps);
        let steps = search.steps(self.rules.graph.root(), best.start, &self.start(target));
        Derivation { bits: best.cost.bits, steps }
    }

    fn start(&self, target: &Target<'_>) -> Scope {
        let frame = Frame { up: self.rules.graph.up, turn: Turn::NONE };
        Scope { bounds: target.bounds(), frame }
    }

    /// The cheapest derivation over all values that the constants may have.
    fn search(&self, memory: &mut Memory, target: &Target<'_>, how: How) -> Result<Best, Reason> {
        let (root, scope) = (self.rules.graph.root(), self.start(target));
        let asked = &self.rules.needs[root.index()].constants;
        let mut best: Option<Best> = None;
        let mut left = self.steps;
        for (table, chance) in tables(self.rules.graph, asked) {
            let start = memory.known.start(table);
            let mut search = Search::new(&self.rules, memory, target, how, left);
            let cost = search.solve(root, start, &scope).map(|cost| cost.plus(Cost::of_chance(chance)));
            left = search.steps;
            best = match (best, cost) {
                (Some(best), Some(cost)) if !cost.is_less(best.cost) => Some(best),
                (best, None) => best,
                (_, Some(cost)) => Some(Best { cost, start }),
            };
        }
        best.ok_or(if left == 0 { Reason::TooManySteps(self.steps) } else { Reason::NoDerivation })
    }
}

impl Memory {
    fn of(version: Version) -> Memory {
        Memory {
            states: States::of(version),
            known: Known::default(),
            chart: Chart::default(),
            looks: Looks::default(),
            footprints: FxHashMap::default(),
            written: FxHashMap::default(),
        }
    }
}
