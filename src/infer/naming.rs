//! Names for rules, from what they hold and how they stand.

use super::combine::{Kind, Kinds};
use super::example::Example;
use crate::block::{self, BlockState, Shape};
use crate::graph::{NodeIndex, Op, OpGraph, Renumbered, RuleName};
use crate::space::{Axis, Bounds, Cell};
use std::collections::BTreeMap;

/// The first place where each node was seen: the example, and the box in it.
pub type Places = BTreeMap<NodeIndex, (usize, Bounds)>;

/// Operations that take more than this many words to write get a rule of their own.
const LONG: usize = 8;

/// Gives names to the nodes that deserve a rule: the root, choices, what is shared, and what is long.
pub fn name(graph: &mut OpGraph, places: &Places, examples: &[Example]) {
    for node in named_nodes(graph) {
        let label = match places.get(&node) {
            Some((example, bounds)) if node != graph.root() => describe(&examples[*example], *bounds),
            _ => "house".to_owned(),
        };
        graph.set_name(node, RuleName { label, ..RuleName::default() });
    }
}

/// The places of the nodes of all kinds of splits, beside those that are known.
pub fn places(kinds: &Kinds, nodes: &[NodeIndex], mut places: Places) -> Places {
    for ((kind, node), seen) in kinds.list.iter().zip(nodes).zip(&kinds.places) {
        if let (Kind::Split { .. }, Some(first)) = (kind, seen.first()) {
            places.entry(*node).or_insert(*first);
        }
    }
    places
}

/// The places by the nodes' new numbers.
pub fn renumbered(places: Places, kept: &Renumbered) -> Places {
    places.into_iter().filter_map(|(node, place)| Some((*kept.get(&node)?, place))).collect()
}

fn named_nodes(graph: &OpGraph) -> Vec<NodeIndex> {
    let mut words = vec![0; graph.len()];
    let mut named = vec![graph.root()];
    for node in graph.children_first().unwrap_or_default() {
        let is_leaf = graph.is_leaf(node);
        let inner: usize = graph.children(node).map(|(_, child)| words[child.index()]).sum();
        let is_named = *graph.op(node) == Op::Choose
            || (!is_leaf && inner > LONG)
            || (!is_leaf && graph.is_shared(node));
        if is_named && node != graph.root() {
            named.push(node);
        }
        words[node.index()] = if is_named || is_leaf { 1 } else { 1 + inner };
    }
    named
}

/// What a part of an example is called: what it is made of most, and how it stands.
fn describe(example: &Example, bounds: Bounds) -> String {
    if bounds == example.bounds() {
        let [x, y, z] = bounds.size().to_array();
        return format!("house_{x}x{y}x{z}");
    }
    let (material, feature) = match example {
        Example::Blocks(grid) => {
            let mut volumes = vec![0; grid.palette().states().len()];
            bounds.cells().for_each(|cell| volumes[usize::from(grid.id(cell))] += 1);
            let states = grid.palette().states().iter().zip(volumes);
            let solid: Vec<(&BlockState, u64)> =
                states.filter(|(state, volume)| *volume > 0 && !state.is_air()).collect();
            (most(solid.iter().map(|(state, volume)| (state.short_name(), *volume))), feature(&solid))
        }
        Example::Boxes(boxes) => {
            let inside = boxes
                .boxes
                .iter()
                .map(|labelled| (labelled.label.as_str(), labelled.bounds.intersect(&bounds).volume()));
            (most(inside.filter(|(_, volume)| *volume > 0)), None)
        }
    };
    let words = [feature.map(str::to_owned), Some(material), Some(stance(bounds.size()).to_owned())];
    let name = words.into_iter().flatten().collect::<Vec<_>>().join("_");
    super::emit::identifier(name.rsplit(':').next().unwrap_or(&name))
}

/// The name with the largest volume in all, the first by name of equal ones.
fn most<'a>(volumes: impl Iterator<Item = (&'a str, u64)>) -> String {
    let mut sums: BTreeMap<&str, u64> = BTreeMap::new();
    volumes.for_each(|(name, volume)| *sums.entry(name).or_insert(0) += volume);
    let most = sums.iter().max_by_key(|(name, volume)| (**volume, std::cmp::Reverse(**name)));
    most.map_or_else(|| "empty".to_owned(), |(name, _)| (*name).to_owned())
}

fn feature(states: &[(&BlockState, u64)]) -> Option<&'static str> {
    let has = |is: fn(&BlockState) -> bool| states.iter().any(|(state, _)| is(state));
    if has(|state| matches!(block::shape(state), Shape::Door(_))) {
        Some("door")
    } else if has(|state| state.name().contains("glass")) {
        Some("window")
    } else {
        None
    }
}

fn stance(size: Cell) -> &'static str {
    let is_thin = Axis::ALL.map(|axis| axis.of(size) == 1);
    match is_thin {
        [true, _, true] => "post",
        [true, true, _] | [_, true, true] => "row",
        [_, true, _] => "floor",
        [true, ..] | [.., true] => "wall",
        _ => "body",
    }
}
