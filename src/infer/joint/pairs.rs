//! Pairs of cells of rows that no example shows: they are barred.

use super::corpus::Corpus;
use super::derivation::{At, Derivation};
use super::emit::Emitted;
use super::plan::{self, Form, NodeId, Plan};
use super::rows::{self, Pair};
use crate::space::Bounds;
use ndarray::Array3;
use std::collections::{BTreeMap, BTreeSet};

/// Two cells of a row that stand side by side where no example has them.
pub type Barred = (NodeId, (Pair, usize, usize));

/// The pairs of cells of rows in a window that no example has there.
pub fn unseen(
    plan: &Plan,
    corpus: &Corpus,
    emitted: &Emitted,
    (derivation, cells): (&Derivation, &Array3<u32>),
    window: Bounds,
) -> Vec<Barred> {
    let mut pairs = Vec::new();
    for at in (0..derivation.len()).filter(|at| !derivation.get(*at).bounds.intersect(&window).is_empty()) {
        for id in emitted.nodes.get(&derivation.get(at).node).into_iter().flatten() {
            let Form::Row { row, .. } = &plan.node(*id).form else { continue };
            let stands_for =
                |at: &At| emitted.nodes.get(&derivation.get(*at).node).is_some_and(|ids| ids.contains(id));
            if derivation.from(at).skip(1).any(|before| stands_for(&before)) {
                continue;
            }
            let bounds = derivation.get(at).bounds;
            let made: Vec<u32> = bounds
                .cells()
                .map(|cell| cells[[cell.y as usize, cell.z as usize, cell.x as usize]])
                .collect();
            let seen: Vec<Vec<u32>> =
                emitted.boxes(*id).classes().map(|class| rows::cells(corpus, class, row.axis)).collect();
            let number = row.axis.of(window.min) - row.axis.of(bounds.min);
            let unseen = usize::try_from(number).ok().and_then(|number| row.unseen(&made, number, &seen));
            pairs.extend(unseen.map(|pair| (*id, pair)));
        }
    }
    pairs
}

/// Rows without what is barred, each with the row in whose place it stands.
pub fn without<'b>(plan: &mut Plan, pairs: impl Iterator<Item = &'b Barred>) -> Vec<(NodeId, NodeId)> {
    let mut barred: BTreeMap<NodeId, BTreeSet<(Pair, usize, usize)>> = BTreeMap::new();
    for (id, pair) in pairs {
        barred.entry(*id).or_default().insert(*pair);
    }
    let narrower = |(id, pairs)| {
        let plan::Node { mut form, how } = plan.node(id).clone();
        if let Form::Row { row, .. } = &mut form {
            row.barred.extend(pairs);
        }
        (id, plan.add(form, how))
    };
    barred.into_iter().map(narrower).collect()
}
