//! Lowering: a checked grammar becomes an op graph (seed 1, section 5.1).

use super::{
    Alternative, Arg, Attribute, Constant, Expr, Group, Number, Op, OpGraph, Origin, RuleName, Size,
    StartSize, Style, Thing,
};
use crate::grammar::ast::{
    self, Against, ExprKind, Ident, Item, Rule, Successor, UnaryOp, for_each_call, for_each_expr_of_rule,
};
use crate::grammar::{Checked, Grammar, Name, Names, is_primitive};
use petgraph::graph::{DiGraph, NodeIndex};
use std::collections::{BTreeMap, BTreeSet};

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
    let mut lowering = Lowering::new(checked, start);
    lowering.out.root = lowering.label(start);
    while let Some((node, work)) = lowering.open.pop() {
        match work {
            Work::Shape(label) => lowering.shape(node, label),
            Work::Choose(label) => lowering.choose(node, label),
            Work::Rule(rule) => lowering.fill(node, &rule.successor, rule),
        }
    }
    Ok(lowering.out)
}

/// What a reserved node is still to be filled with.
enum Work<'g> {
    /// A mark, and what the label stands for below it.
    Shape(&'g str),
    Choose(&'g str),
    Rule(&'g Rule),
}

struct Lowering<'g> {
    checked: &'g Checked,
    out: OpGraph,
    labels: BTreeMap<&'g str, NodeIndex>,
    /// The labels that queries ask for: their shapes are marked.
    asked: BTreeSet<&'g str>,
    open: Vec<(NodeIndex, Work<'g>)>,
}

impl<'g> Lowering<'g> {
    fn new(checked: &'g Checked, start: &'g str) -> Lowering<'g> {
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
            constants: grammar.constants.iter().map(|known| constant(known, plain)).collect(),
            styles: grammar.styles.iter().map(|known| style(known, grammar, plain)).collect(),
            preamble: grammar.preamble.clone(),
            names: BTreeMap::new(),
            origins: BTreeMap::new(),
        };
        Lowering {
            checked,
            out,
            labels: BTreeMap::new(),
            asked: asked_labels(checked, start),
            open: Vec::new(),
        }
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
                (Some(rule), _) if self.asked.contains(label) => {
                    break self.reserve(rule, Work::Shape(label));
                }
                (Some(rule), None) if is_plain(rule) => match &rule.successor.op {
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

    fn shape(&mut self, node: NodeIndex, label: &'g str) {
        let checked = self.checked;
        let mut rules = checked.rules_of(label);
        let child = match (rules.next(), rules.next()) {
            (Some(rule), None) if is_plain(rule) => self.child(&rule.successor, rule),
            _ => {
                let child = self.out.graph.add_node(Op::Nil);
                self.open.push((child, Work::Choose(label)));
                child
            }
        };
        self.out.graph[node] = Op::Shape(label.to_owned());
        self.out.set_children(node, vec![(Arg::None, child)]);
        let origin = checked.rules_of(label).next().map(|rule| rule.label.span).unwrap_or_default();
        self.out.origins.insert(node, Origin { label: label.to_owned(), span: origin });
    }

    fn choose(&mut self, node: NodeIndex, label: &'g str) {
        let checked = self.checked;
        let mut children = Vec::new();
        for rule in checked.rules_of(label) {
            let alternative = Alternative {
                condition: rule.condition.as_ref().map(|condition| self.expr(condition, rule)),
                weight: weight(rule.weight.as_ref().map(|weight| self.expr(weight, rule))),
                priority: rule.priority,
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
        let (op, children) = match &successor.op {
            ast::Op::Nil => (Op::Nil, Vec::new()),
            ast::Op::Primitive { name, material, options } => {
                let options =
                    options.iter().map(|(option, value)| (option.name.clone(), expr(value))).collect();
                (self.primitive(name, material.as_ref(), options, rule), Vec::new())
            }
            ast::Op::Call { label, args } => {
                let args = args.iter().map(expr).collect();
                (Op::Call(args), vec![(Arg::None, self.label(&label.name))])
            }
            ast::Op::All(ops) => (Op::All, ops.iter().map(|op| (Arg::None, self.child(op, rule))).collect()),
            ast::Op::Split { axis, snap, items } => {
                let (axis, snap) = (expr(axis), snap.clone());
                let (mut groups, mut children) = (Vec::new(), Vec::new());
                self.items(items, rule, &mut groups, &mut children);
                (Op::Split { axis, snap, groups }, children)
            }
            ast::Op::Repeat { axis, size, snap, body } => {
                (Op::Repeat { axis: expr(axis), size: expr(size), snap: snap.clone() }, self.only(body, rule))
            }
            ast::Op::RepeatN { axis, count, body } => {
                (Op::RepeatN { axis: expr(axis), count: expr(count) }, self.only(body, rule))
            }
            ast::Op::Carve { how, args, parts } => {
                let op = Op::Carve { how: *how, args: args.iter().map(expr).collect() };
                let child = |(selector, body): &'g (ast::Selector, Successor)| {
                    (Arg::Part(selector.clone()), self.child(body, rule))
                };
                (op, parts.iter().map(child).collect())
            }
            ast::Op::Within { change, body } => (self.change(change, rule), self.only(body, rule)),
            ast::Op::Snap { axis, label } => {
                let label = label.as_ref().map(|label| label.name.clone());
                (Op::Snap { axis: expr(axis), label }, Vec::new())
            }
        };
        self.out.graph[node] = op;
        self.out.set_children(node, children);
        self.out.origins.insert(node, Origin { label: rule.label.name.clone(), span: successor.span });
    }

    fn change(&self, change: &ast::Change, rule: &Rule) -> Op {
        let expr = |expr: &ast::Expr| self.expr(expr, rule);
        let size = |size: &ast::Size| Size { kind: size.kind, value: expr(&size.value) };
        let sizes = |sizes: &[ast::Size; 3]| [&sizes[0], &sizes[1], &sizes[2]].map(size);
        match change {
            ast::Change::Translate(delta) => Op::Translate(sizes(delta)),
            ast::Change::Resize(size) => Op::Resize(sizes(size)),
            ast::Change::Rotate { axis, angle } => Op::Rotate { axis: expr(axis), angle: expr(angle) },
            ast::Change::Local => Op::Local,
            ast::Change::Same(key) => Op::Same(expr(key)),
            ast::Change::Style(name) => {
                let styles = &self.checked.grammar().styles;
                Op::Style(styles.iter().position(|style| style.name == *name).unwrap_or(0))
            }
        }
    }

    /// A primitive. A constant with the name of a shape says what that shape is made of.
    fn primitive(
        &self,
        name: &ast::Expr,
        material: Option<&ast::Expr>,
        options: Vec<(String, Expr)>,
        rule: &Rule,
    ) -> Op {
        let material = material.map(|material| self.expr(material, rule));
        let resolved = self.expr(name, rule);
        match (&name.kind, &resolved) {
            (ExprKind::Name(text), Expr::Constant(_)) if is_primitive(text) => {
                let material = material.or(Some(resolved));
                Op::Primitive { name: Expr::name(text.clone()), material, options }
            }
            _ => Op::Primitive { name: resolved, material, options },
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

/// Whether a rule always applies, at once.
fn is_plain(rule: &Rule) -> bool {
    rule.condition.is_none() && rule.priority == Rule::FIRST
}

fn constant(known: &ast::Constant, plain: impl Fn(&ast::Expr) -> Expr) -> Constant {
    let attribute = known.attribute.as_ref().map(|attribute| Attribute {
        range: attribute.range.as_ref().map(|[low, high]| [plain(low), plain(high)]),
        group: attribute.group.clone(),
        about: attribute.about.clone(),
    });
    Constant { name: known.name.name.clone(), value: plain(&known.value), attribute }
}

fn style(known: &ast::Style, grammar: &Grammar, plain: impl Fn(&ast::Expr) -> Expr) -> Style {
    let place = |name: &Ident| grammar.constants.iter().position(|constant| constant.name == *name);
    let values = known.values.iter().filter_map(|(name, value)| Some((place(name)?, plain(value))));
    Style { name: known.name.name.clone(), values: values.collect() }
}

/// The labels that the queries of rules which `start` leads to ask for.
fn asked_labels<'g>(checked: &'g Checked, start: &'g str) -> BTreeSet<&'g str> {
    let mut asked = BTreeSet::new();
    let mut reached = BTreeSet::from([start]);
    let mut open = vec![start];
    while let Some(label) = open.pop() {
        for rule in checked.rules_of(label) {
            for_each_expr_of_rule(rule, &mut |expr| match &expr.kind {
                ExprKind::Occlusion { against: Against::Label(label), .. } | ExprKind::Visible(label) => {
                    asked.insert(label.as_str());
                }
                _ => {}
            });
            for_each_call(&rule.successor, &mut |called| {
                if reached.insert(called) {
                    open.push(called);
                }
            });
        }
    }
    asked
}

pub(super) fn resolve(expr: &ast::Expr, names: Names<'_>) -> Expr {
    let inner = |expr: &ast::Expr| Box::new(resolve(expr, names));
    let weighted = |parts: &[(ast::Expr, ast::Expr)]| {
        parts.iter().map(|(weight, value)| (resolve(weight, names), resolve(value, names))).collect()
    };
    match &expr.kind {
        ExprKind::Number(value) => Expr::Number(Number(*value)),
        ExprKind::Name(name) => match names.resolve(name) {
            Name::Param(at) => Expr::Param(at),
            Name::Constant(at) => Expr::Constant(at),
            Name::Axis(axis) => Expr::Axis(axis),
            Name::Number(value) => Expr::Number(Number(value)),
            Name::Thing => Expr::Thing(Thing::Name(name.clone())),
        },
        ExprKind::Block(text) => block(text, names),
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
        ExprKind::Share(share) => Expr::Share(*share),
        ExprKind::Pick(parts) => Expr::Pick(weighted(parts)),
        ExprKind::Mix(parts) => Expr::Mix(weighted(parts)),
        ExprKind::Gradient(axis, blocks) => {
            Expr::Gradient(inner(axis), blocks.iter().map(|block| resolve(block, names)).collect())
        }
        ExprKind::Same(key, value) => Expr::Same(inner(key), inner(value)),
        ExprKind::Occlusion { against, distance } => {
            Expr::Occlusion { against: against.clone(), distance: distance.as_deref().map(inner) }
        }
        ExprKind::Visible(label) => Expr::Visible(label.clone()),
    }
}

/// A block state, which may be the value of a name with other properties.
fn block(text: &str, names: Names<'_>) -> Expr {
    // A bare name is one that no constant hides.
    let state = || match text.contains([':', '[']) {
        true => Expr::Thing(Thing::Block(text.to_owned())),
        false => Expr::name(text),
    };
    let Some((name, properties)) = text.split_once('[') else { return state() };
    let named = match names.resolve(name) {
        Name::Param(at) => Expr::Param(at),
        Name::Constant(at) => Expr::Constant(at),
        _ => return state(),
    };
    Expr::State(Box::new(named), properties.trim_end_matches(']').to_owned())
}
