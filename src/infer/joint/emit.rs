//! From a plan to an op graph.

use super::boxes::Boxes;
use super::corpus::{Corpus, is_parameter};
use super::derivation::{At, Derivation};
use super::feasible::{Feasible, Lengths, feasible};
use super::laws::Law;
use super::limits::Limits;
use super::plan::{Form, NodeId, Plan, alternatives, occurrences};
use super::rows::{Row, State};
use super::scope::{Scope, Within};
use super::slopes::Slope;
use super::starts::{Sizes, StartSizes};
use crate::grammar::ast::BinaryOp;
use crate::graph::{Alternative, Arg, Builder, Expr, NodeIndex, Op, Size};
use crate::infer::emit::{block_expr, data_version};
use crate::infer::example::{Example, Terminal, Terminals};
use crate::infer::{Labels, Learnt, Method, Notes};
use crate::space::Axis;
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};

/// What was learnt, and the nodes of the plan that each of its operations stands for.
pub struct Emitted {
    pub learnt: Learnt,
    pub nodes: BTreeMap<NodeIndex, Vec<NodeId>>,
    pub root: NodeId,
    boxes: FxHashMap<NodeId, Boxes>,
}

impl Emitted {
    /// The operation at a node of what was learnt.
    pub fn op(&self, node: NodeIndex) -> &Op {
        self.learnt.graph.op(node)
    }

    /// The nodes of the plan that an operation of a sample stands for.
    pub fn planned(&self, derivation: &Derivation, at: At) -> Vec<NodeId> {
        let of = |at: At| self.nodes.get(&derivation.get(at).node).cloned();
        // A split with parameters stands behind the call that draws them.
        let call = || derivation.before(at).and_then(of);
        of(at).or_else(call).unwrap_or_default()
    }

    /// The boxes of the alternative that an operation of a sample is, and all alternatives of the choice before it.
    pub fn alternatives(
        &self,
        plan: &Plan,
        derivation: &Derivation,
        at: At,
    ) -> Option<(Boxes, Vec<(NodeId, Boxes)>)> {
        let mut ids = self.planned(derivation, derivation.before(at)?).into_iter();
        let all = ids.find_map(|id| alternatives(plan, id, self.boxes(id)))?;
        let (_, own) = all.get(derivation.get(at).number)?;
        Some((own.clone(), all))
    }

    /// The boxes that a node which the root reaches stands for.
    pub fn boxes(&self, id: NodeId) -> &Boxes {
        &self.boxes[&id]
    }
}

/// The op graph of what `root` reaches.
pub fn emit(
    plan: &Plan,
    corpus: &mut Corpus,
    root: NodeId,
    boxes: &Boxes,
    terminals: &Terminals,
    (examples, sizes): (&[Example], Sizes),
    limits: &Limits,
) -> Emitted {
    let all = occurrences(plan, corpus, root, boxes);
    let feasible = feasible(plan, root);
    let mut emitter = Emitter {
        plan,
        corpus,
        terminals,
        limits,
        feasible,
        scope: Scope::of(plan, root),
        builder: Builder::default(),
        nodes: FxHashMap::default(),
        inner: Vec::new(),
    };
    let mut made: BTreeMap<NodeIndex, Vec<NodeId>> = BTreeMap::new();
    for (id, boxes) in all.iter().rev() {
        let node = emitter.node(*id, boxes);
        emitter.nodes.insert(*id, node);
        made.entry(node).or_default().push(*id);
        for (inner, id) in emitter.inner.drain(..) {
            made.entry(inner).or_default().push(id);
        }
    }
    let node = emitter.nodes[&root];
    let (mut graph, kept) = emitter.builder.finish(node);
    let starts = StartSizes { plan, corpus: emitter.corpus, feasible: &emitter.feasible, limits };
    graph.sizes = starts.sizes(root, boxes, sizes);
    graph.data_version = data_version(examples);
    let nodes = made.into_iter().filter_map(|(node, ids)| Some((*kept.get(&node)?, ids))).collect();
    let (labels, notes) = (Labels::new(), Notes::default());
    let learnt = Learnt { graph, labels, by: Method::Joint, is_proved: false, notes };
    Emitted { learnt, nodes, root, boxes: all.into_iter().collect() }
}

struct Emitter<'p> {
    plan: &'p Plan,
    corpus: &'p Corpus,
    feasible: Feasible,
    scope: Scope,
    terminals: &'p Terminals,
    limits: &'p Limits,
    builder: Builder,
    nodes: FxHashMap<NodeId, NodeIndex>,
    /// Further operations that nodes are written with.
    inner: Vec<(NodeIndex, NodeId)>,
}

impl Emitter<'_> {
    /// The node of that number, whose children are there already.
    fn node(&mut self, id: NodeId, boxes: &Boxes) -> NodeIndex {
        let node = self.plan.node(id);
        match &node.form {
            Form::Fill(terminal) => self.fill(*terminal),
            Form::Call { .. } => self.child(id, Within::rule(id)),
            Form::Split { axis, parts } => self.split(id, *axis, parts),
            Form::Repeat { axis, unit, child } => {
                let op =
                    Op::Repeat { axis: Expr::Axis(*axis), size: Expr::number(f64::from(*unit)), snap: None };
                let child = self.child(*child, Within::rule(id));
                self.builder.node(op, vec![(Arg::None, child)])
            }
            Form::Row { row, cells } => self.row(id, row, cells),
            Form::Slope { slope, course, end } => self.slope(id, slope, *course, *end),
            Form::Choose(_) => {
                let alternatives = alternatives(self.plan, id, boxes).unwrap_or_default();
                self.choose(id, &alternatives, boxes)
            }
        }
    }

    /// Cells that may stand anywhere are repeated; else there is a rule for what may follow, for every set of that.
    fn row(&mut self, id: NodeId, row: &Row, cells: &[NodeId]) -> NodeIndex {
        let cells: Vec<NodeIndex> = cells.iter().map(|cell| self.child(*cell, Within::rule(id))).collect();
        let weights = row.kinds.iter().map(|(_, count)| f64::from(*count));
        if row.is_free() {
            let cell = self.builder.choose(weights.zip(cells));
            let op = Op::Repeat { axis: Expr::Axis(row.axis), size: Expr::number(1.0), snap: None };
            return self.builder.node(op, vec![(Arg::None, cell)]);
        }
        let lengths = row.lengths();
        let states: BTreeMap<&State, NodeIndex> =
            lengths.keys().map(|state| (state, self.builder.later(Op::Choose))).collect();
        let nil = self.builder.nil();
        let followed = |state: &State, kind: usize, builder: &mut Builder| {
            let rest = if state.before.contains(&kind) { states[&row.after(state, kind)] } else { nil };
            let parts = vec![(absolute(1), cells[kind]), (Size::floating(1.0), rest)];
            builder.split(Expr::Axis(row.axis), parts)
        };
        for (state, node) in &states {
            let alternative = |kind: &usize| {
                let condition = fills(row.axis, row.lengths_with(state, *kind, &lengths))?;
                let weight = Expr::number(f64::from(row.kinds[*kind].1));
                let alternative = Alternative { condition, ..Alternative::plain(weight) };
                Some((Arg::Alternative(alternative), followed(state, *kind, &mut self.builder)))
            };
            let alternatives = state.before.union(&state.last).filter_map(alternative).collect();
            self.builder.complete(*node, alternatives);
            self.inner.push((*node, id));
        }
        states[&row.start()]
    }

    /// A rule that calls itself for what is left behind a course, until that is short.
    fn slope(&mut self, id: NodeId, slope: &Slope, course: NodeId, end: NodeId) -> NodeIndex {
        let itself = self.builder.later(Op::Choose);
        self.nodes.insert(id, itself);
        let within = Within::rule(id);
        let nil = self.builder.nil();
        let mut left = self.call(id, self.scope.free(id).to_vec(), within);
        for (axis, (low, high)) in slope.peel.runs() {
            let air = |len: i32| (len > 0).then(|| (absolute(len), nil));
            let parts = air(low).into_iter().chain([(Size::floating(1.0), left)]).chain(air(high));
            left = self.builder.split(Expr::Axis(axis), parts.collect());
        }
        let rise = (absolute(slope.peel.rise), self.child(course, within));
        let goes_on = self.builder.split(Expr::Axis(Axis::Y), vec![rise, (Size::floating(1.0), left)]);
        self.inner.push((goes_on, id));
        let mut ends = self.child(end, within);
        if let Some(cap) = slope.cap {
            ends = self
                .builder
                .split(Expr::Axis(Axis::Y), vec![(absolute(cap), ends), (Size::floating(1.0), nil)]);
        }
        let when = |op, by| {
            let of = |(axis, most): (Axis, i32)| {
                Expr::binary(op, Expr::ScopeSize(axis), Expr::number(f64::from(most)))
            };
            slope.ends().map(of).reduce(|left, right| Expr::binary(by, left, right))
        };
        let alternative =
            |condition| Arg::Alternative(Alternative { condition, ..Alternative::plain(Expr::number(1.0)) });
        let alternatives = vec![
            (alternative(when(BinaryOp::Greater, BinaryOp::And)), goes_on),
            (alternative(when(BinaryOp::LessEqual, BinaryOp::Or)), ends),
        ];
        self.builder.complete(itself, alternatives);
        itself
    }

    /// A choice by how often each alternative was seen. One that cannot fill every box has a condition.
    fn choose(&mut self, id: NodeId, alternatives: &[(NodeId, Boxes)], boxes: &Boxes) -> NodeIndex {
        if let [(only, _)] = alternatives {
            return self.child(*only, Within::rule(id));
        }
        let alternative = |(child, group): &(NodeId, Boxes)| {
            let condition = self.condition(*child, group, alternatives, boxes);
            let weight = Expr::number(f64::from(group.count()));
            let child = self.child(*child, Within::rule(id));
            (Arg::Alternative(Alternative { condition, ..Alternative::plain(weight) }), child)
        };
        let alternatives = alternatives.iter().map(alternative).collect();
        self.builder.node(Op::Choose, alternatives)
    }

    /// What has to hold of a scope that one of `boxes` was seen in, so that a node can fill it which was made for
    /// those of `group`.
    fn condition(
        &self,
        node: NodeId,
        group: &Boxes,
        alternatives: &[(NodeId, Boxes)],
        boxes: &Boxes,
    ) -> Option<Expr> {
        let axes = Axis::ALL.into_iter().filter_map(|axis| {
            let seen: BTreeSet<i32> =
                boxes.classes().map(|class| self.corpus.profile(class).len(axis)).collect();
            let feasible = self.feasible[&node][axis.index()];
            let all = alternatives.iter().map(|(_, boxes)| boxes);
            bounds(axis, &seen, feasible.and(self.limits.lengths(self.corpus, group, all, axis)))
        });
        axes.reduce(|left, right| Expr::binary(BinaryOp::And, left, right))
    }

    /// A node as it stands within another: with what that one knows of for its parameters.
    fn child(&mut self, id: NodeId, within: Within) -> NodeIndex {
        let plan = self.plan;
        match &plan.node(id).form {
            Form::Fill(terminal) if is_parameter(*terminal) => {
                let name = self.block(*terminal, within);
                self.builder.primitive(name)
            }
            Form::Call { parameters, arguments, child } => {
                let given = |parameter: &u32| {
                    let number = parameters.iter().position(|own| own == parameter);
                    number.map_or(*parameter, |number| arguments[number])
                };
                let free = self.scope.free(*child).iter().map(given).collect::<Vec<u32>>();
                self.call(*child, free, within)
            }
            _ if self.scope.is_inline(id, within) => self.nodes[&id],
            _ => self.call(id, self.scope.free(id).to_vec(), within),
        }
    }

    fn call(&mut self, id: NodeId, arguments: Vec<u32>, within: Within) -> NodeIndex {
        if arguments.is_empty() {
            return self.nodes[&id];
        }
        let arguments = arguments.into_iter().map(|terminal| self.block(terminal, within)).collect();
        self.builder.node(Op::Call(arguments), vec![(Arg::None, self.nodes[&id])])
    }

    /// A block, or the parameter that stands for it.
    fn block(&self, terminal: u32, within: Within) -> Expr {
        if is_parameter(terminal) {
            let known = self.scope.free(within.rule);
            return Expr::Param(within.drawn + known.binary_search(&terminal).unwrap_or(0));
        }
        match &self.terminals.list[terminal as usize] {
            Terminal::Block(state) => block_expr(state),
            Terminal::Label(label) => Expr::name(label.as_str()),
        }
    }

    fn fill(&mut self, terminal: u32) -> NodeIndex {
        // A parameter is written where it is used.
        if is_parameter(terminal) {
            return self.builder.nil();
        }
        match &self.terminals.list[terminal as usize] {
            Terminal::Block(state) if state.is_air() => self.builder.nil(),
            Terminal::Block(state) => self.builder.primitive(block_expr(state)),
            Terminal::Label(label) => self.builder.primitive(Expr::name(label.as_str())),
        }
    }

    /// A split; sizes that several parts share are parameters, drawn where it is called.
    fn split(&mut self, id: NodeId, axis: Axis, parts: &[(Law, NodeId)]) -> NodeIndex {
        let mut shared: Vec<usize> = parts.iter().filter_map(|(law, _)| same_as(law)).collect();
        shared.sort_unstable();
        shared.dedup();
        let size = |number: usize, law: &Law| {
            let owner = same_as(law).unwrap_or(number);
            match shared.iter().position(|part| *part == owner) {
                Some(param) => Size::absolute(Expr::Param(param)),
                None => size_of(law),
            }
        };
        let within = Within { rule: id, drawn: shared.len() };
        let part =
            |(number, (law, child)): (usize, &(Law, NodeId))| (size(number, law), self.child(*child, within));
        let sized = parts.iter().enumerate().map(part).collect();
        let split = self.builder.split(Expr::Axis(axis), sized);
        if shared.is_empty() {
            return split;
        }
        let drawn = shared.iter().map(|part| size_of(&parts[*part].0).value);
        let handed = (0..self.scope.free(id).len()).map(Expr::Param);
        self.builder.node(Op::Call(drawn.chain(handed).collect()), vec![(Arg::None, split)])
    }
}

/// What a length has to be, of those seen, to be one that can be filled; nothing if all can.
fn bounds(axis: Axis, seen: &BTreeSet<i32>, feasible: Lengths) -> Option<Expr> {
    let (low, high) = (*seen.first()?, *seen.last()?);
    let fits: Vec<i32> = (low..=high).filter(|len| feasible.contains(*len)).collect();
    let is = |op, len: i32| Expr::binary(op, Expr::ScopeSize(axis), Expr::number(f64::from(len)));
    let (Some(first), Some(last)) = (fits.first(), fits.last()) else { return None };
    let is_dense = fits.len() as i32 == last - first + 1;
    match (is_dense, *first == low, *last == high) {
        (true, true, true) => None,
        (true, false, true) => Some(is(BinaryOp::GreaterEqual, *first)),
        (true, true, false) => Some(is(BinaryOp::LessEqual, *last)),
        _ if seen.iter().all(|len| feasible.contains(*len)) => None,
        _ => {
            let own = fits.iter().filter(|len| seen.contains(len)).map(|len| is(BinaryOp::Equal, *len));
            own.reduce(|left, right| Expr::binary(BinaryOp::Or, left, right))
        }
    }
}

/// What a length has to be to be one of these; nothing inside if it may be any, and nothing at all if there are none.
fn fills(axis: Axis, lengths: Lengths) -> Option<Option<Expr>> {
    let low = lengths.iter().next()?;
    let high = lengths.iter().last()?;
    let is = |op, len: i32| Expr::binary(op, Expr::ScopeSize(axis), Expr::number(f64::from(len)));
    let above = (low > 1).then(|| is(BinaryOp::Greater, low - 1));
    let below = (high < Lengths::LONGEST).then(|| is(BinaryOp::LessEqual, high));
    let holes = (low..=high).filter(|len| !lengths.contains(*len)).map(|len| is(BinaryOp::NotEqual, len));
    Some(
        above
            .into_iter()
            .chain(below)
            .chain(holes)
            .reduce(|left, right| Expr::binary(BinaryOp::And, left, right)),
    )
}

fn same_as(law: &Law) -> Option<usize> {
    match law {
        Law::Same(part) => Some(*part),
        _ => None,
    }
}

fn absolute(len: i32) -> Size {
    Size::absolute(Expr::number(f64::from(len)))
}

fn size_of(law: &Law) -> Size {
    match law {
        Law::Float(weight) => Size::floating(f64::from(*weight)),
        law => Size::absolute(value(law)),
    }
}

/// The value of a size that does not float.
pub fn value(law: &Law) -> Expr {
    let number = |value: i32| Expr::number(f64::from(value));
    match law {
        Law::Const(len) => number(*len),
        Law::Range { low, high, step: 1 } => Expr::between(*low, *high),
        Law::Range { low, high, step } => {
            let steps = Expr::between(0, (high - low) / step);
            let more = Expr::binary(BinaryOp::Multiply, number(*step), steps);
            Expr::binary(BinaryOp::Add, number(*low), more)
        }
        Law::Table(entries) => {
            Expr::Pick(entries.iter().map(|(len, count)| (number(*count as i32), number(*len))).collect())
        }
        Law::Float(_) | Law::Same(_) => number(1),
    }
}
