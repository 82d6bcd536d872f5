//! Which operations have rules of their own, and which are nested in the rule around them.

use super::kinds::{Kind, Leaf};
use crate::graph::{NodeIndex, Op, OpGraph};
use std::collections::BTreeSet;

/// Operations with more words than this inside have a rule of their own.
const LONG: usize = 9;
/// So deep are operations nested in one rule.
const DEEP: usize = 3;

/// An operation with its rule, and what that rule says.
#[derive(Clone, Debug)]
pub struct Rule {
    pub node: NodeIndex,
    /// Terminals, each as often as the text has it.
    pub leaves: Vec<NodeIndex>,
    /// The rules that it leads to, in the order of the text.
    next: Vec<NodeIndex>,
}

/// The rules of a graph, the root's first, in the order of the text.
pub fn rules(graph: &OpGraph) -> Vec<Rule> {
    let nodes = nodes_with_rules(graph);
    let mut known = BTreeSet::from([graph.root()]);
    let mut rules = vec![rule(graph, graph.root(), &nodes)];
    let mut at = 0;
    while at < rules.len() {
        let fresh: Vec<NodeIndex> =
            rules[at].next.iter().copied().filter(|node| known.insert(*node)).collect();
        rules.extend(fresh.into_iter().map(|node| rule(graph, node, &nodes)));
        at += 1;
    }
    rules
}

fn rule(graph: &OpGraph, node: NodeIndex, nodes: &BTreeSet<NodeIndex>) -> Rule {
    let mut rule = Rule { node, leaves: Vec::new(), next: Vec::new() };
    let below = |node: NodeIndex| graph.children(node).map(|(_, child)| child).collect::<Vec<_>>();
    let mut open = below(node);
    open.reverse();
    while let Some(node) = open.pop() {
        if nodes.contains(&node) {
            rule.next.push(node);
        } else if matches!(graph.op(node), Op::Primitive { .. } | Op::Nil) {
            rule.leaves.push(node);
        } else {
            open.extend(below(node).into_iter().rev());
        }
    }
    rule
}

/// What the text of an operation takes inside the rule around it.
#[derive(Clone, Copy, Default)]
struct Extent {
    words: usize,
    depth: usize,
}

fn nodes_with_rules(graph: &OpGraph) -> BTreeSet<NodeIndex> {
    let must = must_have_rules(graph);
    let open = graph.open_params();
    let mut extents = vec![Extent::default(); graph.len()];
    let mut nodes = BTreeSet::new();
    for node in graph.inner_first() {
        let children = || graph.children(node).map(|(_, child)| extents[child.index()]);
        let inside = Extent {
            words: children().map(|extent| extent.words).sum(),
            depth: children().map(|extent| extent.depth).max().unwrap_or(0),
        };
        let is_long = inside.words > LONG || inside.depth >= DEEP;
        let has_rule = must.contains(&node) || (is_long && !open[node.index()] && !graph.is_leaf(node));
        if has_rule {
            nodes.insert(node);
        }
        extents[node.index()] = match has_rule || graph.is_leaf(node) {
            true => Extent { words: 1, depth: 0 },
            false => Extent { words: 1 + inside.words, depth: 1 + inside.depth },
        };
    }
    nodes
}

/// The root, choices, what is shared or called, and what people look for: doorways, and what is repeated.
fn must_have_rules(graph: &OpGraph) -> BTreeSet<NodeIndex> {
    let open = graph.open_params();
    let doorways = doorways(graph);
    let wanted = |node: &NodeIndex| {
        *graph.op(*node) == Op::Choose || graph.is_shared(*node) || doorways.contains(node)
    };
    let own = graph.nodes().filter(wanted);
    let units =
        graph.nodes().filter(|node| matches!(graph.op(*node), Op::Repeat { .. } | Op::RepeatN { .. }));
    let units = units.flat_map(|node| graph.children(node).map(|(_, child)| child));
    let free = own.chain(units).filter(|node| !graph.is_leaf(*node) && !open[node.index()]);
    let calls = graph.nodes().filter(|node| matches!(graph.op(*node), Op::Call(_)));
    let called = calls.flat_map(|node| graph.children(node).map(|(_, child)| child));
    free.chain(called).chain([graph.root()]).collect()
}

/// The least operations that hold a door.
fn doorways(graph: &OpGraph) -> BTreeSet<NodeIndex> {
    let mut holds = vec![false; graph.len()];
    let mut doorways = BTreeSet::new();
    for node in graph.inner_first() {
        let is_door = |node| Leaf::of(graph, node).is_some_and(|leaf| leaf.kind == Kind::Door);
        let children = || graph.children(node).map(|(_, child)| child);
        let is_below = children().any(|child| holds[child.index()]);
        if !is_below && children().any(is_door) {
            doorways.insert(node);
        }
        holds[node.index()] = is_below || doorways.contains(&node);
    }
    doorways
}
