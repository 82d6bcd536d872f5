//! Examples as split trees over one set of terminals.

use super::tree::{Node, NodeId, Part, Tree, TreeBuilder};
use super::{BadBoxes, cuboids, split_boxes};
use crate::block::{self, BlockState, Palette};
use crate::grid::{Grid, LabelledBoxes};
use crate::space::{Axis, Bounds};
use std::collections::BTreeMap;

/// A building to learn from.
#[derive(Clone, Debug)]
pub enum Example {
    /// Blocks without labels; their terminals are cuboids of one block state. Properties that a state leaves
    /// out are at their defaults.
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
    fn number(&mut self, terminal: Terminal) -> u32 {
        *self.numbers.entry(terminal.clone()).or_insert_with(|| {
            self.list.push(terminal);
            self.list.len() as u32 - 1
        })
    }
}

impl Example {
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

    /// The split tree of the example.
    pub fn tree(&self, terminals: &mut Terminals) -> Result<Tree, BadBoxes> {
        match self {
            Example::Blocks(grid) => {
                let numbers: Vec<u32> = grid
                    .palette()
                    .states()
                    .iter()
                    .map(|state| terminals.number(Terminal::Block(block::complete(state))))
                    .collect();
                let boxes: Vec<(Bounds, u32)> =
                    cuboids(grid).into_iter().map(|(bounds, id)| (bounds, numbers[id as usize])).collect();
                split_boxes(grid.bounds(), &boxes).map(|tree| joined(&tree))
            }
            Example::Boxes(labelled) => {
                let mut labelled_boxes = Vec::with_capacity(labelled.boxes.len());
                for labelled in &labelled.boxes {
                    labelled_boxes
                        .push((labelled.bounds, terminals.number(Terminal::Label(labelled.label.clone()))));
                }
                split_boxes(labelled.container, &labelled_boxes)
            }
        }
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
