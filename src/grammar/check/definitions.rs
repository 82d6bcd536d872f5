//! Constants, attributes, styles and start sizes.

use super::{Checker, Expected};
use crate::grammar::Code;
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names, closest, is_reserved};

impl Checker<'_> {
    pub(super) fn constants(&mut self) {
        for (at, constant) in self.grammar.constants.iter().enumerate() {
            self.defined_name(&constant.name);
            let earlier = &self.grammar.constants[..at];
            if earlier.iter().any(|other| other.name == constant.name) {
                let message = format!("the constant `{}` is defined twice", constant.name.name);
                let hint = "keep one of the two".to_owned();
                self.tell(Code::ConstantTwice, constant.name.span, message, "again here", hint);
            }
            self.constant_value(&constant.value, at);
            for bound in constant.attribute.iter().flat_map(|attribute| attribute.range.iter().flatten()) {
                self.constant_value(bound, at);
                self.expr(bound, &[], Expected::Number);
            }
        }
    }

    pub(super) fn styles(&mut self) {
        for (at, style) in self.grammar.styles.iter().enumerate() {
            if self.grammar.styles[..at].iter().any(|other| other.name == style.name) {
                let message = format!("the style `{}` is defined twice", style.name.name);
                let hint = "keep one of the two".to_owned();
                self.tell(Code::StyleTwice, style.name.span, message, "again here", hint);
            }
            style.values.iter().for_each(|(name, value)| self.style_value(name, value));
        }
    }

    /// A style gives constants other values, which come as early in the file as theirs.
    fn style_value(&mut self, name: &Ident, value: &Expr) {
        let names = self.grammar.constants.iter().map(|constant| constant.name.name.as_str());
        match self.grammar.constants.iter().position(|constant| constant.name.name == name.name) {
            Some(at) => self.constant_value(value, at),
            None if self.broken.contains(&name.name) => {}
            None => {
                let near = closest(&name.name, names);
                let hint = near
                    .map_or(format!("define what it is without a style: `{} = ...`", name.name), |near| {
                        format!("did you mean `{near}`?")
                    });
                let message = format!("there is no constant `{}`", name.name);
                self.tell(Code::UnknownConstant, name.span, message, "not defined", hint);
            }
        }
    }

    pub(super) fn constant_value(&mut self, value: &Expr, at: usize) {
        let grammar = self.grammar;
        let names = Names { params: &[], constants: &grammar.constants };
        for_each_expr(value, &mut |expr| match &expr.kind {
            ExprKind::ScopeSize(_)
            | ExprKind::Share(_)
            | ExprKind::Occlusion { .. }
            | ExprKind::Visible(_) => self.tell(
                Code::ConstantAsksScope,
                expr.span,
                "a constant is drawn before there is a scope",
                "has no value here",
                "write it inside a rule, where there is one".to_owned(),
            ),
            ExprKind::Name(name) if matches!(names.resolve(name), Name::Constant(other) if other >= at) => {
                let hint = format!("move the line of `{name}` above this one");
                let message = format!("`{name}` has no value yet");
                self.tell(Code::ConstantTooEarly, expr.span, message, "defined below", hint);
            }
            _ => {}
        });
        self.expr(value, &[], Expected::Any);
    }

    pub(super) fn sizes(&mut self) {
        for start in &self.grammar.sizes {
            start.size.iter().chain(&start.weight).for_each(|expr| self.expr(expr, &[], Expected::Number));
        }
    }

    pub(super) fn defined_name(&mut self, ident: &Ident) {
        if is_reserved(&ident.name) {
            let message = format!("`{}` is a word of the language", ident.name);
            self.tell(
                Code::Reserved,
                ident.span,
                message,
                "cannot be defined",
                "choose another name".to_owned(),
            );
        }
    }
}
