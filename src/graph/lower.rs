//! Lowering: a checked grammar becomes an op graph (seed 1, section 5.1).

use super::{Alternative, Arg, Expr, Group, Number, Op, OpGraph, Origin, RuleName, Size, StartSize, Thing};
use crate::grammar::ast::{self, ExprKind, Ident, Item, Rule, Successor, UnaryOp};
use crate::grammar::{Checked, Name, Names, is_primitive};
use petgraph::graph::{DiGraph, NodeIndex};
use std::collections::BTreeMap;

/// Why a grammar cannot start from a label.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadStart {
    #[error("there is no rule `{label}` to start from; the grammar has {}", .known.join(", "))]
    Unknown { label: String, known: Vec<String> },
    #[error("`{label}` takes parameters ({}), so nothing can start from it: add a rule that calls it", .params.join(", "))]
    TakesParameters { label: String, params: Vec<String> },
}

/// The op graph of a grammar from `start`, or from its first rule.
///
/// A label with one plain rule is that rule's operation; with several rules, or with a condition, it is
/// a choice between them. Every operation of the text is a node of its own, so that it keeps its place
/// in the text; [`OpGraph::unified`] joins equal ones.
pub fn lower(checked: &Checked, start: Option<&str>) -> Result<OpGraph, BadStart> {
    let start = start.unwrap_or_else(|| checked.first_label());
    let label = start.to_owned();
    match checked.rules_of(start).next() {
        None => {
            return Err(BadStart::Unknown { label, known: checked.labels().map(str::to_owned).collect() });
        }
        Some(rule) if !rule.params.is_empty() => {
            let params = rule.params.iter().map(|param| param.name.clone()).collect();
            return Err(BadStart::TakesParameters { label, params });
        }
        Some(_) => {}
    }
    let mut lowering = Lowering::new(checked);
    lowering.out.root = lowering.label(start);
    while let Some((node, work)) = lowering.open.pop() {
        match work {
            Work::Choose(label) => lowering.choose(node, label),
            Work::Rule(rule) => lowering.fill(node, &rule.successor, rule),
        }
    }
    Ok(lowering.out)
}

/// What a reserved node is still to be filled with.
enum Work<'g> {
    Choose(&'g str),
    Rule(&'g Rule),
}

struct Lowering<'g> {
    checked: &'g Checked,
    out: OpGraph,
    labels: BTreeMap<&'g str, NodeIndex>,
    open: Vec<(NodeIndex, Work<'g>)>,
}

impl<'g> Lowering<'g> {
    fn new(checked: &'g Checked) -> Lowering<'g> {
        let grammar = checked.grammar();
        let plain = |expr: &ast::Expr| resolve(expr, Names { params: &[], constants: &grammar.constants });
        let out = OpGraph {
            graph: DiGraph::new(),
            root: NodeIndex::end(),
            up: grammar.up,
            data_version: grammar.data_version,
            sizes: grammar
                .sizes
                .iter()
                .map(|start| StartSize {
                    size: [&start.size[0], &start.size[1], &start.size[2]].map(plain),
                    weight: weight(start.weight.as_ref().map(plain)),
                })
                .collect(),
            constants: grammar
                .constants
                .iter()
                .map(|constant| (constant.name.name.clone(), plain(&constant.value)))
                .collect(),
            preamble: grammar.preamble.clone(),
            names: BTreeMap::new(),
            origins: BTreeMap::new(),
        };
        Lowering { checked, out, labels: BTreeMap::new(), open: Vec::new() }
    }

    /// The node of a label, reserved now and filled later: rules may call one another in rings.
    fn label(&mut self, label: &'g str) -> NodeIndex {
        let checked = self.checked;
        let mut names = vec![label];
        let node = loop {
            let label = names[names.len() - 1];
            if let Some(&node) = self.labels.get(label) {
                break node;
            }
            let mut rules = checked.rules_of(label);
            match (rules.next(), rules.next()) {
                (Some(rule), None) if rule.condition.is_none() => match &rule.successor.op {
                    ast::Op::Call { label, args } if args.is_empty() => names.push(&label.name),
                    _ => break self.reserve(rule, Work::Rule(rule)),
                },
                (Some(rule), _) => break self.reserve(rule, Work::Choose(label)),
                (None, _) => unreachable!("a checked grammar has rules for every label"),
            }
        };
        self.labels.extend(names.into_iter().map(|name| (name, node)));
        node
    }

    fn reserve(&mut self, rule: &'g Rule, work: Work<'g>) -> NodeIndex {
        let node = self.out.graph.add_node(Op::Nil);
        let params = rule.params.iter().map(|param| param.name.clone()).collect();
        let name = RuleName { label: rule.label.name.clone(), params, comments: rule.comments.clone() };
        self.out.names.insert(node, name);
        self.open.push((node, work));
        node
    }

    fn choose(&mut self, node: NodeIndex, label: &'g str) {
        let checked = self.checked;
        let mut children = Vec::new();
        for rule in checked.rules_of(label) {
            let alternative = Alternative {
                condition: rule.condition.as_ref().map(|condition| self.expr(condition, rule)),
                weight: weight(rule.weight.as_ref().map(|weight| self.expr(weight, rule))),
            };
            self.out.origins.entry(node).or_insert(Origin { label: label.to_owned(), span: rule.label.span });
            children.push((Arg::Alternative(alternative), self.child(&rule.successor, rule)));
        }
        self.out.graph[node] = Op::Choose;
        self.out.set_children(node, children);
    }

    /// The node of an operation inside a rule.
    fn child(&mut self, successor: &'g Successor, rule: &'g Rule) -> NodeIndex {
        match &successor.op {
            ast::Op::Call { label, args } if args.is_empty() => self.label(&label.name),
            _ => {
                let node = self.out.graph.add_node(Op::Nil);
                self.fill(node, successor, rule);
                node
            }
        }
    }

    fn fill(&mut self, node: NodeIndex, successor: &'g Successor, rule: &'g Rule) {
        let expr = |expr: &ast::Expr| self.expr(expr, rule);
        let size = |size: &ast::Size| Size { kind: size.kind, value: expr(&size.value) };
        let sizes = |sizes: &[ast::Size; 3]| [&sizes[0], &sizes[1], &sizes[2]].map(size);
        let (op, children) = match &successor.op {
            ast::Op::Nil => (Op::Nil, Vec::new()),
            ast::Op::Primitive { name, material } => {
                (self.primitive(name, material.as_ref(), rule), Vec::new())
            }
            ast::Op::Call { label, args } => {
                let args = args.iter().map(expr).collect();
                (Op::Call(args), vec![(Arg::None, self.label(&label.name))])
            }
            ast::Op::Split { axis, items } => {
                let axis = expr(axis);
                let (mut groups, mut children) = (Vec::new(), Vec::new());
                self.items(items, rule, &mut groups, &mut children);
                (Op::Split { axis, groups }, children)
            }
            ast::Op::Repeat { axis, size, body } => {
                (Op::Repeat { axis: expr(axis), size: expr(size) }, self.only(body, rule))
            }
            ast::Op::RepeatN { axis, count, body } => {
                (Op::RepeatN { axis: expr(axis), count: expr(count) }, self.only(body, rule))
            }
            ast::Op::Translate { delta, body } => (Op::Translate(sizes(delta)), self.only(body, rule)),
            ast::Op::Resize { size, body } => (Op::Resize(sizes(size)), self.only(body, rule)),
            ast::Op::Rotate { axis, angle, body } => {
                (Op::Rotate { axis: expr(axis), angle: expr(angle) }, self.only(body, rule))
            }
            ast::Op::Comp { parts } => {
                let faces =
                    parts.iter().map(|(face, body)| (Arg::Face(*face), self.child(body, rule))).collect();
                (Op::Comp, faces)
            }
        };
        self.out.graph[node] = op;
        self.out.set_children(node, children);
        self.out.origins.insert(node, Origin { label: rule.label.name.clone(), span: successor.span });
    }

    /// A primitive. A constant with the name of a shape says what that shape is made of.
    fn primitive(&self, name: &ast::Expr, material: Option<&ast::Expr>, rule: &Rule) -> Op {
        let material = material.map(|material| self.expr(material, rule));
        let resolved = self.expr(name, rule);
        match (&name.kind, &resolved) {
            (ExprKind::Name(text), Expr::Constant(_)) if is_primitive(text) => {
                Op::Primitive { name: Expr::name(text.clone()), material: material.or(Some(resolved)) }
            }
            _ => Op::Primitive { name: resolved, material },
        }
    }

    fn only(&mut self, body: &'g Successor, rule: &'g Rule) -> Vec<(Arg, NodeIndex)> {
        vec![(Arg::None, self.child(body, rule))]
    }

    fn items(
        &mut self,
        items: &'g [Item],
        rule: &'g Rule,
        groups: &mut Vec<Group>,
        children: &mut Vec<(Arg, NodeIndex)>,
    ) {
        for item in items {
            match item {
                Item::Part { size, body } => {
                    let size = Size { kind: size.kind, value: self.expr(&size.value, rule) };
                    children.push((Arg::Size(size), self.child(body, rule)));
                }
                Item::Group { items, .. } => {
                    let (at, first) = (groups.len(), children.len());
                    groups.push(Group { children: first..first });
                    self.items(items, rule, groups, children);
                    groups[at].children.end = children.len();
                }
            }
        }
    }

    fn expr(&self, expr: &ast::Expr, rule: &Rule) -> Expr {
        let constants = &self.checked.grammar().constants;
        resolve(expr, Names { params: &rule.params as &[Ident], constants })
    }
}

fn weight(weight: Option<Expr>) -> Expr {
    weight.unwrap_or(Expr::number(1.0))
}

fn resolve(expr: &ast::Expr, names: Names<'_>) -> Expr {
    let inner = |expr: &ast::Expr| Box::new(resolve(expr, names));
    match &expr.kind {
        ExprKind::Number(value) => Expr::Number(Number(*value)),
        ExprKind::Name(name) => match names.resolve(name) {
            Name::Param(at) => Expr::Param(at),
            Name::Constant(at) => Expr::Constant(at),
            Name::Axis(axis) => Expr::Axis(axis),
            Name::Number(value) => Expr::Number(Number(value)),
            Name::Thing => Expr::Thing(Thing::Name(name.clone())),
        },
        ExprKind::Block(text) => Expr::Thing(Thing::Block(text.clone())),
        ExprKind::File(name) => Expr::Thing(Thing::File(name.clone())),
        ExprKind::ScopeSize(axis) => Expr::ScopeSize(*axis),
        ExprKind::Unary(op, operand) => match (op, *inner(operand)) {
            // A number below zero is one number, whichever way it came to the graph.
            (UnaryOp::Negate, Expr::Number(Number(value))) => Expr::number(-value),
            (op, operand) => Expr::Unary(*op, Box::new(operand)),
        },
        ExprKind::Binary(op, left, right) => Expr::Binary(*op, inner(left), inner(right)),
        ExprKind::Call(function, args) => {
            Expr::Call(*function, args.iter().map(|arg| resolve(arg, names)).collect())
        }
    }
}
