//! Walks over the tree, so that each pass says only what it looks for.

use super::{Change, Expr, ExprKind, Item, Op, Rule, Size, Successor};

/// Visits every operation that stands directly in another.
pub fn for_each_child<'g>(op: &'g Op, visit: &mut impl FnMut(&'g Successor)) {
    match op {
        Op::Primitive { .. } | Op::Nil | Op::Call { .. } | Op::Snap { .. } => {}
        Op::All(ops) => ops.iter().for_each(visit),
        Op::Split { items, .. } => items.iter().for_each(|item| item_children(item, visit)),
        Op::Repeat { body, .. } | Op::RepeatN { body, .. } | Op::Within { body, .. } => visit(body),
        Op::Carve { parts, .. } => parts.iter().for_each(|(_, body)| visit(body)),
    }
}

fn item_children<'g>(item: &'g Item, visit: &mut impl FnMut(&'g Successor)) {
    match item {
        Item::Part { body, .. } => visit(body),
        Item::Group { items, .. } => items.iter().for_each(|item| item_children(item, visit)),
    }
}

/// As [`for_each_child`], to change them.
pub fn for_each_child_mut<'g>(op: &'g mut Op, visit: &mut impl FnMut(&'g mut Successor)) {
    match op {
        Op::Primitive { .. } | Op::Nil | Op::Call { .. } | Op::Snap { .. } => {}
        Op::All(ops) => ops.iter_mut().for_each(visit),
        Op::Split { items, .. } => items.iter_mut().for_each(|item| item_children_mut(item, visit)),
        Op::Repeat { body, .. } | Op::RepeatN { body, .. } | Op::Within { body, .. } => visit(body),
        Op::Carve { parts, .. } => parts.iter_mut().for_each(|(_, body)| visit(body)),
    }
}

fn item_children_mut<'g>(item: &'g mut Item, visit: &mut impl FnMut(&'g mut Successor)) {
    match item {
        Item::Part { body, .. } => visit(body),
        Item::Group { items, .. } => items.iter_mut().for_each(|item| item_children_mut(item, visit)),
    }
}

/// Visits the expressions of an operation itself, without those of the operations in it.
pub fn for_each_own_expr<'g>(op: &'g Op, visit: &mut impl FnMut(&'g Expr)) {
    match op {
        Op::Nil | Op::All(_) => {}
        Op::Primitive { name, material, options } => {
            visit(name);
            material.iter().for_each(&mut *visit);
            options.iter().for_each(|(_, value)| visit(value));
        }
        Op::Call { args, .. } | Op::Carve { args, .. } => args.iter().for_each(visit),
        Op::Split { axis, items, .. } => {
            visit(axis);
            items.iter().for_each(|item| item_exprs(item, visit));
        }
        Op::Repeat { axis, size: other, .. } | Op::RepeatN { axis, count: other, .. } => {
            visit(axis);
            visit(other);
        }
        Op::Snap { axis, .. } => visit(axis),
        Op::Within { change, .. } => change_exprs(change, visit),
    }
}

fn item_exprs<'g>(item: &'g Item, visit: &mut impl FnMut(&'g Expr)) {
    match item {
        Item::Part { size: Size { value, .. }, .. } => visit(value),
        Item::Group { items, .. } => items.iter().for_each(|item| item_exprs(item, visit)),
    }
}

fn change_exprs<'g>(change: &'g Change, visit: &mut impl FnMut(&'g Expr)) {
    match change {
        Change::Translate(sizes) | Change::Resize(sizes) => {
            sizes.iter().for_each(|size| visit(&size.value));
        }
        Change::Rotate { axis, angle } => {
            visit(axis);
            visit(angle);
        }
        Change::Same(key) => visit(key),
        Change::Local | Change::Style(_) => {}
    }
}

/// Visits an expression and all its parts.
pub fn for_each_expr<'g>(expr: &'g Expr, visit: &mut impl FnMut(&'g Expr)) {
    visit(expr);
    let mut inner = |part: &'g Expr| for_each_expr(part, visit);
    match &expr.kind {
        ExprKind::Unary(_, operand) => inner(operand),
        ExprKind::Binary(_, left, right) | ExprKind::Same(left, right) => {
            inner(left);
            inner(right);
        }
        ExprKind::Call(_, args) => args.iter().for_each(inner),
        ExprKind::Pick(parts) | ExprKind::Mix(parts) => parts.iter().for_each(|(weight, value)| {
            inner(weight);
            inner(value);
        }),
        ExprKind::Gradient(axis, blocks) => {
            inner(axis);
            blocks.iter().for_each(inner);
        }
        ExprKind::Occlusion { distance, .. } => distance.iter().for_each(|distance| inner(distance)),
        ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Block(_)
        | ExprKind::File(_)
        | ExprKind::ScopeSize(_)
        | ExprKind::Share(_)
        | ExprKind::Visible(_) => {}
    }
}

/// Visits every expression of a rule and of all operations in it, with all its parts.
pub fn for_each_expr_of_rule<'g>(rule: &'g Rule, visit: &mut impl FnMut(&'g Expr)) {
    rule.condition.iter().chain(&rule.weight).for_each(|expr| for_each_expr(expr, visit));
    for_each_expr_of(&rule.successor, visit);
}

fn for_each_expr_of<'g>(successor: &'g Successor, visit: &mut impl FnMut(&'g Expr)) {
    for_each_own_expr(&successor.op, &mut |expr| for_each_expr(expr, visit));
    for_each_child(&successor.op, &mut |child| for_each_expr_of(child, visit));
}

/// Visits every label that an operation calls.
pub fn for_each_call<'g>(successor: &'g Successor, visit: &mut impl FnMut(&'g str)) {
    if let Op::Call { label, .. } = &successor.op {
        visit(&label.name);
    }
    for_each_child(&successor.op, &mut |child| for_each_call(child, visit));
}
