//! Conditions: cases that no rule covers, and rules that no case reaches.

use super::Checker;
use super::cases::{Cases, Stretch, Variable, can_all_hold};
use super::flow::Flow;
use super::numbers::Numbers;
use crate::grammar::Code;
use crate::grammar::ast::*;

impl<'g> Checker<'g> {
    pub(super) fn conditions(&mut self, flow: &Flow<'g>) {
        for rule in &self.grammar.rules {
            if let Some(condition) = rule.condition.as_ref().filter(|condition| !can_all_hold(&[condition])) {
                let message = "this condition can never hold";
                let hint = "its parts contradict one another: did you mean `or`, or another sign?".to_owned();
                self.tell(Code::NeverHolds, condition.span, message, "the rule is never taken", hint);
            }
        }
        let labels: Vec<Vec<&'g Rule>> = self.rules.values().cloned().collect();
        for rules in &labels {
            self.gap(rules, flow);
            self.shadowed(rules);
        }
    }

    /// Tells of the cases that no rule of a label covers, where they are those of one thing.
    fn gap(&mut self, rules: &[&'g Rule], flow: &Flow<'g>) {
        let conditions: Option<Vec<&Expr>> = rules.iter().map(|rule| rule.condition.as_ref()).collect();
        let (Some(conditions), Some(first)) = (conditions, rules.first()) else { return };
        let cases = Cases::of(&conditions);
        let [variable] = cases.variables.as_slice() else { return };
        // Rules of a label may call their parameters differently.
        if rules.iter().any(|rule| rule.params != first.params) || asks(variable) {
            return;
        }
        let Some(numbers) = reached(variable, first, flow) else { return };
        let is_open = |stretch: &Stretch| {
            numbers.meets(stretch.low, stretch.high, !stretch.is_point())
                && !conditions.iter().any(|condition| cases.holds(condition, &[*stretch]))
        };
        let open: Vec<(usize, Stretch)> =
            variable.stretches().into_iter().enumerate().filter(|(_, stretch)| is_open(stretch)).collect();
        if open.is_empty() {
            return;
        }
        let gaps: Vec<String> = joined(&open).into_iter().map(|gap| gap.text(variable, &numbers)).collect();
        let label = &first.label;
        let message =
            format!("`{}` is covered by none of the rules of `{}`", gaps.join("` or `"), label.name);
        let hint =
            "move a bound, add a rule for it, or one without a condition at a later priority".to_owned();
        self.tell(Code::Gap, label.span, message, "every rule has a condition", hint);
    }

    /// Tells of rules of a later priority behind one that always applies.
    fn shadowed(&mut self, rules: &[&'g Rule]) {
        let always = rules.iter().filter(|rule| rule.condition.is_none()).map(|rule| rule.priority).min();
        let Some(always) = always else { return };
        for rule in rules.iter().filter(|rule| rule.priority > always) {
            let message = format!("this rule of `{}` is never taken", rule.label.name);
            let hint =
                format!("a rule of priority {always} has no condition and always applies: give it one");
            self.tell(
                Code::Shadowed,
                rule.label.span,
                message,
                &format!("its priority is {}", rule.priority),
                hint,
            );
        }
    }
}

/// Whether the answer lies in other shapes.
fn asks(variable: &Variable<'_>) -> bool {
    let mut asks = false;
    for side in [Some(variable.left), variable.right].into_iter().flatten() {
        for_each_expr(side, &mut |part| {
            asks |= matches!(part.kind, ExprKind::Occlusion { .. } | ExprKind::Visible(_));
        });
        asks |= super::cases::draws(side);
    }
    asks
}

/// The numbers that a variable may be where the label runs; none where it may be something else, or nothing runs it.
fn reached(variable: &Variable<'_>, rule: &Rule, flow: &Flow<'_>) -> Option<Numbers> {
    let state = flow.state(&rule.label.name)?;
    let numbers = |expr: &Expr| {
        let values = flow.values(expr, &rule.params, state);
        Some(values.numbers).filter(|numbers| !numbers.is_none() && values.axes == [false; 3])
    };
    let left = numbers(variable.left)?;
    match variable.right {
        None => Some(left),
        Some(right) => Some(Numbers::binary(BinaryOp::Subtract, &left, &numbers(right)?)),
    }
}

/// Stretches that follow one another, as one.
struct Gap {
    low: Stretch,
    high: Stretch,
}

fn joined(open: &[(usize, Stretch)]) -> Vec<Gap> {
    let runs = open.chunk_by(|(a, _), (b, _)| a + 1 == *b);
    runs.filter_map(|run| Some(Gap { low: run.first()?.1, high: run.last()?.1 })).collect()
}

impl Gap {
    /// The gap as a condition.
    fn text(&self, variable: &Variable<'_>, numbers: &Numbers) -> String {
        let (mut low, mut high) = (self.low.low, self.high.high);
        let (mut has_low, mut has_high) = (self.low.is_point(), self.high.is_point());
        if variable.right.is_none() && numbers.is_whole() {
            low = if has_low { low.ceil() } else { low.floor() + 1.0 };
            high = if has_high { high.floor() } else { high.ceil() - 1.0 };
            (has_low, has_high) = (true, true);
        }
        // What lies beyond all that can occur needs no word.
        let (is_low_told, is_high_told) =
            (low > numbers.low() || low == high, high < numbers.high() || low == high);
        let sign = |is_in: bool| if is_in { "<=" } else { "<" };
        let (left, right) = (variable.left, variable.right.map(ToString::to_string));
        let of = |bound: f64| right.clone().unwrap_or_else(|| bound.to_string());
        match (is_low_told && low.is_finite(), is_high_told && high.is_finite()) {
            (true, true) if low == high => format!("{left} == {}", of(low)),
            (true, true) => format!("{low} {} {left} {} {high}", sign(has_low), sign(has_high)),
            (true, false) => format!("{left} {} {}", sign(has_low).replace('<', ">"), of(low)),
            (false, true) => format!("{left} {} {}", sign(has_high), of(high)),
            (false, false) => format!("any {left}"),
        }
    }
}
