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
        imports: Vec::new(),
        constants: raised_constants(graph),
        styles: graph.styles.iter().map(|style| raising.style(style)).collect(),
        rules: Vec::new(),
        imported: BTreeSet::new(),
        epilogue: Vec::new(),
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
        let shapes = graph.nodes().filter_map(|node| shape_label(graph, node)).map(str::to_owned);
        let taken = graph.constants.iter().map(|known| known.name.clone()).chain(shapes).collect();
        let open_params = graph.open_params();
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
        if let Some(label) = shape_label(self.graph, node) {
            self.labels.insert((node, arity), label.to_owned());
            self.open.push_back((node, arity));
            return Ident::new(label);
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
        let mut rule = |condition, successor, weight, priority| Rule {
            comments: std::mem::take(&mut comments),
            behind: None,
            label: label.clone(),
            params: idents.clone(),
            condition,
            successor,
            weight,
            priority,
        };
        let graph = self.graph;
        let body = match graph.op(node) {
            Op::Shape(_) => only_child(graph, node),
            _ => node,
        };
        if body != node && self.needs_rule(body) && self.has_label(body) {
            return vec![rule(None, self.successor(body, &params), None, Rule::FIRST)];
        }
        if *graph.op(body) != Op::Choose {
            return vec![rule(None, self.op(body, &params), None, Rule::FIRST)];
        }
        let alternatives = graph.children(body).filter_map(|(arg, child)| match arg {
            Arg::Alternative(alternative) => Some((alternative, child)),
            _ => None,
        });
        alternatives
            .map(|(alternative, child)| {
                let condition = alternative.condition.as_ref().map(|condition| self.expr(condition, &params));
                let is_plain = alternative.weight == Expr::number(1.0);
                let weight = (!is_plain).then(|| self.expr(&alternative.weight, &params));
                rule(condition, self.successor(child, &params), weight, alternative.priority)
            })
            .collect()
    }

    /// Whether a node is one that rules have, apart from a shape's mark above it.
    fn has_label(&self, node: NodeIndex) -> bool {
        self.graph.name(node).is_some() || self.graph.is_shared(node) || node == self.graph.root
    }

    /// Names for parameters: their own, unless a constant has them, which they would hide.
    fn params(&self, own: Vec<String>, arity: usize) -> Vec<String> {
        let is_constant = |name: &String| self.graph.constants.iter().any(|known| known.name == *name);
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
        matches!(self.graph.op(node), Op::Choose | Op::Shape(_))
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
            Op::Primitive { name, material, options } => {
                let text = self.expr(name, params);
                let material = material.as_ref().and_then(|material| {
                    let raised = self.expr(material, params);
                    // A constant of the shape's own name is what the shape is made of unless another is named.
                    let is_own = matches!((name, material), (Expr::Thing(_), Expr::Constant(_)));
                    (!is_own || raised.kind != text.kind).then_some(raised)
                });
                let options =
                    options.iter().map(|(option, value)| (Ident::new(option), self.expr(value, params)));
                ast::Op::Primitive { name: text, material, options: options.collect() }
            }
            Op::Call(args) => {
                let target = graph.children(node).next().map_or(node, |(_, child)| child);
                ast::Op::Call {
                    label: self.label(target, args.len()),
                    args: args.iter().map(|arg| self.expr(arg, params)).collect(),
                }
            }
            Op::All => ast::Op::All(children.map(|(_, child)| self.successor(child, params)).collect()),
            Op::Split { axis, snap, .. } => ast::Op::Split {
                axis: self.expr(axis, params),
                snap: snap.clone(),
                items: self.items(node, params),
            },
            Op::Repeat { axis, size, snap } => ast::Op::Repeat {
                axis: self.expr(axis, params),
                size: self.expr(size, params),
                snap: snap.clone(),
                body: only(self),
            },
            Op::RepeatN { axis, count } => ast::Op::RepeatN {
                axis: self.expr(axis, params),
                count: self.expr(count, params),
                body: only(self),
            },
            Op::Carve { how, args } => ast::Op::Carve {
                how: *how,
                args: args.iter().map(|arg| self.expr(arg, params)).collect(),
                parts: children
                    .filter_map(|(arg, child)| match arg {
                        Arg::Part(selector) => Some((selector.clone(), self.successor(child, params))),
                        _ => None,
                    })
                    .collect(),
            },
            Op::Snap { axis, label } => {
                ast::Op::Snap { axis: self.expr(axis, params), label: label.as_ref().map(Ident::new) }
            }
            op @ (Op::Translate(_)
            | Op::Resize(_)
            | Op::Rotate { .. }
            | Op::Local
            | Op::Same(_)
            | Op::Style(_)) => ast::Op::Within { change: self.change(op, params), body: only(self) },
            Op::Choose | Op::Shape(_) => unreachable!("a choice and a marked shape have rules of their own"),
        })
    }

    fn change(&self, op: &Op, params: &[String]) -> ast::Change {
        match op {
            Op::Translate(delta) => ast::Change::Translate(self.sizes(delta, params)),
            Op::Resize(size) => ast::Change::Resize(self.sizes(size, params)),
            Op::Rotate { axis, angle } => {
                ast::Change::Rotate { axis: self.expr(axis, params), angle: self.expr(angle, params) }
            }
            Op::Same(key) => ast::Change::Same(self.expr(key, params)),
            Op::Style(at) => {
                ast::Change::Style(Ident::new(self.graph.styles.get(*at).map_or("", |style| &style.name)))
            }
            _ => ast::Change::Local,
        }
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
            behind: None,
            size: [&start.size[0], &start.size[1], &start.size[2]].map(|length| self.expr(length, &[])),
            weight: (!is_plain).then(|| self.expr(&start.weight, &[])),
            span: Default::default(),
        }
    }

    fn style(&self, style: &super::Style) -> ast::Style {
        let name_of = |at: usize| Ident::new(self.graph.constants.get(at).map_or("", |known| &known.name));
        let values = style.values.iter().map(|(at, value)| (name_of(*at), self.expr(value, &[])));
        ast::Style {
            comments: Vec::new(),
            behind: None,
            name: Ident::new(&style.name),
            values: values.collect(),
        }
    }

    fn expr(&self, expr: &Expr, params: &[String]) -> ast::Expr {
        raise_expr(self.graph, expr, params)
    }
}

/// The constants of a graph as a grammar has them.
pub(super) fn raised_constants(graph: &OpGraph) -> Vec<Constant> {
    graph.constants.iter().map(|known| constant(graph, known)).collect()
}

fn constant(graph: &OpGraph, known: &super::Constant) -> Constant {
    let expr = |expr: &Expr| raise_expr(graph, expr, &[]);
    let attribute = known.attribute.as_ref().map(|attribute| ast::Attribute {
        range: attribute.range.as_ref().map(|[low, high]| [expr(low), expr(high)]),
        group: attribute.group.clone(),
        about: attribute.about.clone(),
    });
    Constant {
        comments: Vec::new(),
        behind: None,
        name: Ident::new(&known.name),
        value: expr(&known.value),
        attribute,
    }
}

/// The label that a node marks, if it marks one.
fn shape_label(graph: &OpGraph, node: NodeIndex) -> Option<&str> {
    match graph.op(node) {
        Op::Shape(label) => Some(label),
        _ => None,
    }
}

fn only_child(graph: &OpGraph, node: NodeIndex) -> NodeIndex {
    graph.children(node).next().map_or(node, |(_, child)| child)
}

/// An expression in the words of the text, with these names for the parameters.
pub(super) fn raise_expr(graph: &OpGraph, expr: &Expr, params: &[String]) -> ast::Expr {
    let raise = |expr: &Expr| raise_expr(graph, expr, params);
    let inner = |expr: &Expr| Box::new(raise(expr));
    let weighted = |parts: &[(Expr, Expr)]| {
        parts.iter().map(|(weight, value)| (raise(weight), raise(value))).collect::<Vec<_>>()
    };
    let name_of = |names: Option<&String>| ExprKind::Name(names.cloned().unwrap_or_default());
    ast::Expr::new(match expr {
        Expr::Number(number) if number.0 < 0.0 => {
            ExprKind::Unary(ast::UnaryOp::Negate, Box::new(ast::Expr::number(-number.0)))
        }
        Expr::Number(number) if number.0 == PI => ExprKind::Name("pi".to_owned()),
        Expr::Number(number) => ExprKind::Number(number.0),
        Expr::Axis(axis) => ExprKind::Name(axis.to_string()),
        Expr::Thing(thing) => return raise_thing(thing),
        Expr::Param(at) => name_of(params.get(*at)),
        Expr::Constant(at) => name_of(graph.constants.get(*at).map(|known| &known.name)),
        Expr::ScopeSize(axis) => ExprKind::ScopeSize(*axis),
        Expr::Unary(op, operand) => ExprKind::Unary(*op, inner(operand)),
        Expr::Binary(op, left, right) => ExprKind::Binary(*op, inner(left), inner(right)),
        Expr::Call(function, args) => ExprKind::Call(*function, args.iter().map(raise).collect()),
        Expr::Share(share) => ExprKind::Share(*share),
        Expr::Pick(parts) => ExprKind::Pick(weighted(parts)),
        Expr::Mix(parts) => ExprKind::Mix(weighted(parts)),
        Expr::Gradient(axis, blocks) => ExprKind::Gradient(inner(axis), blocks.iter().map(raise).collect()),
        Expr::State(base, properties) => ExprKind::Block(format!("{}[{properties}]", raise(base))),
        Expr::Same(key, value) => ExprKind::Same(inner(key), inner(value)),
        Expr::Occlusion { against, distance } => {
            ExprKind::Occlusion { against: against.clone(), distance: distance.as_deref().map(inner) }
        }
        Expr::Visible(label) => ExprKind::Visible(label.clone()),
    })
}

fn raise_thing(thing: &Thing) -> ast::Expr {
    let weighted =
        |(weight, thing): &(super::Number, Thing)| (ast::Expr::number(weight.0), raise_thing(thing));
    ast::Expr::new(match thing {
        Thing::Name(name) => ExprKind::Name(name.clone()),
        Thing::Block(text) => ExprKind::Block(text.clone()),
        Thing::File(name) => ExprKind::File(name.clone()),
        Thing::Mix(parts) => ExprKind::Mix(parts.iter().map(weighted).collect()),
        Thing::Gradient(axis, parts) => ExprKind::Gradient(
            Box::new(ast::Expr::name(axis.to_string())),
            parts.iter().map(raise_thing).collect(),
        ),
    })
}

impl OpGraph {
    /// For each node, whether it or a node below it, short of a call's target, uses a parameter.
    pub fn open_params(&self) -> Vec<bool> {
        let mut open = vec![false; self.len()];
        let mut todo: Vec<NodeIndex> = self.nodes().filter(|node| uses_params(self, *node)).collect();
        while let Some(node) = todo.pop() {
            if std::mem::replace(&mut open[node.index()], true) {
                continue;
            }
            let users = self.graph.neighbors_directed(node, Direction::Incoming);
            todo.extend(users.filter(|user| !matches!(self.op(*user), Op::Call(_))));
        }
        open
    }
}

fn uses_params(graph: &OpGraph, node: NodeIndex) -> bool {
    let on_edges = graph.children(node).any(|(arg, _)| arg.exprs().any(Expr::uses_params));
    on_edges || graph.op(node).exprs().any(Expr::uses_params)
}
