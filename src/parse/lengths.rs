//! What the parts of a split may measure.

use super::draw::{Draw, Sight};
use super::value::Value;
use crate::grammar::ast::SizeKind;
use crate::graph::{Expr, Size};
use crate::space::Length;

/// The lengths that a part may have, in blocks or as weights.
#[derive(Clone, Debug)]
pub enum Law {
    One(Length),
    /// Each with its chance.
    OneOf(Vec<(Length, f64)>),
    /// Any between two.
    Between {
        low: Length,
        high: Length,
    },
}

/// So many lengths stand for all between two, where they have to be named.
const SAMPLES: usize = 16;

/// Differences below this are noise of floating-point sums.
const NOISE: f64 = 1e-6;

/// The law of a size in a scope of that length; `None` where a run would stop with an error.
pub fn law(size: &Size, sight: &Sight<'_>, total: i32) -> Option<Law> {
    let of = |value: f64| match size.kind {
        SizeKind::Absolute => Length::Absolute(value),
        SizeKind::Floating => Length::Floating(value),
        SizeKind::Relative => Length::Absolute(value * f64::from(total)),
    };
    // The common case, without a detour.
    if let Expr::Number(number) = &size.value {
        return Some(Law::One(of(number.0)));
    }
    match sight.draw(&size.value)? {
        Draw::Certain(value) => Some(Law::One(of(value.as_number()?))),
        Draw::Between(low, high) => Some(Law::Between { low: of(low.max(0.0)), high: of(high.max(0.0)) }),
        Draw::OneOf(values) => {
            let value = |(value, chance): (Value, f64)| Some((of(value.as_number()?), chance));
            let all = values.into_iter().map(value).collect::<Option<Vec<(Length, f64)>>>()?;
            let fits = |length: &Length| match *length {
                Length::Absolute(size) => (-NOISE..f64::from(total) + 0.5).contains(&size),
                Length::Floating(weight) => weight >= -NOISE,
            };
            let all: Vec<(Length, f64)> = all.into_iter().filter(|(length, _)| fits(length)).collect();
            (!all.is_empty()).then_some(Law::OneOf(all))
        }
    }
}

impl Law {
    /// The length, if there is but one.
    pub fn certain(&self) -> Option<Length> {
        match self {
            Law::One(length) => Some(*length),
            _ => None,
        }
    }

    /// The lengths with their chances; of those between two some, evenly spread.
    pub fn samples(&self) -> Vec<(Length, f64)> {
        match self {
            Law::One(length) => vec![(*length, 1.0)],
            Law::OneOf(lengths) => lengths.clone(),
            Law::Between { low, high } => {
                let at = |sample: usize| (sample as f64 + 0.5) / SAMPLES as f64;
                (0..SAMPLES).map(|sample| (between(*low, *high, at(sample)), 1.0 / SAMPLES as f64)).collect()
            }
        }
    }

    /// The lengths in whole blocks, if it has no others.
    pub fn whole(&self) -> Option<Vec<(i32, f64)>> {
        let whole = |(length, chance): (Length, f64)| match length {
            Length::Absolute(size) if (size - size.round()).abs() < NOISE => {
                Some((size.round() as i32, chance))
            }
            _ => None,
        };
        match self {
            Law::One(length) => Some(vec![whole((*length, 1.0))?]),
            Law::OneOf(lengths) => lengths.iter().copied().map(whole).collect(),
            Law::Between { .. } => None,
        }
    }

    /// The least and the greatest length.
    pub fn ends(&self) -> Span {
        let value = |length: Length| match length {
            Length::Absolute(value) | Length::Floating(value) => value,
        };
        let (first, low, high) = match self {
            Law::One(length) => (*length, value(*length), value(*length)),
            Law::Between { low, high } => (*low, value(*low), value(*high)),
            Law::OneOf(lengths) => {
                let values = || lengths.iter().map(|(length, _)| value(*length));
                (lengths[0].0, values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max))
            }
        };
        Span { low, high, floats: matches!(first, Length::Floating(_)) }
    }
}

fn between(low: Length, high: Length, share: f64) -> Length {
    match (low, high) {
        (Length::Absolute(low), Length::Absolute(high)) => Length::Absolute(low + (high - low) * share),
        (Length::Floating(low), Length::Floating(high)) => Length::Floating(low + (high - low) * share),
        (low, _) => low,
    }
}

/// Lengths between two, in blocks or as weights.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    pub low: f64,
    pub high: f64,
    pub floats: bool,
}

/// A range of numbers, empty where it ends before it starts.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    pub low: f64,
    pub high: f64,
}

impl Range {
    fn narrow(&mut self, slope: f64, rest: f64) {
        // slope * t + rest <= 0
        match slope {
            slope if slope > 1e-12 => self.high = self.high.min(-rest / slope),
            slope if slope < -1e-12 => self.low = self.low.max(-rest / slope),
            _ if rest > NOISE => self.high = f64::NEG_INFINITY,
            _ => {}
        }
    }

    pub fn is_empty(&self) -> bool {
        self.low > self.high + NOISE
    }
}

/// Whether some lengths within the spans end where `ends` says when they are rounded to blocks. `ends` may stop
/// before the last part.
///
/// With `t` blocks to a weight each part is between two lengths that are linear in `t`, and each end lies within
/// half a block of its own place. Such a chain holds where all its stretches do, and these leave a range of `t`.
///
/// Absolute parts may run over by less than half a block; floating ones are then empty.
pub fn can_end(total: i32, spans: &[Span], ends: &[i32]) -> bool {
    let pressed = |span: &Span| if span.floats { Span { low: 0.0, high: 0.0, floats: false } } else { *span };
    !scale(total, spans, ends).is_empty()
        || (spans.iter().any(|span| span.floats)
            && !scale(total, &spans.iter().map(pressed).collect::<Vec<_>>(), ends).is_empty())
}

/// The blocks to a weight with which lengths within the spans end where `ends` says.
pub fn scale(total: i32, spans: &[Span], ends: &[i32]) -> Range {
    let floats = spans.iter().any(|span| span.floats);
    let last = spans.len();
    // A scope that is missed by less than half a block is missed at both ends alike.
    let slack = if floats { 0.0 } else { 0.25 };
    let window = |at: usize| match at {
        0 => (-slack, slack),
        at if at == last => (f64::from(total) - slack, f64::from(total) + slack),
        at => (f64::from(ends[at]) - 0.5, f64::from(ends[at]) + 0.5),
    };
    let mut range = Range { low: 0.0, high: f64::INFINITY };
    let known: Vec<usize> = (0..ends.len()).chain((ends.len()..=last).filter(|at| *at == last)).collect();
    for (place, &from) in known.iter().enumerate() {
        for &to in &known[place + 1..] {
            let part = |pick: fn(&Span) -> f64, floats: bool| -> f64 {
                spans[from..to].iter().filter(|span| span.floats == floats).map(pick).sum()
            };
            let (least, most) = (window(to).0 - window(from).1, window(to).1 - window(from).0);
            range.narrow(part(|span| span.low, true), part(|span| span.low, false) - most);
            range.narrow(-part(|span| span.high, true), least - part(|span| span.high, false));
            if range.is_empty() {
                return range;
            }
        }
    }
    range
}
