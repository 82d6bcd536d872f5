//! Rules of a plan that may be one.

use super::boxes::Boxes;
use super::contexts::tell_apart;
use super::corpus::{Corpus, Skeleton};
use super::explain::{Explainer, Search};
use super::plan::{self, NodeId};
use super::recolour::Recolouring;
use std::collections::BTreeSet;
use std::rc::Rc;

/// One description for the boxes of some rules.
pub struct Merge {
    rules: Vec<(NodeId, Boxes)>,
    by: By,
    /// The bits that are saved, as far as an estimate tells.
    promise: f64,
}

enum By {
    /// All boxes are explained together.
    Together(Boxes),
    /// So are they once parameters stand for their materials.
    Materials(Recolouring),
}

impl Merge {
    /// What is described, and as what.
    pub fn explained(&self) -> (Vec<Boxes>, Boxes) {
        let all = match &self.by {
            By::Together(all) => all.clone(),
            By::Materials(recolouring) => recolouring.boxes(),
        };
        (self.rules.iter().map(|(_, boxes)| boxes.clone()).collect(), all)
    }

    /// What stands in the place of each rule.
    pub fn nodes(&self, explainer: &mut Explainer<'_>, search: Search) -> Vec<(NodeId, NodeId)> {
        match &self.by {
            By::Together(all) => {
                let one = explainer.explain(all, search);
                self.rules.iter().map(|(id, _)| (*id, one)).collect()
            }
            By::Materials(recolouring) => self.calls(explainer, recolouring, search),
        }
    }

    /// Whether the rules draw otherwise, one from the other.
    pub fn depends_on_place(&self, explainer: &mut Explainer<'_>, search: Search) -> bool {
        let By::Together(all) = &self.by else { return false };
        let one = explainer.explain(all, search);
        let places: Vec<&Boxes> = self.rules.iter().map(|(_, boxes)| boxes).collect();
        tell_apart(&explainer.plan, explainer.corpus, one, &places)
    }

    /// Calls of one rule with the materials of each box.
    fn calls(
        &self,
        explainer: &mut Explainer<'_>,
        recolouring: &Recolouring,
        search: Search,
    ) -> Vec<(NodeId, NodeId)> {
        let calls = explainer.calls(recolouring, search);
        let rule = |(id, boxes): &(NodeId, Boxes)| (*id, explainer.called(recolouring, &calls, boxes));
        self.rules.iter().map(rule).collect()
    }
}

/// All merges that promise anything, the best first.
pub fn merges(explainer: &mut Explainer<'_>, root: NodeId, boxes: &Boxes) -> Vec<Merge> {
    let rules = rules(explainer, root, boxes);
    let mut merges: Vec<Merge> = Vec::new();
    for (number, one) in rules.iter().enumerate() {
        merges.extend(by_materials(explainer, &[one]));
        for other in rules[number + 1..].iter().filter(|other| other.boxes != one.boxes) {
            if one.id != root && one.is_like(other) {
                merges.push(together(explainer, &[one, other]));
            } else if one.id != root && one.is_patterned_like(other) {
                merges.extend(by_materials(explainer, &[one, other]));
            }
        }
    }
    merges.retain(|merge| merge.promise > 0.0);
    merges.sort_by(|one, other| other.promise.total_cmp(&one.promise));
    merges
}

fn by_materials(explainer: &mut Explainer<'_>, rules: &[&Rule]) -> Option<Merge> {
    let all = union(rules);
    let recolouring = explainer.recolouring(&all)?;
    let promise = apart(explainer, rules) - explainer.estimate_calls(&recolouring);
    Some(Merge { rules: places(rules), by: By::Materials(recolouring), promise })
}

fn together(explainer: &mut Explainer<'_>, rules: &[&Rule]) -> Merge {
    let all = union(rules);
    let promise = apart(explainer, rules) - explainer.estimate(&all);
    Merge { rules: places(rules), by: By::Together(all), promise }
}

/// The estimate of rules by themselves.
fn apart(explainer: &mut Explainer<'_>, rules: &[&Rule]) -> f64 {
    rules.iter().map(|rule| explainer.estimate(&rule.boxes)).sum()
}

fn union(rules: &[&Rule]) -> Boxes {
    Boxes::of(rules.iter().flat_map(|rule| rule.boxes.iter()))
}

fn places(rules: &[&Rule]) -> Vec<(NodeId, Boxes)> {
    rules.iter().map(|rule| (rule.id, rule.boxes.clone())).collect()
}

/// A node with what its boxes are made of.
struct Rule {
    id: NodeId,
    boxes: Boxes,
    terminals: BTreeSet<u32>,
    skeletons: BTreeSet<Skeleton>,
    /// Skeletons in any materials.
    patterns: BTreeSet<Rc<[u32]>>,
}

impl Rule {
    fn is_like(&self, other: &Rule) -> bool {
        self.terminals == other.terminals || !self.skeletons.is_disjoint(&other.skeletons)
    }

    fn is_patterned_like(&self, other: &Rule) -> bool {
        !self.patterns.is_disjoint(&other.patterns)
    }
}

/// All that the root leads to and that is more than one block; the root first.
fn rules(explainer: &mut Explainer<'_>, root: NodeId, boxes: &Boxes) -> Vec<Rule> {
    let all = plan::occurrences(&explainer.plan, explainer.corpus, root, boxes);
    let corpus = &mut *explainer.corpus;
    let rule = |corpus: &mut Corpus, (id, boxes): (NodeId, Boxes)| Rule {
        id,
        terminals: boxes.classes().flat_map(|class| corpus.terminals(class).to_vec()).collect(),
        skeletons: boxes.classes().map(|class| corpus.profile(class).skeleton).collect(),
        patterns: boxes.classes().map(|class| corpus.pattern(class).numbers.clone()).collect(),
        boxes,
    };
    let all = all.into_iter().filter_map(|own| own.1.fill(corpus).is_none().then(|| rule(corpus, own)));
    all.collect()
}
