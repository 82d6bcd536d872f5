//! Which parameters the rules of a plan take, and from where.

use super::corpus::is_parameter;
use super::plan::{Form, NodeId, Plan};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// By node, the parameters that it leaves open, in order, and how many places lead to it.
pub struct Scope {
    free: FxHashMap<NodeId, Vec<u32>>,
    places: FxHashMap<NodeId, usize>,
    /// What is written as a choice.
    choices: BTreeSet<NodeId>,
}

/// Where a node is written: in a rule, behind so many sizes that were drawn for it.
#[derive(Clone, Copy, Debug)]
pub struct Within {
    pub rule: NodeId,
    pub drawn: usize,
}

impl Within {
    pub fn rule(rule: NodeId) -> Within {
        Within { rule, drawn: 0 }
    }
}

impl Scope {
    /// Of all that `root` reaches.
    pub fn of(plan: &Plan, root: NodeId) -> Scope {
        let mut scope =
            Scope { free: FxHashMap::default(), places: FxHashMap::default(), choices: BTreeSet::new() };
        for id in plan.reachable(root) {
            let free = scope.left_open(plan, id);
            scope.free.insert(id, free.into_iter().collect());
            plan.children(id).into_iter().for_each(|child| *scope.places.entry(child).or_insert(0) += 1);
            if let Form::Choose(_) | Form::Slope { .. } = plan.node(id).form {
                scope.choices.insert(id);
            }
        }
        scope
    }

    /// The parameters that a node leaves open, in order.
    pub fn free(&self, id: NodeId) -> &[u32] {
        self.free.get(&id).map_or(&[], Vec::as_slice)
    }

    /// Whether a node can be written as a part of the rule around it.
    pub fn is_inline(&self, id: NodeId, within: Within) -> bool {
        let is_alone = self.places.get(&id) == Some(&1) && !self.choices.contains(&id);
        let knows_all = within.drawn == 0 && self.free(id) == self.free(within.rule);
        self.free(id).is_empty() || (is_alone && knows_all)
    }

    fn left_open(&self, plan: &Plan, id: NodeId) -> BTreeSet<u32> {
        let below = plan.children(id).into_iter().flat_map(|child| self.free(child).to_vec());
        match &plan.node(id).form {
            Form::Fill(terminal) => {
                [*terminal].into_iter().filter(|terminal| is_parameter(*terminal)).collect()
            }
            Form::Call { parameters, arguments, .. } => {
                let given = arguments.iter().copied().filter(|terminal| is_parameter(*terminal));
                below.filter(|parameter| !parameters.contains(parameter)).chain(given).collect()
            }
            _ => below.collect(),
        }
    }
}
