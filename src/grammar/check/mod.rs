//! Static checks: what can be known to be wrong before a grammar runs.

mod attributes;
mod cases;
mod conditions;
mod definitions;
mod expressions;
mod fitting;
mod flow;
mod labels;
mod numbers;
mod options;
mod parts;
mod recursion;
mod rules;
mod snapping;
mod usage;
mod value;
mod weights;

use super::ast::*;
use super::load::load;
use super::parse::no_rule;
use super::{Code, Diagnostic, Span};
use flow::Flow;
use std::collections::{BTreeMap, BTreeSet};

pub use value::value;

/// A grammar without errors: every label has rules, every name a meaning, every call the right arity.
#[derive(Clone, Debug)]
pub struct Checked {
    grammar: Grammar,
    /// The places of each label's rules.
    rules: BTreeMap<String, Vec<usize>>,
    pub warnings: Vec<Diagnostic>,
}

impl Checked {
    pub fn grammar(&self) -> &Grammar {
        &self.grammar
    }

    /// The start rule unless another is named: the first of the file.
    pub fn first_label(&self) -> &str {
        &self.grammar.rules[0].label.name
    }

    /// Every label, in alphabetical order.
    pub fn labels(&self) -> impl Iterator<Item = &str> {
        self.rules.keys().map(String::as_str)
    }

    /// The rules of a label, in the order of the file.
    pub fn rules_of(&self, label: &str) -> impl Iterator<Item = &Rule> + use<'_> {
        self.rules.get(label).into_iter().flatten().map(|at| &self.grammar.rules[*at])
    }
}

/// Parses and checks the text of a grammar that imports nothing. Every error is reported, with the warnings, in the order
/// of their places; an error in one rule does not hide those in others.
pub fn read(text: &str) -> Result<Checked, Vec<Diagnostic>> {
    load("", text, &mut |_| Err("this text stands alone".to_owned())).checked
}

/// Checks what could be read of a grammar that lacks the items which define the names in `broken`.
pub fn judge(
    grammar: Grammar,
    mut errors: Vec<Diagnostic>,
    broken: &BTreeSet<String>,
) -> Result<Checked, Vec<Diagnostic>> {
    if errors.is_empty() && grammar.rules.is_empty() {
        return Err(vec![no_rule()]);
    }
    if errors.is_empty() {
        return check(grammar);
    }
    let found = findings(&grammar, broken);
    errors.extend(found.into_iter().filter(Diagnostic::is_error));
    errors.sort_by_key(|finding| finding.span.start);
    Err(errors)
}

/// Checks a grammar. Every error is reported, with the warnings, in the order of their places.
pub fn check(grammar: Grammar) -> Result<Checked, Vec<Diagnostic>> {
    let found = findings(&grammar, &BTreeSet::new());
    match found.iter().any(Diagnostic::is_error) {
        true => Err(found),
        false => Ok(Checked { rules: places(&grammar), grammar, warnings: found }),
    }
}

/// What is to be said of a grammar that may lack the items that define the names in `broken`.
fn findings(grammar: &Grammar, broken: &BTreeSet<String>) -> Vec<Diagnostic> {
    let mut rules: BTreeMap<&str, Vec<&Rule>> = BTreeMap::new();
    grammar.rules.iter().for_each(|rule| rules.entry(&rule.label.name).or_default().push(rule));
    let mut checker = Checker { grammar, rules, broken, found: Vec::new() };
    checker.constants();
    checker.sizes();
    checker.styles();
    grammar.rules.iter().for_each(|rule| checker.rule(rule));
    checker.aliases();
    checker.unreachable();
    checker.weights();
    // What follows is about grammars whose every name has a meaning.
    if broken.is_empty() && !checker.found.iter().any(Diagnostic::is_error) {
        checker.meaning();
    }
    let mut found = checker.found;
    found.sort_by_key(|finding| finding.span.start);
    found
}

fn places(grammar: &Grammar) -> BTreeMap<String, Vec<usize>> {
    let mut places: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (at, rule) in grammar.rules.iter().enumerate() {
        places.entry(rule.label.name.clone()).or_default().push(at);
    }
    places
}

/// What an expression has to be in its place.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Expected {
    Number,
    Axis,
    Thing,
    /// An argument or a constant: its type shows where it is used.
    Any,
}

struct Checker<'g> {
    grammar: &'g Grammar,
    /// The rules of each label, in the order of the file.
    rules: BTreeMap<&'g str, Vec<&'g Rule>>,
    /// Names whose definitions could not be read.
    broken: &'g BTreeSet<String>,
    found: Vec<Diagnostic>,
}

impl<'g> Checker<'g> {
    /// What names alone do not show: what can never go well, and what is for nothing.
    fn meaning(&mut self) {
        self.unused();
        self.snap_planes();
        self.recursion();
        let flow = Flow::of(self.grammar, &self.rules);
        self.attributes(&flow);
        self.fitting(&flow);
        self.conditions(&flow);
    }

    fn tell(
        &mut self,
        code: Code,
        span: Span,
        message: impl Into<String>,
        label: &str,
        hint: impl Into<Option<String>>,
    ) {
        self.found.push(Diagnostic::new(code, span, message).label(label).maybe_hint(hint.into()));
    }
}

fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}
