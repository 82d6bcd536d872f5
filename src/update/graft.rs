//! An alternative that is another one but for some of its operations.

use super::alternative::{Candidate, Local, MOST_STEPS, Writer, binary, filled};
use super::fills::Fills;
use super::growth::{Growth, growth};
use super::learnt::{Learnt, learn};
use super::lengths::path;
use super::names::renamed;
use super::reuse::reused;
use crate::grammar::Span;
use crate::grammar::ast::{BinaryOp, Rule, Successor, for_each_child_mut};
use crate::parse::Choice;
use crate::space::Axis;

impl Writer<'_, '_> {
    /// One that is the rule around the last step of a path, but for what that step does, and for what does not fit
    /// elsewhere in the same run of the rule.
    pub fn inside(&self, path: &[usize]) -> Option<Candidate> {
        let (&last, above) = path.split_last()?;
        let (rule, _) = self.operations.at(self.origin(last)?)?;
        let top = *above.iter().rev().take_while(|at| self.is_in(rule, **at)).last()?;
        let Local { file, rule: mut own, known, offset } = self.local(rule)?;
        let mut taken = self.taken();
        let (mut rules, mut needs) = (Vec::new(), [None; 3]);
        for at in self.misfits(rule, top, last) {
            let Learnt { successor, rules: more, fills } = learn(self.house, &self.steps[at].scope)?;
            let (successor, more) = renamed(successor, more, &mut taken);
            let (successor, more) = reused(successor, more, &known);
            replace(&mut own.successor, self.origin(at)?, offset, &successor);
            rules.extend(more);
            for axis in Axis::ALL {
                let need = self.need(top, at, axis, fills[axis.index()])?;
                needs[axis.index()] = stricter(needs[axis.index()], need);
            }
        }
        let condition = [own.condition.take(), filled(&self.steps[top].scope, needs)];
        own.condition =
            condition.into_iter().flatten().reduce(|left, right| binary(BinaryOp::And, left, right));
        self.written(&file, self.last_rule(&rule.label.name)?, own, rules)
    }

    pub fn origin(&self, at: usize) -> Option<Span> {
        self.program.graph.origin(self.steps[at].node).map(|origin| origin.span)
    }

    /// Whether a step is an operation in the text of a rule.
    fn is_in(&self, rule: &Rule, at: usize) -> bool {
        let found = self.origin(at).and_then(|span| self.operations.at(span));
        found.is_some_and(|(own, _)| std::ptr::eq(own, rule))
    }

    /// The step at `last`, and the other ones of the same run of a rule that do not fit.
    fn misfits(&self, rule: &Rule, top: usize, last: usize) -> Vec<usize> {
        let replaced = last..self.end(last);
        let is_direct = |at: usize| {
            let path = path(self.steps, at);
            path.iter().skip_while(|above| **above != top).all(|step| self.is_in(rule, *step))
        };
        let others = (top..self.end(top)).filter(|at| {
            let is_open = matches!(self.steps[*at].choice, Choice::Other(_));
            is_open && !replaced.contains(at) && is_direct(*at)
        });
        std::iter::once(last).chain(others).take(MOST_STEPS).collect()
    }

    /// The first step behind all that are inside of one.
    fn end(&self, at: usize) -> usize {
        let depth = self.steps[at].depth;
        at + 1 + self.steps[at + 1..].iter().take_while(|step| step.depth > depth).count()
    }

    /// What the scope of the rule at `top` has to fill so that an operation in it fills its own; `None` where that
    /// cannot be told.
    fn need(&self, top: usize, at: usize, axis: Axis, fills: Fills) -> Option<Option<Fills>> {
        let (outer, inner) = (&self.steps[top].scope, &self.steps[at].scope);
        if outer.frame.turn != inner.frame.turn {
            return None;
        }
        let path = path(self.steps, at);
        let from = path.iter().position(|step| *step == top)?;
        let growths = path[from..].windows(2).map(|pair| self.growth(pair[0], pair[1], axis));
        let growth = growths.fold(Growth::Along, Growth::then);
        let (whole, part) = (outer.len(axis), inner.len(axis));
        Some(match (growth, fills) {
            (Growth::Fixed, _) | (_, Fills::From(..=1)) => None,
            (Growth::Along, Fills::From(least)) => Some(Fills::From(whole - part + least)),
            _ => Some(Fills::Only(whole)),
        })
    }

    fn growth(&self, outer: usize, inner: usize, axis: Axis) -> Growth {
        let of = |at: usize| self.origin(at).and_then(|span| self.operations.at(span));
        match (of(outer), of(inner)) {
            (Some((_, outer)), Some((_, inner))) => growth(outer, inner, axis),
            _ => Growth::Unknown,
        }
    }
}

/// What fills both, where something is asked.
fn stricter(one: Option<Fills>, other: Option<Fills>) -> Option<Fills> {
    match (one, other) {
        (Some(Fills::From(one)), Some(Fills::From(other))) => Some(Fills::From(one.max(other))),
        (Some(Fills::Only(length)), _) | (_, Some(Fills::Only(length))) => Some(Fills::Only(length)),
        (one, other) => one.or(other),
    }
}

/// Puts an operation into the place of another, which stands in the file `offset` before its place among all files.
fn replace(successor: &mut Successor, place: Span, offset: usize, by: &Successor) {
    let (start, end) = (place.start - offset, place.end - offset);
    match (successor.span.start, successor.span.end) == (start, end) {
        true => *successor = by.clone(),
        false => for_each_child_mut(&mut successor.op, &mut |child| replace(child, place, offset, by)),
    }
}

pub fn uncomment(successor: &mut Successor) {
    successor.notes = None;
    for_each_child_mut(&mut successor.op, &mut |child| uncomment(child));
}
