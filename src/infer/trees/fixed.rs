//! Rows of known order: how long their parts are.

use super::bounds::Need;
use super::draw::{Draw, number};
use super::row::Row;
use super::sketch::{Sketch, split};
use crate::graph::{Expr, Size};
use crate::infer::joint::laws::{Law, Part, Seen, Stretch, fitted};
use crate::space::Axis;
use std::collections::BTreeMap;

/// A row as it is written.
#[derive(Debug)]
pub struct Fixed {
    pub sketch: Sketch,
    /// The shortest scope that it fits, in cells.
    pub need: i32,
}

/// Parts that are there in some row, with their lengths in each.
struct Parts {
    sketches: Vec<Sketch>,
    seen: Vec<Seen>,
}

/// How a row is written that is `least` cells long at least.
pub fn fixed(axis: Axis, rows: &[Row], children: &[Sketch], least: i32, need: Need) -> Fixed {
    let parts = Parts::of(rows, children);
    let mut laws = fitted(&parts.seen, &parts.known());
    if !laws.iter().any(|law| matches!(law, Law::Float(_))) {
        let longest = (0..laws.len()).max_by_key(|at| (parts.is_full(*at), parts.seen[0].0[*at]));
        laws[longest.unwrap_or(0)] = Law::Float(1);
    }
    Plan { axis, parts: &parts, laws, need }.written(least)
}

/// The shares of a row that fits any scope.
pub fn elastic(axis: Axis, rows: &[Row], children: &[Sketch]) -> Sketch {
    let parts = Parts::of(rows, children);
    let total: u32 = parts.seen.iter().map(|(_, count)| count).sum();
    let share = |at: usize| {
        let sum: f64 =
            parts.seen.iter().map(|(lengths, count)| f64::from(lengths[at]) * f64::from(*count)).sum();
        Size::floating((sum / f64::from(total)).round().max(1.0))
    };
    split(axis, parts.sketches.iter().cloned().enumerate().map(|(at, sketch)| (share(at), sketch)).collect())
}

impl Parts {
    fn of(rows: &[Row], children: &[Sketch]) -> Parts {
        let mut counts: BTreeMap<Vec<i32>, u32> = BTreeMap::new();
        rows.iter().for_each(|row| *counts.entry(row.lengths()).or_default() += 1);
        let pairs = children.iter().flat_map(|child| [child.clone(), Sketch::Nil]);
        let sketches: Vec<Sketch> = std::iter::once(Sketch::Nil).chain(pairs).collect();
        let there: Vec<usize> =
            (0..sketches.len()).filter(|at| counts.keys().any(|lengths| lengths[*at] > 0)).collect();
        let kept = |lengths: &Vec<i32>| there.iter().map(|at| lengths[*at]).collect();
        Parts {
            sketches: there.iter().map(|at| sketches[*at].clone()).collect(),
            seen: counts.iter().map(|(lengths, count)| (kept(lengths), *count)).collect(),
        }
    }

    fn is_full(&self, at: usize) -> bool {
        !matches!(self.sketches[at], Sketch::Nil)
    }

    /// What the laws go by, of each.
    fn known(&self) -> Vec<Part> {
        let stretch = |sketch: &Sketch| match sketch {
            Sketch::Nil | Sketch::Leaf(_) => Stretch::Alike,
            _ => Stretch::Bends,
        };
        let look = |sketch: &Sketch| self.sketches.iter().take_while(|own| *own != sketch).count() as u32;
        self.sketches.iter().map(|sketch| Part { stretch: stretch(sketch), look: look(sketch) }).collect()
    }

    fn least(&self, at: usize) -> i32 {
        self.seen.iter().map(|(lengths, _)| lengths[at]).min().unwrap_or(0)
    }
}

/// A row with the laws of its parts.
struct Plan<'p> {
    axis: Axis,
    parts: &'p Parts,
    laws: Vec<Law>,
    need: Need,
}

impl Plan<'_> {
    /// What a part has to be left with, in cells.
    fn floor(&self, at: usize) -> i32 {
        match (&self.laws[at], &self.parts.sketches[at]) {
            (Law::Const(len), _) => *len,
            (_, Sketch::Nil) => 0,
            (_, Sketch::Leaf(_)) => 1,
            _ if self.need == Need::Bare => 1,
            _ => self.parts.least(at),
        }
    }

    fn written(mut self, least: i32) -> Fixed {
        let need: i32 = (0..self.laws.len()).map(|at| self.floor(at)).sum();
        let most: i32 = (0..self.laws.len()).map(|at| self.most(at)).sum();
        let drawn: Vec<usize> = (0..self.laws.len()).filter(|at| self.laws[*at].is_drawn()).collect();
        let is_safe = most <= least.max(need);
        let sketch = match (is_safe, drawn.as_slice()) {
            (true, _) | (false, [] | [_]) => self.flat(if is_safe { None } else { Some(need) }),
            _ => {
                self.untie();
                self.nested(0..self.laws.len())
            }
        };
        Fixed { sketch, need }
    }

    /// The greatest length of a part, of those that float the least.
    fn most(&self, at: usize) -> i32 {
        match &self.laws[at] {
            Law::Float(_) => self.floor(at),
            Law::Same(other) => self.most(*other),
            law => law.lengths().max().unwrap_or(0),
        }
    }

    /// All parts in one split; where they may overrun the scope, what is drawn leaves what the others need.
    fn flat(&self, need: Option<i32>) -> Sketch {
        let copies = |at: usize| self.laws.iter().filter(|law| **law == Law::Same(at)).count() as i32;
        let drawn = |at: usize| {
            let draw = Draw::by(&self.laws[at]);
            let count = 1 + copies(at);
            match need {
                Some(need) => {
                    let rest = need - count * self.floor(at);
                    draw.within_several(self.axis, rest, count)
                }
                None => draw,
            }
        };
        let tied: Vec<usize> = (0..self.laws.len()).filter(|at| copies(*at) > 0).collect();
        let size = |at: usize| {
            let owner = if let Law::Same(owner) = &self.laws[at] { *owner } else { at };
            match (&self.laws[at], tied.iter().position(|own| *own == owner)) {
                (_, Some(param)) => Size::absolute(Expr::Param(param)),
                (law, None) => size_of(law, || drawn(at).expr),
            }
        };
        let parts = self.parts.sketches.iter().enumerate().map(|(at, sketch)| (size(at), sketch.clone()));
        let row = split(self.axis, parts.collect());
        match tied.is_empty() {
            true => row,
            false => Sketch::Call(tied.iter().map(|at| drawn(*at).expr).collect(), Box::new(row)),
        }
    }

    /// Parts that are as long as others are drawn by themselves.
    fn untie(&mut self) {
        for at in 0..self.laws.len() {
            if let Law::Same(owner) = self.laws[at] {
                self.laws[at] = self.laws[owner].clone();
            }
        }
    }

    /// One drawn part after the other, from both ends inwards, so that each leaves what the rest needs.
    fn nested(&self, range: std::ops::Range<usize>) -> Sketch {
        let drawn = || range.clone().filter(|at| self.laws[*at].is_drawn());
        let floating =
            range.clone().find(|at| matches!(self.laws[*at], Law::Float(_))).unwrap_or(range.start);
        let need = |range: std::ops::Range<usize>| range.map(|at| self.floor(at)).sum::<i32>();
        let (Some(first), Some(last)) = (drawn().next(), drawn().next_back()) else {
            return self.part_of(range.clone(), None);
        };
        if drawn().count() == 1 {
            return self.part_of(range.clone(), Some((first, need(range) - self.floor(first))));
        }
        let (outer, inner, is_before) = match first < floating {
            true => (range.start..first + 1, first + 1..range.end, true),
            false => (last..range.end, range.start..last, false),
        };
        let drawn_at = if is_before { first } else { last };
        let rest = need(range.clone()) - self.floor(drawn_at);
        let mut parts = self.sized(outer, Some((drawn_at, rest)));
        let inner = (Size::floating(1.0), self.nested(inner));
        match is_before {
            true => parts.push(inner),
            false => parts.insert(0, inner),
        }
        split(self.axis, parts)
    }

    fn part_of(&self, range: std::ops::Range<usize>, limited: Option<(usize, i32)>) -> Sketch {
        split(self.axis, self.sized(range, limited))
    }

    fn sized(&self, range: std::ops::Range<usize>, limited: Option<(usize, i32)>) -> Vec<(Size, Sketch)> {
        let size = |at: usize| {
            size_of(&self.laws[at], || {
                let draw = Draw::by(&self.laws[at]);
                match limited.filter(|(own, _)| *own == at) {
                    Some((_, rest)) => draw.within(self.axis, rest).expr,
                    None => draw.expr,
                }
            })
        };
        range.map(|at| (size(at), self.parts.sketches[at].clone())).collect()
    }
}

fn size_of(law: &Law, drawn: impl Fn() -> Expr) -> Size {
    match law {
        Law::Float(weight) => Size::floating(f64::from(*weight)),
        Law::Const(len) => Size::absolute(number(*len)),
        _ => Size::absolute(drawn()),
    }
}
