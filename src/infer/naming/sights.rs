//! What all the places of an operation have in common, as derivations of the examples tell.

use super::kinds::{Kind, Leaf};
use crate::graph::{NodeIndex, OpGraph};
use crate::infer::Example;
use crate::parse::{Choice, Derivation, Labels, Laws, Parser, Step};
use crate::space::{Axis, Bounds, Cell};
use std::collections::{BTreeMap, BTreeSet};

/// Larger examples are not looked at: their rules are named after what they hold alone.
const MOST_CELLS: u64 = 1 << 21;

/// The same of examples of more labelled boxes.
const MOST_BOXES: usize = 1 << 10;

/// How a place lies along an axis of its example.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Along {
    Whole,
    /// Its middle is in the first third.
    Low,
    Middle,
    High,
}

/// How often something was seen.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Seen {
    pub times: u32,
    pub examples: u32,
    /// The last example, counted from 1.
    last: usize,
}

impl Seen {
    fn note(&mut self, example: usize) {
        self.times += 1;
        self.examples += u32::from(self.last != example + 1);
        self.last = example + 1;
    }
}

/// What is known of an operation from all of its places.
#[derive(Clone, Default, Debug)]
pub struct Sight {
    /// The least and the greatest size; `None` where no place is known.
    pub sizes: Option<[Cell; 2]>,
    pub along: [BTreeSet<Along>; 3],
    /// Cells by kind, and by material those of all but doors, windows and nothing.
    pub kinds: BTreeMap<Kind, u64>,
    pub words: BTreeMap<String, u64>,
    /// Of a choice, each alternative.
    pub chosen: Vec<Seen>,
}

impl Sight {
    fn note(&mut self, place: Bounds, whole: Bounds) {
        let size = place.size();
        let [low, high] = self.sizes.unwrap_or([size, size]);
        self.sizes = Some([low.min(size), high.max(size)]);
        for axis in Axis::ALL {
            self.along[axis.index()].insert(along(place, whole, axis));
        }
    }

    fn hold(&mut self, leaf: &Leaf, cells: u64) {
        let held = self.kinds.entry(leaf.kind).or_default();
        *held = held.saturating_add(cells);
        if !matches!(leaf.kind, Kind::Nothing | Kind::Window | Kind::Door) {
            *self.words.entry(leaf.word.clone()).or_default() += cells;
        }
    }

    /// Whether it is one block thin wherever it stands.
    pub fn is_thin(&self, axis: Axis) -> bool {
        self.sizes.is_some_and(|[_, high]| axis.of(high) == 1)
    }

    /// How it lies along an axis, if it lies so in all places.
    pub fn lies(&self, axis: Axis) -> Option<Along> {
        let known = &self.along[axis.index()];
        known.first().copied().filter(|_| known.len() == 1)
    }

    pub fn cells(&self, kind: Kind) -> u64 {
        self.kinds.get(&kind).copied().unwrap_or(0)
    }

    /// All cells but those of nothing.
    pub fn filled(&self) -> u64 {
        self.kinds.iter().filter(|(kind, _)| **kind != Kind::Nothing).map(|(_, cells)| cells).sum()
    }

    /// Whether half of what it holds is of these kinds.
    pub fn is_mostly(&self, kinds: &[Kind]) -> bool {
        let cells: u64 = kinds.iter().map(|kind| self.cells(*kind)).sum();
        cells > 0 && 2 * cells >= self.filled()
    }

    /// The materials, those of most cells first.
    pub fn materials(&self) -> Vec<&str> {
        let mut words: Vec<(&String, &u64)> = self.words.iter().collect();
        words.sort_by_key(|(word, cells)| (std::cmp::Reverse(**cells), *word));
        words.into_iter().map(|(word, _)| word.as_str()).collect()
    }
}

fn along(place: Bounds, whole: Bounds, axis: Axis) -> Along {
    if place.len(axis) == whole.len(axis) {
        return Along::Whole;
    }
    let middle = axis.of(place.min + place.max) - 2 * axis.of(whole.min);
    match 3 * middle {
        middle if middle < 2 * whole.len(axis) => Along::Low,
        middle if middle > 4 * whole.len(axis) => Along::High,
        _ => Along::Middle,
    }
}

/// The sight of each node.
pub fn sights(graph: &OpGraph, labels: &Labels, examples: &[Example]) -> Vec<Sight> {
    // What is turned holds what it turns.
    let is_childless = |node: &NodeIndex| graph.children(*node).next().is_none();
    let leaves = graph.nodes().map(|node| Leaf::of(graph, node).filter(|_| is_childless(&node)));
    let leaves: Vec<Option<Leaf>> = leaves.collect();
    let mut sights = vec![Sight::default(); graph.len()];
    let parser = Parser::new(graph, Laws::AsWritten).with_labels(labels);
    for (number, example) in examples.iter().enumerate() {
        if let Some(derivation) = derivation(&parser, example) {
            look(&mut sights, graph, &leaves, &derivation, (number, example.bounds()));
        }
    }
    guess(&mut sights, graph, &leaves);
    sights
}

fn derivation(parser: &Parser<'_>, example: &Example) -> Option<Derivation> {
    match example {
        // What no derivation explains takes long to find.
        _ if !is_small(example) => None,
        Example::Boxes(boxes) if boxes.boxes.len() > MOST_BOXES => None,
        Example::Boxes(boxes) => parser.any_of_boxes(boxes),
        Example::Blocks(_) if !example.is_derived_by(parser) => None,
        Example::Blocks(grid) => parser.parse(grid).ok(),
    }
}

/// Labelled boxes take no time for their cells.
fn is_small(example: &Example) -> bool {
    matches!(example, Example::Boxes(_)) || example.bounds().volume() <= MOST_CELLS
}

fn look(
    sights: &mut [Sight],
    graph: &OpGraph,
    leaves: &[Option<Leaf>],
    derivation: &Derivation,
    (number, whole): (usize, Bounds),
) {
    let mut around: Vec<NodeIndex> = Vec::new();
    for Step { node, scope, depth, choice, .. } in &derivation.steps {
        around.truncate(*depth as usize);
        around.push(*node);
        let sight = &mut sights[node.index()];
        sight.note(scope.bounds, whole);
        if let Choice::Alternative(alternative) = choice {
            sight.chosen.resize(graph.children(*node).count(), Seen::default());
            sight.chosen[*alternative as usize].note(number);
        }
        if let Some(leaf) = &leaves[node.index()] {
            let cells = scope.bounds.volume();
            around.iter().for_each(|node| sights[node.index()].hold(leaf, cells));
        }
    }
}

/// What is known of nodes that stand in no derivation: what lies below them, each mention as one cell.
fn guess(sights: &mut [Sight], graph: &OpGraph, leaves: &[Option<Leaf>]) {
    for node in graph.inner_first() {
        if !sights[node.index()].kinds.is_empty() {
            continue;
        }
        let mut sight = std::mem::take(&mut sights[node.index()]);
        if let Some(leaf) = &leaves[node.index()] {
            sight.hold(leaf, 1);
        }
        for (_, child) in graph.children(node) {
            let below = &sights[child.index()];
            below.kinds.iter().for_each(|(kind, _)| *sight.kinds.entry(*kind).or_default() += 1);
            below.words.keys().for_each(|word| *sight.words.entry(word.clone()).or_default() += 1);
        }
        sights[node.index()] = sight;
    }
}
