//! Laws that go by what stands in the parts of splits now.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::laws::fitted;
use super::plan::{self, Form, NodeId, Plan};
use super::replace::rebuilt;
use super::stretch;
use rustc_hash::FxHashMap;

/// The root of the plan with the laws of all splits that leave lengths to chance fitted again: what stands in them may
/// take otherwise to other lengths than when they were made.
pub fn refitted(plan: &mut Plan, corpus: &mut Corpus, root: NodeId, boxes: &Boxes) -> NodeId {
    let mut now: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    for (id, boxes) in plan::occurrences(plan, corpus, root, boxes).iter().rev() {
        let own = rebuilt(plan, *id, &now);
        now.insert(*id, with_laws(plan, corpus, own, boxes));
    }
    now[&root]
}

/// A split of these boxes with laws that go by what stands in it now, if it leaves any lengths to chance.
fn with_laws(plan: &mut Plan, corpus: &Corpus, id: NodeId, boxes: &Boxes) -> NodeId {
    let Form::Split { axis, parts } = &plan.node(id).form else { return id };
    if !parts.iter().any(|(law, _)| law.is_drawn()) {
        return id;
    }
    let children: Vec<NodeId> = parts.iter().map(|(_, child)| *child).collect();
    let parts = stretch::parts(plan, &children, *axis);
    let laws = fitted(&plan::seen(plan, corpus, id, boxes), &parts);
    plan.with_laws(id, boxes, laws)
}

#[cfg(test)]
mod tests {
    use super::super::corpus::{Class, Place};
    use super::super::laws::Law;
    use super::super::plan::How;
    use super::super::volume::Volume;
    use super::*;
    use crate::space::Axis;
    use ndarray::Array3;
    use smallvec::SmallVec;

    #[test]
    fn what_bends_now_floats() {
        // Wood, then a pattern that was a repeat when the laws were made and is stone now.
        let rows = [(2, 6), (3, 8), (2, 9)];
        let row = |(wood, len): &(i32, i32)| {
            let cells = (0..*len).map(|x| if x < *wood { 1 } else { 2 }).collect();
            Volume::new(Array3::from_shape_vec((1, 1, *len as usize), cells).unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(rows.iter().map(row).collect(), 0);
        let places: Vec<Place> = corpus.examples();
        let classes: Vec<Class> = places.into_iter().map(|place| corpus.class(place)).collect();
        let boxes = Boxes::of(classes.iter().map(|class| (*class, 1)));
        let mut plan = Plan::default();
        let [wood, stone] = [1, 2].map(|terminal| plan.add(Form::Fill(terminal), []));
        let how = classes.iter().zip(&rows);
        let how = how.map(|(class, (wood, _))| (*class, How::Split(SmallVec::from_slice(&[*wood]))));
        let parts = vec![(Law::Float(1), wood), (Law::Range { low: 4, high: 7, step: 1 }, stone)];
        let split = plan.add(Form::Split { axis: Axis::X, parts }, how);
        let fitted = refitted(&mut plan, &mut corpus, split, &boxes);
        let parts = vec![(Law::Range { low: 2, high: 3, step: 1 }, wood), (Law::Float(1), stone)];
        assert_eq!(plan.node(fitted).form, Form::Split { axis: Axis::X, parts });
        assert_eq!(refitted(&mut plan, &mut corpus, fitted, &boxes), fitted);
    }
}
