//! The order of constants: each below those that it uses.

use crate::grammar::ast::{Constant, Expr, ExprKind, Style, for_each_expr};
use std::collections::BTreeMap;

/// Puts constants, each with the number of its file, in an order in which those of other files stand above where they
/// are used. The order within a file stays, so that a use above a definition in one file is still a slip.
pub fn in_order(constants: Vec<(usize, Constant)>, styles: &[Style]) -> Vec<Constant> {
    let needs = needs(&constants, styles);
    let mut is_known = vec![false; constants.len()];
    let mut order = Vec::with_capacity(constants.len());
    let mut open: Vec<Visit> = (0..constants.len()).rev().map(Visit::Enter).collect();
    while let Some(visit) = open.pop() {
        match visit {
            Visit::Enter(at) if !std::mem::replace(&mut is_known[at], true) => {
                open.push(Visit::Leave(at));
                open.extend(needs[at].iter().rev().copied().map(Visit::Enter));
            }
            Visit::Enter(_) => {}
            Visit::Leave(at) => order.push(at),
        }
    }
    let mut constants: Vec<Option<Constant>> =
        constants.into_iter().map(|(_, constant)| Some(constant)).collect();
    order.into_iter().filter_map(|at| constants[at].take()).collect()
}

/// A step of a walk over what constants need: before it, and after it.
enum Visit {
    Enter(usize),
    Leave(usize),
}

/// For each constant the places of those that it uses, but for those below it in its own file.
fn needs(constants: &[(usize, Constant)], styles: &[Style]) -> Vec<Vec<usize>> {
    let places: BTreeMap<&str, usize> =
        constants.iter().enumerate().map(|(at, (_, constant))| (constant.name.name.as_str(), at)).collect();
    let mut needs = vec![Vec::new(); constants.len()];
    let mut add = |at: usize, value: &Expr| {
        for_each_expr(value, &mut |part| {
            let used = name(&part.kind).and_then(|name| places.get(name));
            needs[at].extend(used.filter(|used| constants[**used].0 != constants[at].0 || **used < at));
        });
    };
    for (at, (_, constant)) in constants.iter().enumerate() {
        add(at, &constant.value);
        let range = constant.attribute.iter().flat_map(|attribute| attribute.range.iter().flatten());
        range.for_each(|bound| add(at, bound));
    }
    for (constant, value) in styles.iter().flat_map(|style| &style.values) {
        places.get(constant.name.as_str()).into_iter().for_each(|at| add(*at, value));
    }
    needs
}

/// The name that an expression reads.
fn name(kind: &ExprKind) -> Option<&str> {
    match kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Block(text) => text.split('[').next(),
        _ => None,
    }
}
