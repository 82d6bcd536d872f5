//! The parts that derivations are made of, and what divided the building into them.

use crate::graph::{NodeIndex, Op, OpGraph};
use crate::parse::{Derivation, Step};
use std::collections::BTreeMap;

/// A step and the operation whose division gave it its scope; none has given the start scope.
#[derive(Clone, Copy, Debug)]
pub struct Part<'d> {
    pub step: &'d Step,
    pub around: Option<NodeIndex>,
}

/// The steps of a derivation with what is around them.
pub fn parts<'d>(graph: &OpGraph, derivation: &'d Derivation) -> Vec<Part<'d>> {
    let mut around: Vec<&Step> = Vec::new();
    let part = |step: &'d Step| {
        while around.last().is_some_and(|outer| outer.depth >= step.depth) {
            around.pop();
        }
        let part = Part { step, around: around.last().map(|outer| outer.node) };
        if divides(graph.op(step.node)) {
            around.push(step);
        }
        part
    };
    derivation.steps.iter().map(part).collect()
}

fn divides(op: &Op) -> bool {
    matches!(
        op,
        Op::Split { .. }
            | Op::Repeat { .. }
            | Op::RepeatN { .. }
            | Op::Carve { .. }
            | Op::Translate(_)
            | Op::Resize(_)
    )
}

/// How often each operation runs in derivations.
pub fn uses<'d>(derivations: impl IntoIterator<Item = &'d Derivation>) -> BTreeMap<NodeIndex, u64> {
    let mut uses = BTreeMap::new();
    for step in derivations.into_iter().flat_map(|derivation| &derivation.steps) {
        *uses.entry(step.node).or_insert(0) += 1;
    }
    uses
}
