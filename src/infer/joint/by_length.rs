//! Alternatives and drawn sizes that no example has where a scope is as long as in a sample: they are not to be had there.
//!
//! A wing may be four or five blocks wide, but at the widest house five only: what stands behind it would meet it otherwise
//! than in any example.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus};
use super::derivation::{At, Derivation};
use super::emit::Emitted;
use super::laws::{Law, law_of};
use super::limits::{Limits, Where};
use super::plan::{self, Form, NodeId, Plan};
use super::replace::replaced;
use crate::graph::Op;
use crate::space::{Axis, Bounds};

/// What a sample drew in a scope of a length at which no example draws it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Drawn {
    /// The boxes of that length in the examples: the fewer, the less is lost by barring it.
    seen: u32,
    axis: Axis,
    len: i32,
    what: What,
}

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum What {
    /// The alternative that was made for these boxes.
    Alternative(Boxes),
    /// The length of a part of a split.
    Part(NodeId),
}

/// What a derivation drew in the scopes that touch a window and no example draws at their lengths; what is rarest first.
pub fn drawn(
    plan: &Plan,
    corpus: &Corpus,
    emitted: &Emitted,
    derivation: &Derivation,
    window: Bounds,
) -> Vec<Drawn> {
    let is_near = |at: &At| !derivation.get(*at).bounds.intersect(&window).is_empty();
    let drawing = Drawing { plan, corpus, emitted, derivation };
    let near = (0..derivation.len()).filter(is_near);
    let mut drawn: Vec<Drawn> =
        near.flat_map(|at| drawing.alternative(at).into_iter().chain(drawing.parts(at))).collect();
    drawn.sort();
    drawn
}

/// What a sample was drawn from.
struct Drawing<'d> {
    plan: &'d Plan,
    corpus: &'d Corpus,
    emitted: &'d Emitted,
    derivation: &'d Derivation,
}

impl Drawing<'_> {
    /// The alternative that an operation is, by each axis on which no example takes it at this length.
    fn alternative(&self, at: At) -> Vec<Drawn> {
        let bounds = self.derivation.get(at).bounds;
        let Some((own, alternatives)) = self.emitted.alternatives(self.plan, self.derivation, at) else {
            return Vec::new();
        };
        let drawn = |axis: Axis| {
            let len = bounds.len(axis);
            let is_long = |boxes: &Boxes| self.count(boxes, axis, len);
            let others: u32 = alternatives.iter().map(|(_, boxes)| is_long(boxes)).sum();
            let is_barred = is_long(&own) == 0 && others > 0;
            is_barred.then(|| Drawn { seen: others, axis, len, what: What::Alternative(own.clone()) })
        };
        Axis::ALL.into_iter().filter_map(drawn).collect()
    }

    /// The split that an operation is, if it drew a part, by each axis on which no example has that part so long at this
    /// length.
    fn parts(&self, at: At) -> Vec<Drawn> {
        match self.emitted.op(self.derivation.get(at).node) {
            Op::Split { .. } => self.planned(at).into_iter().flat_map(|id| self.parts_of(at, id)).collect(),
            _ => Vec::new(),
        }
    }

    fn parts_of(&self, at: At, id: NodeId) -> Vec<Drawn> {
        let Form::Split { axis: along, parts } = &self.plan.node(id).form else { return Vec::new() };
        let made: Vec<i32> = self.derivation.children(at).map(|part| part.bounds.len(*along)).collect();
        if made.len() != parts.len() {
            return Vec::new();
        }
        let bounds = self.derivation.get(at).bounds;
        let boxes = self.emitted.boxes(id);
        let drawn = |axis: Axis| {
            let len = bounds.len(axis);
            let there = boxes.classes().filter(|class| self.corpus.profile(*class).len(axis) == len);
            let there: Vec<Vec<i32>> =
                there.map(|class| plan::lengths(self.plan, self.corpus, id, class)).collect();
            let is_unseen = |part: usize| {
                parts[part].0.is_drawn()
                    && !there.iter().any(|lengths| lengths.get(part) == Some(&made[part]))
            };
            let seen = self.count(boxes, axis, len);
            let is_barred = 0 < seen && seen < boxes.count() && (0..parts.len()).any(is_unseen);
            is_barred.then_some(Drawn { seen, axis, len, what: What::Part(id) })
        };
        Axis::ALL.into_iter().filter_map(drawn).collect()
    }

    fn planned(&self, at: At) -> Vec<NodeId> {
        self.emitted.planned(self.derivation, at)
    }

    /// How many boxes are so long.
    fn count(&self, boxes: &Boxes, axis: Axis, len: i32) -> u32 {
        let there = boxes.iter().filter(|(class, _)| self.corpus.profile(*class).len(axis) == len);
        there.map(|(_, count)| count).sum()
    }
}

/// The root of the plan without one of what was drawn in each place, the rarest that is not barred yet; `None` if there is
/// no such.
pub fn barred(
    plan: &mut Plan,
    corpus: &Corpus,
    emitted: &Emitted,
    limits: &mut Limits,
    places: &[Vec<Drawn>],
) -> Option<NodeId> {
    let mut made: Vec<(NodeId, NodeId)> = Vec::new();
    let mut bar = |Drawn { axis, len, what, .. }: &Drawn| match what {
        What::Alternative(own) => limits.set(own, *axis, Where::Seen),
        What::Part(id) if made.iter().any(|(split, _)| split == id) => true,
        What::Part(id) => {
            let node = told_apart(plan, corpus, limits, (*id, emitted.boxes(*id)), (*axis, *len));
            // Both groups may draw the same.
            let is_new = node != *id;
            made.extend(is_new.then_some((*id, node)));
            is_new
        }
    };
    let any = places.iter().fold(false, |any, place| place.iter().any(&mut bar) | any);
    any.then(|| replaced(plan, emitted.root, &made))
}

/// A choice by their length between the split of the boxes that are so long and that of the others.
fn told_apart(
    plan: &mut Plan,
    corpus: &Corpus,
    limits: &mut Limits,
    (id, boxes): (NodeId, &Boxes),
    (axis, len): (Axis, i32),
) -> NodeId {
    let is_there = |(class, _): &(Class, u32)| corpus.profile(*class).len(axis) == len;
    let (there, others): (Vec<_>, Vec<_>) = boxes.iter().partition(is_there);
    let mut of = Vec::new();
    for group in [there, others].map(Boxes::of) {
        let node = refitted(plan, corpus, id, &group);
        limits.set(&group, axis, Where::Seen);
        of.extend(group.classes().map(|class| (class, node)));
    }
    of.sort_unstable();
    plan.choose(of)
}

/// A split that draws what some of its boxes show.
fn refitted(plan: &mut Plan, corpus: &Corpus, id: NodeId, boxes: &Boxes) -> NodeId {
    let Form::Split { parts, .. } = &plan.node(id).form else { return id };
    let seen = plan::seen(plan, corpus, id, boxes);
    let own = |part: usize| law_of(seen.iter().map(|(lengths, count)| (lengths[part], *count)));
    let law = |(part, (law, _)): (usize, &(Law, NodeId))| match law {
        Law::Same(owner) if !own(*owner).is_drawn() => own(*owner),
        law if law.is_drawn() => own(part),
        law => law.clone(),
    };
    let laws = parts.iter().enumerate().map(law).collect();
    plan.with_laws(id, boxes, laws)
}

#[cfg(test)]
mod tests {
    use super::super::corpus::Place;
    use super::super::feasible::Lengths;
    use super::super::plan::How;
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;
    use smallvec::SmallVec;

    /// Rows of wood up to a length, then stone.
    fn corpus(rows: &[(i32, i32)]) -> (Corpus, Vec<Class>) {
        let row = |(wood, len): &(i32, i32)| {
            let cells = (0..*len).map(|x| if x < *wood { 1 } else { 2 }).collect();
            Volume::new(Array3::from_shape_vec((1, 1, *len as usize), cells).unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(rows.iter().map(row).collect(), 0);
        let places: Vec<Place> = corpus.examples();
        let classes = places.into_iter().map(|place| corpus.class(place)).collect();
        (corpus, classes)
    }

    #[test]
    fn a_length_that_was_never_drawn_in_so_long_a_box_is_not_to_be_had_there() {
        let rows = [(2, 5), (3, 6), (2, 7), (3, 7)];
        let (corpus, classes) = corpus(&rows);
        let boxes = Boxes::of(classes.iter().map(|class| (*class, 1)));
        let mut plan = Plan::default();
        let [wood, stone] = [1, 2].map(|terminal| plan.add(Form::Fill(terminal), []));
        let drawn = Law::Range { low: 2, high: 3, step: 1 };
        let how = classes
            .iter()
            .zip(&rows)
            .map(|(class, (wood, _))| (*class, How::Split(SmallVec::from_slice(&[*wood]))));
        let parts = vec![(drawn.clone(), wood), (Law::Float(1), stone)];
        let split = plan.add(Form::Split { axis: Axis::X, parts }, how);
        let mut limits = Limits::default();
        let choice = told_apart(&mut plan, &corpus, &mut limits, (split, &boxes), (Axis::X, 6));
        let alternatives = plan::alternatives(&plan, choice, &boxes).unwrap_or_default();
        let shown = alternatives.iter().map(|(id, own)| {
            let Form::Split { parts, .. } = &plan.node(*id).form else { panic!("a split is told apart") };
            let all = alternatives.iter().map(|(_, boxes)| boxes);
            let lengths = limits.lengths(&corpus, own, all, Axis::X);
            (parts[0].0.clone(), Lengths::of(5..=7).and(lengths))
        });
        let shown: Vec<(Law, Lengths)> = shown.collect();
        assert_eq!(shown, [(drawn, Lengths::of([5, 7])), (Law::Const(3), Lengths::of([6]))]);
    }
}
