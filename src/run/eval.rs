use super::error::Kind;
use super::place::Place;
use crate::grammar::ast::{BinaryOp, Function, UnaryOp};
use crate::graph::{Expr, Thing};
use crate::space::{Axis, Scope};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

/// What an expression evaluates to. Conditions are numbers: zero is false, all else true.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value<'g> {
    Number(f64),
    Axis(Axis),
    Thing(&'g Thing),
}

impl Value<'_> {
    fn describe(self) -> String {
        match self {
            Value::Number(number) => format!("the number {number}"),
            Value::Axis(axis) => format!("the axis {axis}"),
            Value::Thing(thing) => format!("`{}`", thing.text()),
        }
    }
}

/// What the expressions of one operation can see, and the random stream of its place.
pub struct Env<'a, 'g> {
    pub constants: &'a [Value<'g>],
    pub params: &'a [Value<'g>],
    pub scope: Option<&'a Scope>,
    stream: Stream,
}

/// A stream that is set up at the first draw: most operations draw nothing.
enum Stream {
    At(Place),
    Open(Pcg64Mcg),
}

/// Errors are boxed: values are handed on far more often, and should travel in registers.
pub type Eval<T> = Result<T, Box<Kind>>;

impl<'a, 'g> Env<'a, 'g> {
    pub fn new(
        constants: &'a [Value<'g>],
        params: &'a [Value<'g>],
        scope: Option<&'a Scope>,
        place: Place,
    ) -> Self {
        Env { constants, params, scope, stream: Stream::At(place) }
    }

    pub fn number(&mut self, expr: &'g Expr) -> Eval<f64> {
        // The common case, without a detour.
        if let Expr::Number(number) = expr {
            return Ok(number.0);
        }
        match self.value(expr)? {
            Value::Number(number) if number.is_finite() => Ok(number),
            Value::Number(_) => Err(Box::new(Kind::NotANumber)),
            found => Err(Box::new(Kind::Type { expected: "a number", found: found.describe() })),
        }
    }

    pub fn axis(&mut self, expr: &'g Expr) -> Eval<Axis> {
        match self.value(expr)? {
            Value::Axis(axis) => Ok(axis),
            found => Err(Box::new(Kind::Type { expected: "an axis", found: found.describe() })),
        }
    }

    pub fn thing(&mut self, expr: &'g Expr) -> Eval<&'g Thing> {
        match self.value(expr)? {
            Value::Thing(thing) => Ok(thing),
            found => {
                Err(Box::new(Kind::Type { expected: "a block or a primitive", found: found.describe() }))
            }
        }
    }

    pub fn truth(&mut self, expr: &'g Expr) -> Eval<bool> {
        Ok(self.number(expr)? != 0.0)
    }

    pub fn value(&mut self, expr: &'g Expr) -> Eval<Value<'g>> {
        Ok(match expr {
            Expr::Number(number) => Value::Number(number.0),
            Expr::Axis(axis) => Value::Axis(*axis),
            Expr::Thing(thing) => Value::Thing(thing),
            Expr::Param(at) => self.params[*at],
            Expr::Constant(at) => self.constants[*at],
            Expr::ScopeSize(axis) => {
                Value::Number(self.scope.map_or(0.0, |scope| f64::from(scope.len(*axis))))
            }
            Expr::Unary(UnaryOp::Negate, operand) => Value::Number(-self.number(operand)?),
            Expr::Unary(UnaryOp::Not, operand) => truth(!self.truth(operand)?),
            Expr::Binary(op, left, right) => self.binary(*op, left, right)?,
            Expr::Call(function, args) => Value::Number(self.call(*function, args)?),
        })
    }

    fn binary(&mut self, op: BinaryOp, left: &'g Expr, right: &'g Expr) -> Eval<Value<'g>> {
        match op {
            BinaryOp::And => return Ok(truth(self.truth(left)? && self.truth(right)?)),
            BinaryOp::Or => return Ok(truth(self.truth(left)? || self.truth(right)?)),
            BinaryOp::Equal => return Ok(truth(self.value(left)? == self.value(right)?)),
            BinaryOp::NotEqual => return Ok(truth(self.value(left)? != self.value(right)?)),
            _ => {}
        }
        let (left, right) = (self.number(left)?, self.number(right)?);
        Ok(match op {
            BinaryOp::Less => truth(left < right),
            BinaryOp::LessEqual => truth(left <= right),
            BinaryOp::Greater => truth(left > right),
            BinaryOp::GreaterEqual => truth(left >= right),
            BinaryOp::Add => Value::Number(left + right),
            BinaryOp::Subtract => Value::Number(left - right),
            BinaryOp::Multiply => Value::Number(left * right),
            BinaryOp::Divide => Value::Number(left / right),
            // The sign of the divisor, so that `n % 2` alternates below zero as well.
            _ => Value::Number(left - right * (left / right).floor()),
        })
    }

    fn call(&mut self, function: Function, args: &'g [Expr]) -> Eval<f64> {
        let mut numbers = Vec::with_capacity(args.len());
        for arg in args {
            numbers.push(self.number(arg)?);
        }
        Ok(match (function, numbers.as_slice()) {
            (Function::Rand, &[low, high]) => low + (high - low) * self.draw(),
            (Function::Rand, _) => self.draw(),
            (Function::Randint, &[low, high]) => self.integer(low, high)?,
            (Function::Min, numbers) => numbers.iter().copied().fold(f64::INFINITY, f64::min),
            (Function::Max, numbers) => numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            (Function::Abs, &[number]) => number.abs(),
            (Function::Floor, &[number]) => number.floor(),
            (Function::Ceil, &[number]) => number.ceil(),
            (Function::Round, &[number]) => number.round(),
            _ => return Err(Box::new(Kind::NotANumber)),
        })
    }

    /// A number from 0 up to 1.
    pub fn draw(&mut self) -> f64 {
        self.stream().random()
    }

    /// A whole number from `low` to `high`, both included, whichever way round they are.
    fn integer(&mut self, low: f64, high: f64) -> Eval<f64> {
        const EXACT: f64 = 9e15;
        let (low, high) = (low.min(high).ceil(), low.max(high).floor());
        if low > high || low < -EXACT || high > EXACT {
            return Err(Box::new(Kind::NotANumber));
        }
        Ok(self.stream().random_range(low as i64..=high as i64) as f64)
    }

    fn stream(&mut self) -> &mut Pcg64Mcg {
        if let Stream::At(place) = self.stream {
            self.stream = Stream::Open(place.stream());
        }
        match &mut self.stream {
            Stream::Open(stream) => stream,
            Stream::At(_) => unreachable!("the stream was just opened"),
        }
    }
}

fn truth<'g>(truth: bool) -> Value<'g> {
    Value::Number(f64::from(u8::from(truth)))
}
