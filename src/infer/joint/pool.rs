//! Rules that were found in different places and are one: their boxes are explained together where that is shorter.
//!
//! Each of them alone sees too few boxes to tell which sizes vary, and how.

use super::boxes::Boxes;
use super::explain::{Explainer, Search};
use super::merge::{Merge, merges};
use super::plan::{self, NodeId};
use super::replace::replaced;
use rustc_hash::FxHashSet;

/// Bits that one rule instead of two has to save, beside those of saying which two of all that were tried. Small
/// gains are often chance.
const MARGIN: f64 = 10.0;
/// So many merges are tried in full, those first that promise most.
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

    /// The plan with one rule for what a merge joins; none if the search was cut short.
    fn merged(&self, explainer: &mut Explainer<'_>, merge: &Merge, search: Search) -> Option<Whole<'b>> {
        let by = merge.nodes(explainer, search);
        let root = replaced(&mut explainer.plan, self.root, &by);
        (!explainer.is_spent()).then(|| Whole::new(explainer, root, self.boxes))
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
        let found = merges(explainer, whole.root, boxes);
        let least = MARGIN + (found.len().max(1) as f64).log2();
        let better = found.into_iter().find_map(|merge| {
            if tried.len() >= TRIED || explainer.is_spent() || !tried.insert(merge.explained()) {
                return None;
            }
            let other = whole.merged(explainer, &merge, search)?;
            let is_better = whole.bits - other.bits > least && !merge.depends_on_place(explainer, search);
            (is_better && holds(explainer, other.root)).then_some(other)
        });
        match better {
            Some(shorter) => whole = shorter,
            None => return whole.root,
        }
    }
}
