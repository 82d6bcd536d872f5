use crate::graph::{Number, Thing};
use crate::space::Axis;
use std::fmt;
use std::sync::Arc;

/// What an expression comes to. Unlike those of a run, values can be compared and kept.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Value {
    Number(Number),
    Axis(Axis),
    Thing(Arc<Thing>),
    /// Some number between two: a draw that was handed on before it was known.
    Between(Number, Number),
}

impl Value {
    pub fn number(value: f64) -> Value {
        Value::Number(Number(value + 0.0))
    }

    pub fn truth(truth: bool) -> Value {
        Value::number(f64::from(u8::from(truth)))
    }

    /// `None` for what is no number, and for one that is not finite: a run stops there.
    pub fn as_number(&self) -> Option<f64> {
        match self {
            Value::Number(number) if number.0.is_finite() => Some(number.0),
            _ => None,
        }
    }

    pub fn as_axis(&self) -> Option<Axis> {
        match self {
            Value::Axis(axis) => Some(*axis),
            _ => None,
        }
    }

    pub fn as_thing(&self) -> Option<&Arc<Thing>> {
        match self {
            Value::Thing(thing) => Some(thing),
            _ => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Number(number) => number.0.fmt(f),
            Value::Axis(axis) => axis.fmt(f),
            Value::Thing(thing) => f.write_str(thing.text()),
            Value::Between(low, high) => write!(f, "{}..{}", low.0, high.0),
        }
    }
}
