//! Boxes that begin and end with one of the same things, at one distance from both ends or with even shares of what the
//! middle leaves: a wall, what is between, and a wall again.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Skeleton};
use super::dependence::Row;
use super::laws::{self, Seen};
use super::planes::FIXED;
use crate::space::Axis;
use std::collections::BTreeSet;

/// Where the middle of each class starts and ends, in order; one rule stands on both sides of it.
#[derive(Clone, PartialEq, Debug)]
pub struct Sides {
    pub axis: Axis,
    pub middles: Vec<[i32; 2]>,
    /// The bits of saying so.
    pub bits: f64,
}

impl Sides {
    /// Every one whose planes show a change in some box and go through no whole of two blocks.
    pub fn of(corpus: &mut Corpus, boxes: &Boxes) -> Vec<Sides> {
        let ways = Axis::ALL.into_iter().flat_map(|axis| {
            let fixed = fixed(corpus, boxes, axis);
            fixed.into_iter().chain(shared(corpus, boxes, axis)).collect::<Vec<Sides>>()
        });
        let ways: Vec<Sides> = ways.collect();
        ways.into_iter().filter(|sides| sides.hold(corpus, boxes)).collect()
    }

    /// Whether what stands at one end of the boxes stands at the other one too, of the same box or of another.
    fn hold(&self, corpus: &mut Corpus, boxes: &Boxes) -> bool {
        let ends =
            boxes.classes().zip(&self.middles).map(|(class, middle)| self.ends(corpus, class, *middle));
        let ends: Option<Vec<[Skeleton; 2]>> = ends.collect();
        let Some(ends) = ends else { return false };
        let [low, high] = [0, 1].map(|end| ends.iter().map(|ends| ends[end]).collect::<BTreeSet<Skeleton>>());
        low.is_subset(&high) || high.is_subset(&low)
    }

    /// What both ends are but for their sizes; nothing where a plane goes through a whole of two blocks.
    fn ends(&self, corpus: &mut Corpus, class: Class, [low, high]: [i32; 2]) -> Option<[Skeleton; 2]> {
        let len = corpus.profile(class).len(self.axis);
        let spares = [low, high].into_iter().all(|at| !corpus.is_whole_across(class, self.axis, at));
        spares.then(|| {
            [(0, low), (high, len)].map(|(low, high)| {
                let end = corpus.part(class, self.axis, low, high);
                corpus.profile(end).skeleton
            })
        })
    }

    /// The parts of every box, one row a box.
    pub fn rows(&self, corpus: &mut Corpus, boxes: &Boxes) -> Vec<Row> {
        let row = |((class, count), [low, high]): ((Class, u32), &[i32; 2])| {
            let len = corpus.profile(class).len(self.axis);
            let mut part = |low, high| corpus.part(class, self.axis, low, high);
            (vec![part(0, *low), part(*low, *high), part(*high, len)], count)
        };
        boxes.iter().zip(&self.middles).map(row).collect()
    }

    /// The sides and the middles of all boxes.
    pub fn parts(&self, corpus: &mut Corpus, boxes: &Boxes) -> [Boxes; 2] {
        let rows = self.rows(corpus, boxes);
        let sides = rows.iter().flat_map(|(parts, count)| [(parts[0], *count), (parts[2], *count)]);
        [Boxes::of(sides), Boxes::of(rows.iter().map(|(parts, count)| (parts[1], *count)))]
    }
}

/// Those of one thickness.
fn fixed(corpus: &Corpus, boxes: &Boxes, axis: Axis) -> Vec<Sides> {
    let lens: Vec<i32> = boxes.classes().map(|class| corpus.profile(class).len(axis)).collect();
    let shortest = lens.iter().copied().min().unwrap_or(0);
    let thick = corpus.profile(boxes.first()).starts(axis)[1..].iter();
    let thick = thick.take_while(|thick| 2 * **thick < shortest);
    let sides = thick.map(|thick| Sides {
        axis,
        middles: lens.iter().map(|len| [*thick, len - thick]).collect(),
        bits: 2.0 * FIXED,
    });
    sides.collect()
}

/// Those between changes of one number from either end, of which both share what the middle leaves.
fn shared(corpus: &Corpus, boxes: &Boxes, axis: Axis) -> Vec<Sides> {
    let profiles = || boxes.iter().map(|(class, count)| (corpus.profile(class), count));
    let fewest = profiles().map(|(profile, _)| profile.starts(axis).len()).min().unwrap_or(0);
    let sides = (1..=fewest.saturating_sub(1) / 2).filter_map(|number| {
        let middle = |starts: &[i32]| [starts[number], starts[starts.len() - number]];
        let middles: Vec<[i32; 2]> = profiles().map(|(profile, _)| middle(profile.starts(axis))).collect();
        let seen = profiles().zip(&middles);
        let seen = seen
            .map(|((profile, count), [low, high])| (vec![*low, high - low, profile.len(axis) - high], count));
        let seen: Vec<Seen> = seen.collect();
        let varies = seen.iter().any(|(lengths, _)| lengths[0] != seen[0].0[0]);
        let bits = if varies { 2.0 * FIXED + laws::sharing(&seen) } else { f64::INFINITY };
        bits.is_finite().then_some(Sides { axis, middles, bits })
    });
    sides.collect()
}

#[cfg(test)]
mod tests {
    use super::super::corpus::Place;
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;

    fn row(cells: &[u32]) -> Volume {
        Volume::new(Array3::from_shape_vec((1, 1, cells.len()), cells.to_vec()).unwrap_or_default(), &[])
    }

    fn sides_of(rows: &[&[u32]]) -> (Corpus, Boxes, Vec<Sides>) {
        let mut corpus = Corpus::new(rows.iter().map(|cells| row(cells)).collect(), 0);
        let places: Vec<Place> = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        let sides = Sides::of(&mut corpus, &boxes);
        (corpus, boxes, sides)
    }

    #[test]
    fn what_stands_at_both_ends_of_all_boxes_is_a_side() {
        let (mut corpus, boxes, sides) = sides_of(&[&[1, 2, 3, 1, 2], &[1, 2, 4, 4, 1, 2]]);
        let own = Sides { axis: Axis::X, middles: vec![[2, 3], [2, 4]], bits: 2.0 * FIXED };
        assert_eq!(sides, std::slice::from_ref(&own));
        let [sides, middles] = own.parts(&mut corpus, &boxes);
        assert_eq!((sides.kinds(), sides.count()), (1, 4));
        assert_eq!(middles.kinds(), 2);
    }

    #[test]
    fn what_stands_at_one_end_and_never_at_the_other_is_no_side() {
        assert_eq!(sides_of(&[&[1, 2, 1], &[1, 2, 3], &[4, 2, 1]]).2, []);
        assert_eq!(sides_of(&[&[1, 2, 1], &[1, 2, 3], &[3, 2, 1]]).2.len(), 1);
        assert_eq!(sides_of(&[&[1, 2, 2, 1], &[1, 1]]).2, []);
    }

    #[test]
    fn sides_may_share_what_the_middle_leaves() {
        let middle =
            |rows: &[&[u32]]| sides_of(rows).2.into_iter().map(|sides| sides.middles).collect::<Vec<_>>();
        let window: &[&[u32]] = &[&[1, 2, 2, 1], &[1, 1, 2, 2, 1, 1], &[1, 1, 2, 2, 1, 1, 1]];
        assert!(middle(window).contains(&vec![[1, 3], [2, 4], [2, 4]]));
        let uneven: &[&[u32]] = &[&[1, 2, 2, 1], &[1, 2, 2, 1, 1, 1], &[1, 1, 2, 2, 1, 1]];
        assert!(!middle(uneven).contains(&vec![[1, 3], [1, 3], [2, 4]]));
    }
}
