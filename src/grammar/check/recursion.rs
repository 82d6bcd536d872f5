//! Rings of labels that nothing can end: no part of the scope is left out, and no rule stops.

use super::Checker;
use super::cases::{can_all_hold, draws, known_number};
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names};
use crate::grammar::{Code, Span};
use std::collections::{BTreeMap, BTreeSet};

/// A call that surely comes about where its rule is taken, in a scope that does not become smaller.
#[derive(Clone)]
struct Call<'g> {
    label: &'g Ident,
    args: &'g [Expr],
    kept: Kept,
}

/// What is the same where a call stands as where its rule begins.
#[derive(Clone, Copy, PartialEq)]
struct Kept {
    lengths: [bool; 3],
    constants: bool,
}

const ALL_KEPT: Kept = Kept { lengths: [true; 3], constants: true };

impl<'g> Checker<'g> {
    pub(super) fn recursion(&mut self) {
        let calls: BTreeMap<&str, Vec<Vec<Call<'g>>>> = self
            .rules
            .iter()
            .map(|(label, rules)| (*label, rules.iter().map(|rule| sure_calls(rule)).collect()))
            .collect();
        let endless = endless(&calls);
        self.rings(&endless, &calls);
        let rules: Vec<&'g Rule> = self.grammar.rules.iter().collect();
        for rule in rules.into_iter().filter(|rule| !endless.contains(rule.label.name.as_str())) {
            self.unchanging(rule, &calls);
        }
    }

    /// Tells of each ring of labels without an end.
    fn rings(&mut self, endless: &BTreeSet<&'g str>, calls: &BTreeMap<&'g str, Vec<Vec<Call<'g>>>>) {
        let mut known = BTreeSet::new();
        for rule in &self.grammar.rules {
            let mut chain: Vec<(&str, Span)> = Vec::new();
            let mut label = rule.label.name.as_str();
            while endless.contains(label) && known.insert(label) {
                let first =
                    calls[label].iter().flatten().find(|call| endless.contains(call.label.name.as_str()));
                let Some(call) = first else { break };
                chain.push((label, call.label.span));
                label = &call.label.name;
            }
            if let Some(first) = chain.iter().position(|(other, _)| *other == label) {
                self.tell_ring(&chain[first..]);
            }
        }
    }

    fn tell_ring(&mut self, ring: &[(&'g str, Span)]) {
        // Labels that are only names for one another are told of as such.
        if ring.iter().all(|(label, _)| self.alias(label).is_some()) {
            return;
        }
        let labels: Vec<String> = ring.iter().map(|(label, _)| format!("`{label}`")).collect();
        let message = match labels.as_slice() {
            [one] => format!("{one} calls itself in a scope that is never smaller, and nothing ends it"),
            [others @ .., last] => format!(
                "{} and {last} call one another in a scope that is never smaller, and nothing ends it",
                others.join(", ")
            ),
            [] => return,
        };
        let hint = "call it in a part of the scope, as in `split(y){ 4 : storey | ~1 : tower }`, or add a rule \
                    that ends it";
        self.tell(Code::Endless, ring[ring.len() - 1].1, message, "without an end", hint.to_owned());
    }

    /// Tells of a rule that leads back to its label with all that its condition reads as it was.
    fn unchanging(&mut self, rule: &'g Rule, calls: &BTreeMap<&'g str, Vec<Vec<Call<'g>>>>) {
        let Some(condition) = rule.condition.as_ref().filter(|condition| !depends_on_place(condition)) else {
            return;
        };
        let back = sure_calls(rule).into_iter().find_map(|call| {
            let first = call.label.span;
            self.way_back(rule, call, calls).filter(|way| self.keeps(condition, rule, way)).map(|_| first)
        });
        if let Some(span) = back
            && !self.is_ended(rule, condition)
        {
            let message =
                format!("`{}` calls itself with its condition `{condition}` as it was", rule.label.name);
            let hint = "change what the condition reads: hand over another value, as in `n - 1`, or call it in a \
                        part of the scope";
            self.tell(Code::EndlessCondition, span, message, "never ends once it begins", hint.to_owned());
        }
    }

    /// Whether another rule of the label may be taken where a condition holds.
    fn is_ended(&self, rule: &Rule, condition: &Expr) -> bool {
        let rules = self.rules[rule.label.name.as_str()].iter();
        rules.filter(|other| !std::ptr::eq(**other, rule)).any(|other| {
            let can_hold = other.condition.as_ref().is_none_or(|other| can_all_hold(&[condition, other]));
            other.priority <= rule.priority && can_hold
        })
    }

    /// Follows a call through labels that have no choice, back to the label of its rule.
    fn way_back(
        &self,
        rule: &'g Rule,
        call: Call<'g>,
        calls: &BTreeMap<&'g str, Vec<Vec<Call<'g>>>>,
    ) -> Option<Way> {
        let own: Vec<Option<usize>> = (0..rule.params.len()).map(Some).collect();
        let mut way = Way { params: own, kept: ALL_KEPT };
        let (mut from, mut call) = (rule, call);
        let mut seen = BTreeSet::new();
        loop {
            way = way.along(&call, &from.params, self.grammar);
            let label = call.label.name.as_str();
            if label == rule.label.name {
                return Some(way);
            }
            let [next] = self.rules.get(label)?.as_slice() else { return None };
            if next.condition.is_some() || !seen.insert(label) {
                return None;
            }
            from = next;
            call = calls[label].first()?.first()?.clone();
        }
    }

    /// Whether all that a condition reads is the same at the end of a way.
    fn keeps(&self, condition: &Expr, rule: &Rule, way: &Way) -> bool {
        let names = Names { params: &rule.params, constants: &self.grammar.constants };
        let mut keeps = true;
        for_each_expr(condition, &mut |expr| {
            keeps &= match &expr.kind {
                ExprKind::ScopeSize(axis) => way.kept.lengths[axis.index()],
                ExprKind::Name(name) => match names.resolve(name) {
                    Name::Param(at) => way.params.get(at) == Some(&Some(at)),
                    Name::Constant(_) => way.kept.constants,
                    _ => true,
                },
                _ => true,
            };
        });
        keeps
    }
}

/// What becomes of a rule's parameters and scope along a chain of calls.
struct Way {
    /// For each parameter of the label at hand, which of those at the start it is.
    params: Vec<Option<usize>>,
    kept: Kept,
}

impl Way {
    fn along(&self, call: &Call<'_>, params: &[Ident], grammar: &Grammar) -> Way {
        let names = Names { params, constants: &grammar.constants };
        let origin = |arg: &Expr| match &arg.kind {
            ExprKind::Name(name) => match names.resolve(name) {
                Name::Param(at) => self.params.get(at).copied().flatten(),
                _ => None,
            },
            _ => None,
        };
        let lengths = [0, 1, 2].map(|axis| self.kept.lengths[axis] && call.kept.lengths[axis]);
        let kept = Kept { lengths, constants: self.kept.constants && call.kept.constants };
        Way { params: call.args.iter().map(origin).collect(), kept }
    }
}

/// Whether a condition may change though nothing that it names does: by chance, or with what lies around.
fn depends_on_place(condition: &Expr) -> bool {
    let mut depends = draws(condition);
    for_each_expr(condition, &mut |expr| {
        depends |=
            matches!(expr.kind, ExprKind::Share(_) | ExprKind::Occlusion { .. } | ExprKind::Visible(_));
    });
    depends
}

/// The labels each of whose rules surely calls another such label: all but those that something may end.
fn endless<'g>(calls: &BTreeMap<&'g str, Vec<Vec<Call<'g>>>>) -> BTreeSet<&'g str> {
    let mut endless: BTreeSet<&str> = calls.keys().copied().collect();
    // How many calls of each rule may go on, and which rules call a label.
    let mut left: BTreeMap<(&str, usize), usize> = BTreeMap::new();
    let mut callers: BTreeMap<&str, Vec<(&str, usize)>> = BTreeMap::new();
    let mut ended = Vec::new();
    for (label, rules) in calls {
        for (number, rule) in rules.iter().enumerate() {
            left.insert((label, number), rule.len());
            rule.iter().for_each(|call| callers.entry(&call.label.name).or_default().push((label, number)));
            if rule.is_empty() && endless.remove(label) {
                ended.push(*label);
            }
        }
    }
    while let Some(label) = ended.pop() {
        for (caller, number) in callers.get(label).into_iter().flatten() {
            let left = left.entry((caller, *number)).or_default();
            *left -= 1;
            if *left == 0 && endless.remove(caller) {
                ended.push(caller);
            }
        }
    }
    endless
}

fn sure_calls<'g>(rule: &'g Rule) -> Vec<Call<'g>> {
    let mut calls = Vec::new();
    collect(&rule.successor, ALL_KEPT, &mut calls);
    calls
}

fn collect<'g>(successor: &'g Successor, kept: Kept, out: &mut Vec<Call<'g>>) {
    match &successor.op {
        Op::Call { label, args } => out.push(Call { label, args, kept }),
        Op::All(ops) => ops.iter().for_each(|op| collect(op, kept, out)),
        Op::Split { items, .. } => {
            // A single floating part is the scope itself, but it stands alone among its like.
            if let [Item::Part { size: Size { kind: SizeKind::Floating, value }, body }] = items.as_slice()
                && known_number(value).is_some_and(|number| number > 0.0)
            {
                collect(body, kept, out);
            }
        }
        Op::Within { change, body } => {
            if let Some(kept) = kept_by(change, kept) {
                collect(body, kept, out);
            }
        }
        Op::Primitive { .. } | Op::Nil | Op::Snap { .. } => {}
        Op::Repeat { .. } | Op::RepeatN { .. } | Op::Carve { .. } => {}
    }
}

/// What a change leaves as it was; `None` where the scope may be gone.
fn kept_by(change: &Change, kept: Kept) -> Option<Kept> {
    match change {
        Change::Translate(_) | Change::Local | Change::Same(_) => Some(kept),
        Change::Style(_) => Some(Kept { constants: false, ..kept }),
        Change::Rotate { .. } => Some(Kept { lengths: [false; 3], ..kept }),
        Change::Resize(sizes) => {
            let mut lengths = kept.lengths;
            for (axis, size) in sizes.iter().enumerate() {
                lengths[axis] &= match (size.kind, known_number(&size.value)) {
                    (SizeKind::Relative, Some(1.0)) => true,
                    (SizeKind::Absolute, Some(blocks)) if blocks >= 1.0 => false,
                    _ => return None,
                };
            }
            Some(Kept { lengths, ..kept })
        }
    }
}
