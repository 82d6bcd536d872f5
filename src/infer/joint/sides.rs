//! Boxes that begin and end with one of the same things, at one distance from both ends: a wall, what is between, and a
//! wall again.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, Skeleton};
use super::dependence::Row;
use crate::space::Axis;
use std::collections::BTreeSet;

/// Planes at one distance from both ends of every box, outside of which one rule stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sides {
    pub axis: Axis,
    pub thick: i32,
}

impl Sides {
    /// Every one whose planes show a change in some box and go through no whole of two blocks.
    pub fn of(corpus: &mut Corpus, boxes: &Boxes) -> Vec<Sides> {
        let mut found = Vec::new();
        for axis in Axis::ALL {
            let shortest = boxes.classes().map(|class| corpus.profile(class).len(axis)).min().unwrap_or(0);
            let thick = corpus.profile(boxes.first()).starts(axis)[1..].to_vec();
            let sides = thick.into_iter().map(|thick| Sides { axis, thick });
            let sides = sides.take_while(|sides| 2 * sides.thick < shortest);
            found.extend(sides.filter(|sides| sides.hold(corpus, boxes)));
        }
        found
    }

    /// Whether what stands at one end of the boxes stands at the other one too, of the same box or of another.
    fn hold(&self, corpus: &mut Corpus, boxes: &Boxes) -> bool {
        let ends: Option<Vec<[Skeleton; 2]>> =
            boxes.classes().map(|class| self.ends(corpus, class)).collect();
        let Some(ends) = ends else { return false };
        let [low, high] = [0, 1].map(|end| ends.iter().map(|ends| ends[end]).collect::<BTreeSet<Skeleton>>());
        low.is_subset(&high) || high.is_subset(&low)
    }

    /// What both ends are but for their sizes; nothing where a plane goes through a whole of two blocks.
    fn ends(&self, corpus: &mut Corpus, class: Class) -> Option<[Skeleton; 2]> {
        let len = corpus.profile(class).len(self.axis);
        let spares = self.planes(len).iter().all(|at| !corpus.is_whole_across(class, self.axis, *at));
        let ends = [(0, self.thick), (len - self.thick, len)];
        spares.then(|| {
            ends.map(|(low, high)| {
                let end = corpus.part(class, self.axis, low, high);
                corpus.profile(end).skeleton
            })
        })
    }

    /// Where the middle starts and ends in a box of that length.
    pub fn planes(&self, len: i32) -> [i32; 2] {
        [self.thick, len - self.thick]
    }

    /// The parts of every box, one row a box.
    pub fn rows(&self, corpus: &mut Corpus, boxes: &Boxes) -> Vec<Row> {
        let row = |(class, count)| {
            let len = corpus.profile(class).len(self.axis);
            let [low, high] = self.planes(len);
            let mut part = |low, high| corpus.part(class, self.axis, low, high);
            (vec![part(0, low), part(low, high), part(high, len)], count)
        };
        boxes.iter().map(row).collect()
    }

    /// The sides and the middles of all boxes.
    pub fn parts(&self, corpus: &mut Corpus, boxes: &Boxes) -> [Boxes; 2] {
        let rows = self.rows(corpus, boxes);
        let sides = rows.iter().flat_map(|(parts, count)| [(parts[0], *count), (parts[2], *count)]);
        [Boxes::of(sides), Boxes::of(rows.iter().map(|(parts, count)| (parts[1], *count)))]
    }
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
        let own = Sides { axis: Axis::X, thick: 2 };
        assert_eq!(sides, [own]);
        let [sides, middles] = own.parts(&mut corpus, &boxes);
        assert_eq!((sides.kinds(), sides.count()), (1, 4));
        assert_eq!(middles.kinds(), 2);
    }

    #[test]
    fn what_stands_at_one_end_and_never_at_the_other_is_no_side() {
        assert_eq!(sides_of(&[&[1, 2, 1], &[1, 2, 3], &[4, 2, 1]]).2, []);
        assert_eq!(sides_of(&[&[1, 2, 1], &[1, 2, 3], &[3, 2, 1]]).2, [Sides { axis: Axis::X, thick: 1 }]);
        assert_eq!(sides_of(&[&[1, 2, 2, 1], &[1, 1]]).2, []);
    }
}
