//! Where the boxes of a plan stand: which operations led to each, and as which part of them.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::plan::{self, Form, How, NodeId, Plan};

/// As which part of an operation something stands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Edge {
    /// The child of that number.
    Child(usize),
    Unit(Unit),
}

/// Which unit of a repeat.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Unit {
    First,
    Inner,
    Last,
    /// There is no other.
    Only,
}

impl Unit {
    pub fn of(number: usize, count: usize) -> Unit {
        match (number == 0, number + 1 == count) {
            (true, true) => Unit::Only,
            (true, false) => Unit::First,
            (false, true) => Unit::Last,
            (false, false) => Unit::Inner,
        }
    }
}

/// The operations that led to a box with the edges below them, the outermost first.
pub type Path = [(NodeId, Edge)];

/// Goes through all places of the boxes of `root`: each with its node, its path and its class.
pub fn each_place(
    plan: &Plan,
    corpus: &mut Corpus,
    root: NodeId,
    boxes: &Boxes,
    mut visit: impl FnMut(NodeId, &Path, Class),
) {
    for class in boxes.classes() {
        let mut path = Vec::new();
        let mut open = vec![(0, None, root, class)];
        while let Some((depth, step, id, class)) = open.pop() {
            path.truncate(depth);
            path.extend(step);
            visit(id, &path, class);
            let below = path.len();
            let inside = inside(plan, corpus, id, class).into_iter().rev();
            open.extend(inside.map(|(edge, child, part)| (below, Some((id, edge)), child, part)));
        }
    }
}

/// The parts of a box under a node, each with its edge and the node that describes it.
fn inside(plan: &Plan, corpus: &mut Corpus, id: NodeId, class: Class) -> Vec<(Edge, NodeId, Class)> {
    let parts = plan::inside(plan, corpus, id, class);
    let count = parts.len();
    let edge = |number: usize, child: NodeId| match &plan.node(id).form {
        Form::Split { .. } => Edge::Child(number),
        Form::Repeat { .. } => Edge::Unit(Unit::of(number, count)),
        _ => Edge::Child(plan.children(id).iter().position(|own| *own == child).unwrap_or(0)),
    };
    parts.into_iter().enumerate().map(|(number, (child, part))| (edge(number, child), child, part)).collect()
}

/// The child that a choice makes of a class.
pub fn chosen(plan: &Plan, id: NodeId, class: Class) -> Option<NodeId> {
    let node = plan.node(id);
    match (&node.form, node.how.get(&class)) {
        (Form::Choose(children), Some(How::Choose(number))) => Some(children[*number]),
        _ => None,
    }
}
