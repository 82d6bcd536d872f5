//! Alternatives that may stand only where a scope is as long as they were seen.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::feasible::Lengths;
use crate::space::Axis;
use rustc_hash::FxHashSet;

/// What was made for some boxes and may stand only where a scope is as long as they, by axis.
#[derive(Default, Debug)]
pub struct Limits(FxHashSet<(Boxes, Axis)>);

impl Limits {
    /// Sets a limit; whether that is new.
    pub fn set(&mut self, boxes: &Boxes, axis: Axis) -> bool {
        self.0.insert((boxes.clone(), axis))
    }

    pub fn has(&self, boxes: &Boxes, axis: Axis) -> bool {
        self.0.contains(&(boxes.clone(), axis))
    }

    /// The lengths that an alternative may have beside others: those between the ones that were seen of it, and all that
    /// are not between the ones that were seen of another.
    pub fn lengths<'b>(
        &self,
        corpus: &Corpus,
        own: &Boxes,
        all: impl Iterator<Item = &'b Boxes>,
        axis: Axis,
    ) -> Lengths {
        if !self.has(own, axis) {
            return Lengths::ALL;
        }
        let others = all.map(|boxes| between(corpus, boxes, axis)).fold(Lengths::NONE, Lengths::or);
        between(corpus, own, axis).or(others.inverse())
    }
}

/// The lengths between those of boxes, these included.
pub fn between(corpus: &Corpus, boxes: &Boxes, axis: Axis) -> Lengths {
    let seen = || boxes.classes().map(|class| corpus.profile(class).len(axis));
    match (seen().min(), seen().max()) {
        (Some(low), Some(high)) => Lengths::of(low..=high),
        _ => Lengths::NONE,
    }
}
