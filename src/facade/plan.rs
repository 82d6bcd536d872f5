//! Layouts as splits of splits: what a decision at each structure makes of a layout.

use super::cuts::{Cutter, StructureId};
use super::fold::{Folding, folded, in_step};
use super::{Region, Side};
use rustc_hash::FxHashMap;

pub type NodeId = usize;

/// What a region is. Equal ones are one node, wherever they stand.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// A label, of any size.
    Leaf(u32),
    Split {
        axis: Side,
        items: Vec<Item>,
    },
}

/// Parts of a split that stand so often in a row.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Item {
    pub times: u32,
    pub parts: Vec<Part>,
}

impl Item {
    /// Its parts as often as they stand.
    pub fn written_out(&self) -> impl Iterator<Item = &Part> {
        (0..self.times).flat_map(|_| &self.parts)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Part {
    /// In blocks.
    pub length: u32,
    pub node: NodeId,
}

/// A layout as nodes, those below before those above.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Plan {
    pub nodes: Vec<Node>,
    pub root: NodeId,
    pub size: [u32; 2],
}

/// Where to cut regions of one structure: by which of all lines across an axis.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Decision {
    pub axis: Side,
    /// Rising numbers among the lines that cut the region, one at least.
    pub lines: Vec<u16>,
}

impl Decision {
    /// The lines themselves.
    pub fn cuts(&self, cutter: &Cutter, region: &Region) -> Vec<u32> {
        let all = cutter.cuts(region, self.axis);
        self.lines.iter().filter_map(|line| all.get(usize::from(*line)).copied()).collect()
    }
}

impl Plan {
    /// The plan that decisions make, each used wherever its structure stands. `structure` says which a region has,
    /// `decision` what is done with it.
    pub fn of(
        cutter: &Cutter,
        folding: Folding,
        structure: &mut impl FnMut(&Region) -> StructureId,
        decision: &mut impl FnMut(StructureId, &Region) -> Decision,
    ) -> Plan {
        let whole = cutter.whole();
        let mut builder = Builder {
            cutter,
            folding,
            structure,
            decision,
            nodes: Vec::new(),
            known: FxHashMap::default(),
            of: FxHashMap::default(),
        };
        let root = builder.node(&whole);
        let Builder { nodes, .. } = builder;
        let size = Side::ALL.map(|axis| cutter.length(&whole, axis));
        Plan { nodes, root, size }.flattened()
    }

    pub fn parts(&self, node: NodeId) -> impl Iterator<Item = &Part> {
        let items = match &self.nodes[node] {
            Node::Leaf(_) => [].as_slice(),
            Node::Split { items, .. } => items,
        };
        items.iter().flat_map(|item| &item.parts)
    }

    /// How often each node stands in the rules.
    fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0; self.nodes.len()];
        uses[self.root] += 1;
        for node in 0..self.nodes.len() {
            self.parts(node).for_each(|part| uses[part.node] += 1);
        }
        uses
    }

    /// A split along the axis of the one around it that stands in no other place is no rule of its own.
    fn flattened(&self) -> Plan {
        let uses = self.uses();
        let mut nodes: Vec<Node> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            nodes.push(match node {
                Node::Leaf(label) => Node::Leaf(*label),
                Node::Split { axis, items } => {
                    let flat = items.iter().flat_map(|item| inlined(item, *axis, &nodes, &uses));
                    Node::Split { axis: *axis, items: flat.collect() }
                }
            });
        }
        Plan { nodes, ..*self }.reached()
    }

    /// Without what the root does not reach.
    fn reached(&self) -> Plan {
        let mut is_reached = vec![false; self.nodes.len()];
        is_reached[self.root] = true;
        for node in (0..self.nodes.len()).rev().filter(|node| *node <= self.root) {
            if is_reached[node] {
                self.parts(node).for_each(|part| is_reached[part.node] = true);
            }
        }
        let mut numbers = vec![0; self.nodes.len()];
        let mut nodes = Vec::new();
        for (node, content) in self.nodes.iter().enumerate().filter(|(node, _)| is_reached[*node]) {
            numbers[node] = nodes.len();
            let mut content = content.clone();
            if let Node::Split { items, .. } = &mut content {
                let parts = items.iter_mut().flat_map(|item| &mut item.parts);
                parts.for_each(|part| part.node = numbers[part.node]);
            }
            nodes.push(content);
        }
        Plan { nodes, root: numbers[self.root], size: self.size }
    }
}

/// An item, or the items of the split that it holds alone.
fn inlined(item: &Item, axis: Side, nodes: &[Node], uses: &[u32]) -> Vec<Item> {
    match item.parts.as_slice() {
        [Part { node, .. }] if item.times == 1 && uses[*node] == 1 => match &nodes[*node] {
            Node::Split { axis: inner, items }
                if *inner == axis && items.iter().all(|item| item.times == 1) =>
            {
                items.clone()
            }
            _ => vec![item.clone()],
        },
        _ => vec![item.clone()],
    }
}

struct Builder<'c, S, D> {
    cutter: &'c Cutter,
    folding: Folding,
    structure: &'c mut S,
    decision: &'c mut D,
    nodes: Vec<Node>,
    known: FxHashMap<Node, NodeId>,
    of: FxHashMap<Region, NodeId>,
}

impl<S, D> Builder<'_, S, D>
where
    S: FnMut(&Region) -> StructureId,
    D: FnMut(StructureId, &Region) -> Decision,
{
    fn node(&mut self, region: &Region) -> NodeId {
        if let Some(known) = self.of.get(region) {
            return *known;
        }
        let node = match self.cutter.only_leaf(region) {
            Some(leaf) => Node::Leaf(self.cutter.label(leaf)),
            None => self.split(region),
        };
        let next = self.nodes.len();
        let id = *self.known.entry(node.clone()).or_insert(next);
        if id == next {
            self.nodes.push(node);
        }
        self.of.insert(*region, id);
        id
    }

    fn split(&mut self, region: &Region) -> Node {
        let structure = (self.structure)(region);
        let decision = (self.decision)(structure, region);
        let (axis, cuts) = (decision.axis, decision.cuts(self.cutter, region));
        let regions: Vec<Region> = self.cutter.parts(region, axis, &cuts).collect();
        let parts: Vec<Part> = regions
            .iter()
            .map(|part| Part { length: self.cutter.length(part, axis), node: self.node(part) })
            .collect();
        let runs = in_step(folded(&parts, self.folding));
        Node::Split {
            axis,
            items: runs.into_iter().map(|run| Item { times: run.times, parts: run.unit }).collect(),
        }
    }
}
