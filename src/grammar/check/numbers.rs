//! The numbers that an expression may have, as far as can be known without a run.

use crate::grammar::ast::{BinaryOp, Function};

/// A set that holds every number that can occur, and maybe more.
#[derive(Clone, PartialEq, Debug)]
pub enum Numbers {
    /// One of these, rising.
    Few(Vec<f64>),
    /// Any number from `low` to `high`, or any whole one.
    Between { low: f64, high: f64, whole: bool },
}

/// More numbers than this are kept as the interval that they lie in.
const MOST: usize = 16;

impl Numbers {
    pub const NONE: Numbers = Numbers::Few(Vec::new());
    pub const ANY: Numbers = Numbers::Between { low: f64::NEG_INFINITY, high: f64::INFINITY, whole: false };

    pub fn one(number: f64) -> Numbers {
        Numbers::few([number])
    }

    /// All of these; what has no value can become anything.
    pub fn few(numbers: impl IntoIterator<Item = f64>) -> Numbers {
        let mut few: Vec<f64> = numbers.into_iter().collect();
        if few.iter().any(|number| !number.is_finite()) {
            return Numbers::ANY;
        }
        few.sort_by(f64::total_cmp);
        few.dedup();
        let numbers = Numbers::Few(few);
        match &numbers {
            Numbers::Few(few) if few.len() > MOST => numbers.hull(),
            _ => numbers,
        }
    }

    pub fn between(low: f64, high: f64) -> Numbers {
        Numbers::Between { low, high, whole: false }.tidy()
    }

    /// The whole numbers from `low` to `high`.
    pub fn whole(low: f64, high: f64) -> Numbers {
        Numbers::Between { low: low.ceil(), high: high.floor(), whole: true }.tidy()
    }

    fn tidy(self) -> Numbers {
        match self {
            Numbers::Between { low, high, .. } if low.is_nan() || high.is_nan() => Numbers::ANY,
            Numbers::Between { low, high, .. } if low > high => Numbers::NONE,
            Numbers::Between { low, high, .. } if low == high => Numbers::one(low),
            Numbers::Between { low, high, whole: true } if high - low < MOST as f64 => {
                Numbers::few((0..=(high - low) as u32).map(|step| low + f64::from(step)))
            }
            numbers => numbers,
        }
    }

    fn hull(&self) -> Numbers {
        Numbers::Between { low: self.low(), high: self.high(), whole: self.is_whole() }
    }

    pub fn is_none(&self) -> bool {
        *self == Numbers::NONE
    }

    /// The least number; infinity where there is none.
    pub fn low(&self) -> f64 {
        match self {
            Numbers::Few(few) => few.first().copied().unwrap_or(f64::INFINITY),
            Numbers::Between { low, .. } => *low,
        }
    }

    pub fn high(&self) -> f64 {
        match self {
            Numbers::Few(few) => few.last().copied().unwrap_or(f64::NEG_INFINITY),
            Numbers::Between { high, .. } => *high,
        }
    }

    pub fn is_whole(&self) -> bool {
        match self {
            Numbers::Few(few) => few.iter().all(|number| number.fract() == 0.0),
            Numbers::Between { whole, .. } => *whole,
        }
    }

    /// Whether some number lies from `low` to `high`, or between them where `is_open`.
    pub fn meets(&self, low: f64, high: f64, is_open: bool) -> bool {
        let inside = |number: f64| {
            if is_open { low < number && number < high } else { low <= number && number <= high }
        };
        match self {
            Numbers::Few(few) => few.iter().copied().any(inside),
            Numbers::Between { low: least, high: most, whole } => {
                let (from, to) = (low.max(*least), high.min(*most));
                match whole {
                    true => {
                        let first = if is_open && from.fract() == 0.0 && from == low {
                            from + 1.0
                        } else {
                            from.ceil()
                        };
                        first <= *most && inside(first)
                    }
                    false => {
                        if is_open {
                            from < to
                        } else {
                            from <= to
                        }
                    }
                }
            }
        }
    }

    pub fn join(&self, other: &Numbers) -> Numbers {
        match (self, other) {
            (Numbers::Few(a), Numbers::Few(b)) => Numbers::few(a.iter().chain(b).copied()),
            (none, some) | (some, none) if none.is_none() => some.clone(),
            (a, b) => Numbers::Between {
                low: a.low().min(b.low()),
                high: a.high().max(b.high()),
                whole: a.is_whole() && b.is_whole(),
            },
        }
    }

    /// As [`Numbers::join`], but a bound that still moves goes as far as it can: so that a ring of rules comes to rest.
    pub fn widened(&self, other: &Numbers) -> Numbers {
        let joined = self.join(other);
        if joined == *self || self.is_none() {
            return joined;
        }
        let low = if joined.low() < self.low() { f64::NEG_INFINITY } else { joined.low() };
        let high = if joined.high() > self.high() { f64::INFINITY } else { joined.high() };
        Numbers::Between { low, high, whole: joined.is_whole() }
    }

    /// Those from `low` to `high`.
    pub fn clamped(&self, low: f64, high: f64) -> Numbers {
        match self {
            Numbers::Few(few) => {
                Numbers::few(few.iter().copied().filter(|number| low <= *number && *number <= high))
            }
            Numbers::Between { low: least, high: most, whole } => {
                let (low, high) = (least.max(low), most.min(high));
                match whole {
                    true => Numbers::whole(low, high),
                    false => Numbers::between(low, high),
                }
            }
        }
    }

    /// What becomes of the numbers where a function never falls.
    pub fn rising(&self, function: impl Fn(f64) -> f64, whole: bool) -> Numbers {
        match self {
            Numbers::Few(few) => Numbers::few(few.iter().copied().map(function)),
            Numbers::Between { low, high, .. } => {
                Numbers::Between { low: function(*low), high: function(*high), whole }.tidy()
            }
        }
    }

    /// What an operator makes of any number of one set and any of another.
    pub fn binary(op: BinaryOp, left: &Numbers, right: &Numbers) -> Numbers {
        if let (Numbers::Few(a), Numbers::Few(b)) = (left, right) {
            return Numbers::few(a.iter().flat_map(|a| b.iter().map(|b| applied(op, *a, *b))));
        }
        let whole = left.is_whole() && right.is_whole();
        let corners = |op| {
            let ends = |numbers: &Numbers| [numbers.low(), numbers.high()];
            let all = ends(left).into_iter().flat_map(|a| ends(right).map(|b| applied(op, a, b)));
            let all: Vec<f64> = all.collect();
            match all.iter().any(|number| number.is_nan()) {
                true => Numbers::ANY,
                false => Numbers::Between {
                    low: all.iter().copied().fold(f64::INFINITY, f64::min),
                    high: all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                    whole: whole && op != BinaryOp::Divide,
                }
                .tidy(),
            }
        };
        match op {
            BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply => corners(op),
            BinaryOp::Divide if right.low() > 0.0 || right.high() < 0.0 => corners(op),
            BinaryOp::Divide => Numbers::ANY,
            BinaryOp::Remainder => remainder(right, whole),
            _ => Numbers::few([0.0, 1.0]),
        }
    }

    /// What a function makes of its arguments.
    pub fn call(function: Function, args: &[Numbers]) -> Numbers {
        match (function, args) {
            (Function::Rand, []) => Numbers::between(0.0, 1.0),
            (Function::Rand, [a, b]) => Numbers::between(a.low().min(b.low()), a.high().max(b.high())),
            (Function::Triangular, [a, _, b]) => {
                Numbers::between(a.low().min(b.low()), a.high().max(b.high()))
            }
            (Function::Randint, [a, b]) => Numbers::whole(a.low().min(b.low()), a.high().max(b.high())),
            (Function::Floor, [a]) => a.rising(f64::floor, true),
            (Function::Ceil, [a]) => a.rising(f64::ceil, true),
            (Function::Round, [a]) => a.rising(f64::round, true),
            (Function::Abs, [Numbers::Few(few)]) => Numbers::few(few.iter().copied().map(f64::abs)),
            (Function::Abs, [a]) => {
                let high = a.high().abs().max(a.low().abs());
                let low = if a.low() > 0.0 { a.low() } else { (-a.high()).max(0.0) };
                Numbers::Between { low, high, whole: a.is_whole() }
            }
            (Function::Min, args) => extreme(args, f64::min),
            (Function::Max, args) => extreme(args, f64::max),
            _ => Numbers::ANY,
        }
    }
}

fn extreme(args: &[Numbers], of: fn(f64, f64) -> f64) -> Numbers {
    let two = |a: Numbers, b: &Numbers| match (&a, b) {
        (Numbers::Few(a), Numbers::Few(b)) => {
            Numbers::few(a.iter().flat_map(|a| b.iter().map(|b| of(*a, *b))))
        }
        (a, b) => {
            let whole = a.is_whole() && b.is_whole();
            Numbers::Between { low: of(a.low(), b.low()), high: of(a.high(), b.high()), whole }.tidy()
        }
    };
    match args {
        [first, rest @ ..] => rest.iter().fold(first.clone(), two),
        [] => Numbers::ANY,
    }
}

fn remainder(divisor: &Numbers, whole: bool) -> Numbers {
    match divisor.low() > 0.0 {
        true if whole => Numbers::whole(0.0, divisor.high() - 1.0),
        true => Numbers::between(0.0, divisor.high()),
        false => Numbers::ANY,
    }
}

/// The value of an operator, as a run has it.
pub fn applied(op: BinaryOp, left: f64, right: f64) -> f64 {
    let truth = |truth: bool| f64::from(u8::from(truth));
    match op {
        BinaryOp::Or => truth(left != 0.0 || right != 0.0),
        BinaryOp::And => truth(left != 0.0 && right != 0.0),
        BinaryOp::Equal => truth(left == right),
        BinaryOp::NotEqual => truth(left != right),
        BinaryOp::Less => truth(left < right),
        BinaryOp::LessEqual => truth(left <= right),
        BinaryOp::Greater => truth(left > right),
        BinaryOp::GreaterEqual => truth(left >= right),
        BinaryOp::Add => left + right,
        BinaryOp::Subtract => left - right,
        BinaryOp::Multiply => left * right,
        BinaryOp::Divide => left / right,
        BinaryOp::Remainder => left - right * (left / right).floor(),
    }
}
