//! All boxes that one rule stands for.

use super::corpus::{Class, Corpus};
use crate::space::Axis;
use smallvec::SmallVec;
use std::rc::Rc;

/// Classes with how often each occurs, in order of their numbers.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Boxes(Rc<[(Class, u32)]>);

impl Boxes {
    pub fn of(boxes: impl IntoIterator<Item = (Class, u32)>) -> Boxes {
        let mut all: SmallVec<[(Class, u32); 32]> = boxes.into_iter().collect();
        all.sort_unstable_by_key(|(class, _)| *class);
        all.dedup_by(|(class, count), (known, sum)| {
            let is_known = class == known;
            *sum += if is_known { *count } else { 0 };
            is_known
        });
        Boxes(Rc::from(all.as_slice()))
    }

    pub fn classes(&self) -> impl Iterator<Item = Class> + Clone + '_ {
        self.0.iter().map(|(class, _)| *class)
    }

    /// The classes with how often each occurs.
    pub fn iter(&self) -> impl Iterator<Item = (Class, u32)> + Clone + '_ {
        self.0.iter().copied()
    }

    /// Every class by itself.
    pub fn each(&self) -> Vec<Boxes> {
        self.iter().map(|own| Boxes::of([own])).collect()
    }

    /// How many boxes there are.
    pub fn count(&self) -> u32 {
        self.0.iter().map(|(_, count)| count).sum()
    }

    /// How many differ.
    pub fn kinds(&self) -> usize {
        self.0.len()
    }

    pub fn first(&self) -> Class {
        self.0[0].0
    }

    /// The terminal that all of them are full of.
    pub fn fill(&self, corpus: &Corpus) -> Option<u32> {
        let is_uniform = self.classes().all(|class| corpus.profile(class).is_uniform());
        let terminal = corpus.terminal(self.first());
        (is_uniform && self.classes().all(|class| corpus.terminal(class) == terminal)).then_some(terminal)
    }

    /// Whether every box is one slice across an axis, or several equal ones, of more than one block.
    pub fn is_slice(&self, corpus: &Corpus, axis: Axis) -> bool {
        self.classes().all(|class| {
            let profile = corpus.profile(class);
            profile.starts(axis).len() == 1 && !profile.is_uniform()
        })
    }

    /// The parts of all boxes between two bounds, which are told by class.
    pub fn parts(
        &self,
        corpus: &mut Corpus,
        axis: Axis,
        mut bounds: impl FnMut(&Corpus, Class) -> (i32, i32),
    ) -> Boxes {
        let parts = self.iter().map(|(class, count)| {
            let (low, high) = bounds(corpus, class);
            (corpus.part(class, axis, low, high), count)
        });
        Boxes::of(parts)
    }
}
