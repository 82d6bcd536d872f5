//! All that an expression may come to, where a run draws one value.
//!
//! Draws are independent of one another, those with a key as well. What a query about other shapes answers is not
//! known here: it may answer anything.

use super::value::Value;
use crate::grammar::ast::{BinaryOp, Function, Share, UnaryOp};
use crate::graph::{Expr, Number, Thing};
use crate::space::{Axis, Scope};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What may come out.
#[derive(Clone, Debug)]
pub enum Draw {
    Certain(Value),
    /// Each with its probability; none is twice there.
    OneOf(Vec<(Value, f64)>),
    /// Any number between two, as likely as another.
    Between(f64, f64),
}

/// What the expressions of one operation see.
#[derive(Clone, Copy)]
pub struct Sight<'a> {
    pub params: &'a [Value],
    /// `None` for those that nothing asks for.
    pub constants: &'a [Option<Value>],
    /// The place among the shares of a split: number and total.
    pub share: (u32, u32),
    pub scope: Option<&'a Scope>,
}

/// More values than this are not told apart.
const MOST_VALUES: usize = 1 << 12;

/// So many values stand for all between two, where one has to be named.
const SAMPLES: usize = 16;

/// A normal draw lies within so many deviations: the draws of a run have 53 bits.
const DEVIATIONS: f64 = 8.6;

impl Draw {
    pub fn number(value: f64) -> Draw {
        Draw::Certain(Value::number(value))
    }

    fn of(value: Value) -> Draw {
        match value {
            Value::Between(low, high) => Draw::Between(low.0, high.0),
            value => Draw::Certain(value),
        }
    }

    /// The values with their probabilities, as they are handed on: numbers between two stay unknown.
    pub fn handed_on(self) -> Vec<(Value, f64)> {
        match self {
            Draw::Between(low, high) => vec![(Value::Between(Number(low), Number(high)), 1.0)],
            draw => draw.values(),
        }
    }

    /// The values with their probabilities; of those between two numbers some, evenly spread.
    pub fn values(self) -> Vec<(Value, f64)> {
        match self {
            Draw::Certain(value) => vec![(value, 1.0)],
            Draw::OneOf(values) => values,
            Draw::Between(low, high) => {
                let at = |sample: usize| low + (high - low) * (sample as f64 + 0.5) / SAMPLES as f64;
                (0..SAMPLES).map(|sample| (Value::number(at(sample)), 1.0 / SAMPLES as f64)).collect()
            }
        }
    }

    /// The numbers with their probabilities; `None` where one is no number.
    pub fn numbers(self) -> Option<Vec<(f64, f64)>> {
        self.values().into_iter().map(|(value, chance)| Some((value.as_number()?, chance))).collect()
    }

    /// The chance that it is not zero.
    pub fn truth(self) -> Option<f64> {
        Some(self.numbers()?.iter().filter(|(number, _)| *number != 0.0).map(|(_, chance)| chance).sum())
    }

    /// The least and the greatest number.
    fn ends(&self) -> Option<[f64; 2]> {
        match self {
            Draw::Certain(value) => value.as_number().map(|number| [number; 2]),
            Draw::Between(low, high) => Some([*low, *high]),
            Draw::OneOf(values) => {
                values.iter().try_fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (value, _)| {
                    let number = value.as_number()?;
                    Some([low.min(number), high.max(number)])
                })
            }
        }
    }

    /// Equal values joined; those that never come left out.
    fn one_of(values: impl IntoIterator<Item = (Value, f64)>) -> Option<Draw> {
        let mut places: FxHashMap<Value, usize> = FxHashMap::default();
        let mut joined: Vec<(Value, f64)> = Vec::new();
        for (value, chance) in values.into_iter().filter(|(_, chance)| *chance > 0.0) {
            match places.get(&value) {
                Some(&at) => joined[at].1 += chance,
                None => {
                    places.insert(value.clone(), joined.len());
                    joined.push((value, chance));
                }
            }
        }
        match joined.len() {
            0 => None,
            1 => joined.pop().map(|(value, _)| Draw::Certain(value)),
            _ => Some(Draw::OneOf(joined)),
        }
    }

    fn between(low: f64, high: f64) -> Option<Draw> {
        match low.is_finite() && high.is_finite() {
            true if low == high => Some(Draw::number(low)),
            true => Some(Draw::Between(low.min(high), low.max(high))),
            false => None,
        }
    }
}

impl Sight<'_> {
    /// What an expression may come to; `None` where a run would stop with an error.
    pub fn draw(&self, expr: &Expr) -> Option<Draw> {
        Some(match expr {
            Expr::Number(number) => Draw::Certain(Value::Number(*number)),
            Expr::Axis(axis) => Draw::Certain(Value::Axis(*axis)),
            Expr::Thing(thing) => Draw::Certain(Value::Thing(Arc::new(thing.clone()))),
            Expr::Param(at) => Draw::of(self.params.get(*at)?.clone()),
            Expr::Constant(at) => Draw::of(self.constants.get(*at)?.clone()?),
            Expr::ScopeSize(axis) => {
                Draw::number(self.scope.map_or(0.0, |scope| f64::from(scope.len(*axis))))
            }
            Expr::Share(Share::Index) => Draw::number(f64::from(self.share.0)),
            Expr::Share(Share::Total) => Draw::number(f64::from(self.share.1)),
            Expr::Unary(op, operand) => unary(*op, self.draw(operand)?)?,
            Expr::Binary(op, left, right) => self.binary(*op, left, right)?,
            Expr::Call(function, args) => self.call(*function, args)?,
            Expr::Pick(parts) => self.pick(parts)?,
            Expr::Mix(parts) => self.mix(parts)?,
            Expr::Gradient(axis, blocks) => self.gradient(axis, blocks)?,
            Expr::State(base, properties) => {
                let changed = |value: &Value| Some(Arc::new(value.as_thing()?.with(properties)));
                let bases = self.draw(base)?.values().into_iter();
                let changed = bases.map(|(base, chance)| Some((Value::Thing(changed(&base)?), chance)));
                Draw::one_of(changed.collect::<Option<Vec<_>>>()?)?
            }
            Expr::Same(_, value) => self.draw(value)?,
            Expr::Occlusion { .. } => Draw::one_of([0.0, 1.0, 2.0].map(|n| (Value::number(n), 1.0 / 3.0)))?,
            Expr::Visible(_) => Draw::one_of([0.0, 1.0].map(|n| (Value::number(n), 0.5)))?,
        })
    }

    /// The value of an expression that has but one.
    pub fn certain(&self, expr: &Expr) -> Option<Value> {
        match self.draw(expr)? {
            Draw::Certain(value) => Some(value),
            _ => None,
        }
    }

    fn binary(&self, op: BinaryOp, left: &Expr, right: &Expr) -> Option<Draw> {
        let left = self.draw(left)?;
        match op {
            // What comes after a decision is not looked at.
            BinaryOp::And if matches!(&left, Draw::Certain(value) if value.as_number() == Some(0.0)) => {
                return Some(Draw::number(0.0));
            }
            BinaryOp::Or if matches!(&left, Draw::Certain(value) if value.as_number().is_some_and(|n| n != 0.0)) =>
            {
                return Some(Draw::number(1.0));
            }
            _ => {}
        }
        let right = self.draw(right)?;
        match (&left, &right) {
            (Draw::Between(..), _) | (_, Draw::Between(..)) if op.is_comparison() => {
                compare(op, left.ends()?, right.ends()?)
            }
            (Draw::Certain(left), Draw::Certain(right)) => Some(Draw::Certain(apply(op, left, right)?)),
            (Draw::Between(..), _) | (_, Draw::Between(..)) if is_smooth(op) => {
                stretch(op, left.ends()?, right.ends()?)
            }
            _ => product(vec![left, right], |values| apply(op, values[0], values[1])),
        }
    }

    fn call(&self, function: Function, args: &[Expr]) -> Option<Draw> {
        let args = args.iter().map(|arg| self.draw(arg)).collect::<Option<Vec<Draw>>>()?;
        let ends = |at: usize| args.get(at).and_then(Draw::ends);
        match (function, args.len()) {
            (Function::Rand, 2) => Draw::between(ends(0)?[0].min(ends(1)?[0]), ends(0)?[1].max(ends(1)?[1])),
            (Function::Rand, _) => Draw::between(0.0, 1.0),
            (Function::Gauss, _) => {
                let [low, high] = ends(0)?;
                let most = DEVIATIONS * ends(1)?.into_iter().fold(0.0, |most: f64, end| most.max(end.abs()));
                Draw::between(low - most, high + most)
            }
            (Function::Triangular, 3) => {
                Draw::between(ends(0)?[0].min(ends(2)?[0]), ends(0)?[1].max(ends(2)?[1]))
            }
            (Function::Randint, 2) => ranges(args),
            (Function::Floor | Function::Ceil | Function::Round, 1) => match args.into_iter().next()? {
                Draw::Between(low, high) => rounded(function, low, high),
                certain => product(vec![certain], |values| {
                    Some(Value::number(round(function, values[0].as_number()?)))
                }),
            },
            (Function::Min | Function::Max, _) if args.iter().any(|arg| matches!(arg, Draw::Between(..))) => {
                let ends = args.iter().map(Draw::ends).collect::<Option<Vec<[f64; 2]>>>()?;
                let fold = |at: usize| numbers(function, &mut ends.iter().map(|ends| ends[at]));
                Draw::between(fold(0), fold(1))
            }
            _ => product(args, |values| {
                let list = values.iter().map(|value| value.as_number()).collect::<Option<Vec<f64>>>()?;
                Some(Value::number(match function {
                    Function::Abs => list.first()?.abs(),
                    _ => numbers(function, &mut list.into_iter()),
                }))
            }),
        }
    }

    fn pick(&self, parts: &[(Expr, Expr)]) -> Option<Draw> {
        let weights = parts.iter().map(|(weight, _)| self.weight(weight)).collect::<Option<Vec<f64>>>()?;
        let total: f64 = weights.iter().sum();
        let mut values = Vec::new();
        for ((_, value), weight) in parts.iter().zip(weights).filter(|(_, weight)| *weight > 0.0) {
            let drawn = self.draw(value)?.values().into_iter();
            values.extend(drawn.map(|(value, chance)| (value, chance * weight / total)));
        }
        Draw::one_of(values)
    }

    fn mix(&self, parts: &[(Expr, Expr)]) -> Option<Draw> {
        let weights = parts.iter().map(|(weight, _)| self.weight(weight)).collect::<Option<Vec<f64>>>()?;
        let things = parts.iter().map(|(_, thing)| self.draw(thing)).collect::<Option<Vec<Draw>>>()?;
        product(things, |things| {
            let things = things.iter().map(|thing| Some((**thing.as_thing()?).clone()));
            let parts = weights.iter().zip(things).map(|(weight, thing)| Some((Number(*weight), thing?)));
            Some(Value::Thing(Arc::new(Thing::Mix(parts.collect::<Option<_>>()?))))
        })
    }

    fn gradient(&self, axis: &Expr, blocks: &[Expr]) -> Option<Draw> {
        let axis: Axis = self.certain(axis)?.as_axis()?;
        let blocks = blocks.iter().map(|block| self.draw(block)).collect::<Option<Vec<Draw>>>()?;
        product(blocks, |blocks| {
            let blocks = blocks.iter().map(|block| Some((**block.as_thing()?).clone()));
            Some(Value::Thing(Arc::new(Thing::Gradient(axis, blocks.collect::<Option<_>>()?))))
        })
    }

    /// A weight; where it is drawn itself, its mean.
    pub fn weight(&self, expr: &Expr) -> Option<f64> {
        if let Expr::Number(number) = expr {
            return Some(number.0).filter(|weight| *weight >= 0.0);
        }
        let numbers = self.draw(expr)?.numbers()?;
        let mean: f64 = numbers.iter().map(|(number, chance)| number * chance).sum();
        (mean >= 0.0).then_some(mean)
    }
}

fn unary(op: UnaryOp, operand: Draw) -> Option<Draw> {
    match (op, operand) {
        (UnaryOp::Negate, Draw::Between(low, high)) => Some(Draw::Between(-high, -low)),
        (op, operand) => product(vec![operand], |values| {
            let number = values[0].as_number()?;
            Some(match op {
                UnaryOp::Negate => Value::number(-number),
                UnaryOp::Not => Value::truth(number == 0.0),
            })
        }),
    }
}

/// What comes of values that are drawn each for itself.
fn product(draws: Vec<Draw>, of: impl Fn(&[&Value]) -> Option<Value>) -> Option<Draw> {
    let draws: Vec<Vec<(Value, f64)>> = draws.into_iter().map(Draw::values).collect();
    let ways = draws.iter().try_fold(1, |ways: usize, draw| ways.checked_mul(draw.len()));
    let ways = ways.filter(|ways| *ways <= MOST_VALUES)?;
    let mut out = Vec::with_capacity(ways);
    for mut way in 0..ways {
        let (mut values, mut chance) = (Vec::with_capacity(draws.len()), 1.0);
        for draw in &draws {
            let (value, own) = &draw[way % draw.len()];
            way /= draw.len();
            values.push(value);
            chance *= own;
        }
        // A way that ends in an error is none.
        out.extend(of(&values).map(|value| (value, chance)));
    }
    Draw::one_of(out)
}

fn apply(op: BinaryOp, left: &Value, right: &Value) -> Option<Value> {
    match op {
        BinaryOp::Equal => return Some(Value::truth(left == right)),
        BinaryOp::NotEqual => return Some(Value::truth(left != right)),
        _ => {}
    }
    let (left, right) = (left.as_number()?, right.as_number()?);
    Some(match op {
        BinaryOp::And => Value::truth(left != 0.0 && right != 0.0),
        BinaryOp::Or => Value::truth(left != 0.0 || right != 0.0),
        BinaryOp::Less => Value::truth(left < right),
        BinaryOp::LessEqual => Value::truth(left <= right),
        BinaryOp::Greater => Value::truth(left > right),
        BinaryOp::GreaterEqual => Value::truth(left >= right),
        _ => Value::number(arithmetic(op, left, right)),
    })
}

fn arithmetic(op: BinaryOp, left: f64, right: f64) -> f64 {
    match op {
        BinaryOp::Add => left + right,
        BinaryOp::Subtract => left - right,
        BinaryOp::Multiply => left * right,
        BinaryOp::Divide => left / right,
        _ => left - right * (left / right).floor(),
    }
}

/// Whether numbers between two give numbers between two.
fn is_smooth(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide)
}

fn stretch(op: BinaryOp, left: [f64; 2], right: [f64; 2]) -> Option<Draw> {
    let corners = left.into_iter().flat_map(|left| right.map(|right| arithmetic(op, left, right)));
    let [low, high] =
        corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    Draw::between(low, high)
}

/// What a comparison of any numbers between two says.
fn compare(op: BinaryOp, left: [f64; 2], right: [f64; 2]) -> Option<Draw> {
    let (op, left, right) = match op {
        BinaryOp::Greater | BinaryOp::GreaterEqual => (op.mirrored(), right, left),
        op => (op, left, right),
    };
    let can_be = match op {
        BinaryOp::Equal | BinaryOp::NotEqual => left[0] <= right[1] && right[0] <= left[1],
        _ => left[0] < right[1],
    };
    let must_be = matches!(op, BinaryOp::Less | BinaryOp::LessEqual) && left[1] <= right[0];
    let truth = |is: bool| Some(Draw::Certain(Value::truth(is != (op == BinaryOp::NotEqual))));
    match (can_be, must_be) {
        (false, _) => truth(false),
        (true, true) => truth(true),
        (true, false) => Draw::one_of([(Value::truth(true), 0.5), (Value::truth(false), 0.5)]),
    }
}

fn numbers(function: Function, list: &mut dyn Iterator<Item = f64>) -> f64 {
    match function {
        Function::Min => list.fold(f64::INFINITY, f64::min),
        _ => list.fold(f64::NEG_INFINITY, f64::max),
    }
}

fn round(function: Function, number: f64) -> f64 {
    match function {
        Function::Floor => number.floor(),
        Function::Ceil => number.ceil(),
        _ => number.round(),
    }
}

/// The whole numbers that those between two are rounded to.
fn rounded(function: Function, low: f64, high: f64) -> Option<Draw> {
    let (first, last) = (round(function, low), round(function, high));
    if last - first > MOST_VALUES as f64 {
        return None;
    }
    let below = match function {
        Function::Floor => 0.0,
        Function::Ceil => 1.0,
        _ => 0.5,
    };
    let whole = (0..=(last - first) as usize).map(|step| first + step as f64);
    Draw::one_of(whole.map(|number| {
        let share = (number - below + 1.0).min(high) - (number - below).max(low);
        (Value::number(number), share / (high - low))
    }))
}

/// The whole numbers between two, whichever way round they are.
fn ranges(args: Vec<Draw>) -> Option<Draw> {
    let [from, to]: [Draw; 2] = args.try_into().ok()?;
    let mut values = Vec::new();
    for (from, from_chance) in from.numbers()? {
        for (to, to_chance) in to.clone().numbers()? {
            let (low, high) = (from.min(to).ceil(), from.max(to).floor());
            let count = high - low + 1.0;
            if count < 1.0 {
                return None;
            }
            if count + values.len() as f64 > MOST_VALUES as f64 {
                return Draw::between(low, high);
            }
            let chance = from_chance * to_chance / count;
            values.extend((0..count as usize).map(|step| (Value::number(low + step as f64), chance)));
        }
    }
    Draw::one_of(values)
}
