use super::{Expr, Thing};
use crate::grammar::Span;
use crate::grammar::ast::{Carving, Rule, Selector, SizeKind, Snap};
use crate::space::Up;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::ops::Range;

/// An operation. What it does to each child stands on the edge to that child.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    Primitive {
        name: Expr,
        material: Option<Expr>,
        /// In the order of the text.
        options: Vec<(String, Expr)>,
    },
    Nil,
    /// Runs every child in the same scope, in order.
    All,
    /// Edges carry sizes. The groups are the rhythms among the children, outer ones first.
    Split {
        axis: Expr,
        snap: Option<Snap>,
        groups: Vec<Group>,
    },
    Repeat {
        axis: Expr,
        size: Expr,
        snap: Option<Snap>,
    },
    RepeatN {
        axis: Expr,
        count: Expr,
    },
    /// Edges carry selectors.
    Carve {
        how: Carving,
        args: Vec<Expr>,
    },
    Translate([Size; 3]),
    Resize([Size; 3]),
    Rotate {
        axis: Expr,
        angle: Expr,
    },
    /// Keeps snap planes and coherent draws inside to itself.
    Local,
    /// Draws inside come from a key.
    Same(Expr),
    /// Constants inside have the values of the style of that number.
    Style(usize),
    /// Marks the planes that bound the scope.
    Snap {
        axis: Expr,
        label: Option<String>,
    },
    /// A shape with a label that some query asks for.
    Shape(String),
    /// Edges carry alternatives.
    Choose,
    /// Runs its child with these arguments as its parameters.
    Call(Vec<Expr>),
}

impl Op {
    /// A primitive that is all that its name says.
    pub fn primitive(name: Expr) -> Op {
        Op::Primitive { name, material: None, options: Vec::new() }
    }

    /// Its own expressions, without those on its edges.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        let mut list: SmallVec<[&Expr; 4]> = SmallVec::new();
        match self {
            Op::Primitive { name, material, options } => {
                list.push(name);
                list.extend(material);
                list.extend(options.iter().map(|(_, value)| value));
            }
            Op::Split { axis, .. } | Op::Snap { axis, .. } => list.push(axis),
            Op::Repeat { axis, size: other, .. }
            | Op::RepeatN { axis, count: other }
            | Op::Rotate { axis, angle: other } => list.extend([axis, other]),
            Op::Carve { args, .. } | Op::Call(args) => list.extend(args),
            Op::Translate(sizes) | Op::Resize(sizes) => list.extend(sizes.iter().map(|size| &size.value)),
            Op::Same(key) => list.push(key),
            Op::Nil | Op::All | Op::Local | Op::Style(_) | Op::Shape(_) | Op::Choose => {}
        }
        list.into_iter()
    }
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
    Part(Selector),
    Alternative(Alternative),
}

impl Arg {
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        let list: [Option<&Expr>; 2] = match self {
            Arg::None | Arg::Part(_) => [None, None],
            Arg::Size(size) => [Some(&size.value), None],
            Arg::Alternative(alternative) => [Some(&alternative.weight), alternative.condition.as_ref()],
        };
        list.into_iter().flatten()
    }
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
    /// Alternatives of a lower number are tried first.
    pub priority: u32,
}

impl Alternative {
    /// One without a condition, of the first priority.
    pub fn plain(weight: Expr) -> Alternative {
        Alternative { condition: None, weight, priority: Rule::FIRST }
    }
}

/// A value that is drawn once for a run.
#[derive(Clone, Debug)]
pub struct Constant {
    pub name: String,
    pub value: Expr,
    /// What the text tells about it, if a run may set it.
    pub attribute: Option<Attribute>,
}

/// What `attr` tells. It takes no part in equality.
#[derive(Clone, Debug, Default)]
pub struct Attribute {
    pub range: Option<[Expr; 2]>,
    pub group: Option<String>,
    pub about: Option<String>,
}

/// Other values for constants, by their place.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Style {
    pub name: String,
    pub values: Vec<(usize, Expr)>,
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
    pub constants: Vec<Constant>,
    pub styles: Vec<Style>,
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

    /// Whether a node is a primitive, turned or not, nil, or a call: too short to have a rule of its own.
    pub fn is_leaf(&self, node: NodeIndex) -> bool {
        match self.op(node) {
            Op::Primitive { .. } | Op::Nil | Op::Call(_) => true,
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

    /// Every file that the graph names, sorted.
    pub fn files(&self) -> Vec<&str> {
        let constants = self.constants.iter().map(|constant| &constant.value);
        let styled = self.styles.iter().flat_map(|style| style.values.iter().map(|(_, value)| value));
        let own = self.graph.node_weights().flat_map(Op::exprs);
        let mut files = Vec::new();
        for expr in constants.chain(styled).chain(own) {
            expr.for_each(&mut |part| {
                if let Expr::Thing(Thing::File(file)) = part {
                    files.push(file.as_str());
                }
            });
        }
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
