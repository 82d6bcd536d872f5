//! Alternatives that may stand only where a scope is as long as they were seen.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::feasible::Lengths;
use crate::space::Axis;
use rustc_hash::FxHashMap;

/// Which lengths are those of some boxes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Where {
    /// All from the shortest to the longest of them.
    Between,
    /// Only those that they have themselves.
    Seen,
}

/// What was made for some boxes and may stand only where a scope is as long as they, by axis.
#[derive(Default, Debug)]
pub struct Limits(FxHashMap<(Boxes, Axis), Where>);

impl Limits {
    /// Sets a limit; whether that is new.
    pub fn set(&mut self, boxes: &Boxes, axis: Axis, lengths: Where) -> bool {
        let before = self.0.get(&(boxes.clone(), axis)).copied();
        let is_new = before.is_none_or(|before| before < lengths);
        if is_new {
            self.0.insert((boxes.clone(), axis), lengths);
        }
        is_new
    }

    pub fn has(&self, boxes: &Boxes, axis: Axis) -> bool {
        self.0.contains_key(&(boxes.clone(), axis))
    }

    /// The lengths that an alternative may have beside others: those that were seen of it, or all between them, and all that
    /// are not between the ones that were seen of another.
    pub fn lengths<'b>(
        &self,
        corpus: &Corpus,
        own: &Boxes,
        all: impl Iterator<Item = &'b Boxes>,
        axis: Axis,
    ) -> Lengths {
        let seen = match self.0.get(&(own.clone(), axis)) {
            None => return Lengths::ALL,
            Some(Where::Between) => between(corpus, own, axis),
            Some(Where::Seen) => Lengths::of(own.classes().map(|class| corpus.profile(class).len(axis))),
        };
        let others = all.map(|boxes| between(corpus, boxes, axis)).fold(Lengths::NONE, Lengths::or);
        seen.or(others.inverse())
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
