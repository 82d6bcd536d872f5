//! How often a new alternative comes.

use crate::grammar::ast::{Expr, ExprKind, Rule};

/// The weight of a further alternative beside those that there are: that of the rarest, but never more than one. A
/// text does not say how many houses its weights were counted in, and people set them by hand, so none is counted up.
pub fn weight<'r>(rules: impl Iterator<Item = &'r Rule>) -> Option<Expr> {
    let weights = rules.filter_map(|rule| match rule.weight.as_ref().map(|weight| &weight.kind) {
        Some(ExprKind::Number(weight)) if *weight > 0.0 => Some(*weight),
        _ => None,
    });
    weights.min_by(f64::total_cmp).filter(|least| *least < 1.0).map(Expr::number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::Grammar;

    #[test]
    fn a_new_alternative_comes_as_often_as_the_rarest() {
        let of = |text: &str| {
            let grammar: Grammar = text.parse().unwrap();
            weight(grammar.rules.iter()).map(|weight| weight.to_string())
        };
        assert_eq!(of("a --> I(stone)"), None);
        assert_eq!(of("a --> I(stone) : 7\na --> nil : 3"), None);
        assert_eq!(of("a --> I(stone) : 0.7\na --> nil : 0.2\na --> I(glass) : 0.1"), Some("0.1".to_owned()));
        assert_eq!(of("a --> I(stone) : 0\na --> nil : 0.5"), Some("0.5".to_owned()));
    }
}
