//! How long a description of boxes will be, before it is searched for.

use super::alternation::{Alternation, units_and_separators};
use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Sequence, Skeleton};
use super::laws::{self, Seen};
use super::repeats::Period;
use super::rows::Row;
use super::slopes::Slope;
use crate::space::Axis;
use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::SmallVec;

/// Bits of a row of cells, and of each of its runs.
const ROW: f64 = 5.5;
const RUN: f64 = 6.0;
/// Bits of one more alternative.
pub const ALTERNATIVE: f64 = 3.0;
/// Bits of a size that is left free, beside its values.
const FREE: f64 = 4.0;
/// Bits of planes that stand at shares of what others leave.
const SHARES: f64 = 6.0;
/// Bits of a repeat.
pub const REPEAT: f64 = 7.0;
/// Bits of a slope: a choice of two and two splits.
pub const SLOPE: f64 = 24.0;
/// Bits of units with separators between them: a repeat, and two planes at fixed distances.
pub const ALTERNATION: f64 = 21.0;

/// What was estimated, by what was asked.
#[derive(Default, Debug)]
pub struct Estimates {
    skeletons: FxHashMap<Skeleton, f64>,
    boxes: FxHashMap<Boxes, f64>,
}

impl Estimates {
    /// The bits of a description of `boxes`: on the best axis, those of every slice that differs, once for all
    /// boxes; those of the sequences of slices; of the choice between sequences; and of the planes that are free
    /// to move. Or those of the units that they repeat. Beyond all measure once the search is cut short.
    pub fn bits(&mut self, corpus: &mut Corpus, boxes: &Boxes) -> f64 {
        if let Some(&known) = self.boxes.get(boxes) {
            return known;
        }
        if corpus.is_spent() {
            return f64::INFINITY;
        }
        let plain = self.plain(corpus, boxes);
        let repeats = Period::of(corpus, boxes);
        let repeated = repeats.into_iter().map(|period| {
            let parts = period.parts(corpus, boxes);
            REPEAT + parts.into_iter().map(|part| self.plain(corpus, &part)).sum::<f64>()
        });
        let bits = repeated.fold(plain, f64::min);
        let slopes = Slope::of(corpus, boxes).into_iter();
        let sloped = slopes.map(|slope| {
            let parts = slope.parts(corpus, boxes);
            SLOPE + parts.into_iter().map(|part| self.plain(corpus, &part)).sum::<f64>()
        });
        let bits = sloped.fold(bits, f64::min);
        let bits = Row::of(corpus, boxes).map_or(bits, |row| bits.min(of_row(&row)));
        let alternating = Alternation::of(corpus, boxes).into_iter().map(|alternation| {
            let rows = alternation.rows(corpus, boxes);
            ALTERNATION
                + units_and_separators(&rows).map(|part| self.plain(corpus, &part)).iter().sum::<f64>()
        });
        let bits = alternating.fold(bits, f64::min);
        if !corpus.is_spent() {
            self.boxes.insert(boxes.clone(), bits);
        }
        bits
    }

    /// The bits of a choice between groups: slices that several groups show count once, since equal parts become
    /// one rule.
    pub fn alternatives(&mut self, corpus: &mut Corpus, groups: &[Boxes]) -> f64 {
        let mut known = FxHashSet::default();
        let mut bits = 0.0;
        for group in groups {
            if corpus.is_spent() {
                return f64::INFINITY;
            }
            let across = Axis::ALL.map(|axis| (axis, self.across(corpus, group, axis, &mut known.clone())));
            let best = across.into_iter().min_by(|(_, a), (_, b)| a.total_cmp(b));
            let repeated = self.bits(corpus, group);
            bits += best.map_or(repeated, |(axis, _)| {
                let shared = self.across(corpus, group, axis, &mut known);
                repeated.min(shared + free(corpus, group))
            });
        }
        let counts: Vec<u32> = groups.iter().map(Boxes::count).collect();
        bits + ALTERNATIVE * groups.len() as f64 + choice(counts.iter())
    }

    /// The bits of boxes that share slices across an axis with others, which are described anyway.
    pub fn beside(&mut self, corpus: &mut Corpus, boxes: &Boxes, others: &Boxes, axis: Axis) -> f64 {
        if corpus.is_spent() {
            return f64::INFINITY;
        }
        let mut known = FxHashSet::default();
        for class in others.classes() {
            known.extend(corpus.slices(class, axis).iter().copied());
        }
        self.across(corpus, boxes, axis, &mut known) + free(corpus, boxes)
    }

    fn plain(&mut self, corpus: &mut Corpus, boxes: &Boxes) -> f64 {
        if boxes.fill(corpus).is_some() {
            return ROW + RUN;
        }
        if corpus.is_spent() {
            return f64::INFINITY;
        }
        let axes = Axis::ALL.map(|axis| self.across(corpus, boxes, axis, &mut FxHashSet::default()));
        axes.into_iter().fold(f64::INFINITY, f64::min) + free(corpus, boxes)
    }

    fn across(
        &mut self,
        corpus: &mut Corpus,
        boxes: &Boxes,
        axis: Axis,
        known: &mut FxHashSet<Skeleton>,
    ) -> f64 {
        let mut sequences: SmallVec<[(Sequence, u32, Class); 32]> =
            boxes.iter().map(|(class, count)| (corpus.sequence(class, axis), count, class)).collect();
        sequences.sort_unstable_by_key(|(sequence, ..)| *sequence);
        let mut bits = 0.0;
        let mut counts: SmallVec<[u32; 16]> = SmallVec::new();
        for equal in sequences.chunk_by(|(one, ..), (other, ..)| one == other) {
            let (sequence, _, class) = equal[0];
            bits += self.unknown_slices(corpus, class, axis, known) + RUN * f64::from(sequence.pieces);
            counts.push(equal.iter().map(|(_, count, _)| count).sum());
        }
        bits + ALTERNATIVE * (counts.len() - 1) as f64 + choice(counts.iter())
    }

    /// The bits of the slices of a class that are not known, which they are from now on.
    fn unknown_slices(
        &mut self,
        corpus: &mut Corpus,
        class: Class,
        axis: Axis,
        known: &mut FxHashSet<Skeleton>,
    ) -> f64 {
        let mut bits = 0.0;
        for (number, slice) in corpus.slices(class, axis).iter().enumerate() {
            if !corpus.is_spent() && known.insert(*slice) {
                let at = corpus.profile(class).starts(axis)[number];
                let class = corpus.part(class, axis, at, at + 1);
                bits += self.skeleton(corpus, class);
            }
        }
        bits
    }

    /// The bits of one shape without its sizes.
    fn skeleton(&mut self, corpus: &mut Corpus, class: Class) -> f64 {
        let profile = corpus.profile(class);
        let skeleton = profile.skeleton;
        if let Some(&known) = self.skeletons.get(&skeleton) {
            return known;
        }
        let long: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| profile.starts(*axis).len() > 1).collect();
        let bits = match long.as_slice() {
            [] => ROW + RUN,
            [axis] => ROW + RUN * f64::from(corpus.sequence(class, *axis).pieces),
            _ => {
                let across = |axis: &Axis| {
                    self.across(corpus, &Boxes::of([(class, 1)]), *axis, &mut FxHashSet::default())
                };
                long.iter().map(across).fold(f64::INFINITY, f64::min)
            }
        };
        if !corpus.is_spent() {
            self.skeletons.insert(skeleton, bits);
        }
        bits
    }
}

/// The bits of a row of cells that are drawn.
pub fn of_row(row: &Row) -> f64 {
    REPEAT + (ROW + RUN) * row.kinds.len() as f64 + row.model() + row.chance()
}

/// The bits of saying which of several things it is, for all occurrences together.
pub fn choice<'c>(counts: impl Iterator<Item = &'c u32> + Clone) -> f64 {
    let total: u32 = counts.clone().sum();
    counts.map(|count| f64::from(*count) * (f64::from(total) / f64::from(*count)).log2()).sum()
}

/// The bits of all planes that stand at no fixed distance from either end.
fn free(corpus: &Corpus, boxes: &Boxes) -> f64 {
    Axis::ALL.into_iter().map(|axis| free_across(corpus, boxes, axis)).sum()
}

fn free_across(corpus: &Corpus, boxes: &Boxes, axis: Axis) -> f64 {
    let starts = |class: Class| corpus.profile(class).starts(axis).len();
    let mut boxes: SmallVec<[(usize, Class, u32); 32]> =
        boxes.iter().map(|(class, count)| (starts(class), class, count)).collect();
    boxes.sort_unstable();
    let groups = boxes.chunk_by(|(one, ..), (other, ..)| one == other);
    groups.map(|group| free_planes(corpus, group, axis)).sum()
}

/// The bits of the planes in boxes with as many each: no more than those of a share, if all stand by shares.
fn free_planes(corpus: &Corpus, group: &[(usize, Class, u32)], axis: Axis) -> f64 {
    let bits = (1..group[0].0).map(|plane| free_plane(corpus, group, axis, plane)).sum::<f64>();
    if bits <= SHARES {
        return bits;
    }
    let lengths = |(_, class, count): &(usize, Class, u32)| {
        let profile = corpus.profile(*class);
        let ends = profile.starts(axis).iter().skip(1).copied().chain([profile.len(axis)]);
        (profile.starts(axis).iter().zip(ends).map(|(low, high)| high - low).collect(), *count)
    };
    let seen: Vec<Seen> = group.iter().map(lengths).collect();
    if laws::shared(&seen).is_some() { SHARES } else { bits }
}

/// The bits of the plane of that number in boxes with as many planes each.
fn free_plane(corpus: &Corpus, group: &[(usize, Class, u32)], axis: Axis, plane: usize) -> f64 {
    let distances = |of: fn(i32, i32) -> i32| {
        let distance = |(_, class, _): &(usize, Class, u32)| {
            let profile = corpus.profile(*class);
            of(profile.starts(axis)[plane], profile.len(axis))
        };
        distinct(group.iter().map(distance).collect())
    };
    match distances(|at, _| at).min(distances(|at, len| len - at)) {
        1 => 0.0,
        values => {
            let count: u32 = group.iter().map(|(.., count)| count).sum();
            FREE + f64::from(count) * (values as f64).log2()
        }
    }
}

fn distinct(mut numbers: SmallVec<[i32; 32]>) -> usize {
    numbers.sort_unstable();
    numbers.dedup();
    numbers.len()
}
