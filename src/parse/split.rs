//! Splits and repeats: where their parts may end, and the cheapest of these ways.

use super::Laws;
use super::chart::{Backdrop, Choice, Found, Piece, Rigour};
use super::cost::Cost;
use super::draw::Draw;
use super::lengths::{Law, law};
use super::search::{Search, keep};
use super::surroundings::Around;
use super::target::{Planes, Target};
use super::widened::STRETCHED;
use crate::graph::{Arg, Expr, Group, NodeIndex};
use crate::run::written_out;
use crate::space::{Axis, Length, Scope, fit, shares};
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The parts of one split, which are few.
type Few<T> = SmallVec<[T; 8]>;

/// A part of a split that is laid out: from where to where it reaches.
#[derive(Clone, Copy, Debug)]
pub struct Laid {
    pub child: NodeIndex,
    pub low: i32,
    pub high: i32,
    /// Its number among all, those without a block included.
    pub number: u32,
}

/// What the parts of a split may measure in a scope of one size.
#[derive(Debug)]
pub struct Written {
    laws: Few<Law>,
    children: Few<NodeIndex>,
    /// By part, the lengths in whole blocks, if it has no others.
    whole: Few<Option<Vec<(i32, f64)>>>,
    /// The lengths, if there is but one for each part.
    certain: Option<Few<Length>>,
}

impl Written {
    fn of(laws: Few<Law>, children: Few<NodeIndex>) -> Written {
        let whole = laws.iter().map(Law::whole).collect();
        let certain = laws.iter().map(Law::certain).collect();
        Written { laws, children, whole, certain }
    }
}

/// More splits and sizes of their scopes than these are not kept.
const MOST_WRITTEN: usize = 1 << 18;

/// A split or repeat and its scope.
#[derive(Clone, Copy)]
pub struct Row<'s> {
    pub node: NodeIndex,
    pub around: Around,
    pub scope: &'s Scope,
    pub axis: Axis,
    /// Where its parts may end; `None` is anywhere.
    pub planes: Option<&'s Planes>,
}

impl Row<'_> {
    /// Whether a part may lie there: what cuts a labelled box holds no derivation.
    fn has_room_for(&self, part: &Laid) -> bool {
        let is_clear = |at: i32| self.planes.is_none_or(|planes| planes.clear.contains(at as usize));
        is_clear(part.low) && is_clear(part.high)
    }

    /// Whether a box begins or ends there.
    pub fn is_face(&self, at: i32) -> bool {
        self.planes.is_some_and(|planes| planes.faces.contains(at as usize))
    }

    pub fn total(&self) -> i32 {
        self.scope.len(self.axis)
    }
}

/// Noise of floating-point arithmetic in counting repetitions, as a run has it.
const NOISE: f64 = 1e-6;

/// More ways than this to draw the sizes of a split that repeats some of them are not tried.
const MOST_WAYS: usize = 1 << 12;

impl Search<'_, '_> {
    pub fn split(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        axis: Axis,
        groups: &[Group],
    ) -> Option<Found> {
        let planes = self.planes(scope, axis);
        if planes.as_ref().is_some_and(|planes| planes.clear.is_clear()) {
            return None;
        }
        let row = Row { node, around, scope, axis, planes: planes.as_deref() };
        match self.rules.laws {
            Laws::AsWritten => self.as_written(row, groups),
            Laws::Widened => self.widened(row, groups),
            Laws::Stretched => {
                let mut best = self.as_written(row, groups);
                keep(&mut best, self.widened_at_a_price(row, groups));
                best
            }
        }
    }

    /// Where parts of a scope may end, if not anywhere.
    fn planes(&self, scope: &Scope, axis: Axis) -> Option<Rc<Planes>> {
        match (self.target, self.rigour, self.backdrop) {
            (Target::Boxes(boxes), Rigour::Exact, Backdrop::Air) => Some(boxes.planes(scope.bounds, axis)),
            _ => None,
        }
    }

    fn as_written(&mut self, row: Row<'_>, groups: &[Group]) -> Option<Found> {
        let Written { laws, children, whole, certain } = &*self.written(row)?;
        match certain {
            Some(lengths) => self.fixed(row, lengths, children, groups, Cost::NONE),
            None if !groups.is_empty() => self.every_way(row, laws, children, groups),
            None if self.takes_any()
                && let Some(found) = self.first_way(row, laws, children, whole) =>
            {
                found
            }
            None => self.free(row, laws, children),
        }
    }

    /// A split as it is written, for a scope of that size.
    fn written(&mut self, row: Row<'_>) -> Option<Rc<Written>> {
        let key = (row.node, row.around, Axis::ALL.map(|axis| row.scope.len(axis)));
        if let Some(known) = self.memory.written.get(&key) {
            return known.clone();
        }
        let written = self.laws(row).map(|(laws, children)| Rc::new(Written::of(laws, children)));
        if self.memory.written.len() >= MOST_WRITTEN {
            self.memory.written.clear();
        }
        self.memory.written.insert(key, written.clone());
        written
    }

    /// What the parts of a split may measure, and their children.
    pub fn laws(&self, row: Row<'_>) -> Option<(Few<Law>, Few<NodeIndex>)> {
        let sight = self.sight(row.around, row.scope);
        let (mut laws, mut children) = (SmallVec::new(), SmallVec::new());
        for (arg, child) in self.rules.graph.children(row.node) {
            if let Arg::Size(size) = arg {
                laws.push(law(size, &sight, row.total())?);
                children.push(child);
            }
        }
        Some((laws, children))
    }

    /// Parts of known lengths.
    pub fn fixed(
        &mut self,
        row: Row<'_>,
        lengths: &[Length],
        children: &[NodeIndex],
        groups: &[Group],
        cost: Cost,
    ) -> Option<Found> {
        let order = match groups.is_empty() {
            true => None,
            false => Some(written_out(lengths, groups, row.total()).ok()?),
        };
        let ends = match &order {
            None => fit(row.total(), lengths).ok()?,
            Some(order) => {
                let lengths: Vec<Length> = order.iter().map(|at| lengths[*at]).collect();
                fit(row.total(), &lengths).ok()?
            }
        };
        let child = |at: usize| children[order.as_ref().map_or(at, |order| order[at])];
        let laid = ends.windows(2).enumerate();
        let laid =
            laid.map(|(at, ends)| Laid { child: child(at), low: ends[0], high: ends[1], number: at as u32 });
        self.row(row, &laid.collect::<Few<Laid>>(), cost)
    }

    /// All parts of a row. Where every cell counts, what is seen at once is looked at first.
    pub fn row(&mut self, row: Row<'_>, laid: &[Laid], cost: Cost) -> Option<Found> {
        let count = laid.len() as u32;
        let there = || laid.iter().filter(|part| part.low < part.high);
        if there().any(|part| !row.has_room_for(part)) {
            return None;
        }
        if self.rigour == Rigour::Exact {
            for part in there() {
                let scope = row.scope.part(row.axis, part.low, part.high);
                let around = self.shared(row, part, count);
                if self.is_hopeless(part.child, around, &scope) {
                    return None;
                }
            }
        }
        let mut cost = cost;
        let mut pieces = Vec::with_capacity(laid.len());
        for part in there() {
            let scope = row.scope.part(row.axis, part.low, part.high);
            let around = self.shared(row, part, count);
            cost = cost.plus(self.solve(part.child, around, &scope)?);
            pieces.push(Piece::of(part.child, around, &scope, row.scope));
        }
        if pieces.is_empty() {
            cost = cost.plus(self.nothing(row.scope.bounds)?);
        }
        let lengths = there().map(|part| part.high - part.low).collect();
        cost.steps += 1;
        Some(Found { cost, choice: Choice::Lengths(lengths), pieces: pieces.into() })
    }

    /// What a part sees, of so many.
    pub fn shared(&mut self, row: Row<'_>, part: &Laid, count: u32) -> Around {
        match self.rules.needs[part.child.index()].share {
            true => self.memory.known.with_share(row.around, (part.number, count)),
            false => row.around,
        }
    }

    /// The cost of one part.
    pub fn part(&mut self, row: Row<'_>, part: &Laid, count: u32) -> Option<Cost> {
        if part.low >= part.high {
            return Some(Cost::NONE);
        }
        if !row.has_room_for(part) {
            return None;
        }
        let around = self.shared(row, part, count);
        self.solve(part.child, around, &row.scope.part(row.axis, part.low, part.high))
    }

    /// Every way to draw the lengths, one after the other.
    fn every_way(
        &mut self,
        row: Row<'_>,
        laws: &[Law],
        children: &[NodeIndex],
        groups: &[Group],
    ) -> Option<Found> {
        let lists: Vec<Vec<(Length, f64)>> = laws.iter().map(Law::samples).collect();
        let ways = lists.iter().try_fold(1, |ways: usize, list| ways.checked_mul(list.len()));
        let mut best = None;
        for mut way in 0..ways.filter(|ways| *ways <= MOST_WAYS)? {
            let mut chance = 1.0;
            let lengths = lists.iter().map(|list| {
                let (length, own) = list[way % list.len()];
                way /= list.len();
                chance *= own;
                length
            });
            let lengths: Vec<Length> = lengths.collect();
            let found = self.fixed(row, &lengths, children, groups, Cost::of_chance(chance));
            keep(&mut best, found);
            if best.is_some() && self.takes_any() {
                break;
            }
        }
        best
    }

    /// Repeats a size as often as it fits, rounded up.
    pub fn repeat(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        axis: Axis,
        size: &Expr,
    ) -> Option<Found> {
        let planes = self.planes(scope, axis);
        let row = Row { node, around, scope, axis, planes: planes.as_deref() };
        let total = f64::from(row.total());
        let fits = |size: f64| (size > 0.0).then(|| (total / size - NOISE).ceil().max(1.0));
        let counts = match self.sight(around, scope).draw(size)? {
            Draw::Between(low, high) => {
                let least = fits(high)?;
                let most = fits(low).unwrap_or(total).min(total.max(least));
                let count = most - least + 1.0;
                (0..count as u32).map(|more| (least + f64::from(more), 1.0 / count)).collect()
            }
            drawn => drawn
                .numbers()?
                .into_iter()
                .filter_map(|(size, chance)| Some((fits(size)?, chance)))
                .collect(),
        };
        self.so_often(row, counts)
    }

    pub fn repeat_times(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        axis: Axis,
        count: &Expr,
    ) -> Option<Found> {
        let planes = self.planes(scope, axis);
        let row = Row { node, around, scope, axis, planes: planes.as_deref() };
        let drawn = self.sight(around, scope).draw(count)?.numbers()?.into_iter();
        let counts = drawn.map(|(count, chance)| (count.round(), chance)).filter(|(count, _)| *count >= 0.0);
        self.so_often(row, counts.collect())
    }

    /// Equal shares, as often as any of the counts says.
    fn so_often(&mut self, row: Row<'_>, counts: Vec<(f64, f64)>) -> Option<Found> {
        let (_, child) = self.rules.graph.children(row.node).next()?;
        let most = f64::from(row.total());
        let mut chances: BTreeMap<u32, f64> = BTreeMap::new();
        // Shares of less than a block are there or not, and their number tells no more: a run of many is work for nothing.
        for (count, chance) in counts.into_iter().filter(|(count, _)| *count <= 16.0 * (most + 1.0)) {
            *chances.entry(count as u32).or_insert(0.0) += chance;
        }
        let any = 1..=row.total().max(1) as u32;
        let mut best = None;
        match self.rules.laws {
            Laws::AsWritten => {}
            Laws::Widened => chances.extend(any.map(|count| (count, 1.0))),
            Laws::Stretched => {
                for count in any.filter(|count| !chances.contains_key(count)) {
                    let found = self.times(row, child, count, STRETCHED);
                    let choice = Choice::StretchedTimes(count);
                    keep(&mut best, found.map(|found| Found { choice, ..found }));
                }
            }
        }
        for (count, chance) in chances {
            let found = self.times(row, child, count, Cost::of_chance(chance));
            keep(&mut best, found);
            if best.is_some() && self.takes_any() {
                break;
            }
        }
        best
    }

    fn times(&mut self, row: Row<'_>, child: NodeIndex, count: u32, cost: Cost) -> Option<Found> {
        let laid = shares(row.total(), count).enumerate();
        let laid: Vec<Laid> =
            laid.map(|(at, (low, high))| Laid { child, low, high, number: at as u32 }).collect();
        let found = self.row(row, &laid, cost);
        found.map(|found| Found { choice: Choice::Times(count), ..found })
    }
}
