//! Comments for people: where rules come from, how often each was seen, and what to change first.

use super::sights::{Seen, Sight};
use super::storeys;
use crate::grammar::Grammar;
use crate::graph::{Alternative, Arg, Expr, NodeIndex, OpGraph, raise};
use crate::infer::{Example, Method};
use crate::space::Axis;
use std::collections::BTreeMap;

/// Comments for the grammar of a graph. They say nothing that a program needs.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Notes {
    /// For the head of the file.
    head: Vec<String>,
    /// Above the start sizes.
    sizes: Vec<String>,
    /// Above constants, by name.
    constants: BTreeMap<String, String>,
    /// Behind the alternatives of each label.
    alternatives: BTreeMap<String, Vec<String>>,
}

impl Notes {
    /// The grammar of a graph, with these comments.
    pub fn write(&self, graph: &OpGraph) -> Grammar {
        let mut grammar = raise(graph);
        grammar.preamble.extend(self.head.iter().cloned());
        if let Some(first) = grammar.sizes.first_mut() {
            first.comments.extend(self.sizes.iter().cloned());
        }
        for constant in &mut grammar.constants {
            constant.comments.extend(self.constants.get(&constant.name.name).cloned());
        }
        let mut left = self.alternatives.clone();
        left.values_mut().for_each(|notes| notes.reverse());
        for rule in &mut grammar.rules {
            rule.behind = left.get_mut(&rule.label.name).and_then(Vec::pop);
        }
        grammar
    }
}

/// The comments for a graph whose rules and constants have their names.
pub fn notes(graph: &OpGraph, sights: &[Sight], examples: &[Example], by: Method) -> Notes {
    let alternatives = alternatives(graph, sights, examples.len());
    Notes {
        head: head(graph, by, !alternatives.is_empty()),
        sizes: sizes(graph, examples),
        constants: constants(graph),
        alternatives,
    }
}

fn head(graph: &OpGraph, by: Method, has_choices: bool) -> Vec<String> {
    let way = match by {
        Method::Joint => "Learnt from all of them at once: a rule holds wherever something like it stands.",
        Method::Boxes | Method::Shapes => {
            "Learnt from each by itself: what is equal in several of them is one rule."
        }
    };
    let has = |name: &str| graph.constants.iter().any(|known| known.name == name);
    let has_materials = graph.constants.iter().any(|known| known.name != storeys::NAME);
    let first = [
        has(storeys::NAME).then_some("the storeys"),
        has_materials.then_some("the materials"),
        (!graph.sizes.is_empty()).then_some("the sizes"),
    ];
    let first: Vec<&str> = first.into_iter().flatten().collect();
    let choices =
        "Of several rules with one name one is drawn, by the number behind it: how often it was seen.";
    let mut lines = vec![way.to_owned(), format!("What to change first: {}.", listed(&first))];
    lines.extend(has_choices.then(|| choices.to_owned()));
    lines
}

fn listed(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

/// What the numbers of a start size measure, and what was seen of each.
fn sizes(graph: &OpGraph, examples: &[Example]) -> Vec<String> {
    let seen = |axis: Axis| {
        let lens = || examples.iter().map(|example| axis.of(example.bounds().size()));
        match (lens().min().unwrap_or(0), lens().max().unwrap_or(0)) {
            (low, high) if low == high => format!("{low}"),
            (low, high) => format!("{low} to {high}"),
        }
    };
    let [x, y, z] = Axis::ALL.map(seen);
    match graph.sizes.as_slice() {
        [] => Vec::new(),
        [_] => vec![format!("Width, height and depth in blocks; seen: {x}, {y} and {z}.")],
        _ => vec![format!("Width, height and depth in blocks of the examples: {x}, {y} and {z}.")],
    }
}

fn constants(graph: &OpGraph) -> BTreeMap<String, String> {
    let storeys = graph.constants.iter().find(|known| known.name == storeys::NAME);
    let materials = graph.constants.iter().find(|known| known.name != storeys::NAME);
    let storeys =
        storeys.map(|known| (known.name.clone(), "How many storeys stand over one another.".to_owned()));
    let materials =
        materials.map(|known| (known.name.clone(), "Materials, by what most of them is for.".to_owned()));
    storeys.into_iter().chain(materials).collect()
}

/// How often each alternative of each choice was seen; where a rule calls itself, its size tells which.
fn alternatives(graph: &OpGraph, sights: &[Sight], examples: usize) -> BTreeMap<String, Vec<String>> {
    let of_node = |node: NodeIndex| {
        let seen = &sights[node.index()].chosen;
        if graph.leads_to(node, node) {
            return None;
        }
        let label = graph.name(node)?.label.clone();
        (!seen.is_empty()).then(|| (label, texts(&weights(graph, node), seen, examples)))
    };
    graph.nodes().filter_map(of_node).collect()
}

/// The weights of a choice, those that are whole numbers.
fn weights(graph: &OpGraph, node: NodeIndex) -> Vec<Option<u32>> {
    let weight = |arg: &Arg| match arg {
        Arg::Alternative(Alternative { weight: Expr::Number(weight), .. }) if weight.0.fract() == 0.0 => {
            Some(weight.0 as u32)
        }
        _ => None,
    };
    graph.children(node).map(|(arg, _)| weight(arg)).collect()
}

/// The weights are how often each alternative was seen; in how many houses, derivations tell. Where these are of other
/// alternatives, or some were put together of parts and seen nowhere, the weights only say what will be drawn.
fn texts(weights: &[Option<u32>], seen: &[Seen], examples: usize) -> Vec<String> {
    let total: u32 = weights.iter().flatten().sum();
    let are_same = weights.iter().zip(seen).all(|(weight, seen)| *weight == Some(seen.times));
    let is_once_each = total as usize == examples && seen.iter().all(|seen| seen.times == seen.examples);
    let text = |(weight, seen): (&Option<u32>, &Seen)| match (weight, are_same) {
        (Some(times), true) if is_once_each => format!("seen in {times} of {examples} houses"),
        (Some(times), true) => format!("seen {times} of {total} times, in {}", houses(seen.examples)),
        (Some(times), false) => format!("drawn {times} of {total} times"),
        (None, _) => format!("seen {} times, in {}", seen.times, houses(seen.examples)),
    };
    weights.iter().zip(seen).map(text).collect()
}

fn houses(count: u32) -> String {
    format!("{count} house{}", if count == 1 { "" } else { "s" })
}
