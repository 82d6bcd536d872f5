//! Runs of units of one length that fill boxes, but for a few slices at their ends.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use crate::space::Axis;
use std::rc::Rc;

/// So many slices may stand before the first unit, and behind the last.
const MOST_BEFORE: i32 = 1;
const MOST_BEHIND: i32 = 2;
/// This share of the changes between slices has to come again one unit later.
const AGREE: f64 = 0.45;

/// A repeat that all boxes can be described by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Period {
    pub axis: Axis,
    pub before: i32,
    pub behind: i32,
    /// The length of a unit.
    pub unit: i32,
}

impl Period {
    /// Every period of the boxes.
    pub fn of(corpus: &mut Corpus, boxes: &Boxes) -> Vec<Period> {
        let ends = |axis| {
            (0..=MOST_BEFORE)
                .flat_map(move |before| (0..=MOST_BEHIND).map(move |behind| (axis, before, behind)))
        };
        let mut found = Vec::new();
        for axis in Axis::ALL {
            let varied = boxes.classes().any(|class| corpus.profile(class).starts(axis).len() > 2);
            if !varied {
                continue;
            }
            let slices: Vec<Rc<[Class]>> = boxes.classes().map(|class| corpus.row(class, axis)).collect();
            for (axis, before, behind) in ends(axis) {
                for unit in units(&slices, before, behind) {
                    let period = Period { axis, before, behind, unit };
                    if period.agrees(&slices) && period.spares_wholes(corpus, boxes) {
                        found.push(period);
                    }
                }
            }
        }
        found
    }

    /// What stands before the units, the units, and what stands behind; empty parts are left out.
    pub fn parts(&self, corpus: &mut Corpus, boxes: &Boxes) -> Vec<Boxes> {
        let Period { axis, before, behind, .. } = *self;
        let mut parts = Vec::new();
        if before > 0 {
            parts.push(boxes.parts(corpus, axis, |_, _| (0, before)));
        }
        parts.push(self.units(corpus, boxes));
        if behind > 0 {
            parts.push(boxes.parts(corpus, axis, |corpus, class| {
                let len = corpus.profile(class).len(axis);
                (len - behind, len)
            }));
        }
        parts
    }

    /// All units of all boxes.
    pub fn units(&self, corpus: &mut Corpus, boxes: &Boxes) -> Boxes {
        let mut units = Vec::new();
        for (class, count) in boxes.iter() {
            for at in self.starts(corpus.profile(class).len(self.axis)) {
                units.push((corpus.part(class, self.axis, at, at + self.unit), count));
            }
        }
        Boxes::of(units)
    }

    /// Where units start in a box of that length.
    pub fn starts(&self, len: i32) -> impl Iterator<Item = i32> + use<> {
        (self.before..len - self.behind).step_by(self.unit as usize)
    }

    /// Whether enough changes from slice to slice come again one unit later.
    fn agrees(&self, slices: &[Rc<[Class]>]) -> bool {
        let (mut equal, mut all) = (0, 0);
        for slices in slices {
            let inner = &slices[self.before as usize..slices.len() - self.behind as usize];
            let unit = self.unit as usize;
            let changes = |at: usize| at == 0 || inner[at] != inner[at - 1];
            let later = (unit..inner.len()).filter(|at| changes(*at));
            all += later.clone().count();
            equal += later.filter(|at| changes(at - unit) && inner[*at] == inner[at - unit]).count();
        }
        all > 0 && f64::from(equal as u32) >= AGREE * f64::from(all as u32)
    }

    fn spares_wholes(&self, corpus: &Corpus, boxes: &Boxes) -> bool {
        boxes.classes().all(|class| {
            let len = corpus.profile(class).len(self.axis);
            let planes = self.starts(len).chain([len - self.behind]).filter(|at| *at > 0 && *at < len);
            planes.into_iter().all(|at| !corpus.is_whole_across(class, self.axis, at))
        })
    }
}

/// The lengths that divide what all boxes have between their ends, where one of them has two units at least.
fn units(slices: &[Rc<[Class]>], before: i32, behind: i32) -> Vec<i32> {
    let inner: Vec<i32> = slices.iter().map(|slices| slices.len() as i32 - before - behind).collect();
    let longest = inner.iter().copied().max().unwrap_or(0);
    if inner.iter().any(|len| *len <= 0) {
        return Vec::new();
    }
    let divisor = inner.iter().copied().fold(0, gcd);
    (2..=longest / 2).filter(|unit| divisor % unit == 0).collect()
}

pub fn gcd(a: i32, b: i32) -> i32 {
    if b == 0 { a } else { gcd(b, a % b) }
}
