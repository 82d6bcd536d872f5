//! Units of one length with a separator of one length between any two, which fill boxes: lot, street, lot.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::dependence::Row;
use crate::space::Axis;

/// This share of the planes between units and separators has to show a change.
const SHOWN: f64 = 0.5;

/// An alternation that all boxes can be described by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Alternation {
    pub axis: Axis,
    /// The length of a unit, and of what stands between two.
    pub unit: i32,
    pub between: i32,
}

impl Alternation {
    /// Every alternation of the boxes with two units in each box at least, and separators that are no longer than
    /// units. Two units without anything to tell them by are but the sides of something.
    pub fn of(corpus: &Corpus, boxes: &Boxes) -> Vec<Alternation> {
        let mut found = Vec::new();
        for axis in Axis::ALL {
            let shortest = boxes.classes().map(|class| corpus.profile(class).len(axis)).min().unwrap_or(0);
            let varied = boxes.classes().any(|class| corpus.profile(class).starts(axis).len() > 2);
            let periods = if varied { 2..shortest } else { 0..0 };
            let alternations = periods.filter_map(|period| {
                let unit = rest(corpus, boxes, axis, period)?;
                Some(Alternation { axis, unit, between: period - unit })
            });
            found.extend(alternations.filter(|own| {
                (1..=own.unit).contains(&own.between)
                    && own.is_shown(corpus, boxes)
                    && own.is_told(corpus, boxes)
                    && own.spares_wholes(corpus, boxes)
            }));
        }
        found
    }

    /// The length of a unit with what stands behind it.
    pub fn period(&self) -> i32 {
        self.unit + self.between
    }

    /// Where separators begin in a box of that length.
    pub fn gaps(&self, len: i32) -> impl Iterator<Item = i32> + Clone + use<> {
        (self.unit..len).step_by(self.period() as usize)
    }

    /// All planes in a box of that length.
    pub fn planes(&self, len: i32) -> impl Iterator<Item = i32> + use<> {
        let between = self.between;
        self.gaps(len).flat_map(move |at| [at, at + between])
    }

    /// The units and separators of all boxes, one row a box, in order.
    pub fn rows(&self, corpus: &mut Corpus, boxes: &Boxes) -> Vec<Row> {
        let rows = boxes.iter().map(|(class, count)| {
            let len = corpus.profile(class).len(self.axis);
            let ends: Vec<i32> = std::iter::once(0).chain(self.planes(len)).chain([len]).collect();
            let parts = ends.windows(2).map(|ends| corpus.part(class, self.axis, ends[0], ends[1]));
            (parts.collect(), count)
        });
        rows.collect()
    }

    fn is_shown(&self, corpus: &Corpus, boxes: &Boxes) -> bool {
        let (mut shown, mut all) = (0, 0);
        for class in boxes.classes() {
            let profile = corpus.profile(class);
            let starts = profile.starts(self.axis);
            for at in self.planes(profile.len(self.axis)) {
                all += 1;
                shown += u32::from(starts.binary_search(&at).is_ok());
            }
        }
        f64::from(shown) >= SHOWN * f64::from(all)
    }

    /// Whether some box has three units, or some unit changes along the axis.
    fn is_told(&self, corpus: &Corpus, boxes: &Boxes) -> bool {
        boxes.classes().any(|class| {
            let profile = corpus.profile(class);
            let is_in_unit = |at: &i32| (1..self.unit).contains(&(at % self.period()));
            profile.len(self.axis) > self.unit + self.period()
                || profile.starts(self.axis).iter().any(is_in_unit)
        })
    }

    fn spares_wholes(&self, corpus: &Corpus, boxes: &Boxes) -> bool {
        boxes.classes().all(|class| {
            let len = corpus.profile(class).len(self.axis);
            self.planes(len).all(|at| !corpus.is_whole_across(class, self.axis, at))
        })
    }
}

/// What a period leaves of all boxes alike.
fn rest(corpus: &Corpus, boxes: &Boxes, axis: Axis, period: i32) -> Option<i32> {
    let mut rests = boxes.classes().map(|class| corpus.profile(class).len(axis) % period);
    let first = rests.next()?;
    (first > 0 && rests.all(|rest| rest == first)).then_some(first)
}

/// The units of rows, and what stands between them.
pub fn units_and_separators(rows: &[Row]) -> [Boxes; 2] {
    [0, 1].map(|first| {
        let of_row = |(parts, count): &Row| {
            let own = parts.iter().skip(first).step_by(2);
            own.map(|part| (*part, *count)).collect::<Vec<_>>()
        };
        Boxes::of(rows.iter().flat_map(of_row))
    })
}

#[cfg(test)]
mod tests {
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;
    use proptest::prelude::*;

    fn corpus(rows: &[Vec<u32>]) -> (Corpus, Boxes) {
        let volume = |row: &Vec<u32>| {
            let cells = Array3::from_shape_vec((1, 1, row.len()), row.clone());
            Volume::new(cells.unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(rows.iter().map(volume).collect(), 0);
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        (corpus, boxes)
    }

    proptest! {
        /// Whatever stands on the lots: if streets are seen beside them, three lots and more are found.
        #[test]
        fn lots_between_streets_are_found(
            lots in prop::collection::vec(prop::collection::vec(2u32..9, 3..6), 1..4),
            unit in 2i32..6,
            between in 1i32..3,
        ) {
            let between = between.min(unit);
            let row = |lots: &Vec<u32>| -> Vec<u32> {
                let lot = |lot: &u32| std::iter::repeat_n(*lot, unit as usize).collect::<Vec<u32>>();
                let street = vec![1; between as usize];
                lots.iter().map(lot).collect::<Vec<Vec<u32>>>().join(&street[..])
            };
            let rows: Vec<Vec<u32>> = lots.iter().map(row).collect();
            let (mut corpus, boxes) = corpus(&rows);
            let wanted = Alternation { axis: Axis::X, unit, between };
            prop_assert!(Alternation::of(&corpus, &boxes).contains(&wanted));
            let rows = wanted.rows(&mut corpus, &boxes);
            let [units, separators] = units_and_separators(&rows);
            prop_assert!(units.classes().all(|class| corpus.profile(class).len(Axis::X) == unit));
            prop_assert_eq!(separators.fill(&corpus), Some(1));
        }
    }
}
