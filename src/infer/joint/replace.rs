//! A plan with other nodes in the place of some.

use super::corpus::Class;
use super::plan::{Form, How, Node, NodeId, Plan};
use rustc_hash::FxHashMap;

/// The root of the plan with every node of `by` replaced.
pub fn replaced(plan: &mut Plan, root: NodeId, by: &[(NodeId, NodeId)]) -> NodeId {
    let mut now: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    for id in plan.reachable(root) {
        let other = by.iter().find(|(old, _)| *old == id).map(|(_, new)| *new);
        let own = other.unwrap_or_else(|| rebuilt(plan, id, &now));
        now.insert(id, own);
    }
    now[&root]
}

/// A node with other children in the place of its own, where there are others.
pub fn rebuilt(plan: &mut Plan, id: NodeId, now: &FxHashMap<NodeId, NodeId>) -> NodeId {
    let now = |child: &NodeId| now.get(child).copied().unwrap_or(*child);
    if plan.children(id).iter().all(|child| now(child) == *child) {
        return id;
    }
    let Node { mut form, how } = plan.node(id).clone();
    if let Form::Choose(children) = &form {
        return plan.choose(chosen(children, how, now));
    }
    form.children_mut().into_iter().for_each(|child| *child = now(child));
    plan.add(form, how)
}

/// What stands now for each class that a choice tells apart, in the order of classes.
fn chosen(
    children: &[NodeId],
    how: FxHashMap<Class, How>,
    now: impl Fn(&NodeId) -> NodeId,
) -> Vec<(Class, NodeId)> {
    let child = |(class, how)| match how {
        How::Choose(number) => Some((class, now(&children[number]))),
        _ => None,
    };
    let mut of: Vec<(Class, NodeId)> = how.into_iter().filter_map(child).collect();
    of.sort_unstable();
    of
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::infer::joint::laws::Law;
    use crate::space::Axis;

    #[test]
    fn what_leads_to_a_node_leads_to_the_other_one_and_equal_alternatives_are_one() {
        let mut plan = Plan::default();
        let [stone, wood, brick] = [0, 1, 2].map(|terminal| plan.add(Form::Fill(terminal), []));
        let choice = plan.choose(vec![(Class(0), stone), (Class(1), wood)]);
        let parts = vec![(Law::Const(1), brick), (Law::Float(1), choice)];
        let root = plan.add(Form::Split { axis: Axis::Y, parts }, []);
        let other = replaced(&mut plan, root, &[(wood, stone)]);
        assert_eq!(plan.children(other), [brick, stone]);
        assert_eq!(replaced(&mut plan, root, &[(brick, brick)]), root);
    }
}
