use super::{Expr, Thing};
use crate::grammar::Span;
use crate::grammar::ast::{Face, SizeKind};
use crate::space::Up;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;
use std::collections::BTreeMap;
use std::ops::Range;

/// An operation. What it does to each child stands on the edge to that child.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    Primitive {
        name: Expr,
        material: Option<Expr>,
    },
    Nil,
    /// Edges carry sizes. The groups are the rhythms among the children, outer ones first.
    Split {
        axis: Expr,
        groups: Vec<Group>,
    },
    Repeat {
        axis: Expr,
        size: Expr,
    },
    RepeatN {
        axis: Expr,
        count: Expr,
    },
    Translate([Size; 3]),
    Resize([Size; 3]),
    Rotate {
        axis: Expr,
        angle: Expr,
    },
    /// Edges carry faces.
    Comp,
    /// Edges carry alternatives.
    Choose,
    /// Runs its child with these arguments as its parameters.
    Call(Vec<Expr>),
}

/// A run of a split's children that is repeated as often as it fits. Groups may stand inside others.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Group {
    pub children: Range<usize>,
}

/// What an edge carries.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Arg {
    None,
    Size(Size),
    Face(Face),
    Alternative(Alternative),
}

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Size {
    pub kind: SizeKind,
    pub value: Expr,
}

impl Size {
    pub fn absolute(value: Expr) -> Size {
        Size { kind: SizeKind::Absolute, value }
    }

    pub fn floating(weight: f64) -> Size {
        Size { kind: SizeKind::Floating, value: Expr::number(weight) }
    }
}

/// One of the rules of a label.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Alternative {
    pub condition: Option<Expr>,
    pub weight: Expr,
}

/// A size that the start scope may have, with its weight.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct StartSize {
    pub size: [Expr; 3],
    pub weight: Expr,
}

/// The label under which a node is known, and its parameters. Names take no part in equality.
#[derive(Clone, Debug, Default)]
pub struct RuleName {
    pub label: String,
    pub params: Vec<String>,
    /// Comments to print above the rule.
    pub comments: Vec<String>,
}

/// Where in a grammar's text an operation stands.
#[derive(Clone, Debug)]
pub struct Origin {
    pub label: String,
    pub span: Span,
}

/// Operations joined by ordered edges. Hand-written graphs may have cycles, inferred ones have none.
///
/// Two graphs are equal when they describe the same derivations: names do not matter, nor how often an
/// equal operation is written out.
#[derive(Clone, Debug)]
pub struct OpGraph {
    pub(super) graph: DiGraph<Op, Arg>,
    pub(super) root: NodeIndex,
    pub up: Up,
    /// The version of the game that the block states belong to.
    pub data_version: Option<i32>,
    pub sizes: Vec<StartSize>,
    /// Values that are drawn once for a run, with their names.
    pub constants: Vec<(String, Expr)>,
    /// Comments for the head of the file.
    pub preamble: Vec<String>,
    pub(super) names: BTreeMap<NodeIndex, RuleName>,
    pub(super) origins: BTreeMap<NodeIndex, Origin>,
}

impl OpGraph {
    pub fn root(&self) -> NodeIndex {
        self.root
    }

    pub fn op(&self, node: NodeIndex) -> &Op {
        &self.graph[node]
    }

    /// The children in order, with what their edges carry.
    pub fn children(&self, node: NodeIndex) -> impl Iterator<Item = (&Arg, NodeIndex)> {
        self.graph.edges(node).map(|edge| (edge.weight(), edge.target()))
    }

    /// Whether a node is a primitive, turned or not, or nil: too short to have a rule of its own.
    pub fn is_leaf(&self, node: NodeIndex) -> bool {
        match self.op(node) {
            Op::Primitive { .. } | Op::Nil => true,
            Op::Rotate { .. } => {
                self.children(node).all(|(_, child)| matches!(self.op(child), Op::Primitive { .. }))
            }
            _ => false,
        }
    }

    /// How many nodes there are; their indices are the numbers below it.
    pub fn len(&self) -> usize {
        self.graph.node_count()
    }

    /// A graph has a root at least.
    pub fn is_empty(&self) -> bool {
        false
    }

    pub fn edge_count(&self) -> usize {
        self.graph.edge_count()
    }

    pub fn nodes(&self) -> impl Iterator<Item = NodeIndex> + use<> {
        self.graph.node_indices()
    }

    pub fn name(&self, node: NodeIndex) -> Option<&RuleName> {
        self.names.get(&node)
    }

    pub fn set_name(&mut self, node: NodeIndex, name: RuleName) {
        self.names.insert(node, name);
    }

    pub fn origin(&self, node: NodeIndex) -> Option<&Origin> {
        self.origins.get(&node)
    }

    /// Every file that a primitive of the graph is read from, sorted.
    pub fn files(&self) -> Vec<&str> {
        let constants = self.constants.iter().map(|(_, value)| value);
        let own = self.graph.node_weights().flat_map(|op| match op {
            Op::Primitive { name, material } => [Some(name), material.as_ref()],
            _ => [None, None],
        });
        let args = self.graph.node_weights().flat_map(|op| match op {
            Op::Call(args) => args.as_slice(),
            _ => &[],
        });
        let mut files: Vec<&str> = own
            .flatten()
            .chain(args)
            .chain(constants)
            .filter_map(|expr| match expr {
                Expr::Thing(Thing::File(file)) => Some(file.as_str()),
                _ => None,
            })
            .collect();
        files.sort_unstable();
        files.dedup();
        files
    }

    /// petgraph walks the edges of a node from the newest back, so they are added in reverse.
    pub(super) fn set_children(&mut self, node: NodeIndex, children: Vec<(Arg, NodeIndex)>) {
        for (arg, child) in children.into_iter().rev() {
            self.graph.add_edge(node, child, arg);
        }
    }
}
