//! The sizes of new buildings: those of the examples, and what lies between them wherever it can be filled.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::emit::value;
use super::feasible::Feasible;
use super::laws::Law;
use super::limits::Limits;
use super::plan::{Form, NodeId, Plan};
use super::repeats::gcd;
use crate::graph::{Expr, StartSize};
use crate::space::Axis;
use std::collections::BTreeMap;

/// What start sizes depend on.
pub struct StartSizes<'s> {
    pub plan: &'s Plan,
    pub corpus: &'s Corpus,
    pub feasible: &'s Feasible,
    pub limits: &'s Limits,
}

/// Which sizes new buildings have, where buildings of several kinds are told apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Sizes {
    /// Those of the examples.
    Seen,
    /// Those between them as well, on each axis on which all kinds fill every length.
    Between,
}

impl StartSizes<'_> {
    /// The start sizes of `root`, which describes `boxes`. Lengths on the axes that are free are drawn by themselves; on
    /// the others what was seen stays together.
    pub fn sizes(&self, root: NodeId, boxes: &Boxes, sizes: Sizes) -> Vec<StartSize> {
        let laws = Axis::ALL
            .map(|axis| Some(self.between(boxes, axis)).filter(|law| self.is_free(root, axis, law, sizes)));
        let mut seen: BTreeMap<[i32; 3], u32> = BTreeMap::new();
        for (class, count) in boxes.iter() {
            let len = |axis: Axis| self.corpus.profile(class).len(axis);
            let bound = Axis::ALL.map(|axis| if laws[axis.index()].is_some() { 0 } else { len(axis) });
            *seen.entry(bound).or_insert(0) += count;
        }
        let is_alone = seen.len() == 1;
        let start = |(bound, count): ([i32; 3], u32)| StartSize {
            size: Axis::ALL.map(|axis| {
                let at = axis.index();
                laws[at].as_ref().map_or_else(|| Expr::number(f64::from(bound[at])), value)
            }),
            weight: Expr::number(if is_alone { 1.0 } else { f64::from(count) }),
        };
        seen.into_iter().map(start).collect()
    }

    /// The lengths between those of the examples, in the steps that these have.
    fn between(&self, boxes: &Boxes, axis: Axis) -> Law {
        let lens = || boxes.iter().map(|(class, count)| (self.corpus.profile(class).len(axis), count));
        let (low, high) = lens().fold((i32::MAX, 0), |(low, high), (len, _)| (low.min(len), high.max(len)));
        match lens().map(|(len, _)| len - low).fold(0, gcd) {
            0 => Law::Const(low),
            _ if self.limits.has(boxes, axis) => Law::table(lens()),
            step => Law::Range { low, high, step },
        }
    }

    /// Whether all that can be chosen for a building fills every length that a law gives. Buildings of one kind were
    /// described together because they do.
    fn is_free(&self, root: NodeId, axis: Axis, law: &Law, sizes: Sizes) -> bool {
        let Form::Choose(children) = &self.plan.node(root).form else { return true };
        let fills = |child: &NodeId| {
            let feasible = self.feasible[child][axis.index()];
            law.lengths().all(|len| feasible.contains(len))
        };
        is_one(self.plan, children) || (sizes == Sizes::Between && children.iter().all(fills))
    }
}

/// Whether all that can be chosen is one rule.
fn is_one(plan: &Plan, children: &[NodeId]) -> bool {
    let called = |child: &NodeId| match &plan.node(*child).form {
        Form::Call { child, .. } => Some(*child),
        _ => None,
    };
    let first = children.first().and_then(called);
    first.is_some() && children.iter().all(|child| called(child) == first)
}
