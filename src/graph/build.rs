use super::unify::Renumbered;
use super::{Alternative, Arg, Expr, Op, OpGraph, Size};
use petgraph::graph::{DiGraph, NodeIndex};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Builds a graph from its leaves up and makes equal operations one node as it goes.
///
/// A node is found by the hash of its operation and its children; both are compared behind the hash.
/// Its functions keep the graph in normal form: no choice of one, no split of one part.
#[derive(Debug, Default)]
pub struct Builder {
    graph: DiGraph<Op, Arg>,
    nodes: FxHashMap<(Op, Children), NodeIndex>,
}

type Children = Vec<(Arg, NodeIndex)>;

impl Builder {
    /// The node of this operation with these children, which is made if there is none yet.
    pub fn node(&mut self, op: Op, children: Children) -> NodeIndex {
        if let Some(&node) = self.nodes.get(&(op.clone(), children.clone())) {
            return node;
        }
        let node = self.graph.add_node(op.clone());
        for (arg, child) in children.iter().rev() {
            self.graph.add_edge(node, *child, arg.clone());
        }
        self.nodes.insert((op, children), node);
        node
    }

    /// A node that may be led to before its children are known: that of a ring. It is equal to no other.
    pub fn later(&mut self, op: Op) -> NodeIndex {
        self.graph.add_node(op)
    }

    /// Gives a node that was made for later its children.
    pub fn complete(&mut self, node: NodeIndex, children: Children) {
        for (arg, child) in children.into_iter().rev() {
            self.graph.add_edge(node, child, arg);
        }
    }

    pub fn nil(&mut self) -> NodeIndex {
        self.node(Op::Nil, Vec::new())
    }

    pub fn primitive(&mut self, name: Expr) -> NodeIndex {
        self.node(Op::primitive(name), Vec::new())
    }

    pub fn split(&mut self, axis: Expr, parts: Vec<(Size, NodeIndex)>) -> NodeIndex {
        match parts.as_slice() {
            [(_, only)] => *only,
            _ => {
                let children = parts.into_iter().map(|(size, child)| (Arg::Size(size), child)).collect();
                self.node(Op::Split { axis, snap: None, groups: Vec::new() }, children)
            }
        }
    }

    /// A choice between nodes by weight; equal ones are joined and their weights added.
    pub fn choose(&mut self, alternatives: impl IntoIterator<Item = (f64, NodeIndex)>) -> NodeIndex {
        let mut joined: Vec<(f64, NodeIndex)> = Vec::new();
        for (weight, child) in alternatives {
            match joined.iter_mut().find(|(_, known)| *known == child) {
                Some((sum, _)) => *sum += weight,
                None => joined.push((weight, child)),
            }
        }
        if let [(_, only)] = joined.as_slice() {
            return *only;
        }
        let alternatives = joined
            .into_iter()
            .map(|(weight, child)| (Arg::Alternative(Alternative::plain(Expr::number(weight))), child));
        self.node(Op::Choose, alternatives.collect())
    }

    pub fn op(&self, node: NodeIndex) -> &Op {
        &self.graph[node]
    }

    /// The part of the graph that `root` reaches, and the new number of each node in it.
    pub fn finish(self, root: NodeIndex) -> (OpGraph, Renumbered) {
        let out = OpGraph {
            graph: self.graph,
            root,
            up: Default::default(),
            data_version: None,
            sizes: Vec::new(),
            constants: Vec::new(),
            styles: Vec::new(),
            preamble: Vec::new(),
            names: BTreeMap::new(),
            origins: BTreeMap::new(),
        };
        out.reachable()
    }
}
