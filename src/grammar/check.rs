//! Static checks: what can be known to be wrong before a grammar runs.

use super::ast::*;
use super::names::{Name, Names, closest};
use super::parse::{Parsed, parse_items};
use super::{Diagnostic, PRIMITIVES, Severity, Span, is_primitive};
use crate::block::{self, BlockState};
use std::collections::{BTreeMap, BTreeSet};

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

/// Parses and checks the text of a grammar. Every error is reported, with the warnings, in the order of their
/// places; an error in one rule does not hide those in others.
pub fn read(text: &str) -> Result<Checked, Vec<Diagnostic>> {
    let Parsed { grammar, mut errors, broken } = parse_items(text);
    if errors.is_empty() {
        return check(grammar);
    }
    let found = findings(&grammar, &broken);
    errors.extend(found.into_iter().filter(|finding| finding.severity == Severity::Error));
    errors.sort_by_key(|finding| finding.span.start);
    Err(errors)
}

/// Checks a grammar. Every error is reported, with the warnings, in the order of their places.
pub fn check(grammar: Grammar) -> Result<Checked, Vec<Diagnostic>> {
    let found = findings(&grammar, &BTreeSet::new());
    match found.iter().any(|finding| finding.severity == Severity::Error) {
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
    grammar.rules.iter().for_each(|rule| checker.rule(rule));
    checker.aliases();
    checker.unreachable();
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

/// Whether a name is a word of the language, which nothing else can be called.
pub fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

const RESERVED: [&str; 23] = [
    "I", "nil", "split", "repeat", "repeatN", "T", "S", "R", "comp", "size", "scope", "x", "y", "z", "pi",
    "and", "or", "not", "true", "false", "rand", "randint", "up",
];

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
    fn error(&mut self, span: Span, message: impl Into<String>, label: &str, hint: Option<String>) {
        self.found.push(Diagnostic::error(span, message).label(label).maybe_hint(hint));
    }

    // Definitions

    fn constants(&mut self) {
        for (at, constant) in self.grammar.constants.iter().enumerate() {
            self.defined_name(&constant.name);
            let earlier = &self.grammar.constants[..at];
            if earlier.iter().any(|other| other.name == constant.name) {
                let message = format!("the constant `{}` is defined twice", constant.name.name);
                self.error(constant.name.span, message, "again here", Some("keep one of the two".to_owned()));
            }
            self.constant_value(&constant.value, at);
        }
    }

    fn constant_value(&mut self, value: &Expr, at: usize) {
        let grammar = self.grammar;
        let names = Names { params: &[], constants: &grammar.constants };
        for_each_expr(value, &mut |expr| match &expr.kind {
            ExprKind::ScopeSize(_) => self.error(
                expr.span,
                "a constant is drawn before there is a scope",
                "has no value here",
                Some("use the scope's length inside a rule".to_owned()),
            ),
            ExprKind::Name(name) if matches!(names.resolve(name), Name::Constant(other) if other >= at) => {
                let hint = format!("move the line of `{name}` above this one");
                self.error(expr.span, format!("`{name}` has no value yet"), "defined below", Some(hint));
            }
            _ => {}
        });
        self.expr(value, &[], Expected::Any);
    }

    fn sizes(&mut self) {
        for start in &self.grammar.sizes {
            start.size.iter().chain(&start.weight).for_each(|expr| self.expr(expr, &[], Expected::Number));
        }
    }

    fn defined_name(&mut self, ident: &Ident) {
        if is_reserved(&ident.name) {
            let message = format!("`{}` is a word of the language", ident.name);
            self.error(ident.span, message, "cannot be defined", Some("choose another name".to_owned()));
        }
    }

    // Rules

    fn rule(&mut self, rule: &'g Rule) {
        self.defined_name(&rule.label);
        for (at, param) in rule.params.iter().enumerate() {
            self.defined_name(param);
            if rule.params[..at].contains(param) {
                let message = format!("the parameter `{}` stands twice", param.name);
                self.error(param.span, message, "again", Some("give each its own name".to_owned()));
            }
        }
        let arity = self.arity(&rule.label.name).unwrap_or(rule.params.len());
        if rule.params.len() != arity {
            let message = format!(
                "`{}` has {} here, but {} in its first rule",
                rule.label.name,
                count(rule.params.len(), "parameter"),
                arity
            );
            let hint = "all rules of a label take the same parameters".to_owned();
            self.error(rule.label.span, message, "differs", Some(hint));
        }
        for expr in rule.condition.iter().chain(&rule.weight) {
            self.expr(expr, &rule.params, Expected::Number);
        }
        self.successor(&rule.successor, &rule.params);
    }

    fn successor(&mut self, successor: &Successor, params: &[Ident]) {
        match &successor.op {
            Op::Nil => {}
            Op::Primitive { name, material } => {
                self.expr(name, params, Expected::Thing);
                material.iter().for_each(|material| self.material(name, material, params));
            }
            Op::Call { label, args } => {
                self.call(label, args, successor.span);
                args.iter().for_each(|arg| self.expr(arg, params, Expected::Any));
            }
            Op::Split { axis, items } => {
                self.expr(axis, params, Expected::Axis);
                items.iter().for_each(|item| self.item(item, params));
            }
            Op::Repeat { axis, size: number, body } | Op::RepeatN { axis, count: number, body } => {
                self.expr(axis, params, Expected::Axis);
                self.expr(number, params, Expected::Number);
                self.successor(body, params);
            }
            Op::Translate { delta: sizes, body } | Op::Resize { size: sizes, body } => {
                sizes.iter().for_each(|size| self.fixed_size(size, params));
                self.successor(body, params);
            }
            Op::Rotate { axis, angle, body } => {
                self.rotation_axis(axis, params);
                self.expr(angle, params, Expected::Number);
                self.successor(body, params);
            }
            Op::Comp { parts } => {
                for (at, (face, body)) in parts.iter().enumerate() {
                    if parts[..at].iter().any(|(other, _)| other == face) {
                        let message = format!("the face `{}` stands twice", face.name());
                        self.error(body.span, message, "never runs", Some("keep one of the two".to_owned()));
                    }
                    self.successor(body, params);
                }
            }
        }
    }

    fn item(&mut self, item: &Item, params: &[Ident]) {
        match item {
            Item::Part { size, body } => {
                self.expr(&size.value, params, Expected::Number);
                self.successor(body, params);
            }
            Item::Group { items, .. } => items.iter().for_each(|item| self.item(item, params)),
        }
    }

    fn fixed_size(&mut self, size: &Size, params: &[Ident]) {
        if size.kind == SizeKind::Floating {
            let hint = "write blocks, or `'` for a fraction of the scope".to_owned();
            self.error(
                size.value.span,
                "a floating size only has a meaning in a split",
                "floats",
                Some(hint),
            );
        }
        self.expr(&size.value, params, Expected::Number);
    }

    fn rotation_axis(&mut self, axis: &Expr, params: &[Ident]) {
        self.expr(axis, params, Expected::Axis);
        let up = self.grammar.up.axis();
        let names = Names { params, constants: &self.grammar.constants };
        if let ExprKind::Name(name) = &axis.kind
            && let Name::Axis(named) = names.resolve(name)
            && named != up
        {
            let message = format!("blocks only turn about the vertical, which is {up} here");
            self.error(axis.span, message, "lies flat", Some(format!("write `R({up}, ...)`")));
        }
    }

    /// Only a shape is made of something: a block is what it is.
    fn material(&mut self, name: &Expr, material: &Expr, params: &[Ident]) {
        self.expr(material, params, Expected::Thing);
        let is_other = match &name.kind {
            ExprKind::Name(text) if params.iter().all(|param| param.name != *text) => !is_primitive(text),
            ExprKind::Block(_) | ExprKind::File(_) => true,
            _ => false,
        };
        if is_other {
            let message = format!("`{name}` is no shape that could be made of `{material}`");
            let hint = format!("write `I({name})`, or one of the shapes: {}", PRIMITIVES.join(", "));
            self.error(name.span, message, "no shape", Some(hint));
        }
    }

    fn call(&mut self, label: &Ident, args: &[Expr], span: Span) {
        match self.arity(&label.name) {
            None if self.broken.contains(&label.name) => {}
            None => {
                let hint = self.label_hint(&label.name);
                let message = format!("there is no rule for `{}`", label.name);
                self.error(label.span, message, "not defined", Some(hint));
            }
            Some(arity) if arity != args.len() => {
                let message =
                    format!("`{}` takes {}, not {}", label.name, count(arity, "argument"), args.len());
                let params = self.parameters(&label.name);
                self.error(
                    span,
                    message,
                    "called here",
                    Some(format!("its rules read `{}{params} --> ...`", label.name)),
                );
            }
            Some(_) => {}
        }
    }

    /// The parameters of a label as its first rule has them, in brackets.
    fn parameters(&self, label: &str) -> String {
        let first = self.rules.get(label).and_then(|rules| rules.first());
        let names: Vec<&str> =
            first.map_or_else(Vec::new, |rule| rule.params.iter().map(|param| param.name.as_str()).collect());
        if names.is_empty() { String::new() } else { format!("({})", names.join(", ")) }
    }

    /// How many parameters the first rule of a label takes.
    fn arity(&self, label: &str) -> Option<usize> {
        self.rules.get(label).and_then(|rules| rules.first()).map(|rule| rule.params.len())
    }

    fn label_hint(&self, name: &str) -> String {
        if let Some(label) = closest(name, self.rules.keys().copied()) {
            return format!("did you mean `{label}`?");
        }
        let is_constant = self.grammar.constants.iter().any(|constant| constant.name.name == name);
        if is_constant || is_thing(name) {
            return format!("to place it as a primitive, write `I({name})`");
        }
        format!("add a rule `{name} --> ...`")
    }

    // Expressions

    fn expr(&mut self, expr: &Expr, params: &[Ident], expected: Expected) {
        match &expr.kind {
            ExprKind::Name(name) => self.name(name, expr.span, params, expected),
            ExprKind::Block(text) => self.block(text, expr.span, expected),
            ExprKind::File(_) => self.is_of(Expected::Thing, expected, expr.span, "a file"),
            ExprKind::Number(_) | ExprKind::ScopeSize(_) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
            }
            ExprKind::Unary(_, operand) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                self.expr(operand, params, Expected::Number);
            }
            ExprKind::Binary(op, left, right) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                // Anything can be compared for equality: `ax == y`.
                let operands = match op {
                    BinaryOp::Equal | BinaryOp::NotEqual => Expected::Any,
                    _ => Expected::Number,
                };
                self.expr(left, params, operands);
                self.expr(right, params, operands);
            }
            ExprKind::Call(_, args) => {
                self.is_of(Expected::Number, expected, expr.span, "a number");
                args.iter().for_each(|arg| self.expr(arg, params, Expected::Number));
            }
        }
    }

    fn is_of(&mut self, is: Expected, expected: Expected, span: Span, found: &str) {
        let wanted = match expected {
            Expected::Any => return,
            Expected::Number => "a number",
            Expected::Axis => "an axis: x, y or z",
            Expected::Thing => "a block or a primitive",
        };
        if is != expected {
            let hint = match expected {
                Expected::Number => "write a number, a parameter or an expression such as `scope.sx / 2`",
                Expected::Axis => "name the axis, as in `split(x){ ... }`",
                Expected::Thing | Expected::Any => "name what is placed, as in `I(stone)`",
            };
            self.error(span, format!("expected {wanted}, found {found}"), "here", Some(hint.to_owned()));
        }
    }

    fn name(&mut self, name: &str, span: Span, params: &[Ident], expected: Expected) {
        match (Names { params, constants: &self.grammar.constants }).resolve(name) {
            Name::Param(_) => {}
            Name::Thing if self.broken.contains(name) => {}
            Name::Constant(at) => {
                let is = constant_type(&self.grammar.constants[at].value);
                if is != Expected::Any {
                    self.is_of(is, expected, span, &format!("the constant `{name}`"));
                }
            }
            Name::Axis(axis) => self.is_of(Expected::Axis, expected, span, &format!("the axis {axis}")),
            Name::Number(_) => self.is_of(Expected::Number, expected, span, "a number"),
            Name::Thing if matches!(expected, Expected::Number | Expected::Axis) => {
                let known = params.iter().chain(self.grammar.constants.iter().map(|c| &c.name));
                let hint = match closest(name, known.map(|ident| ident.name.as_str())) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None if expected == Expected::Axis => "the axes are x, y and z".to_owned(),
                    None => format!("define it: `{name} = 3`"),
                };
                let message = format!("`{name}` is no parameter and no constant");
                self.error(span, message, "not defined", Some(hint));
            }
            Name::Thing if is_thing(name) => {}
            Name::Thing => {
                let hint = thing_hint(name);
                let message = format!("there is no block or primitive `{name}`");
                self.error(span, message, "not known", Some(hint));
            }
        }
    }

    fn block(&mut self, text: &str, span: Span, expected: Expected) {
        self.is_of(Expected::Thing, expected, span, "a block");
        let state = match text.parse::<BlockState>() {
            Ok(state) => state,
            Err(error) => return self.error(span, error.to_string(), "here", None),
        };
        // Files of other versions and of mods hold blocks and properties that vox does not know.
        let is_bare = !text.split('[').next().unwrap_or(text).contains(':');
        if is_bare && block::known(state.name()).is_none() {
            let message = format!("there is no block `{}`", state.short_name());
            self.error(span, message, "not known", Some(thing_hint(state.short_name())));
        } else if let Err(error) = block::check(&state) {
            let hint = "it is written as it stands, and the game may drop it";
            self.found.push(Diagnostic::warning(span, error.to_string()).label("not known").hint(hint));
        }
    }

    // The whole file

    /// Labels whose only rule is another label, and so on in a ring, never do anything.
    fn aliases(&mut self) {
        let labels: Vec<&str> = self.rules.keys().copied().collect();
        let mut known: BTreeSet<&str> = BTreeSet::new();
        for start in labels {
            let mut chain = Vec::new();
            let mut next = Some(start);
            while let Some(label) = next.filter(|label| known.insert(label)) {
                chain.push(label);
                next = self.alias(label);
            }
            let ring = chain.iter().position(|label| Some(*label) == next);
            ring.into_iter().for_each(|first| self.ring(&chain[first..]));
        }
    }

    fn ring(&mut self, labels: &[&'g str]) {
        for label in labels {
            let message = format!("`{label}` only leads back to itself");
            let hint = "give one of the rules in the ring an operation".to_owned();
            self.error(self.rules[label][0].label.span, message, "never ends", Some(hint));
        }
    }

    /// The label that a label is only another name of.
    fn alias(&self, label: &str) -> Option<&'g str> {
        match self.rules.get(label)?.as_slice() {
            [Rule { successor: Successor { op: Op::Call { label, args }, .. }, .. }] if args.is_empty() => {
                Some(&label.name)
            }
            _ => None,
        }
    }

    fn unreachable(&mut self) {
        let Some(first) = self.grammar.rules.first() else { return };
        if !first.params.is_empty() {
            let message = format!("the first rule, `{}`, takes parameters", first.label.name);
            let hint = "put a rule without parameters first, or start from one with `--start`";
            let label = "nothing can start from it";
            self.found.push(Diagnostic::warning(first.label.span, message).label(label).hint(hint));
        }
        let mut reached = BTreeSet::from([first.label.name.as_str()]);
        let mut open = vec![first.label.name.as_str()];
        while let Some(label) = open.pop() {
            for rule in self.rules.get(label).into_iter().flatten() {
                for_each_call(&rule.successor, &mut |called| {
                    if reached.insert(called) {
                        open.push(called);
                    }
                });
            }
        }
        let mut told = BTreeSet::new();
        for rule in &self.grammar.rules {
            let label = rule.label.name.as_str();
            if !reached.contains(label) && told.insert(label) {
                let message = format!("`{label}` cannot be reached from `{}`", first.label.name);
                let hint = "call it, delete it, or start from it with `--start`";
                self.found.push(Diagnostic::warning(rule.label.span, message).label("never runs").hint(hint));
            }
        }
    }
}

/// The type that a constant's own text shows; `Any` where it depends on what it is used for.
fn constant_type(value: &Expr) -> Expected {
    match &value.kind {
        ExprKind::Name(_) => Expected::Any,
        ExprKind::Block(_) | ExprKind::File(_) => Expected::Thing,
        _ => Expected::Number,
    }
}

/// Whether a bare name can be placed: a primitive, a block of the game, or a family of blocks.
fn is_thing(name: &str) -> bool {
    is_primitive(name) || block::known(name).is_some() || block::Family::of(name).is_some()
}

fn thing_hint(name: &str) -> String {
    let materials = block::all().iter().filter_map(|known| known.name().strip_suffix("_stairs"));
    let near = closest(name, PRIMITIVES.into_iter().chain(materials)).or_else(|| block::suggest(name));
    near.map_or_else(
        || format!("say what it is made of, as in `{name} = stone`; blocks of mods carry their namespace"),
        |near| format!("did you mean `{near}`? Or say what it is made of, as in `{name} = stone`"),
    )
}

fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

/// Visits an expression and all its parts.
fn for_each_expr<'g>(expr: &'g Expr, visit: &mut impl FnMut(&'g Expr)) {
    visit(expr);
    match &expr.kind {
        ExprKind::Unary(_, operand) => for_each_expr(operand, visit),
        ExprKind::Binary(_, left, right) => {
            for_each_expr(left, visit);
            for_each_expr(right, visit);
        }
        ExprKind::Call(_, args) => args.iter().for_each(|arg| for_each_expr(arg, visit)),
        _ => {}
    }
}

/// Visits every label that an operation calls.
fn for_each_call<'g>(successor: &'g Successor, visit: &mut impl FnMut(&'g str)) {
    match &successor.op {
        Op::Nil | Op::Primitive { .. } => {}
        Op::Call { label, .. } => visit(&label.name),
        Op::Split { items, .. } => items.iter().for_each(|item| for_each_item_call(item, visit)),
        Op::Repeat { body, .. }
        | Op::RepeatN { body, .. }
        | Op::Translate { body, .. }
        | Op::Resize { body, .. }
        | Op::Rotate { body, .. } => for_each_call(body, visit),
        Op::Comp { parts } => parts.iter().for_each(|(_, body)| for_each_call(body, visit)),
    }
}

fn for_each_item_call<'g>(item: &'g Item, visit: &mut impl FnMut(&'g str)) {
    match item {
        Item::Part { body, .. } => for_each_call(body, visit),
        Item::Group { items, .. } => items.iter().for_each(|item| for_each_item_call(item, visit)),
    }
}
