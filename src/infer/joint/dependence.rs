//! Whether parts of boxes go together: what varied together in the examples must not be drawn apart.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::groups::materials;
use super::repeats::Period;
use crate::space::Axis;
use rustc_hash::FxHashMap;

/// Bits that dependent parts cost beside what they tell of one another. They have to weigh more than a few
/// operations that are written twice.
const PENALTY: f64 = 40.0;
/// Bits of a plane where parts meet that could not stand side by side: more than any description has.
const TORN: f64 = 1e9;

/// So few boxes are told apart by anything that differs.
const FEW: u32 = 3;

/// What parts of one box look like, one label a part, with how often.
type Row = (Vec<Class>, u32);

/// More parts than this are not tried side by side.
const MOST: usize = 12;

/// The bits that it costs to draw the parts of these boxes, which stand along an axis, apart.
pub fn dependence(corpus: &mut Corpus, rows: &[Row], axis: Axis) -> f64 {
    if rows.len() < 2 {
        return 0.0;
    }
    let parts = rows.first().map_or(0, |(parts, _)| parts.len());
    let torn = (1..parts).filter(|part| !all_fit(corpus, rows, axis, *part)).count();
    TORN * torn as f64 + told(corpus, rows)
}

/// Whether every part before a plane fits every part behind it. Parts of other sizes may fit for all that is known.
fn all_fit(corpus: &mut Corpus, rows: &[Row], axis: Axis, part: usize) -> bool {
    let [left, right] = [part - 1, part].map(|part| distinct(rows, part));
    left.iter().all(|left| right.iter().all(|right| corpus.fit(*left, *right, axis).unwrap_or(true)))
}

/// What stands in one part; some of it where there is much.
fn distinct(rows: &[Row], part: usize) -> Vec<Class> {
    let mut side: Vec<Class> = rows.iter().map(|(parts, _)| parts[part]).collect();
    side.sort_unstable();
    side.dedup();
    side.truncate(MOST);
    side
}

/// The bits that parts tell of one another.
fn told(corpus: &mut Corpus, rows: &[Row]) -> f64 {
    let parts = rows.first().map_or(0, |(parts, _)| parts.len());
    let shapes = columns(rows, parts, |class| u64::from(corpus.profile(class).skeleton.0));
    let materials = columns(rows, parts, |class| materials(corpus, class));
    let counts: Vec<u32> = rows.iter().map(|(_, count)| *count).collect();
    let mut bits = 0.0;
    for one in 0..parts {
        for other in one + 1..parts {
            let by = |labels: &[Vec<u64>]| shared(&labels[one], &labels[other], &counts);
            bits += by(&shapes).max(by(&materials));
        }
    }
    bits
}

fn columns(rows: &[Row], parts: usize, mut label: impl FnMut(Class) -> u64) -> Vec<Vec<u64>> {
    let mut known: FxHashMap<Class, u64> = FxHashMap::default();
    let mut label = |class: Class| *known.entry(class).or_insert_with(|| label(class));
    (0..parts).map(|part| rows.iter().map(|(parts, _)| label(parts[part])).collect()).collect()
}

/// The bits for one pair of labels: none if they are independent as far as so few boxes tell.
fn shared(one: &[u64], other: &[u64], counts: &[u32]) -> f64 {
    let (mut ones, mut others, mut both) = (Counts::default(), Counts::default(), Counts::default());
    for ((a, b), count) in one.iter().zip(other).zip(counts) {
        ones.add((*a, 0), *count);
        others.add((0, *b), *count);
        both.add((*a, *b), *count);
    }
    let [a, b, joint] = [&ones, &others, &both].map(|counts| counts.0.len() as f64);
    if a == 1.0 || b == 1.0 {
        return 0.0;
    }
    let total: u32 = counts.iter().sum();
    let is_one_to_one = a == b && a == joint && (2.0 * a <= f64::from(total) || total <= FEW);
    let mutual = ones.entropy() + others.entropy() - both.entropy();
    if is_one_to_one || is_told(mutual, [a, b], total) { PENALTY + mutual } else { 0.0 }
}

/// Whether labels that are so many tell so many bits of one another that it is no chance, by the Bayesian
/// information criterion, in nats.
fn is_told(mutual: f64, labels: [f64; 2], total: u32) -> bool {
    let [a, b] = labels;
    a > 1.0
        && b > 1.0
        && mutual * std::f64::consts::LN_2 > (a - 1.0) * (b - 1.0) / 2.0 * f64::from(total).ln()
}

/// Whether one label tells of the other, given pairs of them with how often each occurs.
pub fn tells(pairs: &[(u64, u64, u32)]) -> bool {
    let (mut ones, mut others, mut both) = (Counts::default(), Counts::default(), Counts::default());
    for (a, b, count) in pairs {
        ones.add((*a, 0), *count);
        others.add((0, *b), *count);
        both.add((*a, *b), *count);
    }
    let mutual = ones.entropy() + others.entropy() - both.entropy();
    let total = pairs.iter().map(|(.., count)| count).sum();
    is_told(mutual, [&ones, &others].map(|counts| counts.0.len() as f64), total)
}

/// How often each label occurs.
#[derive(Default)]
struct Counts(std::collections::BTreeMap<(u64, u64), u32>);

impl Counts {
    fn add(&mut self, label: (u64, u64), count: u32) {
        *self.0.entry(label).or_insert(0) += count;
    }

    /// In bits, of all occurrences together.
    fn entropy(&self) -> f64 {
        super::estimate::choice(self.0.values())
    }
}

/// What boxes look like on both sides of a plane.
pub fn halves(corpus: &mut Corpus, boxes: &Boxes, axis: Axis, at: &[i32]) -> Vec<Row> {
    let rows = boxes.iter().zip(at).map(|((class, count), at)| {
        let len = corpus.profile(class).len(axis);
        (vec![corpus.part(class, axis, 0, *at), corpus.part(class, axis, *at, len)], count)
    });
    rows.collect()
}

/// Units that stand side by side in a repeat.
pub fn neighbours(corpus: &mut Corpus, boxes: &Boxes, period: Period) -> Vec<Row> {
    let mut rows = Vec::new();
    for (class, count) in boxes.iter() {
        let starts: Vec<i32> = period.starts(corpus.profile(class).len(period.axis)).collect();
        for pair in starts.windows(2) {
            let unit = |at: i32| corpus.part(class, period.axis, at, at + period.unit);
            rows.push((pair.iter().copied().map(unit).collect(), count));
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::tells;

    #[test]
    fn labels_tell_of_one_another_where_so_many_boxes_agree() {
        assert!(tells(&[(0, 7, 10), (1, 8, 10)]));
        assert!(!tells(&[(0, 7, 10), (0, 8, 9), (1, 7, 9), (1, 8, 10)]));
        // Of two boxes each is something else.
        assert!(!tells(&[(0, 7, 1), (0, 8, 1), (1, 8, 1)]));
        assert!(!tells(&[(0, 7, 30), (1, 7, 40)]));
    }
}
