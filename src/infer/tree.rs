//! Split trees: how a box is cut, along one axis at a time, into labelled boxes and empty space.

use crate::space::{Axis, Bounds};

/// A split tree. It holds lengths only: where its parts lie is implied by the box it is laid out in.
///
/// Always in normal form: a split has two parts or more, none of them a split along the same axis, and
/// no two empty parts are neighbours.
#[derive(Clone, Debug)]
pub struct Tree {
    arena: TreeBuilder,
    root: NodeId,
}

/// The number of a node in its tree.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct NodeId(u32);

/// One node, as a reader of the tree sees it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Node<'a> {
    /// Empty space.
    Nil,
    /// A box that bears this label.
    Leaf(u32),
    /// Parts side by side along `axis`, from its low end; their lengths sum to that of the node's box.
    Split { axis: Axis, parts: &'a [Part] },
}

/// A part of a split.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    /// In cells along the axis of the split, at least 1.
    pub len: i32,
    pub child: NodeId,
}

impl Tree {
    pub fn root(&self) -> NodeId {
        self.root
    }

    /// The node of this number, which must come from this tree.
    pub fn node(&self, id: NodeId) -> Node<'_> {
        self.arena.node(id)
    }

    /// Every node with its box where the tree fills `root`: parents first, parts from low to high.
    pub fn nodes(&self, root: Bounds) -> impl Iterator<Item = (Bounds, Node<'_>)> {
        let mut open = vec![(root, self.root)];
        std::iter::from_fn(move || {
            let (bounds, id) = open.pop()?;
            let node = self.node(id);
            if let Node::Split { axis, parts } = node {
                let first = open.len();
                open.extend(places(bounds, axis, parts));
                open[first..].reverse();
            }
            Some((bounds, node))
        })
    }

    /// Every node with its box where the tree fills `root`, parents first, and where its children begin in this order: they
    /// stand together, from low to high.
    pub fn in_levels(&self, root: Bounds) -> Vec<(NodeId, Bounds, usize)> {
        let mut order = vec![(self.root, root, 0)];
        let mut at = 0;
        while at < order.len() {
            let (id, bounds, _) = order[at];
            order[at].2 = order.len();
            if let Node::Split { axis, parts } = self.node(id) {
                order.extend(places(bounds, axis, parts).map(|(place, child)| (child, place, 0)));
            }
            at += 1;
        }
        order
    }

    /// The labelled boxes where the tree fills `root`, parts from low to high.
    pub fn leaves(&self, root: Bounds) -> impl Iterator<Item = (Bounds, u32)> {
        self.nodes(root).filter_map(|(bounds, node)| match node {
            Node::Leaf(label) => Some((bounds, label)),
            Node::Nil | Node::Split { .. } => None,
        })
    }

    /// The nodes without places, parents first, each with its length in the split above (0 at the root).
    fn walk(&self) -> impl Iterator<Item = (i32, Node<'_>)> {
        let mut open = vec![Part { len: 0, child: self.root }];
        std::iter::from_fn(move || {
            let part = open.pop()?;
            let node = self.node(part.child);
            if let Node::Split { parts, .. } = node {
                open.extend(parts.iter().rev());
            }
            Some((part.len, node))
        })
    }
}

/// The boxes of the parts of a split of `bounds`.
fn places(bounds: Bounds, axis: Axis, parts: &[Part]) -> impl Iterator<Item = (Bounds, NodeId)> {
    let mut low = axis.of(bounds.min);
    parts.iter().map(move |part| {
        let place = bounds.slab(axis, low, low + part.len);
        low += part.len;
        (place, part.child)
    })
}

/// The same splits and labels, wherever the nodes lie in memory.
impl PartialEq for Tree {
    fn eq(&self, other: &Tree) -> bool {
        let key = |(len, node)| match node {
            Node::Split { axis, parts } => (len, Some(axis), parts.len() as u32),
            Node::Leaf(label) => (len, None, label),
            Node::Nil => (len, Some(Axis::X), 0),
        };
        self.walk().map(key).eq(other.walk().map(key))
    }
}

impl Eq for Tree {}

/// Builds a tree from its leaves up, and keeps it in normal form.
#[derive(Clone, Debug)]
pub struct TreeBuilder {
    nodes: Vec<Stored>,
    /// The parts of all splits, those of one split together.
    parts: Vec<Part>,
}

#[derive(Clone, Copy, Debug)]
enum Stored {
    Nil,
    Leaf(u32),
    Split { axis: Axis, first: u32, end: u32 },
}

/// All empty space is one node.
const NIL: NodeId = NodeId(0);

impl TreeBuilder {
    pub fn new() -> TreeBuilder {
        TreeBuilder { nodes: vec![Stored::Nil], parts: Vec::new() }
    }

    pub fn nil(&self) -> NodeId {
        NIL
    }

    pub fn leaf(&mut self, label: u32) -> NodeId {
        self.push(Stored::Leaf(label))
    }

    /// A split along `axis` into `parts`, from the low end; every length is at least 1.
    ///
    /// Parts that are splits along the same axis give way to their own parts, neighbouring empty parts
    /// become one, and a split of a single part is that part.
    pub fn split(&mut self, axis: Axis, parts: impl IntoIterator<Item = Part>) -> NodeId {
        let first = self.parts.len();
        for part in parts {
            self.append_flat(axis, first, part);
        }
        match self.parts[first..] {
            [] => NIL,
            [Part { child, .. }] => {
                self.parts.truncate(first);
                child
            }
            _ => self.push(Stored::Split { axis, first: first as u32, end: self.parts.len() as u32 }),
        }
    }

    pub fn finish(self, root: NodeId) -> Tree {
        Tree { arena: self, root }
    }

    fn append_flat(&mut self, axis: Axis, first: usize, part: Part) {
        debug_assert!(part.len > 0, "a part without cells");
        match self.nodes[part.child.0 as usize] {
            Stored::Split { axis: inner, first: from, end } if inner == axis => {
                (from..end).for_each(|i| self.append(first, self.parts[i as usize]));
            }
            _ => self.append(first, part),
        }
    }

    /// Adds a part to the split whose parts begin at `first`.
    fn append(&mut self, first: usize, part: Part) {
        match self.parts[first..].last_mut() {
            Some(last) if last.child == NIL && part.child == NIL => last.len += part.len,
            _ => self.parts.push(part),
        }
    }

    fn push(&mut self, node: Stored) -> NodeId {
        self.nodes.push(node);
        NodeId(self.nodes.len() as u32 - 1)
    }

    pub fn node(&self, id: NodeId) -> Node<'_> {
        match self.nodes[id.0 as usize] {
            Stored::Nil => Node::Nil,
            Stored::Leaf(label) => Node::Leaf(label),
            Stored::Split { axis, first, end } => {
                Node::Split { axis, parts: &self.parts[first as usize..end as usize] }
            }
        }
    }
}

impl Default for TreeBuilder {
    fn default() -> TreeBuilder {
        TreeBuilder::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Cell;

    fn part(len: i32, child: NodeId) -> Part {
        Part { len, child }
    }

    #[test]
    fn splits_along_one_axis_become_one_split() {
        let mut b = TreeBuilder::new();
        let [one, two] = [b.leaf(1), b.leaf(2)];
        let inner = b.split(Axis::X, [part(2, one), part(1, NIL)]);
        let root = b.split(Axis::X, [part(3, inner), part(4, NIL), part(1, two)]);
        let tree = b.finish(root);
        let parts = [part(2, one), part(5, NIL), part(1, two)];
        assert_eq!(tree.node(tree.root()), Node::Split { axis: Axis::X, parts: &parts });
    }

    #[test]
    fn a_split_of_one_part_is_that_part() {
        let mut b = TreeBuilder::new();
        let one = b.leaf(1);
        assert_eq!(b.split(Axis::Y, [part(7, one)]), one);
        assert_eq!(b.split(Axis::Y, [part(3, NIL), part(4, NIL)]), NIL);
    }

    #[test]
    fn leaves_lie_where_the_lengths_say() {
        let mut b = TreeBuilder::new();
        let [one, two] = [b.leaf(1), b.leaf(2)];
        let column = b.split(Axis::Y, [part(1, one), part(2, two)]);
        let root = b.split(Axis::X, [part(2, column), part(1, NIL), part(3, one)]);
        let at = Cell::new(10, 20, 30);
        let boxed = |min: [i32; 3], max: [i32; 3]| Bounds::new(at + Cell::from(min), at + Cell::from(max));
        let leaves: Vec<_> = b.finish(root).leaves(boxed([0, 0, 0], [6, 3, 1])).collect();
        let expected = [
            (boxed([0, 0, 0], [2, 1, 1]), 1),
            (boxed([0, 1, 0], [2, 3, 1]), 2),
            (boxed([3, 0, 0], [6, 3, 1]), 1),
        ];
        assert_eq!(leaves, expected);
    }

    #[test]
    fn equality_is_of_cuts_and_labels() {
        let tree = |spare: u32, len: i32| {
            let mut b = TreeBuilder::new();
            for label in 0..spare {
                b.leaf(label);
            }
            let one = b.leaf(1);
            let root = b.split(Axis::Z, [part(len, one), part(1, NIL)]);
            b.finish(root)
        };
        assert_eq!(tree(0, 2), tree(3, 2));
        assert_ne!(tree(0, 2), tree(0, 3));
    }
}
