//! Rules that were found in different places and are one: their boxes are explained together where that is shorter.
//!
//! Each of them alone sees too few boxes to tell which sizes vary, and how.

use super::boxes::Boxes;
use super::corpus::{Class, Skeleton};
use super::explain::{Explainer, Search};
use super::groups::terminals;
use super::plan::{self, Form, How, Node, NodeId, Plan};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;

/// Bits that one rule instead of two has to save, beside those of saying which two of all that were tried. Small
/// gains are often chance.
const MARGIN: f64 = 10.0;
/// So many pairs are tried in full, those first that promise most.
const TRIED: usize = 48;

/// A plan for all examples.
struct Whole<'b> {
    root: NodeId,
    boxes: &'b Boxes,
    bits: f64,
}

impl<'b> Whole<'b> {
    fn new(explainer: &mut Explainer<'_>, root: NodeId, boxes: &'b Boxes) -> Whole<'b> {
        Whole { root, boxes, bits: plan::bits(&explainer.plan, explainer.corpus, root, boxes) }
    }
}

/// The root of the plan with rules that are one made one, as long as `holds` is true of what comes of it.
pub fn pooled(
    explainer: &mut Explainer<'_>,
    root: NodeId,
    boxes: &Boxes,
    search: Search,
    mut holds: impl FnMut(&mut Explainer<'_>, NodeId) -> bool,
) -> NodeId {
    let mut whole = Whole::new(explainer, root, boxes);
    let mut tried = FxHashSet::default();
    loop {
        let pairs = pairs(explainer, &whole);
        let least = MARGIN + (pairs.len().max(1) as f64).log2();
        let fresh = pairs.into_iter().find_map(|pair| {
            if tried.len() >= TRIED || explainer.is_spent() || !tried.insert(pair.boxes.clone()) {
                return None;
            }
            let other = joined(explainer, &whole, &pair, search);
            (whole.bits - other.bits > least && holds(explainer, other.root)).then_some(other)
        });
        match fresh {
            Some(shorter) => whole = shorter,
            None => return whole.root,
        }
    }
}

/// The plan with one rule in the place of two.
fn joined<'b>(explainer: &mut Explainer<'_>, whole: &Whole<'b>, pair: &Pair, search: Search) -> Whole<'b> {
    let one = explainer.explain(&Boxes::union(&pair.boxes), search);
    let root = replaced(&mut explainer.plan, whole.root, pair.nodes, one);
    Whole::new(explainer, root, whole.boxes)
}

/// Two rules that may be one.
struct Pair {
    nodes: [NodeId; 2],
    boxes: [Boxes; 2],
    /// The bits that are saved, as far as an estimate tells.
    promise: f64,
}

/// All pairs that promise anything, the best first.
fn pairs(explainer: &mut Explainer<'_>, whole: &Whole<'_>) -> Vec<Pair> {
    let rules = rules(explainer, whole);
    let mut pairs = Vec::new();
    for (number, one) in rules.iter().enumerate() {
        for other in rules[number + 1..].iter().filter(|other| one.is_like(other)) {
            let boxes = [one.boxes.clone(), other.boxes.clone()];
            let promise = explainer.saved(&boxes);
            if promise > 0.0 {
                pairs.push(Pair { nodes: [one.id, other.id], boxes, promise });
            }
        }
    }
    pairs.sort_by(|one, other| other.promise.total_cmp(&one.promise));
    pairs
}

/// A node with what its boxes are made of.
struct Rule {
    id: NodeId,
    boxes: Boxes,
    terminals: BTreeSet<u32>,
    skeletons: BTreeSet<Skeleton>,
}

impl Rule {
    fn is_like(&self, other: &Rule) -> bool {
        let shares = self.terminals == other.terminals || !self.skeletons.is_disjoint(&other.skeletons);
        shares && self.boxes != other.boxes
    }
}

/// All that the root leads to and that is more than one block.
fn rules(explainer: &mut Explainer<'_>, whole: &Whole<'_>) -> Vec<Rule> {
    let all = plan::occurrences(&explainer.plan, explainer.corpus, whole.root, whole.boxes);
    let corpus = &*explainer.corpus;
    let others = all.into_iter().filter(|(id, boxes)| *id != whole.root && boxes.fill(corpus).is_none());
    let rule = |(id, boxes): (NodeId, Boxes)| Rule {
        id,
        terminals: boxes.classes().flat_map(|class| terminals(corpus, class)).collect(),
        skeletons: boxes.classes().map(|class| corpus.profile(class).skeleton).collect(),
        boxes,
    };
    others.map(rule).collect()
}

/// The plan with one node in the place of two.
fn replaced(plan: &mut Plan, root: NodeId, nodes: [NodeId; 2], by: NodeId) -> NodeId {
    let mut now: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    for id in plan.reachable(root) {
        let own = if nodes.contains(&id) { by } else { rebuilt(plan, id, &now) };
        now.insert(id, own);
    }
    now[&root]
}

/// A node with other children in the place of its own.
fn rebuilt(plan: &mut Plan, id: NodeId, now: &FxHashMap<NodeId, NodeId>) -> NodeId {
    if plan.children(id).iter().all(|child| now[child] == *child) {
        return id;
    }
    let Node { form, how, made_for } = plan.node(id).clone();
    let own = match form {
        Form::Fill(_) => id,
        Form::Split { axis, parts } => {
            let parts = parts.into_iter().map(|(law, child)| (law, now[&child])).collect();
            plan.add(Form::Split { axis, parts }, how)
        }
        Form::Repeat { axis, unit, child } => plan.add(Form::Repeat { axis, unit, child: now[&child] }, how),
        Form::Choose(children) => plan.choose(chosen(&children, how, now)),
    };
    made_for.iter().for_each(|boxes| plan.note(own, boxes));
    own
}

/// What stands now for each class that a choice tells apart, in the order of classes.
fn chosen(
    children: &[NodeId],
    how: FxHashMap<Class, How>,
    now: &FxHashMap<NodeId, NodeId>,
) -> Vec<(Class, NodeId)> {
    let child = |(class, how)| match how {
        How::Choose(number) => Some((class, now[&children[number]])),
        _ => None,
    };
    let mut of: Vec<(Class, NodeId)> = how.into_iter().filter_map(child).collect();
    of.sort_unstable();
    of
}
