//! Examples as split trees over one set of terminals.

use super::tree::{Node, NodeId, Part, Tree, TreeBuilder};
use super::{BadBoxes, PLAN_FIRST, UPRIGHT_FIRST, cuboids, split_boxes};
use crate::block::{BlockState, Mirror, Palette, PaletteFull, complete};
use crate::graph::OpGraph;
use crate::grid::{Grid, LabelledBoxes};
use crate::neighbours::unsettle;
use crate::parse::{Labels, Laws, Parser};
use crate::space::{Axis, Bounds, Cell, Turn};
use ndarray::Array3;
use std::collections::BTreeMap;

/// A building to learn from.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "there are few examples")]
pub enum Example {
    /// Blocks without labels; their terminals are cuboids of one block state. Properties that a state leaves
    /// out are as its neighbours ask for, or at their defaults.
    Blocks(Grid),
    /// Boxes with labels; each is a terminal.
    Boxes(LabelledBoxes),
}

/// What a leaf of a tree is. Leaves of one terminal look alike wherever they stand.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Terminal {
    Block(BlockState),
    Label(String),
}

/// The terminals of all examples, numbered in order of first use.
#[derive(Clone, Default, Debug)]
pub struct Terminals {
    pub list: Vec<Terminal>,
    numbers: BTreeMap<Terminal, u32>,
}

impl Terminals {
    /// The number of each block of a palette.
    fn of_palette(&mut self, grid: &Grid) -> Vec<u32> {
        let states = grid.palette().states().iter();
        states.map(|state| self.number(Terminal::Block(state.clone()))).collect()
    }

    /// Numbers the terminals of an example, in order of first use.
    pub fn enter(&mut self, example: &Example) {
        match example {
            Example::Blocks(grid) => drop(self.of_palette(grid)),
            Example::Boxes(boxes) => boxes.boxes.iter().for_each(|labelled| {
                self.number(Terminal::Label(labelled.label.clone()));
            }),
        }
    }

    /// The number of air.
    pub fn air(&mut self) -> u32 {
        self.number(Terminal::Block(BlockState::air()))
    }

    /// By terminal, whether nothing stands where it is.
    pub fn are_nothing(&self) -> Vec<bool> {
        let is_nothing = |terminal: &Terminal| match terminal {
            Terminal::Block(state) => state.is_nothing(),
            Terminal::Label(_) => false,
        };
        self.list.iter().map(is_nothing).collect()
    }

    /// The blocks of cells, which are indexed `[y, z, x]`.
    pub fn grid(&self, cells: &Array3<u32>) -> Grid {
        let (y, z, x) = cells.dim();
        let mut grid = Grid::new(Cell::new(x as i32, y as i32, z as i32));
        for ((y, z, x), terminal) in cells.indexed_iter() {
            if let Terminal::Block(state) = &self.list[*terminal as usize]
                && let Ok(id) = grid.intern(state)
            {
                grid.set(Cell::new(x as i32, y as i32, z as i32), id);
            }
        }
        grid
    }

    fn number(&mut self, terminal: Terminal) -> u32 {
        *self.numbers.entry(terminal.clone()).or_insert_with(|| {
            self.list.push(terminal);
            self.list.len() as u32 - 1
        })
    }
}

impl Example {
    /// The example as a grammar writes it: without what the neighbours of blocks decide.
    pub fn open(&self) -> Example {
        match self {
            Example::Blocks(grid) => Example::Blocks(open(grid)),
            Example::Boxes(boxes) => Example::Boxes(boxes.clone()),
        }
    }

    /// Whether a parser finds a derivation of it.
    pub fn is_derived_by(&self, parser: &Parser<'_>) -> bool {
        match self {
            Example::Blocks(grid) => parser.derives(grid),
            Example::Boxes(boxes) => parser.derives_boxes(boxes),
        }
    }

    pub fn into_grid(self) -> Option<Grid> {
        match self {
            Example::Blocks(grid) => Some(grid),
            Example::Boxes(_) => None,
        }
    }

    /// The example as it looks turned and mirrored, itself among them; none of labelled boxes.
    pub fn images(&self) -> Vec<Example> {
        let Example::Blocks(grid) = self else { return Vec::new() };
        let turned = (0..4).map(|quarters| grid.turned(Turn::quarters(quarters)));
        turned.flat_map(|grid| [grid.mirrored(Mirror::X), grid]).map(Example::Blocks).collect()
    }

    /// The box that the example fills.
    pub fn bounds(&self) -> Bounds {
        match self {
            Example::Blocks(grid) => grid.bounds(),
            Example::Boxes(boxes) => boxes.container,
        }
    }

    /// Whether it holds nothing.
    pub fn is_empty(&self) -> bool {
        match self {
            Example::Blocks(grid) => grid.cells().iter().all(|id| *id == Palette::AIR),
            Example::Boxes(boxes) => boxes.boxes.is_empty(),
        }
    }

    /// The terminal of every cell, indexed `[y, z, x]`; `None` for labelled boxes.
    pub fn cells(&self, terminals: &mut Terminals) -> Option<Array3<u32>> {
        let Example::Blocks(grid) = self else { return None };
        let numbers = terminals.of_palette(grid);
        Some(grid.cells().mapv(|id| numbers[usize::from(id)]))
    }

    /// The terminals of the example with their boxes, and what fills boxes of its own.
    pub fn boxes(&self, terminals: &mut Terminals, own: &[(Bounds, u32)]) -> Vec<(Bounds, u32)> {
        match self {
            Example::Blocks(grid) => {
                let numbers = terminals.of_palette(grid);
                let mut rest = grid.clone();
                own.iter().for_each(|(bounds, _)| rest.fill(*bounds, Palette::AIR));
                let rest = cuboids(&rest).into_iter().map(|(bounds, id)| (bounds, numbers[id as usize]));
                rest.chain(own.iter().copied()).collect()
            }
            Example::Boxes(labelled) => labelled
                .boxes
                .iter()
                .map(|labelled| (labelled.bounds, terminals.number(Terminal::Label(labelled.label.clone()))))
                .collect(),
        }
    }

    /// The split tree of the part of the example in `bounds`, from its `boxes`.
    pub fn tree(&self, bounds: Bounds, boxes: &[(Bounds, u32)]) -> Result<Tree, BadBoxes> {
        match self {
            Example::Blocks(_) => {
                let inside = boxes.iter().map(|(own, label)| (own.intersect(&bounds), *label));
                let inside: Vec<(Bounds, u32)> = inside.filter(|(own, _)| !own.is_empty()).collect();
                split_boxes(bounds, &inside, UPRIGHT_FIRST).map(|tree| joined(&tree))
            }
            Example::Boxes(_) => split_boxes(bounds, boxes, PLAN_FIRST),
        }
    }
}

/// By example, whether a parser finds a derivation. What is learnt of one grid helps with the next; labelled boxes are
/// looked at side by side. More than so many `steps` are not taken for one example.
pub fn derived(examples: &[Example], graph: &OpGraph, labels: &Labels, steps: u64) -> Vec<bool> {
    let in_order = |examples: &[Example]| -> Vec<bool> {
        let parser = Parser::new(graph, Laws::AsWritten).with_labels(labels).with_steps(steps);
        examples.iter().map(|example| example.is_derived_by(&parser)).collect()
    };
    if !matches!(examples, [Example::Boxes(_), _, ..]) {
        return in_order(examples);
    }
    let most = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        let chunks = examples.chunks(examples.len().div_ceil(most));
        let running: Vec<_> = chunks.map(|chunk| scope.spawn(move || in_order(chunk))).collect();
        let results = running.into_iter().map(|thread| thread.join());
        results.flat_map(|result| result.unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    })
}

/// The grid with open states; with all properties written in the odd case that its palette is too full for that.
fn open(grid: &Grid) -> Grid {
    let mut open = grid.clone();
    let mut full = grid.clone();
    match unsettle(&mut open).or_else(|_| full.map_states(complete).map(|()| open = full)) {
        Ok(()) => open,
        Err(PaletteFull) => grid.clone(),
    }
}

/// The tree with neighbouring parts of one block joined: where a cuboid had to be cut, its pieces often
/// end up side by side again.
fn joined(tree: &Tree) -> Tree {
    let mut builder = TreeBuilder::new();
    let mut order = vec![tree.root()];
    let mut at = 0;
    while at < order.len() {
        if let Node::Split { parts, .. } = tree.node(order[at]) {
            order.extend(parts.iter().map(|part| part.child));
        }
        at += 1;
    }
    let mut rebuilt: BTreeMap<NodeId, NodeId> = BTreeMap::new();
    for id in order.into_iter().rev() {
        let new = match tree.node(id) {
            Node::Nil => builder.nil(),
            Node::Leaf(label) => builder.leaf(label),
            Node::Split { axis, parts } => {
                let parts = parts.iter().map(|part| Part { child: rebuilt[&part.child], ..*part });
                joined_split(&mut builder, axis, parts)
            }
        };
        rebuilt.insert(id, new);
    }
    let root = rebuilt[&tree.root()];
    builder.finish(root)
}

fn joined_split(builder: &mut TreeBuilder, axis: Axis, parts: impl Iterator<Item = Part>) -> NodeId {
    let mut joined: Vec<Part> = Vec::new();
    for part in parts {
        let flat: Vec<Part> = match builder.node(part.child) {
            Node::Split { axis: inner, parts } if inner == axis => parts.to_vec(),
            _ => vec![part],
        };
        for part in flat {
            let is_leaf = !matches!(builder.node(part.child), Node::Split { .. });
            match joined.last_mut() {
                Some(last) if is_leaf && builder.node(last.child) == builder.node(part.child) => {
                    last.len += part.len
                }
                _ => joined.push(part),
            }
        }
    }
    match joined.as_slice() {
        [only] => only.child,
        _ => builder.split(axis, joined),
    }
}
