//! How long a description of boxes will be, before it is searched for.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Skeleton};
use super::fold::{Token, folded};
use super::repeats::Period;
use crate::space::Axis;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// Bits of a row of cells, and of each of its runs.
const ROW: f64 = 5.5;
const RUN: f64 = 6.0;
/// Bits of one more alternative.
pub const ALTERNATIVE: f64 = 3.0;
/// Bits of a size that is left free, beside its values.
const FREE: f64 = 4.0;
/// Bits of a repeat.
pub const REPEAT: f64 = 7.0;

/// What was estimated, by what was asked.
#[derive(Default, Debug)]
pub struct Estimates {
    skeletons: FxHashMap<Skeleton, f64>,
    boxes: FxHashMap<Boxes, f64>,
}

impl Estimates {
    /// The bits of a description of `boxes`: on the best axis, those of every slice that differs, once for all
    /// boxes; those of the sequences of slices; of the choice between sequences; and of the planes that are free
    /// to move. Or those of the units that they repeat.
    pub fn bits(&mut self, corpus: &mut Corpus, boxes: &Boxes) -> f64 {
        if let Some(&known) = self.boxes.get(boxes) {
            return known;
        }
        let plain = self.plain(corpus, boxes);
        let repeats = Period::of(corpus, boxes);
        let repeated = repeats.into_iter().map(|period| {
            let parts = period.parts(corpus, boxes);
            REPEAT + parts.into_iter().map(|part| self.plain(corpus, &part)).sum::<f64>()
        });
        let bits = repeated.fold(plain, f64::min);
        self.boxes.insert(boxes.clone(), bits);
        bits
    }

    /// The bits of a choice between groups: slices that several groups show count once, since equal parts become
    /// one rule.
    pub fn alternatives(&mut self, corpus: &mut Corpus, groups: &[Boxes]) -> f64 {
        let mut known = FxHashSet::default();
        let mut bits = 0.0;
        for group in groups {
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

    fn plain(&mut self, corpus: &mut Corpus, boxes: &Boxes) -> f64 {
        if boxes.fill(corpus).is_some() {
            return ROW + RUN;
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
        let mut sequences: BTreeMap<Vec<Token>, u32> = BTreeMap::new();
        let mut bits = 0.0;
        for (class, count) in boxes.iter() {
            let slices = corpus.slices(class, axis);
            for (number, slice) in slices.iter().enumerate() {
                if known.insert(*slice) {
                    let at = corpus.profile(class).starts(axis)[number];
                    let class = corpus.part(class, axis, at, at + 1);
                    bits += self.skeleton(corpus, class);
                }
            }
            *sequences.entry(folded(&slices)).or_insert(0) += count;
        }
        let lengths: usize = sequences.keys().map(Vec::len).sum();
        bits + RUN * lengths as f64 + ALTERNATIVE * (sequences.len() - 1) as f64 + choice(sequences.values())
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
            [axis] => ROW + RUN * folded(&corpus.slices(class, *axis)).len() as f64,
            _ => {
                let across = |axis: &Axis| {
                    self.across(corpus, &Boxes::of([(class, 1)]), *axis, &mut FxHashSet::default())
                };
                long.iter().map(across).fold(f64::INFINITY, f64::min)
            }
        };
        self.skeletons.insert(skeleton, bits);
        bits
    }
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
    let mut groups: BTreeMap<usize, Vec<(Class, u32)>> = BTreeMap::new();
    for (class, count) in boxes.iter() {
        groups.entry(corpus.profile(class).starts(axis).len()).or_default().push((class, count));
    }
    let planes =
        groups.into_iter().flat_map(|(planes, group)| (1..planes).map(move |plane| (plane, group.clone())));
    planes
        .map(|(plane, group)| {
            let count: u32 = group.iter().map(|(_, count)| count).sum();
            let [from_start, from_end] = [false, true].map(|from_end| {
                let distance = |(class, _): &(Class, u32)| {
                    let profile = corpus.profile(*class);
                    let at = profile.starts(axis)[plane];
                    if from_end { profile.len(axis) - at } else { at }
                };
                group.iter().map(distance).collect::<std::collections::BTreeSet<i32>>().len()
            });
            match from_start.min(from_end) {
                1 => 0.0,
                values => FREE + f64::from(count) * (values as f64).log2(),
            }
        })
        .sum()
}
