//! Raising: an op graph becomes a grammar (seed 1, chapter 11).

use super::{Arg, Expr, Op, OpGraph, Size, Thing};
use crate::grammar::Grammar;
use crate::grammar::ast::{self, Constant, ExprKind, Ident, Item, Rule, StartSize, Successor};
use petgraph::Direction;
use petgraph::graph::NodeIndex;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::f64::consts::PI;

/// The grammar of an op graph. Lowering it gives back an equal graph.
///
/// A node gets rules of its own where it must (choices, operations that are called with arguments or
/// shared) or where it has a name; everything else is nested in the rule around it.
pub fn raise(graph: &OpGraph) -> Grammar {
    let mut raising = Raising::new(graph);
    let mut grammar = Grammar {
        preamble: graph.preamble.clone(),
        up: graph.up,
        data_version: graph.data_version,
        sizes: graph.sizes.iter().map(|size| raising.start_size(size)).collect(),
        constants: graph.constants.iter().map(|(name, value)| raising.constant(name, value)).collect(),
        rules: Vec::new(),
    };
    raising.label(graph.root, 0);
    while let Some((node, arity)) = raising.open.pop_front() {
        grammar.rules.extend(raising.rules(node, arity));
    }
    grammar
}

struct Raising<'g> {
    graph: &'g OpGraph,
    /// Whether what can be derived from a node depends on the parameters of the rule around it.
    open_params: Vec<bool>,
    labels: BTreeMap<(NodeIndex, usize), String>,
    taken: BTreeSet<String>,
    /// By name, the number that the next label of that name tries first.
    numbers: BTreeMap<String, u32>,
    open: VecDeque<(NodeIndex, usize)>,
}

impl<'g> Raising<'g> {
    fn new(graph: &'g OpGraph) -> Raising<'g> {
        let taken = graph.constants.iter().map(|(name, _)| name.clone()).collect();
        let open_params = open_params(graph);
        Raising {
            graph,
            open_params,
            labels: BTreeMap::new(),
            taken,
            numbers: BTreeMap::new(),
            open: VecDeque::new(),
        }
    }

    /// The label of a node that takes `arity` parameters; its rules follow.
    fn label(&mut self, node: NodeIndex, arity: usize) -> Ident {
        if let Some(label) = self.labels.get(&(node, arity)) {
            return Ident::new(label.clone());
        }
        let base = self.graph.name(node).map_or("rule", |name| &name.label);
        let next = self.numbers.entry(base.to_owned()).or_insert(1);
        let label = loop {
            let label = if *next == 1 { base.to_owned() } else { format!("{base}_{next}") };
            *next += 1;
            if !self.taken.contains(&label) {
                break label;
            }
        };
        self.taken.insert(label.clone());
        self.labels.insert((node, arity), label.clone());
        self.open.push_back((node, arity));
        Ident::new(label)
    }

    fn rules(&mut self, node: NodeIndex, arity: usize) -> Vec<Rule> {
        let label = self.label(node, arity);
        let known = self.graph.name(node);
        let names = known.map(|name| name.params.clone()).filter(|names| names.len() == arity);
        let params = self.params(names.unwrap_or_default(), arity);
        let mut comments = known.map(|name| name.comments.clone()).unwrap_or_default();
        let idents: Vec<Ident> = params.iter().map(Ident::new).collect();
        let mut rule = |condition, successor, weight| Rule {
            comments: std::mem::take(&mut comments),
            label: label.clone(),
            params: idents.clone(),
            condition,
            successor,
            weight,
        };
        if *self.graph.op(node) != Op::Choose {
            return vec![rule(None, self.op(node, &params), None)];
        }
        let graph = self.graph;
        let alternatives = graph.children(node).filter_map(|(arg, child)| match arg {
            Arg::Alternative(alternative) => Some((alternative, child)),
            _ => None,
        });
        alternatives
            .map(|(alternative, child)| {
                let condition = alternative.condition.as_ref().map(|condition| self.expr(condition, &params));
                let is_plain = alternative.weight == Expr::number(1.0);
                let weight = (!is_plain).then(|| self.expr(&alternative.weight, &params));
                rule(condition, self.successor(child, &params), weight)
            })
            .collect()
    }

    /// Names for parameters: their own, unless a constant has them, which they would hide.
    fn params(&self, own: Vec<String>, arity: usize) -> Vec<String> {
        let is_constant = |name: &String| self.graph.constants.iter().any(|(known, _)| known == name);
        let fresh = (0..).map(|at| format!("p{at}")).filter(|name| !is_constant(name) && !own.contains(name));
        let mut fresh = fresh.take(arity);
        let mut own = own.iter().map(|name| Some(name.clone()).filter(|name| !is_constant(name)));
        (0..arity).filter_map(|_| own.next().flatten().or_else(|| fresh.next())).collect()
    }

    /// A child: its label if it has rules of its own, else its operation.
    fn successor(&mut self, node: NodeIndex, params: &[String]) -> Successor {
        match self.needs_rule(node) {
            true => Successor::new(ast::Op::Call { label: self.label(node, 0), args: Vec::new() }),
            false => self.op(node, params),
        }
    }

    fn needs_rule(&self, node: NodeIndex) -> bool {
        if self.open_params[node.index()] {
            return false;
        }
        let is_leaf = self.graph.is_leaf(node);
        let is_root = node == self.graph.root;
        *self.graph.op(node) == Op::Choose
            || is_root
            || (!is_leaf && (self.graph.is_shared(node) || self.graph.name(node).is_some()))
    }

    fn op(&mut self, node: NodeIndex, params: &[String]) -> Successor {
        let graph = self.graph;
        let mut children = graph.children(node);
        let mut only = |raising: &mut Self| {
            let child = children.next().map(|(_, child)| raising.successor(child, params));
            Box::new(child.unwrap_or_else(|| Successor::new(ast::Op::Nil)))
        };
        Successor::new(match graph.op(node) {
            Op::Nil => ast::Op::Nil,
            Op::Primitive { name, material } => {
                let text = self.expr(name, params);
                let material = material.as_ref().and_then(|material| {
                    let raised = self.expr(material, params);
                    // A constant of the shape's own name is what the shape is made of unless another is named.
                    let is_own = matches!((name, material), (Expr::Thing(_), Expr::Constant(_)));
                    (!is_own || raised.kind != text.kind).then_some(raised)
                });
                ast::Op::Primitive { name: text, material }
            }
            Op::Call(args) => {
                let target = graph.children(node).next().map_or(node, |(_, child)| child);
                ast::Op::Call {
                    label: self.label(target, args.len()),
                    args: args.iter().map(|arg| self.expr(arg, params)).collect(),
                }
            }
            Op::Split { axis, .. } => {
                ast::Op::Split { axis: self.expr(axis, params), items: self.items(node, params) }
            }
            Op::Repeat { axis, size } => ast::Op::Repeat {
                axis: self.expr(axis, params),
                size: self.expr(size, params),
                body: only(self),
            },
            Op::RepeatN { axis, count } => ast::Op::RepeatN {
                axis: self.expr(axis, params),
                count: self.expr(count, params),
                body: only(self),
            },
            Op::Translate(delta) => ast::Op::Translate { delta: self.sizes(delta, params), body: only(self) },
            Op::Resize(size) => ast::Op::Resize { size: self.sizes(size, params), body: only(self) },
            Op::Rotate { axis, angle } => ast::Op::Rotate {
                axis: self.expr(axis, params),
                angle: self.expr(angle, params),
                body: only(self),
            },
            Op::Comp => ast::Op::Comp {
                parts: graph
                    .children(node)
                    .filter_map(|(arg, child)| match arg {
                        Arg::Face(face) => Some((*face, self.successor(child, params))),
                        _ => None,
                    })
                    .collect(),
            },
            Op::Choose => unreachable!("a choice has rules of its own"),
        })
    }

    fn items(&mut self, node: NodeIndex, params: &[String]) -> Vec<Item> {
        let Op::Split { groups, .. } = self.graph.op(node) else { return Vec::new() };
        let mut done: Vec<Vec<Item>> = vec![Vec::new()];
        let mut ends: Vec<usize> = Vec::new();
        let mut groups = groups.iter().peekable();
        for (at, (arg, child)) in self.graph.children(node).enumerate() {
            while let Some(group) = groups.next_if(|group| group.children.start == at) {
                ends.push(group.children.end);
                done.push(Vec::new());
            }
            if let (Arg::Size(size), Some(items)) = (arg, done.last_mut()) {
                let size = self.size(size, params);
                items.push(Item::Part { size, body: self.successor(child, params) });
            }
            while ends.pop_if(|end| *end == at + 1).is_some() {
                let items = done.pop().unwrap_or_default();
                let group = Item::Group { items, span: Default::default() };
                done.last_mut().into_iter().for_each(|outer| outer.push(group.clone()));
            }
        }
        done.pop().unwrap_or_default()
    }

    fn size(&self, size: &Size, params: &[String]) -> ast::Size {
        ast::Size { kind: size.kind, value: self.expr(&size.value, params) }
    }

    fn sizes(&self, sizes: &[Size; 3], params: &[String]) -> [ast::Size; 3] {
        [&sizes[0], &sizes[1], &sizes[2]].map(|size| self.size(size, params))
    }

    fn start_size(&self, start: &super::StartSize) -> StartSize {
        let is_plain = start.weight == Expr::number(1.0);
        StartSize {
            comments: Vec::new(),
            size: [&start.size[0], &start.size[1], &start.size[2]].map(|length| self.expr(length, &[])),
            weight: (!is_plain).then(|| self.expr(&start.weight, &[])),
            span: Default::default(),
        }
    }

    fn constant(&self, name: &str, value: &Expr) -> Constant {
        Constant { comments: Vec::new(), name: Ident::new(name), value: self.expr(value, &[]) }
    }

    fn expr(&self, expr: &Expr, params: &[String]) -> ast::Expr {
        raise_expr(self.graph, expr, params)
    }
}

/// An expression in the words of the text, with these names for the parameters.
pub(super) fn raise_expr(graph: &OpGraph, expr: &Expr, params: &[String]) -> ast::Expr {
    let raise = |expr: &Expr| raise_expr(graph, expr, params);
    let inner = |expr: &Expr| Box::new(raise(expr));
    let name_of = |names: Option<&String>| ExprKind::Name(names.cloned().unwrap_or_default());
    ast::Expr::new(match expr {
        Expr::Number(number) if number.0 < 0.0 => {
            ExprKind::Unary(ast::UnaryOp::Negate, Box::new(ast::Expr::number(-number.0)))
        }
        Expr::Number(number) if number.0 == PI => ExprKind::Name("pi".to_owned()),
        Expr::Number(number) => ExprKind::Number(number.0),
        Expr::Axis(axis) => ExprKind::Name(axis.to_string()),
        Expr::Thing(Thing::Name(name)) => ExprKind::Name(name.clone()),
        Expr::Thing(Thing::Block(text)) => ExprKind::Block(text.clone()),
        Expr::Thing(Thing::File(name)) => ExprKind::File(name.clone()),
        Expr::Param(at) => name_of(params.get(*at)),
        Expr::Constant(at) => name_of(graph.constants.get(*at).map(|(name, _)| name)),
        Expr::ScopeSize(axis) => ExprKind::ScopeSize(*axis),
        Expr::Unary(op, operand) => ExprKind::Unary(*op, inner(operand)),
        Expr::Binary(op, left, right) => ExprKind::Binary(*op, inner(left), inner(right)),
        Expr::Call(function, args) => ExprKind::Call(*function, args.iter().map(raise).collect()),
    })
}

/// For each node, whether it or a node below it, short of a call's target, uses a parameter.
fn open_params(graph: &OpGraph) -> Vec<bool> {
    let mut open = vec![false; graph.len()];
    let mut todo: Vec<NodeIndex> = graph.nodes().filter(|node| uses_params(graph, *node)).collect();
    while let Some(node) = todo.pop() {
        if std::mem::replace(&mut open[node.index()], true) {
            continue;
        }
        let users = graph.graph.neighbors_directed(node, Direction::Incoming);
        todo.extend(users.filter(|user| !matches!(graph.op(*user), Op::Call(_))));
    }
    open
}

fn uses_params(graph: &OpGraph, node: NodeIndex) -> bool {
    let own = match graph.op(node) {
        Op::Primitive { name, material } => {
            name.uses_params() || material.as_ref().is_some_and(Expr::uses_params)
        }
        Op::Split { axis, .. } => axis.uses_params(),
        Op::Repeat { axis, size: other }
        | Op::RepeatN { axis, count: other }
        | Op::Rotate { axis, angle: other } => axis.uses_params() || other.uses_params(),
        Op::Translate(sizes) | Op::Resize(sizes) => sizes.iter().any(|size| size.value.uses_params()),
        Op::Call(args) => args.iter().any(Expr::uses_params),
        Op::Nil | Op::Comp | Op::Choose => false,
    };
    own || graph.children(node).any(|(arg, _)| match arg {
        Arg::Size(size) => size.value.uses_params(),
        Arg::Alternative(alternative) => {
            alternative.weight.uses_params() || alternative.condition.as_ref().is_some_and(Expr::uses_params)
        }
        Arg::None | Arg::Face(_) => false,
    })
}
