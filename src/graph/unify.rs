//! Equality of operations: which nodes describe the same derivations.

use super::{Arg, Op, OpGraph};
use petgraph::Direction;
use petgraph::algo::toposort;
use petgraph::graph::{DiGraph, NodeIndex};

use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The new number of each node that was kept.
pub type Renumbered = BTreeMap<NodeIndex, NodeIndex>;

impl OpGraph {
    /// The same graph with every two equal operations made one, numbered breadth-first from the root.
    ///
    /// Operations are equal when they and all that can be derived from them are. They are told apart by
    /// refining a partition of the nodes until it is stable, as finite automata are minimised; so rings
    /// of rules are compared as well as trees (seed 1, section 10.2, joins equal trees). A hash table
    /// finds a node's class, and the operations themselves are compared behind the hash.
    pub fn unified(&self) -> OpGraph {
        let classes = self.classes();
        let mut first: BTreeMap<u32, NodeIndex> = BTreeMap::new();
        for node in self.nodes() {
            first.entry(classes[node.index()]).or_insert(node);
        }
        self.project(|node| first[&classes[node.index()]]).0
    }

    /// The part of the graph that the root reaches, numbered breadth-first, and the new number of each node.
    pub(super) fn reachable(&self) -> (OpGraph, Renumbered) {
        self.project(|node| node)
    }

    fn classes(&self) -> Vec<u32> {
        let mut classes = vec![0; self.len()];
        let mut count = 1;
        loop {
            let mut table: FxHashMap<Signature<'_>, u32> = FxHashMap::default();
            let next: Vec<u32> = self
                .nodes()
                .map(|node| {
                    let children =
                        self.children(node).map(|(arg, child)| (arg, classes[child.index()])).collect();
                    let fresh = table.len() as u32;
                    *table.entry((self.op(node), children)).or_insert(fresh)
                })
                .collect();
            let refined = table.len();
            if refined == count {
                return next;
            }
            (classes, count) = (next, refined);
        }
    }

    /// The reachable graph in which each node is replaced by its representative.
    fn project(&self, representative: impl Fn(NodeIndex) -> NodeIndex) -> (OpGraph, Renumbered) {
        let mut numbers = Renumbered::new();
        let mut graph = DiGraph::new();
        let mut order = vec![representative(self.root)];
        numbers.insert(order[0], graph.add_node(self.op(order[0]).clone()));
        let mut at = 0;
        while at < order.len() {
            let node = order[at];
            at += 1;
            for (_, child) in self.children(node) {
                let child = representative(child);
                numbers.entry(child).or_insert_with(|| {
                    order.push(child);
                    graph.add_node(self.op(child).clone())
                });
            }
        }
        let kept = |node: &NodeIndex| numbers.get(node).copied();
        let mut out = OpGraph {
            graph,
            root: NodeIndex::new(0),
            names: BTreeMap::new(),
            origins: BTreeMap::new(),
            up: self.up,
            data_version: self.data_version,
            sizes: self.sizes.clone(),
            constants: self.constants.clone(),
            styles: self.styles.clone(),
            preamble: self.preamble.clone(),
        };
        for (node, name) in &self.names {
            if let Some(node) = kept(&representative(*node)) {
                out.names.entry(node).or_insert_with(|| name.clone());
            }
        }
        out.origins = self.origins.iter().filter_map(|(n, o)| Some((kept(n)?, o.clone()))).collect();
        for node in order {
            let children =
                self.children(node).map(|(arg, child)| (arg.clone(), numbers[&representative(child)]));
            out.set_children(numbers[&node], children.collect());
        }
        (out, numbers)
    }

    /// All nodes, each after its children; `None` where rules call one another in a ring.
    pub fn children_first(&self) -> Option<Vec<NodeIndex>> {
        let mut order = toposort(&self.graph, None).ok()?;
        order.reverse();
        Some(order)
    }

    /// All nodes that the root leads to, each after its children but for those that lead back to it.
    pub fn inner_first(&self) -> Vec<NodeIndex> {
        let mut order = Vec::with_capacity(self.len());
        let mut seen = vec![false; self.len()];
        let mut open = vec![(self.root, false)];
        while let Some((node, is_done)) = open.pop() {
            if is_done {
                order.push(node);
            } else if !std::mem::replace(&mut seen[node.index()], true) {
                open.push((node, true));
                open.extend(self.children(node).map(|(_, child)| (child, false)));
            }
        }
        order
    }

    /// Whether one or more edges lead from a node to another.
    pub fn leads_to(&self, from: NodeIndex, to: NodeIndex) -> bool {
        let mut seen = vec![false; self.len()];
        let mut open = vec![from];
        while let Some(node) = open.pop() {
            for (_, child) in self.children(node) {
                if child == to {
                    return true;
                }
                if !std::mem::replace(&mut seen[child.index()], true) {
                    open.push(child);
                }
            }
        }
        false
    }

    /// Whether several edges lead to a node.
    pub fn is_shared(&self, node: NodeIndex) -> bool {
        self.graph.edges_directed(node, Direction::Incoming).nth(1).is_some()
    }
}

/// What tells nodes apart: the operation, and the edges with the classes of the children.
type Signature<'g> = (&'g Op, Vec<(&'g Arg, u32)>);

impl PartialEq for OpGraph {
    fn eq(&self, other: &OpGraph) -> bool {
        let (a, b) = (self.unified(), other.unified());
        let constants =
            |graph: &OpGraph| graph.constants.iter().map(|known| known.value.clone()).collect::<Vec<_>>();
        (a.up, a.data_version, &a.sizes, constants(&a), &a.styles, a.len())
            == (b.up, b.data_version, &b.sizes, constants(&b), &b.styles, b.len())
            && a.nodes().all(|node| a.op(node) == b.op(node) && a.children(node).eq(b.children(node)))
    }
}
