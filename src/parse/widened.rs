//! Splits whose parts may measure what they like: their order is all that counts.

use super::Laws;
use super::chart::{Choice, Found, Rigour};
use super::cost::Cost;
use super::lengths::{Law, Span};
use super::search::Search;
use super::split::{Laid, Row};
use crate::graph::{Group, NodeIndex};

/// How likely a rule is taken for whose condition does not hold.
pub const STRETCHED_CHANCE: f64 = 1.0 / (1u128 << 64) as f64;

/// What it costs that a split or a repeat does not keep to its laws: more than draws take where it does.
pub const STRETCHED: Cost = Cost { bits: 64.0, ..Cost::NONE };

/// The parts of a split as a chain, in which groups lead back or are passed by.
struct Chain {
    parts: Vec<NodeIndex>,
    /// From one place between parts to another, at no cost.
    leaps: Vec<(usize, usize)>,
}

/// How a place was reached: at what cost, and over which part, from where.
#[derive(Clone, Copy)]
struct Reached {
    cost: Cost,
    from: Option<(usize, i32)>,
}

impl Search<'_, '_> {
    /// The cheapest derivation of a split with parts of any length: absolute ones take a block at least, unless the
    /// grammar lets them be less.
    pub fn widened(&mut self, row: Row<'_>, groups: &[Group]) -> Option<Found> {
        let laid = self.laid_widely(row, groups)?;
        self.row(row, &laid, Cost::NONE)
    }

    /// The same at a price, and which part is how long.
    pub fn widened_at_a_price(&mut self, row: Row<'_>, groups: &[Group]) -> Option<Found> {
        let laid = self.laid_widely(row, groups)?;
        let lengths = laid.iter().map(|part| (part.number, part.high - part.low));
        let choice = Choice::Stretched(lengths.collect());
        self.row(row, &laid, STRETCHED).map(|found| Found { choice, ..found })
    }

    fn laid_widely(&mut self, row: Row<'_>, groups: &[Group]) -> Option<Vec<Laid>> {
        let chain = self.chain(row, groups)?;
        let total = row.total();
        self.pay_for(&chain, total)?;
        let goes_on = self.goes_on(row, &chain);
        let width = total as usize + 1;
        let mut reached: Vec<Option<Reached>> = vec![None; (chain.parts.len() + 1) * width];
        let at = |place: usize, low: i32| place * width + low as usize;
        reached[at(0, 0)] = Some(Reached { cost: Cost::NONE, from: None });
        for low in 0..=total {
            leap(&chain, &mut reached, |place| at(place, low), low);
            for place in 0..chain.parts.len() {
                let Some(here) = reached[at(place, low)] else { continue };
                for high in low + 1..=total {
                    if !goes_on[at(place + 1, high)] {
                        continue;
                    }
                    let child = chain.parts[place];
                    let part = Laid { child, low, high, number: place as u32 };
                    let known = reached[at(place + 1, high)];
                    if known.is_some_and(|known| !here.cost.is_less(known.cost)) {
                        continue;
                    }
                    if let Some(own) = self.part(row, &part, chain.parts.len() as u32) {
                        let cost = here.cost.plus(own);
                        if known.is_none_or(|known| cost.is_less(known.cost)) {
                            reached[at(place + 1, high)] = Some(Reached { cost, from: Some((place, low)) });
                        }
                    }
                }
            }
        }
        walked(&chain, &reached, width, total)
    }

    /// Where laws are stretched, every split is looked at so: each of its lengths counts as a step. `None` where too few
    /// are left.
    fn pay_for(&mut self, chain: &Chain, total: i32) -> Option<()> {
        if self.rules.laws != Laws::Stretched {
            return Some(());
        }
        let ways = chain.parts.len() as u64 * total as u64 * (total as u64 + 1) / 2;
        self.steps = self.steps.saturating_sub(ways);
        (self.steps > 0).then_some(())
    }

    fn chain(&self, row: Row<'_>, groups: &[Group]) -> Option<Chain> {
        let (laws, children) = self.laws(row)?;
        let empty = laws.iter().enumerate().filter(|(_, law)| may_be_empty(law)).map(|(at, _)| (at, at + 1));
        let around = groups.iter().flat_map(|group| {
            let group = &group.children;
            [(group.end, group.start), (group.start, group.end)]
        });
        Some(Chain { parts: children.to_vec(), leaps: empty.chain(around).collect() })
    }

    /// From which places the end can be reached, as far as that is seen at once.
    fn goes_on(&mut self, row: Row<'_>, chain: &Chain) -> Vec<bool> {
        let total = row.total();
        let width = total as usize + 1;
        let at = |place: usize, low: i32| place * width + low as usize;
        let mut goes_on = vec![self.rigour == Rigour::Nearest; (chain.parts.len() + 1) * width];
        goes_on[at(chain.parts.len(), total)] = true;
        if self.rigour == Rigour::Nearest {
            return goes_on;
        }
        for low in (0..=total).rev() {
            for place in (0..chain.parts.len()).rev() {
                let child = chain.parts[place];
                let ends = (low + 1..=total).filter(|high| goes_on[at(place + 1, *high)]);
                let ends: Vec<i32> = ends.collect();
                goes_on[at(place, low)] |= ends
                    .into_iter()
                    .any(|high| !self.is_hopeless(child, row.around, &row.scope.part(row.axis, low, high)));
            }
            for _ in 0..=chain.leaps.len() {
                for &(from, to) in &chain.leaps {
                    goes_on[at(from, low)] |= goes_on[at(to, low)];
                }
            }
        }
        goes_on
    }
}

/// Whether a part may come out without a block.
fn may_be_empty(law: &Law) -> bool {
    let Span { low, floats, .. } = law.ends();
    floats || low < 1.0
}

/// Reaches the places that others lead to at no cost.
fn leap(chain: &Chain, reached: &mut [Option<Reached>], at: impl Fn(usize) -> usize, low: i32) {
    for _ in 0..=chain.leaps.len() {
        for &(from, to) in &chain.leaps {
            if let Some(here) = reached[at(from)]
                && reached[at(to)].is_none_or(|known| here.cost.is_less(known.cost))
            {
                reached[at(to)] = Some(Reached { cost: here.cost, from: Some((from, low)) });
            }
        }
    }
}

/// The parts on the way to the end.
fn walked(chain: &Chain, reached: &[Option<Reached>], width: usize, total: i32) -> Option<Vec<Laid>> {
    let mut laid = Vec::new();
    let (mut place, mut high) = (chain.parts.len(), total);
    while let Some((from, low)) = reached[place * width + high as usize]?.from {
        if low < high {
            let child = chain.parts[from];
            laid.push(Laid { child, low, high, number: from as u32 });
        }
        (place, high) = (from, low);
    }
    laid.reverse();
    Some(laid)
}
