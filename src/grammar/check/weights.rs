//! Weights that are known before a run: below zero, or all zero.

use super::Checker;
use super::cases::known_number;
use crate::grammar::Code;
use crate::grammar::ast::*;

impl<'g> Checker<'g> {
    pub(super) fn weights(&mut self) {
        let labels: Vec<Vec<&Rule>> = self.rules.values().cloned().collect();
        for rules in &labels {
            let weights: Vec<Option<&Expr>> = rules.iter().map(|rule| rule.weight.as_ref()).collect();
            match rules.as_slice() {
                // A rule without a rival is taken, whatever its weight.
                [only] if only.condition.is_none() => self.below_zero(&weights),
                _ => self.weighed(&weights, &format!("the rules of `{}`", rules[0].label.name)),
            }
        }
        let sizes: Vec<Option<&Expr>> =
            self.grammar.sizes.iter().map(|start| start.weight.as_ref()).collect();
        self.weighed(&sizes, "the start sizes");
        let grammar = self.grammar;
        for constant in &grammar.constants {
            for_each_expr(&constant.value, &mut |expr| self.weights_in(expr));
        }
        for rule in &grammar.rules {
            for_each_expr_of_rule(rule, &mut |expr| self.weights_in(expr));
        }
    }

    fn weights_in(&mut self, expr: &Expr) {
        if let ExprKind::Pick(parts) | ExprKind::Mix(parts) = &expr.kind {
            let weights: Vec<Option<&Expr>> = parts.iter().map(|(weight, _)| Some(weight)).collect();
            self.weighed(&weights, "the values to choose from");
        }
    }

    /// Tells of one list of weights; one that is not written is 1.
    fn weighed(&mut self, weights: &[Option<&Expr>], whose: &str) {
        self.below_zero(weights);
        let is_zero = |weight: &Option<&Expr>| weight.and_then(known_number) == Some(0.0);
        if let Some(Some(first)) = weights.first()
            && weights.iter().all(is_zero)
        {
            let hint = "give one of them a weight above zero, or none, which is 1".to_owned();
            let message = format!("the weights of {whose} are all zero");
            self.tell(Code::NoWeight, first.span, message, "nothing can be chosen", hint);
        }
    }

    fn below_zero(&mut self, weights: &[Option<&Expr>]) {
        let is_below = |weight: &&&Expr| known_number(weight).is_some_and(|number| number < 0.0);
        for weight in weights.iter().flatten().filter(is_below) {
            let hint = "write 0 for what is never to be chosen".to_owned();
            self.tell(
                Code::NoWeight,
                weight.span,
                "a weight is below zero",
                "weights are zero or more",
                hint,
            );
        }
    }
}
