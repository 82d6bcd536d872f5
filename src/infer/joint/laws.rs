//! Laws of sizes: how the parts of one split are as long as they are, over all boxes that it describes.

use super::repeats::gcd;
use crate::space::{Length, fit};
use std::collections::BTreeMap;

/// The size of a part.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Law {
    Const(i32),
    /// Shares with the other floating parts, by weight, what the rest leaves.
    Float(u32),
    /// Any of these lengths, each the low one and some steps more; both bounds are included.
    Range {
        low: i32,
        high: i32,
        step: i32,
    },
    /// One of these lengths, by weight.
    Table(Vec<(i32, u32)>),
    /// As long as the part of that number.
    Same(usize),
}

impl Law {
    /// One of these lengths, each as often as it was seen.
    pub fn table(lengths: impl Iterator<Item = (i32, u32)>) -> Law {
        let mut counts: BTreeMap<i32, u32> = BTreeMap::new();
        lengths.for_each(|(len, count)| *counts.entry(len).or_insert(0) += count);
        Law::Table(counts.into_iter().collect())
    }

    /// Whether it leaves lengths to chance.
    pub fn is_drawn(&self) -> bool {
        matches!(self, Law::Range { .. } | Law::Table(_))
    }

    /// The lengths that it gives by itself.
    pub fn lengths(&self) -> Box<dyn Iterator<Item = i32> + '_> {
        match self {
            Law::Const(len) => Box::new(std::iter::once(*len)),
            Law::Range { low, high, step } => Box::new((*low..=*high).step_by(*step as usize)),
            Law::Table(entries) => Box::new(entries.iter().map(|(len, _)| *len)),
            Law::Float(_) | Law::Same(_) => Box::new(std::iter::empty()),
        }
    }

    /// The longest of them.
    fn most(&self) -> i32 {
        self.lengths().max().unwrap_or(0)
    }

    /// The bits of writing it down.
    pub fn bits(&self) -> f64 {
        2.0 + match self {
            Law::Const(len) => integer(*len),
            Law::Float(weight) => integer(*weight as i32),
            Law::Range { low, high, step } => integer(*low) + integer(high - low) + integer(*step),
            Law::Table(entries) => entries.iter().map(|(len, _)| integer(*len) + 3.0).sum(),
            Law::Same(_) => 2.0,
        }
    }

    /// The bits of drawing these lengths, each with how often it was seen.
    pub fn chance(&self, mut lengths: impl Iterator<Item = (i32, u32)>) -> f64 {
        let count = |lengths: &mut dyn Iterator<Item = (i32, u32)>| {
            lengths.map(|(_, count)| f64::from(count)).sum::<f64>()
        };
        match self {
            Law::Const(_) | Law::Float(_) | Law::Same(_) => 0.0,
            Law::Range { low, high, step } => count(&mut lengths) * f64::from((high - low) / step + 1).log2(),
            Law::Table(entries) => {
                let total: u32 = entries.iter().map(|(_, count)| count).sum();
                let share =
                    |len: i32| entries.iter().find(|(own, _)| *own == len).map_or(1, |(_, count)| *count);
                lengths
                    .map(|(len, count)| f64::from(count) * (f64::from(total) / f64::from(share(len))).log2())
                    .sum()
            }
        }
    }
}

/// The bits of a whole number from 1 on, shorter for smaller ones (Elias gamma).
pub fn integer(number: i32) -> f64 {
    2.0 * f64::from(number.max(1)).log2().floor() + 1.0
}

/// The lengths of the parts of one split in one box, and how often that was seen.
pub type Seen = (Vec<i32>, u32);

/// How a part takes to lengths that it was not seen in.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Stretch {
    /// It looks alike at any length.
    Alike,
    /// Some of it floats.
    Bends,
    Stiff,
}

/// What laws go by in a part, beside its lengths.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    pub stretch: Stretch,
    /// The number of what stands in it.
    pub look: u32,
}

/// The parts whose lengths are not one.
fn varying(seen: &[Seen]) -> Vec<usize> {
    let varies = |part: &usize| seen.iter().any(|(lengths, _)| lengths[*part] != seen[0].0[*part]);
    (0..seen[0].0.len()).filter(varies).collect()
}

fn constant(seen: &[Seen]) -> Vec<Law> {
    seen[0].0.iter().map(|len| Law::Const(*len)).collect()
}

/// The simplest laws without chance that give all that was seen, where some of it varies.
pub fn shared(seen: &[Seen]) -> Option<Vec<Law>> {
    let varying = varying(seen);
    weights(varying.len()).find_map(|weights| {
        let mut laws = constant(seen);
        varying.iter().zip(weights).for_each(|(part, weight)| laws[*part] = Law::Float(weight));
        seen.iter().all(|(lengths, _)| gives(&laws, lengths)).then_some(laws)
    })
}

/// The bits of what is left to chance where parts share evenly what others leave, of which one may be drawn; beyond all
/// measure where none do.
pub fn sharing(seen: &[Seen]) -> f64 {
    let (varying, constant) = (varying(seen), constant(seen));
    if varying.is_empty() || shared(seen).is_some() {
        return 0.0;
    }
    let middles = varying.iter().filter_map(|middle| between(seen, &constant, &varying, *middle));
    middles.map(|(bits, _)| bits).fold(f64::INFINITY, f64::min)
}

/// The shortest laws that may give all that was seen.
pub fn fitted(seen: &[Seen], parts: &[Part]) -> Vec<Law> {
    let (varying, constant) = (varying(seen), constant(seen));
    if let Some(laws) = mirrored(seen, &constant, &varying, parts) {
        return laws;
    }
    if varying.is_empty() {
        return stretched(constant, &seen[0].0, parts);
    }
    let is_stiff = |part: &usize| parts[*part].stretch == Stretch::Stiff;
    let drawn = || {
        let options = varying.iter().map(|floating| {
            let (bits, laws) = drawn(seen, &constant, &varying, *floating);
            let is_stiff = is_stiff(floating);
            (overdraws(seen, &laws, *floating), is_stiff, bits, laws)
        });
        let middles = varying.iter().filter_map(|middle| {
            let (bits, laws) = between(seen, &constant, &varying, *middle)?;
            let is_stiff = varying.iter().any(|part| part != middle && is_stiff(part));
            Some((false, is_stiff, bits, laws))
        });
        let options = options.chain(middles);
        let order =
            |(overdraws, is_stiff, bits, _): &(bool, bool, f64, Vec<Law>)| (*overdraws, *is_stiff, *bits);
        let best = options.min_by(|one, other| {
            let ((one, is_stiff, bits), (other, other_is_stiff, other_bits)) = (order(one), order(other));
            one.cmp(&other).then(is_stiff.cmp(&other_is_stiff)).then(bits.total_cmp(&other_bits))
        });
        best.map_or_else(|| constant.clone(), |(.., laws)| laws)
    };
    shared(seen).unwrap_or_else(drawn)
}

/// Whether the parts that are drawn may leave the floating one less than it was ever seen with, in a box that was
/// seen.
fn overdraws(seen: &[Seen], laws: &[Law], floating: usize) -> bool {
    let most = |part: usize| match &laws[part] {
        Law::Same(owner) => laws[*owner].most(),
        law => law.most(),
    };
    let others: i32 = (0..laws.len()).filter(|part| *part != floating).map(most).sum();
    let least = seen.iter().map(|(lengths, _)| lengths[floating]).min().unwrap_or(0);
    seen.iter().any(|(lengths, _)| lengths.iter().sum::<i32>() - others < least)
}

/// Laws of parts that never varied: of those that look alike at any length the longest floats, so that the split
/// fills other scopes as well.
fn stretched(mut laws: Vec<Law>, lengths: &[i32], parts: &[Part]) -> Vec<Law> {
    if let Some(longest) = longest(lengths, parts) {
        laws[longest] = Law::Float(1);
    }
    laws
}

/// The longest part that looks alike at any length.
fn longest(lengths: &[i32], parts: &[Part]) -> Option<usize> {
    let longer =
        (0..lengths.len()).filter(|part| parts[*part].stretch == Stretch::Alike && lengths[*part] > 1);
    longer.max_by_key(|part| (lengths[*part], std::cmp::Reverse(*part)))
}

/// Laws by which what stands in the middle stays there: where one half mirrors the other, all that looks the same shares
/// evenly what the rest leaves, if that gives all that was seen.
fn mirrored(seen: &[Seen], constant: &[Law], varying: &[usize], parts: &[Part]) -> Option<Vec<Law>> {
    let first = varying.first().copied().or_else(|| longest(&seen[0].0, parts))?;
    let is_same = |part: &usize| parts[*part].look == parts[first].look;
    let same: Vec<usize> = (0..parts.len()).filter(is_same).collect();
    let is_mirrored = (0..parts.len()).all(|part| parts[part].look == parts[parts.len() - 1 - part].look);
    let is_alike = parts[first].stretch == Stretch::Alike;
    if !is_mirrored || !is_alike || same.len() < 2 || !varying.iter().all(is_same) {
        return None;
    }
    let mut laws = constant.to_vec();
    same.into_iter().for_each(|part| laws[part] = Law::Float(1));
    seen.iter().all(|(lengths, _)| gives(&laws, lengths)).then_some(laws)
}

/// So many different lengths tell that those between them are right as well.
const MANY: usize = 4;

/// The weights that floating parts are tried with, the simplest first.
fn weights(parts: usize) -> impl Iterator<Item = Vec<u32>> {
    const HEAVIEST: u32 = 3;
    let pairs = (1..=HEAVIEST).flat_map(|sum| (1..=sum).map(move |low| (low, sum)));
    let pairs = pairs.filter(|(low, high)| gcd(*low as i32, *high as i32) == 1);
    let of_pair = move |(low, high): (u32, u32)| match parts {
        1 if high == 1 => vec![vec![1]],
        2 if low == high => vec![vec![1, 1]],
        2 => vec![vec![low, high], vec![high, low]],
        3 if low == high => vec![vec![1; 3]],
        3 => vec![vec![low, high, low], vec![high, low, high]],
        _ if high == 1 => vec![vec![1; parts]],
        _ => Vec::new(),
    };
    pairs.flat_map(of_pair)
}

/// Whether laws without chance give these lengths.
fn gives(laws: &[Law], lengths: &[i32]) -> bool {
    let fixed = laws.iter().map(|law| match law {
        Law::Const(len) => Length::Absolute(f64::from(*len)),
        Law::Float(weight) => Length::Floating(f64::from(*weight)),
        _ => Length::Floating(0.0),
    });
    let bounds = fit(lengths.iter().sum(), &fixed.collect::<Vec<Length>>());
    bounds.is_ok_and(|bounds| bounds.windows(2).map(|pair| pair[1] - pair[0]).eq(lengths.iter().copied()))
}

/// One part floats, the others that vary are drawn; those that are always as long as another are so by law. With the
/// bits of all laws and of what they leave to chance.
fn drawn(seen: &[Seen], constant: &[Law], varying: &[usize], floating: usize) -> (f64, Vec<Law>) {
    let mut laws = constant.to_vec();
    laws[floating] = Law::Float(1);
    let mut bits = 0.0;
    let others = || varying.iter().copied().filter(move |part| *part != floating);
    for part in others() {
        let same = others().take_while(|other| *other < part).find(|other| {
            !matches!(laws[*other], Law::Same(_))
                && seen.iter().all(|(lengths, _)| lengths[*other] == lengths[part])
        });
        let lengths = || seen.iter().map(|(lengths, count)| (lengths[part], *count));
        laws[part] = same.map_or_else(|| law_of(lengths()), Law::Same);
        bits += laws[part].bits() + laws[part].chance(lengths());
    }
    (bits, laws)
}

/// One part is drawn and the others that vary, two at least, share evenly what it leaves: `None` if they do not, or if
/// they might be left less than they were ever seen with. With the bits of all laws and of the draw.
fn between(seen: &[Seen], constant: &[Law], varying: &[usize], middle: usize) -> Option<(f64, Vec<Law>)> {
    let others = || varying.iter().copied().filter(|part| *part != middle);
    let lengths = || seen.iter().map(|(lengths, count)| (lengths[middle], *count));
    let mut laws = constant.to_vec();
    others().for_each(|part| laws[part] = Law::Float(1));
    let with = |len: i32| {
        let mut laws = laws.clone();
        laws[middle] = Law::Const(len);
        laws
    };
    let parts = others().count() as i32;
    let least = seen.iter().flat_map(|(lengths, _)| others().map(|part| lengths[part])).min()?;
    let most = lengths().map(|(len, _)| len).max()?;
    let has_room = |(lengths, _): &Seen| {
        let left = others().map(|part| lengths[part]).sum::<i32>() + lengths[middle] - most;
        left / parts >= least
    };
    if parts < 2
        || !seen.iter().all(|(lengths, _)| gives(&with(lengths[middle]), lengths))
        || !seen.iter().all(has_room)
    {
        return None;
    }
    laws[middle] = law_of(lengths());
    Some((laws[middle].bits() + laws[middle].chance(lengths()), laws))
}

/// The shortest law of lengths that are left to chance: a range where they fill it about evenly, else a table. What
/// lies between a few lengths may never be right, as with windows of 2, 3 and 5; between many it is.
pub fn law_of(lengths: impl Iterator<Item = (i32, u32)>) -> Law {
    let mut counts: BTreeMap<i32, u32> = BTreeMap::new();
    lengths.for_each(|(len, count)| *counts.entry(len).or_insert(0) += count);
    let table = Law::Table(counts.iter().map(|(len, count)| (*len, *count)).collect());
    let (Some((low, _)), Some((high, _))) = (counts.first_key_value(), counts.last_key_value()) else {
        return table;
    };
    if low == high {
        return Law::Const(*low);
    }
    let step = match counts.len() {
        // Two lengths tell of no step.
        2 if high - low == 2 => 1,
        _ => counts.keys().map(|len| len - low).fold(0, gcd),
    };
    let range = Law::Range { low: *low, high: *high, step };
    let cost = |law: &Law| law.bits() + law.chance(counts.iter().map(|(len, count)| (*len, *count)));
    let lens: Vec<i32> = counts.keys().copied().collect();
    let is_full = lens.windows(2).all(|pair| pair[1] - pair[0] == step);
    let is_dense =
        (lens.len() == 2 || lens.len() >= MANY) && lens.windows(2).all(|pair| pair[1] - pair[0] <= 3 * step);
    if (is_full || is_dense) && cost(&range) <= cost(&table) { range } else { table }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a law may give that length on its own.
    fn allows(law: &Law, len: i32) -> bool {
        match law {
            Law::Const(own) => *own == len,
            Law::Float(_) | Law::Same(_) => true,
            Law::Range { low, high, step } => (*low..=*high).contains(&len) && (len - low) % step == 0,
            Law::Table(entries) => entries.iter().any(|(own, _)| *own == len),
        }
    }

    fn laws_of(seen: &[&[i32]], stretch: &[Stretch]) -> Vec<Law> {
        let seen: Vec<Seen> = seen.iter().map(|lengths| (lengths.to_vec(), 1)).collect();
        let parts = (0..).zip(stretch).map(|(look, stretch)| Part { stretch: *stretch, look });
        let laws = fitted(&seen, &parts.collect::<Vec<Part>>());
        for (lengths, _) in &seen {
            assert!(laws.iter().zip(lengths).all(|(law, len)| allows(law, *len)), "{laws:?}");
        }
        laws
    }

    #[test]
    fn what_does_not_vary_is_constant_and_the_rest_floats() {
        let laws = laws_of(&[&[1, 5, 1], &[1, 8, 1]], &[Stretch::Alike; 3]);
        assert_eq!(laws, [Law::Const(1), Law::Float(1), Law::Const(1)]);
    }

    #[test]
    fn shares_are_found() {
        let laws = laws_of(&[&[6, 3], &[7, 4], &[8, 4]], &[Stretch::Alike; 2]);
        assert_eq!(laws, [Law::Float(2), Law::Float(1)]);
    }

    #[test]
    fn equal_lengths_are_drawn_once() {
        let laws = laws_of(&[&[1, 3, 1], &[2, 2, 2], &[2, 5, 2]], &[Stretch::Alike; 3]);
        assert_eq!(laws, [Law::Range { low: 1, high: 2, step: 1 }, Law::Float(1), Law::Same(0)]);
    }

    #[test]
    fn what_is_drawn_may_stand_in_the_middle() {
        let seen: [&[i32]; 4] = [&[1, 3, 2, 3, 1], &[1, 3, 3, 3, 1], &[1, 4, 2, 4, 1], &[1, 2, 3, 2, 1]];
        let laws = laws_of(&seen, &[Stretch::Alike; 5]);
        let middle = Law::Range { low: 2, high: 3, step: 1 };
        assert_eq!(laws, [Law::Const(1), Law::Float(1), middle, Law::Float(1), Law::Const(1)]);
    }

    #[test]
    fn what_is_drawn_leaves_room_for_the_rest() {
        let porch = [Stretch::Bends, Stretch::Alike];
        let laws = laws_of(&[&[3, 4], &[8, 4], &[7, 2], &[10, 2]], &porch);
        assert_eq!(laws, [Law::Float(1), Law::Range { low: 2, high: 4, step: 1 }]);
    }

    #[test]
    fn what_never_varied_stretches_where_it_looks_alike() {
        let laws = laws_of(&[&[1, 4, 2]], &[Stretch::Alike, Stretch::Alike, Stretch::Stiff]);
        assert_eq!(laws, [Law::Const(1), Law::Float(1), Law::Const(2)]);
        assert_eq!(laws_of(&[&[1, 4]], &[Stretch::Stiff; 2]), [Law::Const(1), Law::Const(4)]);
    }

    #[test]
    fn what_stands_in_the_middle_stays_there() {
        let parts = |looks: &[u32]| -> Vec<Part> {
            looks.iter().map(|look| Part { stretch: Stretch::Alike, look: *look }).collect()
        };
        let laws = |lengths: &[i32], looks: &[u32]| fitted(&[(lengths.to_vec(), 1)], &parts(looks));
        assert_eq!(laws(&[2, 1, 2], &[0, 1, 0]), [Law::Float(1), Law::Const(1), Law::Float(1)]);
        assert_eq!(laws(&[3, 1, 2], &[0, 1, 0]), [Law::Float(1), Law::Const(1), Law::Const(2)]);
        assert_eq!(laws(&[2, 1, 2], &[0, 1, 2]), [Law::Float(1), Law::Const(1), Law::Const(2)]);
    }

    #[test]
    fn ranges_have_steps_and_tables_are_for_what_is_uneven() {
        let law = |lengths: &[i32]| law_of(lengths.iter().map(|len| (*len, 1)));
        assert_eq!(law(&[7, 9, 11]), Law::Range { low: 7, high: 11, step: 2 });
        assert_eq!(law(&[2, 3, 5]), Law::Table(vec![(2, 1), (3, 1), (5, 1)]));
        assert_eq!(law(&[2, 3, 5, 6]), Law::Range { low: 2, high: 6, step: 1 });
        let uneven: Vec<i32> = (0..30).map(|number| if number == 0 { 20 } else { 3 }).collect();
        assert!(matches!(law(&uneven), Law::Table(_)));
    }
}
