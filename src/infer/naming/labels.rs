//! A name of its own for each rule.

use super::kinds::Leaf;
use super::phrases::{Common, phrases};
use super::rules::Rule;
use super::sights::Sight;
use super::words::{self, Alternative, Form, Noun};
use crate::block::{self, is_material};
use crate::grammar::{is_primitive, is_reserved};
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph, RuleName};
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// Gives every rule the first name of its candidates that is free.
pub fn label(graph: &mut OpGraph, rules: &[Rule], sights: &[Sight]) {
    let nouns = nouns(graph, rules, sights);
    let mut common = Common::default();
    nouns.iter().for_each(|(node, noun)| common.note(*noun, &sights[node.index()]));
    let mut taken = Taken::by_constants(graph);
    for (node, noun) in nouns {
        let candidates = match node == graph.root() {
            true => vec!["house".to_owned()],
            false => candidates(graph, node, noun, sights, &common),
        };
        let name = RuleName { label: taken.first_free(&candidates), ..RuleName::default() };
        graph.set_name(node, name);
    }
    name_params(graph);
}

/// What each rule is called, if not yet which of them.
fn nouns(graph: &OpGraph, rules: &[Rule], sights: &[Sight]) -> Vec<(NodeIndex, Noun)> {
    let units = units(graph);
    let noun = |node: NodeIndex| {
        let cut = match graph.op(node) {
            Op::Split { axis: Expr::Axis(axis), .. } => Some(*axis),
            _ => None,
        };
        words::noun(&sights[node.index()], units.get(&node).copied(), cut)
    };
    rules.iter().map(|rule| (rule.node, noun(rule.node))).collect()
}

/// The axes that operations are repeated on.
fn units(graph: &OpGraph) -> BTreeMap<NodeIndex, Axis> {
    let unit = |node| match graph.op(node) {
        Op::Repeat { axis: Expr::Axis(axis), .. } | Op::RepeatN { axis: Expr::Axis(axis), .. } => {
            graph.children(node).next().map(|(_, child)| (child, *axis))
        }
        _ => None,
    };
    graph.nodes().filter_map(unit).collect()
}

/// Names for an operation, the best first.
fn candidates(
    graph: &OpGraph,
    node: NodeIndex,
    noun: Noun,
    sights: &[Sight],
    common: &Common,
) -> Vec<String> {
    let sight = &sights[node.index()];
    let phrases = phrases(sight, noun, common);
    choice(graph, node, sights, noun).into_iter().chain(size_name(sight, noun)).chain(phrases).collect()
}

/// A choice after its alternatives: `window_or_wall`, `maybe_railing`.
fn choice(graph: &OpGraph, node: NodeIndex, sights: &[Sight], noun: Noun) -> Vec<String> {
    if *graph.op(node) != Op::Choose {
        return Vec::new();
    }
    let sight = &sights[node.index()];
    let form = Form::of(sight);
    let what =
        |child: NodeIndex| words::alternative(Leaf::of(graph, child).as_ref(), &sights[child.index()], form);
    let distinct: BTreeSet<Alternative> = graph.children(node).map(|(_, child)| what(child)).collect();
    let mut words: Vec<&str> = distinct
        .iter()
        .filter_map(|what| if let Alternative::Word(word) = what { Some(*word) } else { None })
        .collect();
    words.sort_by_key(|word| ORDER.iter().position(|known| known == word).unwrap_or(ORDER.len()));
    let name = match (words.as_slice(), distinct.contains(&Alternative::Nothing)) {
        ([] | [_], true) => format!("maybe_{}", noun.word),
        ([one, other], false) => format!("{one}_or_{other}"),
        _ => return Vec::new(),
    };
    let side = words::side(sight).map(|side| format!("{side}_{name}"));
    std::iter::once(name).chain(side).collect()
}

/// Alternatives in the order of their mention.
const ORDER: [&str; 5] = ["door", "window", "railing", "roof", "furniture"];

/// `house_9x7x12` of houses of one size.
fn size_name(sight: &Sight, noun: Noun) -> Option<String> {
    let [low, high] = sight.sizes?;
    let [x, y, z] = low.to_array();
    (noun.word == "house" && low == high).then(|| format!("house_{x}x{y}x{z}"))
}

/// The names that are taken, by constants and by rules.
struct Taken(BTreeSet<String>);

impl Taken {
    fn by_constants(graph: &OpGraph) -> Taken {
        Taken(graph.constants.iter().map(|known| known.name.clone()).collect())
    }

    /// The first candidate that is free, else the first with a number.
    fn first_free(&mut self, candidates: &[String]) -> String {
        let first = candidates.first().map_or("part", String::as_str);
        let numbered = (2..).map(|number| format!("{first}_{number}"));
        let others = candidates.iter().skip(1).cloned();
        let mut all = std::iter::once(first.to_owned()).chain(others).chain(numbered);
        let free = all.find(|name| is_name(name) && !self.0.contains(name)).unwrap_or_default();
        self.0.insert(free.clone());
        free
    }
}

/// Whether a name means nothing else: no block, no material, no primitive and no word of the language.
pub fn is_name(name: &str) -> bool {
    !is_reserved(name) && !is_primitive(name) && block::known(name).is_none() && !is_material(name)
}

/// Names for the parameters of what is called: what they measure.
fn name_params(graph: &mut OpGraph) {
    let calls = graph.nodes().filter_map(|node| match graph.op(node) {
        Op::Call(args) => graph.children(node).next().map(|(_, target)| (target, args.len())),
        _ => None,
    });
    for (target, count) in calls.collect::<BTreeMap<_, _>>() {
        if let Some(known) = graph.name(target) {
            let params = (0..count).map(|param| param_name(graph, target, param)).collect();
            let name = RuleName { params, ..known.clone() };
            graph.set_name(target, name);
        }
    }
}

/// `margin` for what is left on either side, the length along the axis for the size of a part, else a material.
fn param_name(graph: &OpGraph, target: NodeIndex, param: usize) -> String {
    let uses = |arg: &Arg| matches!(arg, Arg::Size(size) if size.value == Expr::Param(param));
    let parts: Vec<bool> = graph.children(target).map(|(arg, _)| uses(arg)).collect();
    let word = match (graph.op(target), parts.as_slice()) {
        (_, [true, .., true]) => "margin",
        (_, parts) if !parts.contains(&true) => "material",
        (Op::Split { axis: Expr::Axis(Axis::X), .. }, _) => "width",
        (Op::Split { axis: Expr::Axis(Axis::Y), .. }, _) => "height",
        (Op::Split { axis: Expr::Axis(Axis::Z), .. }, _) => "depth",
        _ => "length",
    };
    if param == 0 { word.to_owned() } else { format!("{word}_{}", param + 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_means_something_else_is_passed_over() {
        let mut taken = Taken(BTreeSet::from(["wall".to_owned()]));
        let candidates = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let all = candidates(&["wall", "stone", "oak", "door", "split", "oak_wall"]);
        assert_eq!(taken.first_free(&all), "oak_wall");
        assert_eq!(taken.first_free(&all), "wall_2");
        assert_eq!(taken.first_free(&[]), "part");
    }
}
