//! Conditions that come to hold for further scopes.

use super::texts::Program;
use crate::grammar::ast::{BinaryOp, Expr, ExprKind, for_each_expr};
use crate::space::Axis;

/// The words of a condition that holds for scopes of these sizes as well; `None` where it asks for something else than
/// sizes.
pub fn relaxed(program: &Program, condition: &Expr, sizes: &[[i32; 3]]) -> Option<String> {
    let words = program.words(condition.span).to_owned();
    match &condition.kind {
        ExprKind::Binary(BinaryOp::And, left, right) => {
            let [left, right] = [left, right].map(|side| {
                let relaxed = relaxed(program, side, sizes)?;
                let is_changed = relaxed != program.words(side.span);
                Some(if is_changed && relaxed.contains(" or ") { format!("({relaxed})") } else { relaxed })
            });
            Some(format!("{} and {}", left?, right?))
        }
        ExprKind::Binary(op, left, right) if op.is_comparison() => {
            let (axis, op, bound) = match (&left.kind, &right.kind) {
                (ExprKind::ScopeSize(axis), ExprKind::Number(bound)) => (*axis, *op, *bound),
                (ExprKind::Number(bound), ExprKind::ScopeSize(axis)) => (*axis, op.mirrored(), *bound),
                _ => return None,
            };
            let lengths: Vec<i32> = sizes.iter().map(|size| size[axis.index()]).collect();
            compared(words, axis, op, bound, &lengths)
        }
        _ => {
            let axes = axes(condition);
            (!axes.is_empty())
                .then(|| sizes.iter().fold(words, |words, size| format!("{words} or {}", is(&axes, *size))))
        }
    }
}

/// A comparison that these lengths pass as well.
fn compared(words: String, axis: Axis, op: BinaryOp, bound: f64, lengths: &[i32]) -> Option<String> {
    let passes = |length: &i32| {
        let length = f64::from(*length);
        match op {
            BinaryOp::Equal => length == bound,
            BinaryOp::Less => length < bound,
            BinaryOp::LessEqual => length <= bound,
            BinaryOp::Greater => length > bound,
            BinaryOp::GreaterEqual => length >= bound,
            _ => false,
        }
    };
    let mut failing: Vec<i32> = lengths.iter().copied().filter(|length| !passes(length)).collect();
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
            of("scope.sx == 5 and scope.sy == 3 or scope.sx == 7 and scope.sy == 4", &[[7, 3, 1]]),
            "scope.sx == 5 and scope.sy == 3 or scope.sx == 7 and scope.sy == 4 or scope.sx == 7 and scope.sy == 3"
        );
    }

    #[test]
    fn what_is_not_about_sizes_stays() {
        assert_eq!(relax("rand < 0.5", &[[7, 4, 1]]), None);
        assert_eq!(relax("scope.sx != 7", &[[7, 4, 1]]), None);
    }
}
