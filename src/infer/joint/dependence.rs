//! Whether parts of boxes go together: what varied together in the examples must not be drawn apart.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Profile};
use super::groups::materials;
use super::repeats::Period;
use super::slopes::Slope;
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
pub type Row = (Vec<Class>, u32);

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

/// The bits of drawing freely where a plane stands, if that goes together with what is before or behind it: as it does
/// where one of two wings of other widths stands at the end.
pub fn placed(corpus: &mut Corpus, rows: &[Row], axis: Axis) -> f64 {
    let counts: Vec<u32> = rows.iter().map(|(_, count)| *count).collect();
    let of_side = |corpus: &mut Corpus, side: usize| {
        let lens: Vec<i32> = rows.iter().map(|(parts, _)| corpus.profile(parts[side]).len(axis)).collect();
        let labels: Vec<u64> = rows.iter().map(|(parts, _)| materials(corpus, parts[side])).collect();
        by_threshold(&lens, &labels, &counts)
    };
    of_side(corpus, 0) + of_side(corpus, 1)
}

/// The bits of drawing the lengths of some parts of splits, if that goes together with what these parts are made of.
pub fn of_lengths(corpus: &mut Corpus, rows: &[Row], axis: Axis, drawn: &[usize]) -> f64 {
    let counts: Vec<u32> = rows.iter().map(|(_, count)| *count).collect();
    let of_part = |part: &usize| {
        let lens: Vec<i32> = rows.iter().map(|(parts, _)| corpus.profile(parts[*part]).len(axis)).collect();
        let labels: Vec<u64> = rows.iter().map(|(parts, _)| materials(corpus, parts[*part])).collect();
        by_threshold(&lens, &labels, &counts)
    };
    drawn.iter().map(of_part).sum()
}

/// The bits for numbers and labels, the numbers told apart by the threshold that tells most of the labels.
fn by_threshold(numbers: &[i32], labels: &[u64], counts: &[u32]) -> f64 {
    let mut thresholds = numbers.to_vec();
    thresholds.sort_unstable();
    thresholds.dedup();
    let tries = (thresholds.len() as f64).ln();
    let above =
        |threshold: &i32| -> Vec<u64> { numbers.iter().map(|own| u64::from(own >= threshold)).collect() };
    let told = thresholds.iter().skip(1).map(|threshold| shared(&above(threshold), labels, counts, tries));
    told.fold(0.0, f64::max)
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
            let by = |labels: &[Vec<u64>]| shared(&labels[one], &labels[other], &counts, 0.0);
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

/// The bits for one pair of labels: none if they are independent as far as so few boxes tell. `tries` are the nats of
/// saying which of several pairs it is.
fn shared(one: &[u64], other: &[u64], counts: &[u32], tries: f64) -> f64 {
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
    let is_told = is_told(mutual, [a, b], total, tries);
    if is_one_to_one || is_told { PENALTY + mutual } else { 0.0 }
}

/// Whether labels that are so many tell so many bits of one another that it is no chance, by the Bayesian
/// information criterion, in nats; more so by `tries` where so much was tried.
fn is_told(mutual: f64, labels: [f64; 2], total: u32, tries: f64) -> bool {
    let [a, b] = labels;
    let chance = (a - 1.0) * (b - 1.0) / 2.0 * f64::from(total).ln() + tries;
    a > 1.0 && b > 1.0 && mutual * std::f64::consts::LN_2 > chance
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
    is_told(mutual, [&ones, &others].map(|counts| counts.0.len() as f64), total, 0.0)
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

/// The bits that it costs to draw the units of repeats apart: from their neighbours, and from whether they are the
/// first or the last one.
pub fn of_units(corpus: &mut Corpus, repeats: &[Row], axis: Axis) -> f64 {
    let pair =
        |(units, count): &Row| units.windows(2).map(|pair| (pair.to_vec(), *count)).collect::<Vec<Row>>();
    let pairs: Vec<Row> = repeats.iter().flat_map(pair).collect();
    let ends = [false, true].map(|is_last| at_end(corpus, repeats, is_last));
    dependence(corpus, &pairs, axis) + ends[0] + ends[1]
}

/// The bits that it costs to draw the cells of rows apart, which stand beside one another only as they were seen to.
pub fn of_cells(corpus: &mut Corpus, rows: &[Row], axis: Axis) -> f64 {
    let pair =
        |(cells, count): &Row| cells.windows(2).map(|pair| (pair.to_vec(), *count)).collect::<Vec<Row>>();
    let pairs: Vec<Row> = rows.iter().flat_map(pair).collect();
    let is_torn = |pair: &Row| corpus.fit(pair.0[0], pair.0[1], axis) == Some(false);
    let torn = if pairs.iter().any(is_torn) { TORN } else { 0.0 };
    torn + told(corpus, &pairs) + at_end(corpus, rows, false) + at_end(corpus, rows, true)
}

/// The bits that it costs to draw the courses of slopes apart: from the ones above, from all that is above, and from
/// whether they are the first one.
pub fn of_courses(corpus: &mut Corpus, boxes: &Boxes, slope: &Slope) -> f64 {
    let (mut seams, mut pairs, mut courses): (Vec<Row>, Vec<Row>, Vec<Row>) = Default::default();
    for (class, count) in boxes.iter() {
        let own = slope.seams_of(corpus, class).into_iter();
        seams.extend(own.map(|seam| (seam.to_vec(), count)));
        let own = slope.courses_of(corpus, class);
        pairs.extend(own.windows(2).map(|pair| (pair.to_vec(), count)));
        courses.push((own, count));
    }
    let torn = if all_fit(corpus, &seams, Axis::Y, 1) { 0.0 } else { TORN };
    torn + told(corpus, &pairs) + at_end(corpus, &courses, false) + at_end(corpus, &courses, true)
}

/// The bits that units tell of whether they stand at an end.
fn at_end(corpus: &mut Corpus, repeats: &[Row], is_last: bool) -> f64 {
    let mut units: Vec<(Class, bool, u32)> = Vec::new();
    for (row, count) in repeats {
        let end = if is_last { row.len() - 1 } else { 0 };
        units.extend(row.iter().enumerate().map(|(number, unit)| (*unit, number == end, *count)));
    }
    let shapes = ends_told(&units, |class| u64::from(corpus.profile(class).skeleton.0));
    shapes.max(ends_told(&units, |class| materials(corpus, class)))
}

/// The bits that labels of units tell of their ends: none unless each label comes at the end alone or never, and
/// labels come more than once on average.
fn ends_told(units: &[(Class, bool, u32)], mut label: impl FnMut(Class) -> u64) -> f64 {
    let (mut ends, mut labels, mut both) = (Counts::default(), Counts::default(), Counts::default());
    for (class, is_end, count) in units {
        let (end, label) = (u64::from(*is_end), label(*class));
        ends.add((end, 0), *count);
        labels.add((label, 0), *count);
        both.add((label, end), *count);
    }
    let total: u32 = units.iter().map(|(.., count)| count).sum();
    let is_told = ends.0.len() == 2 && labels.0.len() == both.0.len() && 2 * both.0.len() <= total as usize;
    if is_told { PENALTY + ends.entropy() } else { 0.0 }
}

/// The bits that it costs to draw units and the separators between them apart: each from the next one, from the next of
/// its kind, and units from whether they are the first or the last one.
pub fn of_alternation(corpus: &mut Corpus, rows: &[Row], axis: Axis) -> f64 {
    let next = |first: usize, step: usize| -> Vec<Row> {
        let of_row = |(parts, count): &Row| {
            let ones = parts.iter().skip(first).step_by(2);
            let pairs = ones.zip(parts.iter().skip(first + step).step_by(2));
            pairs.map(|(one, other)| (vec![*one, *other], *count)).collect::<Vec<Row>>()
        };
        rows.iter().flat_map(of_row).collect()
    };
    let beside = [next(0, 1), next(1, 1)].map(|pairs| dependence(corpus, &pairs, axis));
    let alike =
        [next(0, 2), next(1, 2)].map(|pairs| if pairs.len() < 2 { 0.0 } else { told(corpus, &pairs) });
    let units = rows.iter().map(|(parts, count)| (parts.iter().copied().step_by(2).collect(), *count));
    let units: Vec<Row> = units.collect();
    let ends = [false, true].map(|is_last| at_end(corpus, &units, is_last));
    beside.iter().chain(&alike).chain(&ends).sum()
}

/// The bits that materials tell of the sizes of what is made of them: of where the planes stand that show a change, if
/// all boxes show as many on an axis; else of how many there are, if all are equally long. How long boxes are was decided
/// before. One rule for all of them would make what no example shows.
pub fn of_calls(corpus: &Corpus, called: &[(u64, Class, u32)]) -> f64 {
    let labels: Vec<u64> = called.iter().map(|(label, ..)| *label).collect();
    let counts: Vec<u32> = called.iter().map(|(.., count)| *count).collect();
    let profiles: Vec<&Profile> = called.iter().map(|(_, class, _)| corpus.profile(*class)).collect();
    let told = |number: &dyn Fn(&Profile) -> i32| {
        let numbers: Vec<i32> = profiles.iter().map(|profile| number(profile)).collect();
        by_threshold(&numbers, &labels, &counts)
    };
    let across = |axis: Axis| {
        let is_one = |number: &dyn Fn(&Profile) -> i32| {
            profiles.windows(2).all(|pair| number(pair[0]) == number(pair[1]))
        };
        let planes = |profile: &Profile| profile.starts(axis).len() as i32;
        let len = |profile: &Profile| profile.len(axis);
        match (is_one(&planes), is_one(&len)) {
            (true, _) => {
                let all = profiles.first().map_or(1, |profile| profile.starts(axis).len());
                let standing = (1..all).map(|plane| {
                    let from_start = told(&|profile| profile.starts(axis)[plane]);
                    from_start.min(told(&|profile| profile.len(axis) - profile.starts(axis)[plane]))
                });
                standing.fold(0.0, f64::max)
            }
            (false, true) => told(&planes),
            (false, false) => 0.0,
        }
    };
    let told = Axis::ALL.into_iter().map(across).fold(0.0, f64::max);
    if told > 0.0 { TORN } else { 0.0 }
}

/// The units of repeats, one row a box.
pub fn units(corpus: &mut Corpus, boxes: &Boxes, period: Period) -> Vec<Row> {
    let row = |(class, count): (Class, u32)| {
        let starts: Vec<i32> = period.starts(corpus.profile(class).len(period.axis)).collect();
        let unit = |at: &i32| corpus.part(class, period.axis, *at, at + period.unit);
        (starts.iter().map(unit).collect(), count)
    };
    boxes.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::super::corpus::Place;
    use super::super::volume::Volume;
    use super::*;
    use crate::space::Bounds;
    use ndarray::Array3;
    use proptest::prelude::*;

    /// The classes of columns of stone of these heights under air, each nine cells high.
    fn columns(heights: &[i32]) -> (Corpus, Vec<Class>) {
        let column = |height: &i32| {
            let cells = (0..9).map(|y| if y < *height { 1 } else { 0 }).collect();
            Volume::new(Array3::from_shape_vec((9, 1, 1), cells).unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(heights.iter().map(column).collect(), 0);
        let places: Vec<Place> = corpus.examples();
        let classes = places.into_iter().map(|place| corpus.class(place)).collect();
        (corpus, classes)
    }

    proptest! {
        /// Heights that are drawn for every material alike tell nothing of it; ranges that do not meet do.
        #[test]
        fn sizes_that_go_by_the_material_are_not_drawn_apart(low in 1i32..3, more in 1i32..3, times in 6u32..20) {
            let heights: Vec<i32> = (low..=low + more).chain(low + more + 1..=low + 2 * more + 1).collect();
            let (corpus, classes) = columns(&heights);
            let half = heights.len() / 2;
            let own = classes.iter().enumerate().map(|(at, class)| (u64::from(at < half), *class, times));
            prop_assert!(of_calls(&corpus, &own.collect::<Vec<_>>()) > PENALTY);
            let both = classes.iter().flat_map(|class| [0, 1].map(|label| (label, *class, times)));
            prop_assert_eq!(of_calls(&corpus, &both.collect::<Vec<_>>()), 0.0);
        }
    }

    #[test]
    fn lengths_that_go_by_what_a_part_is_made_of_are_not_drawn() {
        // Low hedges and high walls, each with air above.
        let column = |block: u32, height: i32| {
            let cells = (0..9).map(|y| if y < height { block } else { 0 }).collect();
            Volume::new(Array3::from_shape_vec((9, 1, 1), cells).unwrap_or_default(), &[])
        };
        let cost = |kinds: &[(u32, i32)]| {
            let volumes = kinds.iter().map(|(block, height)| column(*block, *height)).collect();
            let mut corpus = Corpus::new(volumes, 0);
            let parts = corpus.examples().into_iter().zip(kinds).map(|(place, (_, height))| {
                let Bounds { min, .. } = place.bounds;
                let part = |low, high| Place { bounds: place.bounds.slab(Axis::Y, low, high), ..place };
                [part(min.y, min.y + height), part(min.y + height, 9)]
            });
            let parts: Vec<[Place; 2]> = parts.collect();
            let rows: Vec<Row> = parts
                .iter()
                .map(|parts| (parts.iter().map(|part| corpus.class(*part)).collect(), 9))
                .collect();
            of_lengths(&mut corpus, &rows, Axis::Y, &[0])
        };
        assert!(cost(&[(1, 1), (1, 2), (2, 5), (2, 6)]) > PENALTY);
        assert_eq!(cost(&[(1, 1), (1, 5), (2, 1), (2, 5)]), 0.0);
    }

    #[test]
    fn labels_tell_of_one_another_where_so_many_boxes_agree() {
        assert!(tells(&[(0, 7, 10), (1, 8, 10)]));
        assert!(!tells(&[(0, 7, 10), (0, 8, 9), (1, 7, 9), (1, 8, 10)]));
        // Of two boxes each is something else.
        assert!(!tells(&[(0, 7, 1), (0, 8, 1), (1, 8, 1)]));
        assert!(!tells(&[(0, 7, 30), (1, 7, 40)]));
    }
}
