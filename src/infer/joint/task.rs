//! One search for the shortest description of all examples: what samples of it show wrong is repaired, and what is one is
//! made one rule.

use super::blame::{self, Repair, Repairs, Suspects};
use super::boxes::Boxes;
use super::by_length::{self, Drawn};
use super::corpus::Corpus;
use super::emit::{self, Emitted};
use super::estimate::Estimates;
use super::explain::{Explainer, Search};
use super::limits::{Limits, Where};
use super::narrow::{self, Blamed};
use super::plan::{self, NodeId};
use super::pool;
use super::refit;
use super::samples::{FEW, Faulty, MANY, Shown};
use super::starts::Sizes;
use crate::infer::example::{Example, Terminals};
use crate::infer::{Freedom, Learnt};

/// So many steps are looked ahead.
const AHEAD: u8 = 1;
/// So often what is to blame is repaired.
const ROUNDS: usize = 100;

/// What is searched.
pub struct Task<'t> {
    pub open: &'t [Example],
    pub freedom: Freedom,
    pub shown: Shown,
}

/// What all searches find out of the examples.
pub struct Known {
    pub terminals: Terminals,
    pub corpus: Corpus,
    pub estimates: Estimates,
    /// How much of the work that may be done they have done.
    pub used: u64,
}

/// What is done first with the examples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum First {
    Any,
    /// They are told apart, by the choice of that number.
    Choice(usize),
}

/// What was learnt, and the bits of describing the examples by it.
pub struct Found {
    pub learnt: Learnt,
    pub bits: f64,
}

/// What a search came to.
pub struct Searched {
    /// The bits of what was estimated best, before anything was tried.
    pub outset: f64,
    pub found: Option<Found>,
}

impl Searched {
    /// Whether repairs took more bits than the search saved, or nothing was found.
    pub fn is_far_off(&self) -> bool {
        self.found.as_ref().is_none_or(|found| found.bits > self.outset)
    }
}

impl Task<'_> {
    /// The best description that one search finds. It goes on only if the bits at its outset are promising. `None` where
    /// they take too long to find, or where there is no such choice.
    pub fn search(
        &self,
        known: &mut Known,
        first: First,
        is_promising: impl Fn(f64) -> bool,
    ) -> Option<Searched> {
        let Known { terminals, corpus, estimates, used } = known;
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        let mut explainer = Explainer::new(corpus, estimates);
        if let First::Choice(number) = first {
            explainer.tell_apart_first(&boxes, number).then_some(())?;
        }
        let root = explainer.explain(&boxes, Search(0));
        let outset = plan::bits(&explainer.plan, explainer.corpus, root, &boxes);
        if first == First::Any && explainer.is_spent() {
            return None;
        }
        explainer.look_ahead(*used);
        let found =
            if is_promising(outset) { self.repaired(&mut explainer, terminals, &boxes) } else { None };
        *used += corpus.asked;
        Some(Searched { outset, found })
    }

    /// Explains the examples, and again after each repair of what samples show wrong, until they show nothing wrong.
    fn repaired(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &mut Terminals,
        boxes: &Boxes,
    ) -> Option<Found> {
        let mut limits = Limits::default();
        for _ in 0..ROUNDS {
            let root = explainer.explain_examples(boxes, Search(AHEAD));
            if explainer.is_spent() || explainer.tells_most_apart(root, boxes) {
                return None;
            }
            let came = match self.freedom {
                Freedom::Seen => self.narrowed(explainer, terminals, (root, boxes), &mut limits),
                Freedom::Free => Came::Sound(root),
            };
            match came {
                Came::Sound(root) => {
                    let (learnt, bits) = self.pooled(explainer, terminals, (root, boxes), &limits);
                    return self.shown.is_exceeded(&learnt.graph).then_some(Found { learnt, bits });
                }
                Came::Repaired => {}
                Came::Stuck => return None,
            }
        }
        None
    }

    /// Repairs what samples show wrong; where there is nothing mild to do, choices are narrowed until samples show nothing
    /// wrong, or what was drawn is barred where a scope is as long.
    fn narrowed(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &mut Terminals,
        (mut root, boxes): (NodeId, &Boxes),
        limits: &mut Limits,
    ) -> Came {
        let made_for = explainer.in_use(boxes, Search(AHEAD));
        let mut harsh = Vec::new();
        while !explainer.is_spent() {
            let emitted = self.emitted(explainer, terminals, (root, boxes), Sizes::Seen, limits);
            let faults = self.shown.faults(&emitted.learnt.graph, terminals);
            if faults.is_empty() {
                return Came::Sound(root);
            }
            let (plan, corpus) = (&explainer.plan, &mut *explainer.corpus);
            let mut suspects = Suspects { plan, corpus, emitted: &emitted, made_for: &made_for };
            let repairs: Vec<Repairs> = faults.iter().flat_map(|faulty| suspects.repairs(faulty)).collect();
            let blamed: Vec<Blamed> = faults.iter().flat_map(|faulty| suspects.blamed(faulty)).collect();
            if mend(explainer, limits, &repairs, &mut harsh) {
                return Came::Repaired;
            }
            let narrower = narrow::narrowed(&mut explainer.plan, explainer.corpus, (root, boxes), &blamed);
            let other = match narrower == root {
                true => barred(explainer, &emitted, limits, &faults),
                false => Some(narrower),
            };
            match other {
                Some(other) => root = other,
                None if keep_apart(explainer, &harsh) => return Came::Repaired,
                None => return Came::Stuck,
            }
        }
        Came::Stuck
    }

    fn emitted(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &Terminals,
        (root, boxes): (NodeId, &Boxes),
        sizes: Sizes,
        limits: &Limits,
    ) -> Emitted {
        emit::emit(&explainer.plan, explainer.corpus, root, boxes, terminals, (self.open, sizes), limits)
    }

    /// What has no faults with rules that are one made one, and with further start sizes, as long as it has none; and its
    /// bits.
    fn pooled(
        &self,
        explainer: &mut Explainer<'_>,
        terminals: &Terminals,
        (root, boxes): (NodeId, &Boxes),
        limits: &Limits,
    ) -> (Learnt, f64) {
        let is_like = |learnt: &Learnt, samples: u64| {
            self.freedom == Freedom::Free || self.shown.is_like(&learnt.graph, samples)
        };
        let learnt = |explainer: &mut Explainer<'_>, root, sizes| {
            self.emitted(explainer, terminals, (root, boxes), sizes, limits).learnt
        };
        let holds = |explainer: &mut Explainer<'_>, root| is_like(&learnt(explainer, root, Sizes::Seen), FEW);
        let one = pool::pooled(explainer, root, boxes, Search(AHEAD), holds);
        let fitted = refit::refitted(&mut explainer.plan, explainer.corpus, one, boxes);
        let tries = [fitted, one]
            .into_iter()
            .flat_map(|root| [Sizes::Between, Sizes::Seen].map(|sizes| (root, sizes)));
        let mut of_one = tries.map(|(root, sizes)| (root, learnt(explainer, root, sizes)));
        let found = of_one.find(|(_, learnt)| is_like(learnt, MANY));
        let (root, learnt) = found.unwrap_or_else(|| (root, learnt(explainer, root, Sizes::Seen)));
        (learnt, plan::bits(&explainer.plan, explainer.corpus, root, boxes))
    }
}

/// What came of repairs.
enum Came {
    /// Samples of this root show nothing wrong.
    Sound(NodeId),
    /// All is to be explained again.
    Repaired,
    Stuck,
}

/// The root without what faulty samples drew and no example draws at that length, if there is such.
fn barred(
    explainer: &mut Explainer<'_>,
    emitted: &Emitted,
    limits: &mut Limits,
    faults: &[Faulty],
) -> Option<NodeId> {
    let (plan, corpus) = (&mut explainer.plan, &*explainer.corpus);
    let drawn = faults.iter().flat_map(|faulty| blame::drawn(plan, corpus, emitted, faulty));
    let drawn: Vec<Vec<Drawn>> = drawn.collect();
    by_length::barred(plan, corpus, emitted, limits, &drawn)
}

/// Makes the mildest repair of each fault that is new, if there is any. What would have to be kept apart for those without
/// one is added to `harsh`.
fn mend(
    explainer: &mut Explainer<'_>,
    limits: &mut Limits,
    repairs: &[Repairs],
    harsh: &mut Vec<Vec<Boxes>>,
) -> bool {
    let mut now: Vec<&Vec<Repair>> = Vec::new();
    for Repairs { mild, kept } in repairs {
        // What was repaired for another fault may be all there is to this one.
        let made = mild.iter().find(|group| {
            now.contains(group)
                || group.iter().fold(false, |made, repair| made | make(explainer, limits, repair))
        });
        match made {
            Some(group) => now.push(group),
            None => harsh.push(kept.clone()),
        }
    }
    !now.is_empty()
}

fn make(explainer: &mut Explainer<'_>, limits: &mut Limits, repair: &Repair) -> bool {
    match repair {
        Repair::Tear { last, first, axis } => explainer.tear(*last, *first, *axis),
        Repair::Limit { boxes, axis } => limits.set(boxes, *axis, Where::Between),
    }
}

/// Keeps the first boxes of each list apart that are not so yet; whether there were any.
fn keep_apart(explainer: &mut Explainer<'_>, lists: &[Vec<Boxes>]) -> bool {
    lists.iter().fold(false, |is_new, list| is_new | list.iter().any(|boxes| explainer.keep(boxes)))
}
