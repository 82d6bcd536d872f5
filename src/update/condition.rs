//! Conditions that come to hold for further scopes.

use super::texts::Program;
use crate::grammar::ast::{BinaryOp, Expr, ExprKind, UnaryOp, for_each_expr};
use crate::space::Axis;

/// The words of a condition that holds for scopes of these sizes as well; `None` where it asks for something else than
/// sizes. Bounds move; of sizes that are named one by one there are more.
pub fn relaxed(program: &Program, condition: &Expr, sizes: &[[i32; 3]]) -> Option<String> {
    let words = program.words(condition.span).to_owned();
    match &condition.kind {
        ExprKind::Binary(BinaryOp::And, left, right) if has_bounds(condition) => {
            let [left, right] = [left, right].map(|side| {
                let relaxed = relaxed(program, side, sizes)?;
                let is_split = relaxed != program.words(side.span) && !has_bounds(side);
                Some(if is_split { format!("({relaxed})") } else { relaxed })
            });
            Some(format!("{} and {}", left?, right?))
        }
        ExprKind::Binary(op, ..) if op.is_comparison() => {
            let (axis, op, bound) = comparison(condition)?;
            let lengths: Vec<i32> = sizes.iter().map(|size| size[axis.index()]).collect();
            compared(words, axis, op, bound, &lengths)
        }
        _ => {
            let axes = axes(condition);
            let failing = sizes.iter().filter(|size| holds(condition, **size) != Some(true));
            let more = failing.map(|size| format!(" or {}", is(&axes, *size)));
            (!axes.is_empty()).then(|| words + &more.collect::<String>())
        }
    }
}

/// Whether a condition holds for a scope of a size; `None` where it asks for something else.
pub fn holds(condition: &Expr, size: [i32; 3]) -> Option<bool> {
    match &condition.kind {
        ExprKind::Unary(UnaryOp::Not, inner) => holds(inner, size).map(|holds| !holds),
        ExprKind::Binary(BinaryOp::And, left, right) => both(holds(left, size), holds(right, size)),
        ExprKind::Binary(BinaryOp::Or, left, right) => {
            let [left, right] = [left, right].map(|side| holds(side, size).map(|holds| !holds));
            both(left, right).map(|fails| !fails)
        }
        _ => {
            let (axis, op, bound) = comparison(condition)?;
            Some(passes(op, size[axis.index()], bound))
        }
    }
}

/// Whether both hold, as far as one of them alone does not tell.
fn both(one: Option<bool>, other: Option<bool>) -> Option<bool> {
    match (one, other) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

/// Whether lengths are bounded by more than those that are named.
fn has_bounds(condition: &Expr) -> bool {
    let mut has = false;
    for_each_expr(condition, &mut |part| {
        has |= comparison(part).is_some_and(|(_, op, _)| op != BinaryOp::Equal);
    });
    has
}

/// A comparison of a length of the scope with a number, as one of the length.
fn comparison(expr: &Expr) -> Option<(Axis, BinaryOp, f64)> {
    let ExprKind::Binary(op, left, right) = &expr.kind else { return None };
    match (&left.kind, &right.kind) {
        _ if !op.is_comparison() => None,
        (ExprKind::ScopeSize(axis), ExprKind::Number(bound)) => Some((*axis, *op, *bound)),
        (ExprKind::Number(bound), ExprKind::ScopeSize(axis)) => Some((*axis, op.mirrored(), *bound)),
        _ => None,
    }
}

fn passes(op: BinaryOp, length: i32, bound: f64) -> bool {
    let length = f64::from(length);
    match op {
        BinaryOp::Equal => length == bound,
        BinaryOp::NotEqual => length != bound,
        BinaryOp::Less => length < bound,
        BinaryOp::LessEqual => length <= bound,
        BinaryOp::Greater => length > bound,
        _ => length >= bound,
    }
}

/// A comparison that these lengths pass as well.
fn compared(words: String, axis: Axis, op: BinaryOp, bound: f64, lengths: &[i32]) -> Option<String> {
    let mut failing: Vec<i32> =
        lengths.iter().copied().filter(|length| !passes(op, *length, bound)).collect();
    failing.sort_unstable();
    failing.dedup();
    let (Some(least), Some(most)) = (failing.first(), failing.last()) else { return Some(words) };
    match op {
        BinaryOp::Equal => {
            Some(failing.iter().fold(words, |words, length| format!("{words} or scope.s{axis} == {length}")))
        }
        BinaryOp::Less | BinaryOp::LessEqual => Some(format!("scope.s{axis} <= {most}")),
        BinaryOp::Greater | BinaryOp::GreaterEqual => Some(format!("scope.s{axis} >= {least}")),
        _ => None,
    }
}

/// The axes whose lengths an expression asks for.
fn axes(expr: &Expr) -> Vec<Axis> {
    let mut asked = [false; 3];
    for_each_expr(expr, &mut |part| {
        if let ExprKind::ScopeSize(axis) = part.kind {
            asked[axis.index()] = true;
        }
    });
    Axis::ALL.into_iter().filter(|axis| asked[axis.index()]).collect()
}

/// That a scope has this size along some axes.
pub fn is(axes: &[Axis], size: [i32; 3]) -> String {
    let is = |axis: &Axis| format!("scope.s{axis} == {}", size[axis.index()]);
    axes.iter().map(is).collect::<Vec<String>>().join(" and ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::Sources;
    use crate::update::Texts;

    fn relax(condition: &str, sizes: &[[i32; 3]]) -> Option<String> {
        let text = format!("a --> b\nb : {condition} --> I(stone)\nb --> nil");
        let program = Texts::of(&Sources::of("a.grammar", &text)).read().unwrap();
        let rule = program.checked.rules_of("b").next().unwrap();
        relaxed(&program, rule.condition.as_ref().unwrap(), sizes)
    }

    #[test]
    fn comparisons_take_in_what_fails() {
        let of = |condition: &str, sizes: &[[i32; 3]]| relax(condition, sizes).unwrap();
        assert_eq!(of("scope.sx < 5", &[[7, 1, 1], [9, 1, 1], [2, 1, 1]]), "scope.sx <= 9");
        assert_eq!(of("3 <= scope.sy", &[[7, 2, 1]]), "scope.sy >= 2");
        assert_eq!(of("scope.sx == 5", &[[7, 2, 1]]), "scope.sx == 5 or scope.sx == 7");
        assert_eq!(
            of("scope.sx == 5 and scope.sy > 3", &[[7, 4, 1]]),
            "(scope.sx == 5 or scope.sx == 7) and scope.sy > 3"
        );
        assert_eq!(
            of("scope.sx == 5 and scope.sy == 3", &[[7, 4, 1], [5, 3, 2]]),
            "scope.sx == 5 and scope.sy == 3 or scope.sx == 7 and scope.sy == 4"
        );
        assert_eq!(
            of("scope.sx == 5 and scope.sy == 3 or scope.sx == 7 and scope.sy == 4", &[[7, 3, 1]]),
            "scope.sx == 5 and scope.sy == 3 or scope.sx == 7 and scope.sy == 4 or scope.sx == 7 and scope.sy == 3"
        );
    }

    #[test]
    fn conditions_on_sizes_hold_or_do_not() {
        let of = |condition: &str| {
            let grammar: crate::grammar::Grammar = format!("a : {condition} --> nil").parse().unwrap();
            holds(grammar.rules[0].condition.as_ref().unwrap(), [5, 3, 2])
        };
        assert_eq!(of("scope.sx == 5 and not (scope.sy > 3)"), Some(true));
        assert_eq!(of("scope.sx != 5 or 2 >= scope.sz"), Some(true));
        assert_eq!(of("rand < 0.5 and scope.sx < 5"), Some(false));
        assert_eq!(of("rand < 0.5 or scope.sx < 5"), None);
    }

    #[test]
    fn what_is_not_about_sizes_stays() {
        assert_eq!(relax("rand < 0.5", &[[7, 4, 1]]), None);
        assert_eq!(relax("scope.sx != 7", &[[7, 4, 1]]), None);
    }
}
