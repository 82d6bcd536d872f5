//! Whether what rules choose depends on where they stand: then they are not one.

use super::boxes::Boxes;
use super::corpus::Corpus;
use super::dependence::tells;
use super::plan::{Form, How, NodeId, Plan, occurrences};
use std::collections::BTreeMap;

/// Whether any choice that `root` makes for the boxes of one place tells of the place.
pub fn tell_apart(plan: &Plan, corpus: &mut Corpus, root: NodeId, places: &[&Boxes]) -> bool {
    let mut chosen: BTreeMap<NodeId, Vec<(u64, u64, u32)>> = BTreeMap::new();
    for (place, boxes) in (0..).zip(places) {
        for (id, boxes) in occurrences(plan, corpus, root, boxes) {
            let node = plan.node(id);
            let numbers =
                boxes.iter().filter_map(|(class, count)| match (&node.form, node.how.get(&class)) {
                    (Form::Choose(_), Some(How::Choose(number))) => Some((place, *number as u64, count)),
                    _ => None,
                });
            chosen.entry(id).or_default().extend(numbers);
        }
    }
    chosen.values().any(|pairs| tells(pairs))
}
