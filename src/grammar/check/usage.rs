//! Definitions that nothing uses: most often a slip of the pen where they were meant.

use super::Checker;
use crate::grammar::Code;
use crate::grammar::ast::*;
use crate::grammar::names::{Name, Names};
use std::collections::BTreeSet;

impl<'g> Checker<'g> {
    pub(super) fn unused(&mut self) {
        let used = self.used_constants();
        self.unused_constants(&used);
        self.empty_styles(&used);
        let labels: Vec<&[&Rule]> = self.rules.values().map(Vec::as_slice).collect();
        let unused: Vec<&Ident> = labels.into_iter().flat_map(unused_params).collect();
        for param in unused {
            let message = format!("the parameter `{}` is never used", param.name);
            let hint =
                format!("leave it out, here and in calls, or begin its name with `_`: `_{}`", param.name);
            self.tell(Code::UnusedParameter, param.span, message, "no rule of the label reads it", hint);
        }
    }

    /// The places of the constants that something else in the file names.
    fn used_constants(&self) -> BTreeSet<usize> {
        let grammar = self.grammar;
        let mut used = BTreeSet::new();
        let mut visit = |expr: &Expr, params: &[Ident]| {
            let names = Names { params, constants: &grammar.constants };
            if let Some(Name::Constant(at)) = named(expr).map(|name| names.resolve(name)) {
                used.insert(at);
            }
        };
        for constant in &grammar.constants {
            let range = constant.attribute.iter().flat_map(|attribute| attribute.range.iter().flatten());
            range.chain([&constant.value]).for_each(|expr| for_each_expr(expr, &mut |expr| visit(expr, &[])));
        }
        let sizes = grammar.sizes.iter().flat_map(|start| start.size.iter().chain(&start.weight));
        let styled = grammar.styles.iter().flat_map(|style| style.values.iter().map(|(_, value)| value));
        sizes.chain(styled).for_each(|expr| for_each_expr(expr, &mut |expr| visit(expr, &[])));
        for rule in &grammar.rules {
            for_each_expr_of_rule(rule, &mut |expr| visit(expr, &rule.params));
        }
        used
    }

    fn unused_constants(&mut self, used: &BTreeSet<usize>) {
        for (at, constant) in self.grammar.constants.iter().enumerate() {
            let name = &constant.name;
            if used.contains(&at) || is_exempt(&name.name) {
                continue;
            }
            let (code, what) = match constant.attribute {
                Some(_) => (Code::UnusedAttribute, "attribute"),
                None => (Code::UnusedConstant, "constant"),
            };
            let hint = format!("delete it, or begin its name with `_`: `_{}`", name.name);
            self.tell(code, name.span, format!("the {what} `{}` is never used", name.name), "not used", hint);
        }
    }

    /// A style matters by the constants to which it gives other values.
    fn empty_styles(&mut self, used: &BTreeSet<usize>) {
        let constants = &self.grammar.constants;
        let is_used = |name: &str| used.iter().any(|at| constants[*at].name.name == name);
        let empty = |style: &&Style| !style.values.iter().any(|(name, _)| is_used(&name.name));
        let found: Vec<&Ident> = self.grammar.styles.iter().filter(empty).map(|style| &style.name).collect();
        for name in found.into_iter().filter(|name| !is_exempt(&name.name)) {
            let message = format!("the style `{}` changes nothing", name.name);
            let hint = "give a constant that is used another value in it, or delete it".to_owned();
            self.tell(Code::EmptyStyle, name.span, message, "no constant of it is used", hint);
        }
    }
}

/// The name that an expression reads, if it is one: also that of `wall[facing=north]`.
fn named(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Block(text) => text.split('[').next(),
        _ => None,
    }
}

/// Names that begin so are meant to be unused; those with a prefix come from another file, which others use too.
fn is_exempt(name: &str) -> bool {
    name.starts_with('_') || name.contains('.')
}

/// The parameters of a label that none of its rules reads, as the first rule has them.
fn unused_params<'g>(rules: &[&'g Rule]) -> Vec<&'g Ident> {
    let mut used = BTreeSet::new();
    for rule in rules {
        for_each_expr_of_rule(rule, &mut |expr| {
            let place = named(expr).and_then(|name| rule.params.iter().position(|param| param.name == name));
            used.extend(place);
        });
    }
    let first = rules.first().map_or(&[][..], |rule| &rule.params);
    let label = rules.first().map_or("", |rule| &rule.label.name);
    let unused = |(at, param): &(usize, &Ident)| !used.contains(at) && !is_exempt(&param.name);
    match is_exempt(label) {
        true => Vec::new(),
        false => first.iter().enumerate().filter(unused).map(|(_, param)| param).collect(),
    }
}
