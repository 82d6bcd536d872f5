//! Splits whose sizes cannot fit, whatever a run draws.

use super::Checker;
use super::flow::{Flow, State};
use super::numbers::Numbers;
use super::parts::Need;
use crate::grammar::ast::*;
use crate::grammar::{Code, Diagnostic};
use crate::space::Axis;

/// A boundary that is less than half a block away from the end of the scope is put there.
const SLACK: f64 = 0.5;

/// Differences below this are noise of floating-point sums, not sizes.
const NOISE: f64 = 1e-6;

impl<'g> Checker<'g> {
    pub(super) fn fitting(&mut self, flow: &Flow<'g>) {
        for rule in &self.grammar.rules {
            let Some(state) = flow.state(&rule.label.name) else { continue };
            let found = &mut self.found;
            flow.visit(rule, state, &mut |successor, state| {
                if let Op::Split { axis, snap: None, items } = &successor.op {
                    let axes = flow.values(axis, &rule.params, state).axes;
                    let numbers = |expr: &Expr| flow.numbers(expr, &rule.params, state);
                    found.extend(misfit(&Need::of(items, &numbers), axes, state, successor));
                }
            });
        }
    }
}

/// What is wrong with a split along any of the axes that it may have.
fn misfit(need: &Need, axes: [bool; 3], state: &State, split: &Successor) -> Option<Diagnostic> {
    let lengths = Axis::ALL.into_iter().filter(|axis| axes[axis.index()]);
    let lengths: Vec<(Axis, &Numbers)> = lengths.map(|axis| (axis, &state.lengths[axis.index()])).collect();
    let (axis, have) = *lengths.first()?;
    let along = if lengths.len() == 1 { format!(" along {axis}") } else { String::new() };
    let most = lengths.iter().map(|(_, have)| have.high()).fold(0.0, f64::max);
    if lengths.iter().all(|(_, have)| overruns(need, have)) {
        let message = match is_fraction_only(need) {
            true => format!("its sizes sum to {} of the scope{along}", number(need.fraction.low())),
            false => format!(
                "its sizes need {}{along}, and the scope has {} at the most",
                blocks(need_at(need, most, Numbers::low)),
                blocks(most)
            ),
        };
        let hint = "make a size floating (`~1`), or the scope larger; or run with `--overrun clip`";
        return Some(told(Code::NeverFits, split, message, "can never fit").hint(hint));
    }
    if !need.floats && !need.groups && lengths.iter().all(|(_, have)| underruns(need, have)) {
        let least = have.low();
        let message = format!(
            "its sizes fill {}{along}, and the scope has {} at the least",
            blocks(need_at(need, least, Numbers::high)),
            blocks(lengths.iter().map(|(_, have)| have.low()).fold(least, f64::min))
        );
        let hint = "make one of the sizes floating (`~1`), or add a part that is `~1 : nil`";
        return Some(told(Code::NeverFills, split, message, "leaves a part of the scope free").hint(hint));
    }
    None
}

fn told(code: Code, split: &Successor, message: String, label: &str) -> Diagnostic {
    Diagnostic::new(code, split.span, message).label(label)
}

fn is_fraction_only(need: &Need) -> bool {
    need.blocks == Numbers::one(0.0)
}

/// The blocks that are needed in a scope of some length.
fn need_at(need: &Need, length: f64, end: fn(&Numbers) -> f64) -> f64 {
    let fraction = end(&need.fraction);
    end(&need.blocks) + if fraction == 0.0 { 0.0 } else { fraction * length }
}

/// Whether the sizes overrun a scope of any of the lengths. What they miss it by is linear in the length, so that the
/// ends tell.
fn overruns(need: &Need, have: &Numbers) -> bool {
    let is_more = need.fraction.low() >= 1.0 || have.high().is_finite();
    is_more && ends(have).all(|length| need_at(need, length, Numbers::low) - length >= SLACK + NOISE)
}

fn underruns(need: &Need, have: &Numbers) -> bool {
    let is_less = need.fraction.high() <= 1.0 || have.high().is_finite();
    is_less && ends(have).all(|length| length - need_at(need, length, Numbers::high) > SLACK - NOISE)
}

/// The ends of what a length may be; of the lengths without bound, the least.
fn ends(have: &Numbers) -> impl Iterator<Item = f64> {
    [have.low(), have.high()].into_iter().filter(|length| length.is_finite())
}

fn blocks(count: f64) -> String {
    format!("{} block{}", number(count), if count == 1.0 { "" } else { "s" })
}

/// A number without the noise of sums.
fn number(number: f64) -> String {
    ((number * 1000.0).round() / 1000.0).to_string()
}
