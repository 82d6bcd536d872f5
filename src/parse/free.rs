//! Splits with drawn sizes: whole sizes fix the ends of parts from the start and from the end of the scope on, what
//! lies between shares the rest.

use super::chart::Found;
use super::cost::Cost;
use super::lengths::{Law, Span, can_end, scale};
use super::search::Search;
use super::split::{Laid, Row};
use crate::graph::NodeIndex;
use crate::space::{Length, fit};
use std::collections::BTreeMap;

/// The cheapest ways to reach each place, with the place before it.
type Reached = BTreeMap<i32, (Cost, i32)>;

/// More ways than this to draw the sizes in the middle are not tried.
const MOST_WAYS: usize = 1 << 12;

/// The parts of a split whose sizes are drawn.
#[derive(Clone, Copy)]
struct Parts<'p> {
    row: Row<'p>,
    laws: &'p [Law],
    children: &'p [NodeIndex],
}

impl Parts<'_> {
    fn laid(&self, at: usize, low: i32, high: i32) -> Laid {
        Laid { child: self.children[at], low, high, number: at as u32 }
    }
}

impl Search<'_, '_> {
    pub fn free(&mut self, row: Row<'_>, laws: &[Law], children: &[NodeIndex]) -> Option<Found> {
        let parts = Parts { row, laws, children };
        let whole: Vec<Option<Vec<(i32, f64)>>> = laws.iter().map(Law::whole).collect();
        let first = whole.iter().position(Option::is_none).unwrap_or(laws.len());
        let last = whole.iter().rposition(Option::is_none).map_or(first, |last| last + 1);
        let before = self.forward(parts, &whole[..first]);
        if first == laws.len() {
            let ends = walked(&before, row.total())?;
            return self.laid_out(parts, &ends);
        }
        let behind = self.backward(parts, &whole, last);
        let mut best = None;
        for (&start, (start_cost, _)) in before.last()? {
            for (&end, (end_cost, _)) in behind.last()?.range(start..) {
                let cost = start_cost.plus(*end_cost);
                let is_better =
                    |best: &Option<(Cost, Vec<i32>)>| best.as_ref().is_none_or(|best| cost.is_less(best.0));
                if is_better(&best) {
                    let outer = Outer { start, end, before: first, behind: laws.len() - last };
                    let found = self.middle(parts, outer);
                    best = cheaper(
                        best,
                        found.map(|(own, ends)| {
                            let head = walked(&before, start).unwrap_or_default();
                            let tail = walked(&behind, end).unwrap_or_default();
                            let ends = head.into_iter().chain(ends).chain(tail.into_iter().rev()).collect();
                            (cost.plus(own), ends)
                        }),
                    );
                }
            }
        }
        let (_, ends) = best?;
        self.laid_out(parts, &ends)
    }

    /// The parts in their places, with what their sizes cost.
    fn laid_out(&mut self, parts: Parts<'_>, ends: &[i32]) -> Option<Found> {
        let laid: Vec<Laid> =
            ends.windows(2).enumerate().map(|(at, ends)| parts.laid(at, ends[0], ends[1])).collect();
        let cost = drawn(parts.row, parts.laws, ends);
        self.row(parts.row, &laid, cost)
    }

    /// Where each of the first parts may end, and the cheapest way there.
    fn forward(&mut self, parts: Parts<'_>, whole: &[Option<Vec<(i32, f64)>>]) -> Vec<Reached> {
        let mut tables = vec![Reached::from([(0, (Cost::NONE, 0))])];
        for (at, lengths) in whole.iter().enumerate() {
            let mut next = Reached::new();
            for (&low, &(cost, _)) in &tables[at] {
                for &(length, chance) in lengths.iter().flatten() {
                    let high = low + length;
                    if high <= parts.row.total() {
                        self.reach(
                            parts,
                            parts.laid(at, low, high),
                            cost.plus(Cost::of_chance(chance)),
                            (high, low),
                            &mut next,
                        );
                    }
                }
            }
            tables.push(next);
        }
        tables
    }

    /// Where each of the last parts may start, from the last one on.
    fn backward(
        &mut self,
        parts: Parts<'_>,
        whole: &[Option<Vec<(i32, f64)>>],
        first: usize,
    ) -> Vec<Reached> {
        let mut tables = vec![Reached::from([(parts.row.total(), (Cost::NONE, 0))])];
        for at in (first..whole.len()).rev() {
            let mut next = Reached::new();
            for (&high, &(cost, _)) in tables.last().into_iter().flatten() {
                for &(length, chance) in whole[at].iter().flatten() {
                    let low = high - length;
                    if low >= 0 {
                        self.reach(
                            parts,
                            parts.laid(at, low, high),
                            cost.plus(Cost::of_chance(chance)),
                            (low, high),
                            &mut next,
                        );
                    }
                }
            }
            tables.push(next);
        }
        tables
    }

    /// Enters a place that a part leads to, if the part holds and nothing cheaper leads there.
    fn reach(
        &mut self,
        parts: Parts<'_>,
        part: Laid,
        cost: Cost,
        (place, from): (i32, i32),
        next: &mut Reached,
    ) {
        if next.get(&place).is_some_and(|(known, _)| !cost.is_less(*known)) {
            return;
        }
        if let Some(own) = self.part(parts.row, &part, parts.laws.len() as u32) {
            let cost = cost.plus(own);
            if next.get(&place).is_none_or(|(known, _)| cost.is_less(*known)) {
                next.insert(place, (cost, from));
            }
        }
    }

    /// The cheapest ends of the parts in the middle, without those at its sides.
    fn middle(&mut self, parts: Parts<'_>, outer: Outer) -> Option<(Cost, Vec<i32>)> {
        let inner = &parts.laws[outer.before..parts.laws.len() - outer.behind];
        let lists: Vec<Vec<(Law, f64)>> = inner.iter().map(alternatives).collect();
        let ways = lists.iter().try_fold(1, |ways: usize, list| ways.checked_mul(list.len()));
        let mut best = None;
        for mut way in 0..ways.filter(|ways| *ways <= MOST_WAYS)? {
            let mut chance = 1.0;
            let chosen = lists.iter().map(|list| {
                let (law, own) = &list[way % list.len()];
                way /= list.len();
                chance *= own;
                law.clone()
            });
            let chosen: Vec<Law> = chosen.collect();
            let found = match chosen.iter().map(Law::certain).collect::<Option<Vec<Length>>>() {
                Some(lengths) => self.settled(parts, outer, &lengths),
                None => self.stretched(parts, outer, &chosen),
            };
            best = cheaper(best, found.map(|(cost, ends)| (cost.plus(Cost::of_chance(chance)), ends)));
        }
        best
    }

    /// The ends of a middle of known lengths.
    fn settled(&mut self, parts: Parts<'_>, outer: Outer, lengths: &[Length]) -> Option<(Cost, Vec<i32>)> {
        let ends = fit(parts.row.total(), &outer.around(parts.row.total(), lengths)).ok()?;
        let ends = &ends[outer.before..ends.len() - outer.behind];
        if ends.first() != Some(&outer.start) || ends.last() != Some(&outer.end) {
            return None;
        }
        let count = parts.laws.len() as u32;
        let mut cost = Cost::NONE;
        for (at, pair) in ends.windows(2).enumerate() {
            cost =
                cost.plus(self.part(parts.row, &parts.laid(outer.before + at, pair[0], pair[1]), count)?);
        }
        Some((cost, ends[1..ends.len() - 1].to_vec()))
    }

    /// The cheapest ends of a middle whose lengths may be any between two: part by part, as far as they can be.
    fn stretched(&mut self, parts: Parts<'_>, outer: Outer, laws: &[Law]) -> Option<(Cost, Vec<i32>)> {
        let whole = |length: i32| Span { low: f64::from(length), high: f64::from(length), floats: false };
        let tail = (outer.behind > 0).then(|| whole(parts.row.total() - outer.end));
        let inner = laws.iter().map(Law::ends);
        let spans: Vec<Span> = std::iter::once(whole(outer.start)).chain(inner).chain(tail).collect();
        let mut open = Stretch { parts, outer, spans: &spans, count: laws.len(), best: None };
        let mut ends = vec![0, outer.start];
        self.stretch(&mut open, &mut ends, Cost::NONE);
        let (cost, ends) = open.best?;
        let cost = cost.plus(Cost::of_bits(looseness(parts.row.total(), &spans, laws)));
        Some((cost, ends[2..ends.len() - 1].to_vec()))
    }

    fn stretch(&mut self, open: &mut Stretch<'_>, ends: &mut Vec<i32>, cost: Cost) {
        let at = ends.len() - 2;
        let total = open.parts.row.total();
        if at == open.count {
            open.best = cheaper(open.best.take(), Some((cost, ends.clone())));
            return;
        }
        let low = ends[ends.len() - 1];
        let highs = if at + 1 == open.count { open.outer.end..=open.outer.end } else { low..=open.outer.end };
        for high in highs {
            ends.push(high);
            if self.steps > 0 && can_end(total, open.spans, ends) {
                self.steps -= 1;
                let laid = open.parts.laid(open.outer.before + at, low, high);
                if let Some(own) = self.part(open.parts.row, &laid, open.parts.laws.len() as u32) {
                    let cost = cost.plus(own);
                    if open.best.as_ref().is_none_or(|(best, _)| cost.is_less(*best)) {
                        self.stretch(open, ends, cost);
                    }
                }
            }
            ends.pop();
        }
    }
}

/// A middle whose parts are laid one after the other.
struct Stretch<'p> {
    parts: Parts<'p>,
    outer: Outer,
    /// With all before and all behind the middle as one part each.
    spans: &'p [Span],
    count: usize,
    best: Option<(Cost, Vec<i32>)>,
}

/// What lies at the sides of a middle: where it starts and ends, and how many parts there are.
#[derive(Clone, Copy)]
struct Outer {
    start: i32,
    end: i32,
    before: usize,
    behind: usize,
}

impl Outer {
    /// All lengths of a split, with those before the middle and behind it as one long part and empty ones: their
    /// ends do not matter, but their number may.
    fn around(&self, total: i32, lengths: &[Length]) -> Vec<Length> {
        let side = |length: i32, count: usize| {
            let empty = std::iter::repeat_n(Length::Absolute(0.0), count.saturating_sub(1));
            (count > 0).then_some(Length::Absolute(f64::from(length))).into_iter().chain(empty)
        };
        let before = side(self.start, self.before);
        before.chain(lengths.iter().copied()).chain(side(total - self.end, self.behind)).collect()
    }
}

fn cheaper(best: Option<(Cost, Vec<i32>)>, found: Option<(Cost, Vec<i32>)>) -> Option<(Cost, Vec<i32>)> {
    match (best, found) {
        (Some(best), Some(found)) if found.0.is_less(best.0) => Some(found),
        (best, found) => best.or(found),
    }
}

/// A law that is drawn as its choices; any between two stay one.
fn alternatives(law: &Law) -> Vec<(Law, f64)> {
    match law {
        Law::OneOf(lengths) => lengths.iter().map(|(length, chance)| (Law::One(*length), *chance)).collect(),
        law => vec![(law.clone(), 1.0)],
    }
}

/// The places on the way to one, from the first table on.
fn walked(tables: &[Reached], place: i32) -> Option<Vec<i32>> {
    let mut places = vec![place];
    for table in tables[1..].iter().rev() {
        places.push(table.get(&places[places.len() - 1])?.1);
    }
    tables[0].get(&places[places.len() - 1])?;
    places.reverse();
    Some(places)
}

/// What the drawn sizes of a split cost that ends so.
pub fn drawn(row: Row<'_>, laws: &[Law], ends: &[i32]) -> Cost {
    let lengths = ends.windows(2).map(|pair| pair[1] - pair[0]);
    let bits = |(law, length): (&Law, i32)| match law.whole() {
        Some(whole) => whole.iter().filter(|(own, _)| *own == length).map(|(_, chance)| -chance.log2()).sum(),
        None => 0.0,
    };
    let spans: Vec<Span> = laws.iter().map(Law::ends).collect();
    let loose = looseness(row.total(), &spans, laws);
    Cost::of_bits(laws.iter().zip(lengths).map(bits).sum::<f64>() + loose)
}

/// What it takes to say lengths between two: one of the whole ones that they may come to.
fn looseness(total: i32, spans: &[Span], laws: &[Law]) -> f64 {
    let scale = scale(total, spans, &[0]);
    let blocks = |law: &Law| match law {
        Law::Between { .. } => {
            let Span { low, high, floats } = law.ends();
            let [low, high] = if floats { [low * scale.low, high * scale.high] } else { [low, high] };
            (high.round().min(f64::from(total)) - low.round() + 1.0).max(1.0).log2()
        }
        _ => 0.0,
    };
    laws.iter().map(blocks).sum()
}
