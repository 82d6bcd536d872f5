//! Lists: rows of any number of units of one role, written as a rule that calls itself for what is left.

use super::draw::{Draw, minus, number};
use super::hist::Hist;
use super::row::Row;
use super::sketch::{Order, Sketch, Way, split};
use crate::grammar::ast::{BinaryOp, Function};
use crate::graph::{Expr, Size};
use crate::space::Axis;

/// A list as it is written.
#[derive(Debug)]
pub struct List {
    /// The rules of what is left.
    pub rest: Vec<Way>,
    /// The whole: what is left of it, between the space at its ends.
    pub whole: Sketch,
    /// The shortest scope that the whole fits, in cells.
    pub need: i32,
}

/// A unit that others follow: with the gap behind it, and what there was from its start to the end of the last unit.
#[derive(Clone, Copy)]
struct Step {
    len: i32,
    gap: i32,
    left: i32,
    /// The units from it on.
    count: i32,
}

impl Step {
    fn pitch(&self) -> i32 {
        self.len + self.gap
    }
}

/// How a list is written of which `rest` is what is left.
pub fn list(axis: Axis, rows: &[Row], unit: &Sketch, rest: &Sketch) -> List {
    let steps: Vec<Step> = rows.iter().flat_map(steps).collect();
    let last = Hist::of(rows.iter().filter_map(|row| row.units.last()).map(|unit| unit.len));
    let (whole, need) = whole(axis, rows, rest);
    let rest = match steps.is_empty() {
        true => vec![Way { condition: None, weight: 1, order: Order::First, sketch: unit.clone() }],
        false => Writer { axis, steps, last, unit, rest }.ways(),
    };
    List { rest, whole, need }
}

fn steps(row: &Row) -> Vec<Step> {
    let mut left = row.len() - row.lead - row.tail();
    let mut steps = Vec::new();
    for (at, unit) in row.units[..row.units.len() - 1].iter().enumerate() {
        steps.push(Step { len: unit.len, gap: unit.gap, left, count: (row.units.len() - at) as i32 });
        left -= unit.len + unit.gap;
    }
    steps
}

/// The list between the space at its ends.
fn whole(axis: Axis, rows: &[Row], rest: &Sketch) -> (Sketch, i32) {
    let lead = Hist::of(rows.iter().map(|row| row.lead));
    let tail = Hist::of(rows.iter().map(Row::tail));
    let mut sketch = rest.clone();
    let mut need = 1;
    for (space, is_before) in [(tail, false), (lead, true)] {
        let (low, high) = space.range();
        if high == 0 {
            continue;
        }
        let draw = Draw::of(space.entries());
        let draw = if low == high { draw } else { draw.within(axis, need) };
        let (nil, inner) = ((Size::absolute(draw.expr), Sketch::Nil), (Size::floating(1.0), sketch));
        sketch = split(axis, if is_before { vec![nil, inner] } else { vec![inner, nil] });
        need += if low == high { low } else { 0 };
    }
    (sketch, need)
}

struct Writer<'w> {
    axis: Axis,
    steps: Vec<Step>,
    /// The lengths of last units.
    last: Hist,
    unit: &'w Sketch,
    rest: &'w Sketch,
}

/// How far from even a list is whose units are still called even, in cells.
const UNEVEN: i32 = 2;

impl Writer<'_> {
    fn ways(&self) -> Vec<Way> {
        let (size, shortest) = match self.even() {
            Some(even) => even,
            None => self.free(),
        };
        // The end takes all that is too short to go on.
        let longest = self.last.range().1.max(shortest - 1);
        let goes_on = split(
            self.axis,
            vec![(Size::absolute(size), self.pair()), (Size::floating(1.0), self.rest.clone())],
        );
        let is_either = |left: i32| (shortest..=longest).contains(&left);
        let on = self.steps.iter().filter(|step| is_either(step.left)).count() as u32;
        let ends: u32 =
            self.last.entries().iter().filter(|(len, _)| is_either(*len)).map(|(_, count)| count).sum();
        let (on, ends) = if shortest > longest { (1, 1) } else { (on.max(1), ends.max(1)) };
        vec![
            Way {
                condition: Some(self.is(BinaryOp::GreaterEqual, shortest)),
                weight: on,
                order: Order::First,
                sketch: goes_on,
            },
            Way {
                condition: Some(self.is(BinaryOp::LessEqual, longest)),
                weight: ends,
                order: Order::First,
                sketch: self.unit.clone(),
            },
        ]
    }

    fn is(&self, op: BinaryOp, len: i32) -> Expr {
        Expr::binary(op, Expr::ScopeSize(self.axis), number(len))
    }

    /// The least that was left behind a unit and its gap.
    fn least_left(&self) -> i32 {
        self.steps.iter().map(|step| step.left - step.pitch()).min().unwrap_or(1)
    }

    /// A unit with its gap.
    fn pair(&self) -> Sketch {
        let gaps = Hist::of(self.steps.iter().map(|step| step.gap));
        let least_unit = self.steps.iter().map(|step| step.len).min().unwrap_or(1);
        let least = self.steps.iter().map(Step::pitch).min().unwrap_or(1);
        let (low, high) = gaps.range();
        if high == 0 {
            return self.unit.clone();
        }
        let draw = Draw::of(gaps.entries());
        let draw =
            if low < high && high + least_unit > least { draw.within(self.axis, least_unit) } else { draw };
        split(
            self.axis,
            vec![(Size::floating(1.0), self.unit.clone()), (Size::absolute(draw.expr), Sketch::Nil)],
        )
    }

    /// Units of any length that was seen, as long as enough is left: the size and the shortest scope.
    fn free(&self) -> (Expr, i32) {
        let pitches = Hist::of(self.steps.iter().map(Step::pitch));
        let rest = self.least_left();
        let draw = Draw::of(pitches.entries());
        let shortest = draw.low + rest;
        let draw = if draw.low < draw.high { draw.within(self.axis, rest) } else { draw };
        (draw.expr, shortest)
    }

    /// Units that divide what is left about evenly, where all did so: the size and the shortest scope.
    fn even(&self) -> Option<(Expr, i32)> {
        let pitches = Hist::of(self.steps.iter().map(Step::pitch));
        let gap = Hist::of(self.steps.iter().map(|step| step.gap)).mean().round() as i32;
        let period = pitches.mean().round() as i32;
        let (low, high) = pitches.range();
        // Where one unit can be as long as two, any length can be filled.
        if self.last.range().0 + low <= self.last.range().1 + 1 || high >= 2 * low {
            return None;
        }
        let count = |left: i32| (f64::from(left + gap) / f64::from(period)).round().max(2.0);
        let even = |left: i32| (f64::from(left + gap) / count(left)).round() as i32;
        if self.steps.iter().any(|step| f64::from(step.count) != count(step.left)) {
            return None;
        }
        let off = Hist::of(self.steps.iter().map(|step| step.pitch() - even(step.left)));
        let (least, most) = off.range();
        if most - least > UNEVEN {
            return None;
        }
        let whole = minus(Expr::ScopeSize(self.axis), -gap);
        let call = |function, args| Expr::Call(function, args);
        let counted =
            call(Function::Round, vec![Expr::binary(BinaryOp::Divide, whole.clone(), number(period))]);
        let counted = call(Function::Max, vec![number(2), counted]);
        let share = call(Function::Round, vec![Expr::binary(BinaryOp::Divide, whole, counted)]);
        let size = match (least, most) {
            (0, 0) => share,
            (least, most) if least == most => minus(share, -least),
            (least, most) => {
                Expr::binary(BinaryOp::Add, minus(share, -least), Expr::between(0, most - least))
            }
        };
        let first = self.steps.iter().map(|step| step.left).min()?;
        let longest = self.last.range().1;
        let shortest = if longest < first { (longest + first + 1) / 2 } else { first };
        (even(shortest) + most < shortest).then_some((size, shortest))
    }
}
