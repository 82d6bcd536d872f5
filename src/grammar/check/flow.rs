//! What can reach each label: the lengths of its scopes and the values of its parameters, joined over all calls.
//!
//! From the first rule and the start sizes of the file, calls are followed until nothing new is found. What is found
//! holds for every run of the file at its own sizes that does not cut off what overruns.

use super::numbers::Numbers;
use super::parts::{self, Lengths};
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names};
use crate::space::Axis;
use std::collections::{BTreeMap, VecDeque};

/// The values that an expression may have. What is neither a number nor an axis is not told apart.
#[derive(Clone, PartialEq, Debug)]
pub struct Values {
    pub numbers: Numbers,
    pub axes: [bool; 3],
}

impl Values {
    pub const NONE: Values = Values { numbers: Numbers::NONE, axes: [false; 3] };
    const ANY: Values = Values { numbers: Numbers::ANY, axes: [true; 3] };

    fn of(numbers: Numbers) -> Values {
        Values { numbers, axes: [false; 3] }
    }

    fn join(&self, other: &Values, joined: fn(&Numbers, &Numbers) -> Numbers) -> Values {
        let axes = [0, 1, 2].map(|axis| self.axes[axis] || other.axes[axis]);
        Values { numbers: joined(&self.numbers, &other.numbers), axes }
    }
}

/// What reaches a label, or an operation.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    pub lengths: Lengths,
    pub params: Vec<Values>,
}

impl State {
    fn join(&self, other: &State, joined: fn(&Numbers, &Numbers) -> Numbers) -> State {
        let lengths = [0, 1, 2].map(|axis| {
            let (a, b) = (&self.lengths[axis], &other.lengths[axis]);
            // Only what was carved flat has no length.
            joined(a, b).clamped(if a.low().min(b.low()) < 1.0 { 0.0 } else { 1.0 }, f64::INFINITY)
        });
        let params = self.params.iter().zip(&other.params).map(|(a, b)| a.join(b, joined)).collect();
        State { lengths, params }
    }
}

/// What is known of every label that the first rule reaches.
pub struct Flow<'g> {
    grammar: &'g Grammar,
    constants: Vec<Values>,
    labels: BTreeMap<&'g str, State>,
}

/// After so many findings at a label its bounds are widened: a ring of rules may find more without an end.
const PATIENCE: u32 = 100;

impl<'g> Flow<'g> {
    pub fn of(grammar: &'g Grammar, rules: &BTreeMap<&'g str, Vec<&'g Rule>>) -> Flow<'g> {
        let mut flow = Flow { grammar, constants: Vec::new(), labels: BTreeMap::new() };
        for constant in &grammar.constants {
            let values = flow.constant(constant);
            flow.constants.push(values);
        }
        flow.spread(rules);
        flow
    }

    /// What reaches a label, if anything does.
    pub fn state(&self, label: &str) -> Option<&State> {
        self.labels.get(label)
    }

    /// The numbers of an expression outside of rules.
    pub fn constant_numbers(&self, expr: &Expr) -> Numbers {
        self.values(expr, &[], &nowhere()).numbers
    }

    /// The values of a constant in any style; an attribute may be set to any value in its range.
    fn constant(&self, constant: &Constant) -> Values {
        let styled = self.grammar.styles.iter().flat_map(|style| &style.values);
        let styled = styled.filter(|(name, _)| *name == constant.name).map(|(_, value)| value);
        let all = styled.chain([&constant.value]).map(|value| self.values(value, &[], &nowhere()));
        let own = all.fold(Values::NONE, |a, b| a.join(&b, Numbers::join));
        match constant.attribute.as_ref().map(|attribute| &attribute.range) {
            None => own,
            Some(None) => Values::ANY,
            Some(Some([low, high])) => {
                let set =
                    Numbers::between(self.constant_numbers(low).low(), self.constant_numbers(high).high());
                own.join(&Values::of(set), Numbers::join)
            }
        }
    }

    fn spread(&mut self, rules: &BTreeMap<&'g str, Vec<&'g Rule>>) {
        let Some(first) = self.grammar.rules.first() else { return };
        let params = vec![Values::ANY; first.params.len()];
        let start = State { lengths: self.start_lengths(), params };
        self.labels.insert(&first.label.name, start);
        let mut open = VecDeque::from([first.label.name.as_str()]);
        let mut visits: BTreeMap<&str, u32> = BTreeMap::new();
        while let Some(label) = open.pop_front() {
            let state = self.labels[label].clone();
            let mut calls = Vec::new();
            for rule in rules.get(label).into_iter().flatten() {
                self.visit(rule, &state, &mut |successor, state| {
                    if let Op::Call { label, args } = &successor.op {
                        let values = |arg| self.values(arg, &rule.params, state);
                        let params = args.iter().map(values).collect();
                        calls.push((label.name.as_str(), State { params, lengths: state.lengths.clone() }));
                    }
                });
            }
            for (called, state) in calls {
                let visits = visits.entry(called).or_default();
                if self.learn(called, state, *visits > PATIENCE) {
                    *visits += 1;
                    if !open.contains(&called) {
                        open.push_back(called);
                    }
                }
            }
        }
    }

    /// Adds what reaches a label; whether that is new.
    fn learn(&mut self, label: &'g str, state: State, is_wide: bool) -> bool {
        let joined = match self.labels.get(label) {
            None => state,
            Some(known) if is_wide => known.join(&state, Numbers::widened),
            Some(known) => known.join(&state, Numbers::join),
        };
        let is_new = self.labels.get(label) != Some(&joined);
        self.labels.insert(label, joined);
        is_new
    }

    fn start_lengths(&self) -> Lengths {
        let sizes = &self.grammar.sizes;
        [0, 1, 2].map(|axis| {
            let lengths =
                sizes.iter().map(|start| self.constant_numbers(&start.size[axis]).rising(f64::round, true));
            let known = lengths.fold(Numbers::NONE, |a, b| a.join(&b)).clamped(1.0, f64::INFINITY);
            if known.is_none() {
                Numbers::Between { low: 1.0, high: f64::INFINITY, whole: true }
            } else {
                known
            }
        })
    }

    /// Visits every operation of a rule with what reaches it. What nothing reaches is left out.
    pub fn visit(&self, rule: &'g Rule, state: &State, visit: &mut dyn FnMut(&'g Successor, &State)) {
        let state = match &rule.condition {
            Some(condition) => self.narrowed(condition, &rule.params, state.clone()),
            None => state.clone(),
        };
        self.descend(&rule.successor, &rule.params, &state, visit);
    }

    fn descend(
        &self,
        successor: &'g Successor,
        params: &[Ident],
        state: &State,
        visit: &mut dyn FnMut(&'g Successor, &State),
    ) {
        if state.lengths.iter().any(Numbers::is_none) {
            return;
        }
        visit(successor, state);
        let numbers = |expr: &Expr| self.numbers(expr, params, state);
        let axes = |expr: &Expr| self.values(expr, params, state).axes;
        let up = self.grammar.up.axis();
        for (child, lengths) in parts::of(&successor.op, &state.lengths, up, &numbers, &axes) {
            let state = State { lengths, params: state.params.clone() };
            self.descend(child, params, &state, visit);
        }
    }

    /// What is left where a condition holds.
    fn narrowed(&self, condition: &Expr, params: &[Ident], mut state: State) -> State {
        let ExprKind::Binary(op, left, right) = &condition.kind else { return state };
        if *op == BinaryOp::And {
            let state = self.narrowed(left, params, state);
            return self.narrowed(right, params, state);
        }
        let bounds = self.values(right, params, &state).numbers;
        self.narrow(left, *op, &bounds, params, &mut state);
        let bounds = self.values(left, params, &state).numbers;
        self.narrow(right, op.mirrored(), &bounds, params, &mut state);
        state
    }

    /// Narrows what an expression may be, if it is a length or a parameter, to what is so compared with some bound.
    fn narrow(&self, expr: &Expr, op: BinaryOp, bounds: &Numbers, params: &[Ident], state: &mut State) {
        let names = Names { params, constants: &self.grammar.constants };
        let numbers = match &expr.kind {
            ExprKind::ScopeSize(axis) => &mut state.lengths[axis.index()],
            ExprKind::Name(name) => match names.resolve(name) {
                // An axis or a block may be compared as well.
                Name::Param(at) if !bounds.is_none() => match state.params.get_mut(at) {
                    Some(values) if values.axes == [false; 3] && !values.numbers.is_none() => {
                        &mut values.numbers
                    }
                    _ => return,
                },
                _ => return,
            },
            _ => return,
        };
        // A whole number below another one is one less at least.
        let step = if numbers.is_whole() && bounds.is_whole() { 1.0 } else { 0.0 };
        *numbers = match op {
            BinaryOp::Less => numbers.clamped(f64::NEG_INFINITY, bounds.high() - step),
            BinaryOp::LessEqual => numbers.clamped(f64::NEG_INFINITY, bounds.high()),
            BinaryOp::Greater => numbers.clamped(bounds.low() + step, f64::INFINITY),
            BinaryOp::GreaterEqual => numbers.clamped(bounds.low(), f64::INFINITY),
            BinaryOp::Equal => numbers.clamped(bounds.low(), bounds.high()),
            _ => return,
        };
    }

    /// The numbers that an expression may be in a rule. What is none ends the run: nothing can be said of what comes of it.
    pub fn numbers(&self, expr: &Expr, params: &[Ident], state: &State) -> Numbers {
        let numbers = self.values(expr, params, state).numbers;
        if numbers.is_none() { Numbers::ANY } else { numbers }
    }

    /// The values that an expression may have in a rule.
    pub fn values(&self, expr: &Expr, params: &[Ident], state: &State) -> Values {
        let values = |expr: &Expr| self.values(expr, params, state);
        // What is no number has none: the run ends there.
        let numbers = |expr: &Expr| values(expr).numbers;
        Values::of(match &expr.kind {
            ExprKind::Number(number) => Numbers::one(*number),
            ExprKind::Name(name) => return self.named(name, params, state),
            ExprKind::ScopeSize(axis) => state.lengths[axis.index()].clone(),
            ExprKind::Share(Share::Index) => Numbers::Between { low: 0.0, high: f64::INFINITY, whole: true },
            ExprKind::Share(Share::Total) => Numbers::Between { low: 1.0, high: f64::INFINITY, whole: true },
            ExprKind::Unary(UnaryOp::Negate, operand) => {
                Numbers::binary(BinaryOp::Subtract, &Numbers::one(0.0), &numbers(operand))
            }
            ExprKind::Unary(UnaryOp::Not, _) | ExprKind::Visible(_) => Numbers::few([0.0, 1.0]),
            ExprKind::Binary(BinaryOp::Equal | BinaryOp::NotEqual, ..) => Numbers::few([0.0, 1.0]),
            ExprKind::Binary(op, left, right) => Numbers::binary(*op, &numbers(left), &numbers(right)),
            ExprKind::Call(function, args) => {
                let args: Vec<Numbers> = args.iter().map(numbers).collect();
                Numbers::call(*function, &args)
            }
            ExprKind::Pick(parts) => {
                let all = parts.iter().map(|(_, value)| values(value));
                return all.fold(Values::NONE, |a, b| a.join(&b, Numbers::join));
            }
            ExprKind::Same(_, value) => return values(value),
            ExprKind::Occlusion { .. } => Numbers::few([0.0, 1.0, 2.0]),
            ExprKind::Block(_) | ExprKind::File(_) | ExprKind::Mix(_) | ExprKind::Gradient(..) => {
                Numbers::NONE
            }
        })
    }

    fn named(&self, name: &str, params: &[Ident], state: &State) -> Values {
        let axis = |axis: Axis| {
            let mut values = Values::NONE;
            values.axes[axis.index()] = true;
            values
        };
        match (Names { params, constants: &self.grammar.constants }).resolve(name) {
            Name::Param(at) => state.params.get(at).cloned().unwrap_or(Values::ANY),
            Name::Constant(at) => self.constants.get(at).cloned().unwrap_or(Values::ANY),
            Name::Axis(known) => axis(known),
            Name::Number(number) => Values::of(Numbers::one(number)),
            Name::Thing => Values::NONE,
        }
    }
}

/// The surroundings of constants, which have none.
fn nowhere() -> State {
    State { lengths: [Numbers::ANY, Numbers::ANY, Numbers::ANY], params: Vec::new() }
}
