//! Further alternatives for the rules whose scope holds what no rule explains.

use super::change::Change;
use super::fills::Fills;
use super::layout::end_of_item;
use super::learnt::{Learnt, learn};
use super::lengths::path;
use super::names::{Taken, renamed};
use super::reuse::{Known, reused};
use super::texts::{Edit, Operations, Program};
use super::weight::weight;
use crate::grammar::ast::{BinaryOp, Expr, ExprKind, Rule, for_each_call};
use crate::grammar::{Grammar, Span, parse};
use crate::grid::Grid;
use crate::parse::{Choice, Derivation, Step};
use crate::space::{Axis, Frame, Scope, Turn};
use std::collections::BTreeSet;

/// A change to a grammar that may explain more of a house.
#[derive(Clone, Debug)]
pub struct Candidate {
    pub edits: Vec<Edit>,
    pub changes: Vec<Change>,
}

/// More operations around a region are not tried, nor more of one rule replaced at once.
pub const MOST_STEPS: usize = 24;

/// What could be written for the largest region that a derivation leaves open: for each operation around it, one that
/// gives what the house has there, in an alternative of the operation's rule. The innermost come first.
pub fn candidates(program: &Program, nearest: &Derivation, house: &Grid) -> Vec<Candidate> {
    let Some(region) = largest(&nearest.steps) else { return Vec::new() };
    let path = path(&nearest.steps, region);
    let operations = program.operations();
    let writer = Writer { program, operations: &operations, steps: &nearest.steps, house };
    // All of the house is no part of it.
    let around = (2..=path.len()).rev().take(MOST_STEPS).map(|length| &path[..length]);
    around.flat_map(|path| [writer.inside(path), writer.whole(path)]).flatten().collect()
}

/// All of a house as an alternative of the rule that a run starts with, for houses of that size.
pub fn anew(program: &Program, house: &Grid) -> Option<Candidate> {
    let frame = Frame { up: program.graph.up, turn: Turn::NONE };
    let scope = Scope { bounds: house.bounds(), frame };
    let writer = Writer { program, operations: &program.operations(), steps: &[], house };
    writer.replacing(program.checked.first_label(), &scope, |_| {
        Axis::ALL.map(|axis| Some(Fills::Only(scope.len(axis))))
    })
}

/// The step with most cells that are other than it says, the first of equal ones.
fn largest(steps: &[Step]) -> Option<usize> {
    let lost = |step: &Step| match step.choice {
        Choice::Other(lost) => lost,
        _ => 0,
    };
    let most = steps.iter().map(lost).max().filter(|most| *most > 0)?;
    steps.iter().position(|step| lost(step) == most)
}

pub struct Writer<'p, 's> {
    pub program: &'p Program,
    pub operations: &'s Operations<'p>,
    pub steps: &'s [Step],
    pub house: &'s Grid,
}

/// A rule as its own file has it.
pub struct Local {
    pub file: String,
    pub rule: Rule,
    /// The rules of the file that need not be written again.
    pub known: Known,
    /// From a place in the file to the same place behind all files before it.
    pub offset: usize,
}

impl Writer<'_, '_> {
    /// One that gives all of a label's scope, if the last step of a path is one of a label.
    fn whole(&self, path: &[usize]) -> Option<Candidate> {
        let step = &self.steps[*path.last()?];
        let label = &self.program.graph.name(step.node)?.label;
        self.replacing(label, &step.scope, |learnt| learnt.fills.map(Some))
    }

    /// One that gives what the house has in a scope, for scopes that are as `fills` says.
    fn replacing(
        &self,
        label: &str,
        scope: &Scope,
        fills: impl Fn(&Learnt) -> [Option<Fills>; 3],
    ) -> Option<Candidate> {
        let last = self.last_rule(label)?;
        let Local { file, rule, known, .. } = self.local(last)?;
        let learnt = learn(self.house, scope)?;
        let condition = filled(scope, fills(&learnt));
        let (successor, rules) = renamed(learnt.successor, learnt.rules, &mut self.taken());
        let (successor, rules) = reused(successor, rules, &known);
        self.written(&file, last, Rule { condition, successor, ..rule }, rules)
    }

    pub fn taken(&self) -> Taken {
        Taken::by(self.program.checked.grammar())
    }

    /// The rule of a label that is tried last, and the last of these in the text: what stands behind it hides none.
    pub fn last_rule(&self, label: &str) -> Option<&Rule> {
        let rules = self.program.checked.rules_of(label);
        rules.max_by_key(|rule| (rule.priority, rule.label.span.start))
    }

    /// The same rule in the words of its file, without its comments.
    pub fn local(&self, rule: &Rule) -> Option<Local> {
        let place = self.program.sources.place(rule.label.span);
        let Grammar { rules, .. } = parse(place.text).ok()?;
        let rules: Vec<Rule> = rules.into_iter().map(without_comments).collect();
        let start = place.span.start;
        let offset = rule.label.span.start - start;
        let around = self.around(&rule.label.name);
        let known = Known::of(&rules, |rule| !around.contains(&(rule.label.span.start + offset)));
        let own = rules.into_iter().find(|rule| rule.label.span.start == start)?;
        Some(Local { file: place.name.to_owned(), rule: own, known, offset })
    }

    /// The places of the rules that lead to a label: were they called from there, rules would run in rings.
    fn around(&self, label: &str) -> BTreeSet<usize> {
        let rules = &self.program.checked.grammar().rules;
        let mut labels = BTreeSet::from([label]);
        loop {
            let known = labels.len();
            for rule in rules {
                let mut leads = false;
                for_each_call(&rule.successor, &mut |called| leads |= labels.contains(called));
                if leads {
                    labels.insert(&rule.label.name);
                }
            }
            if labels.len() == known {
                let around = rules.iter().filter(|rule| labels.contains(rule.label.name.as_str()));
                return around.map(|rule| rule.label.span.start).collect();
            }
        }
    }

    /// The candidate that writes a rule, and those that it calls, behind the last of its label.
    pub fn written(&self, file: &str, last: &Rule, rule: Rule, rules: Vec<Rule>) -> Option<Candidate> {
        let label = last.label.name.clone();
        let end = last.weight.as_ref().map_or(last.successor.span.end, |weight| weight.span.end);
        let place = self.program.sources.place(Span::new(end, end));
        if place.name != file {
            return None;
        }
        let weight = weight(self.program.checked.rules_of(&label));
        let mut text = format!("\n{}", Rule { weight, ..rule });
        rules.iter().for_each(|rule| text += &format!("\n\n{rule}"));
        let at = end_of_item(place.text, place.span.end);
        let edit = Edit { file: file.to_owned(), span: Span::new(at, at), text };
        let mut rules: Vec<String> = rules.into_iter().map(|rule| rule.label.name).collect();
        rules.dedup();
        Some(Candidate { edits: vec![edit], changes: vec![Change::Alternative { label, rules }] })
    }
}

fn without_comments(mut rule: Rule) -> Rule {
    rule.comments.clear();
    rule.behind = None;
    super::graft::uncomment(&mut rule.successor);
    rule
}

/// That a scope can be filled; nothing where all can. `None` of an axis asks for nothing.
pub fn filled(scope: &Scope, fills: [Option<Fills>; 3]) -> Option<Expr> {
    let asked = Axis::ALL.into_iter().zip(fills).filter_map(|(axis, fills)| {
        let (op, length) = match fills? {
            Fills::From(least) if least <= 1 => return None,
            Fills::From(least) if least < scope.len(axis) => (BinaryOp::GreaterEqual, least),
            Fills::From(_) => (BinaryOp::GreaterEqual, scope.len(axis)),
            Fills::Only(length) => (BinaryOp::Equal, length),
        };
        Some(binary(op, Expr::new(ExprKind::ScopeSize(axis)), Expr::number(f64::from(length))))
    });
    asked.reduce(|left, right| binary(BinaryOp::And, left, right))
}

pub fn binary(op: BinaryOp, left: Expr, right: Expr) -> Expr {
    Expr::new(ExprKind::Binary(op, Box::new(left), Box::new(right)))
}
