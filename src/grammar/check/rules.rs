//! Rules and their operations.

use super::expressions::is_thing;
use super::{Checker, Expected, count};
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names, closest};
use crate::grammar::{Code, PRIMITIVES, Span, is_mesh, is_primitive};

impl<'g> Checker<'g> {
    pub(super) fn rule(&mut self, rule: &'g Rule) {
        self.defined_name(&rule.label);
        for (at, param) in rule.params.iter().enumerate() {
            self.defined_name(param);
            if rule.params[..at].contains(param) {
                let message = format!("the parameter `{}` stands twice", param.name);
                let hint = "give each its own name".to_owned();
                self.tell(Code::ParameterTwice, param.span, message, "again", hint);
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
            self.tell(Code::ParametersDiffer, rule.label.span, message, "differs", hint);
        }
        for expr in rule.condition.iter().chain(&rule.weight) {
            self.expr(expr, &rule.params, Expected::Number);
        }
        self.successor(&rule.successor, &rule.params);
    }

    fn successor(&mut self, successor: &Successor, params: &[Ident]) {
        match &successor.op {
            Op::Nil | Op::All(_) => {}
            Op::Primitive { name, material, options } => {
                self.expr(name, params, Expected::Thing);
                material.iter().for_each(|material| self.material(name, material, params));
                self.options(name, options, params);
            }
            Op::Call { label, args } => {
                self.call(label, args, successor.span);
                args.iter().for_each(|arg| self.expr(arg, params, Expected::Any));
            }
            Op::Split { axis, items, .. } => {
                self.expr(axis, params, Expected::Axis);
                items.iter().for_each(|item| self.item_size(item, params));
            }
            Op::Repeat { axis, size: number, .. } | Op::RepeatN { axis, count: number, .. } => {
                self.expr(axis, params, Expected::Axis);
                self.expr(number, params, Expected::Number);
            }
            Op::Snap { axis, .. } => self.expr(axis, params, Expected::Axis),
            Op::Carve { args, parts, .. } => {
                args.iter().for_each(|arg| self.expr(arg, params, Expected::Number));
                self.selectors(parts);
            }
            Op::Within { change, .. } => self.change(change, params),
        }
        for_each_child(&successor.op, &mut |child| self.successor(child, params));
    }

    fn selectors(&mut self, parts: &[(Selector, Successor)]) {
        for (at, (selector, body)) in parts.iter().enumerate() {
            if parts[..at].iter().any(|(other, _)| other == selector) {
                let message = format!("the part `{selector}` stands twice");
                let hint = "keep one of the two".to_owned();
                self.tell(Code::PartTwice, body.span, message, "never runs", hint);
            }
        }
    }

    fn change(&mut self, change: &Change, params: &[Ident]) {
        match change {
            Change::Translate(sizes) | Change::Resize(sizes) => {
                sizes.iter().for_each(|size| self.fixed_size(size, params));
            }
            Change::Rotate { axis, angle } => {
                self.rotation_axis(axis, params);
                self.expr(angle, params, Expected::Number);
            }
            Change::Same(key) => self.key(key, params),
            Change::Style(name) => self.style_name(name),
            Change::Local => {}
        }
    }

    fn style_name(&mut self, name: &Ident) {
        let names: Vec<&str> = self.grammar.styles.iter().map(|style| style.name.name.as_str()).collect();
        if names.contains(&name.name.as_str()) || self.broken.contains("style") {
            return;
        }
        let near = closest(&name.name, names.into_iter());
        let hint = near.map_or(format!("define it: `style {} {{ wall = ... }}`", name.name), |near| {
            format!("did you mean `{near}`?")
        });
        let message = format!("there is no style `{}`", name.name);
        self.tell(Code::UnknownStyle, name.span, message, "not defined", hint);
    }

    fn item_size(&mut self, item: &Item, params: &[Ident]) {
        match item {
            Item::Part { size, .. } => self.expr(&size.value, params, Expected::Number),
            Item::Group { items, .. } => items.iter().for_each(|item| self.item_size(item, params)),
        }
    }

    fn fixed_size(&mut self, size: &Size, params: &[Ident]) {
        if size.kind == SizeKind::Floating {
            let hint = "write blocks, or `'` for a fraction of the scope".to_owned();
            let message = "a floating size only has a meaning in a split";
            self.tell(Code::FloatsAlone, size.value.span, message, "floats", hint);
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
            self.tell(Code::FlatTurn, axis.span, message, "lies flat", format!("write `R({up}, ...)`"));
        }
    }

    /// Only a shape is made of something: a block is what it is.
    fn material(&mut self, name: &Expr, material: &Expr, params: &[Ident]) {
        self.expr(material, params, Expected::Thing);
        // What is nothing at all is told of already.
        let is_other = match &name.kind {
            ExprKind::Name(text) => !is_primitive(text) && is_thing(text) && !self.is_defined(text, params),
            ExprKind::Block(text) => !is_primitive(text),
            // A block stands for a mesh where there are blocks only.
            ExprKind::File(file) => !is_mesh(file),
            _ => false,
        };
        if is_other {
            let message = format!("`{name}` is no shape that could be made of `{material}`");
            let hint = format!("write `I({name})`, or one of the shapes: {}", PRIMITIVES.join(", "));
            self.tell(Code::NoMaterial, name.span, message, "no shape", hint);
        }
    }

    fn call(&mut self, label: &Ident, args: &[Expr], span: Span) {
        match self.arity(&label.name) {
            None if self.broken.contains(&label.name) => {}
            None => {
                let hint = self.label_hint(&label.name);
                let message = format!("there is no rule for `{}`", label.name);
                self.tell(Code::UnknownLabel, label.span, message, "not defined", hint);
            }
            Some(arity) if arity != args.len() => {
                let message =
                    format!("`{}` takes {}, not {}", label.name, count(arity, "argument"), args.len());
                let hint = format!("its rules read `{}{} --> ...`", label.name, self.parameters(&label.name));
                self.tell(Code::WrongArity, span, message, "called here", hint);
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

    pub(super) fn label_hint(&self, name: &str) -> String {
        if let Some(hint) = hint_for_foreign(name) {
            return hint.to_owned();
        }
        let labels = self.rules.keys().copied().chain(self.broken.iter().map(String::as_str));
        if let Some(label) = closest(name, labels) {
            return format!("did you mean `{label}`?");
        }
        let is_constant = self.grammar.constants.iter().any(|constant| constant.name.name == name);
        if is_constant || is_thing(name) {
            return format!("to place it as a primitive, write `I({name})`");
        }
        format!("add a rule `{name} --> ...`")
    }
}

/// What to write instead of operations that other grammars of shapes have.
fn hint_for_foreign(name: &str) -> Option<&'static str> {
    Some(match name {
        "extrude" => "a scope has its height already: `S('1, 10, '1){ ... }` sets another",
        "color" | "texture" | "setupProjection" | "projectUV" => "blocks have their looks: `I(red_wool)`",
        "set" => "a style gives constants other values: `style(spruce){ ... }`",
        "center" => {
            "a part between two floating ones stands in the middle: `split(x){ ~1 : nil | 3 : door | ~1 : nil }`"
        }
        "NIL" | "Nil" | "null" => "to place nothing, write `nil`",
        "i" => "to place something, write `I(stone)`",
        _ => return None,
    })
}
