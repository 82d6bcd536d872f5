//! Combining the trees of all examples: splits of one structure become one kind of split
//! (seed 1, chapter 10).

use super::fold::{Folded, Piece, fold};
use super::law::{Law, Lengths, Stretch, certain, ranges};
use super::tree::{Node, Tree};
use crate::space::{Axis, Bounds};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Where sizes may be left to chance.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Chance {
    /// Wherever the structure is the same, as in seed 1: labels say what belongs together.
    Anywhere,
    /// Nowhere: what a draw puts side by side may stand so in no example.
    Nowhere,
    /// Only in bodies of their own. Slices of one body that draw without knowing of each other would tear
    /// it apart.
    Bodies,
}

/// The number of a kind of operation.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct KindId(pub u32);

/// One operation that stands for many places in the examples.
#[derive(Clone, PartialEq, Debug)]
pub enum Kind {
    Nil,
    Leaf(u32),
    Split { axis: Axis, items: Vec<Item> },
}

/// A part of a kind of split.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    pub law: Law,
    pub content: Content,
}

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Content {
    One(KindId),
    /// These parts again and again, as often as they fit.
    Repeat(Vec<Piece<KindId>>),
}

/// The kinds of all examples, children before parents.
#[derive(Debug)]
pub struct Kinds {
    pub list: Vec<Kind>,
    /// The kind of each slab.
    pub roots: Vec<KindId>,
    /// Whether a kind can be any length along an axis that is not below the shortest seen.
    elastic: Vec<[bool; 3]>,
    /// Leaves that have one size.
    rigid: BTreeSet<u32>,
}

/// A part of an example with its split tree.
#[derive(Debug)]
pub struct Slab {
    pub bounds: Bounds,
    pub tree: Tree,
}

/// Finds the kinds of the trees, each laid out in its box. Leaves with a label of `rigid` have one size.
pub fn combine(slabs: &[Slab], chance: Chance, rigid: BTreeSet<u32>) -> Kinds {
    let forest = Forest::plant(slabs);
    let mut kinds = Kinds { list: Vec::new(), roots: Vec::new(), elastic: Vec::new(), rigid };
    let mut of_node = vec![KindId(u32::MAX); forest.nodes.len()];
    let mut simple: FxHashMap<u64, KindId> = FxHashMap::default();
    for level in forest.levels() {
        let mut groups: Vec<Group> = Vec::new();
        let mut known: FxHashMap<(Axis, Vec<Content>), usize> = FxHashMap::default();
        for number in level {
            let node = &forest.nodes[number];
            match &node.grown {
                Grown::Nil => of_node[number] = kinds.simple(&mut simple, u64::MAX, Kind::Nil),
                Grown::Leaf(label) => {
                    of_node[number] = kinds.simple(&mut simple, u64::from(*label), Kind::Leaf(*label));
                }
                Grown::Split { axis, parts } => {
                    let pieces: Vec<Piece<KindId>> =
                        parts.iter().map(|(len, child)| (*len, of_node[*child])).collect();
                    let folded = fold(&pieces);
                    let contents: Vec<Content> = folded.iter().map(content).collect();
                    let fresh = groups.len();
                    let group = *known.entry((*axis, contents.clone())).or_insert(fresh);
                    if group == fresh {
                        groups.push(Group { axis: *axis, contents, members: Vec::new() });
                    }
                    groups[group].members.push((number, folded.iter().map(Folded::len).collect()));
                    continue;
                }
            }
        }
        for group in groups {
            kinds.settle(group, &forest, chance, &mut of_node);
        }
    }
    kinds.roots = forest.roots.iter().map(|root| of_node[*root]).collect();
    kinds
}

fn content(item: &Folded<KindId>) -> Content {
    match item {
        Folded::One((_, child)) => Content::One(*child),
        Folded::Repeat { unit, .. } => Content::Repeat(unit.clone()),
    }
}

/// Splits of one structure: the same axis and the same contents in the same order.
struct Group {
    axis: Axis,
    contents: Vec<Content>,
    /// The nodes and the lengths of their items.
    members: Vec<(usize, Lengths)>,
}

impl Kinds {
    fn simple(&mut self, known: &mut FxHashMap<u64, KindId>, key: u64, kind: Kind) -> KindId {
        *known.entry(key).or_insert_with(|| self.add(kind))
    }

    fn add(&mut self, kind: Kind) -> KindId {
        self.elastic.push(Axis::ALL.map(|axis| self.stretches(&kind, axis)));
        self.list.push(kind);
        KindId(self.list.len() as u32 - 1)
    }

    /// Makes kinds of a group: one if its sizes follow one law, else one for each law.
    fn settle(&mut self, group: Group, forest: &Forest, chance: Chance, of_node: &mut [KindId]) {
        let Group { axis, contents, members } = group;
        for (laws, members) in self.settled(axis, &contents, members, forest, chance) {
            let items = laws.into_iter().zip(&contents);
            let items = items.map(|(law, content)| Item { law, content: content.clone() }).collect();
            let kind = self.add(Kind::Split { axis, items });
            for number in members {
                of_node[number] = kind;
            }
        }
    }

    /// The laws of a group, each with the nodes that follow it.
    fn settled(
        &self,
        axis: Axis,
        contents: &[Content],
        members: Members,
        forest: &Forest,
        chance: Chance,
    ) -> Vec<(Vec<Law>, Vec<usize>)> {
        let nodes = |members: &Members| members.iter().map(|(number, _)| *number).collect();
        if let Some(laws) = certain(&lengths_of(&members)) {
            return vec![(laws, nodes(&members))];
        }
        let stretch: Vec<Stretch> = contents.iter().map(|content| self.stretch(content, axis)).collect();
        let mut settled = Vec::new();
        for alike in clusters(members) {
            let seen = lengths_of(&alike);
            let is_free = match chance {
                Chance::Anywhere => true,
                Chance::Nowhere => false,
                Chance::Bodies => is_free(&alike, forest),
            };
            let laws = certain(&seen).or_else(|| ranges(&seen, &stretch).filter(|_| is_free));
            match laws {
                Some(laws) => settled.push((laws, nodes(&alike))),
                None => settled.extend(by_fixed_sizes(alike)),
            }
        }
        settled
    }

    fn stretch(&self, content: &Content, axis: Axis) -> Stretch {
        match content {
            Content::One(kind) if self.list[kind.0 as usize] == Kind::Nil => Stretch::Empty,
            Content::One(kind) if self.is_elastic(*kind, axis) => Stretch::Elastic,
            Content::One(_) => Stretch::Rigid,
            Content::Repeat(unit) => Stretch::Multiple(unit.iter().map(|(len, _)| len).sum()),
        }
    }

    fn is_elastic(&self, kind: KindId, axis: Axis) -> bool {
        self.elastic[kind.0 as usize][axis.index()]
    }

    fn stretches(&self, kind: &Kind, axis: Axis) -> bool {
        let (own, items) = match kind {
            Kind::Nil => return true,
            Kind::Leaf(label) => return !self.rigid.contains(label),
            Kind::Split { axis, items } => (axis, items),
        };
        items.iter().filter(|item| *own != axis || item.law == Law::Float).all(|item| match &item.content {
            Content::One(child) => self.is_elastic(*child, axis),
            Content::Repeat(unit) => {
                *own != axis && unit.iter().all(|(_, child)| self.is_elastic(*child, axis))
            }
        })
    }
}

type Members = Vec<(usize, Lengths)>;

fn lengths_of(members: &Members) -> Vec<&Lengths> {
    members.iter().map(|(_, lengths)| lengths).collect()
}

/// Lengths of one part that differ more than this many times over belong to different things.
const ALIKE: i32 = 3;

/// Members whose lengths are alike part by part, so that no bar is stretched into a wall.
fn clusters(members: Members) -> Vec<Members> {
    let mut clusters: Vec<Members> = Vec::new();
    for member in members {
        let fits = |cluster: &&mut Members| cluster.iter().all(|(_, lengths)| are_alike(lengths, &member.1));
        match clusters.iter_mut().find(fits) {
            Some(cluster) => cluster.push(member),
            None => clusters.push(vec![member]),
        }
    }
    clusters
}

fn are_alike(a: &Lengths, b: &Lengths) -> bool {
    a.iter().zip(b).all(|(a, b)| *a.max(b) <= ALIKE * a.min(b))
}

/// Thinner bodies than this, in blocks, are slices of something larger.
const BODY: i32 = 3;

fn is_free(members: &Members, forest: &Forest) -> bool {
    members.iter().all(|(number, _)| {
        let node = &forest.nodes[*number];
        let Grown::Split { axis, .. } = &node.grown else { return false };
        axis.others().iter().all(|other| node.bounds.len(*other) >= BODY)
    })
}

/// One kind for each set of lengths that agrees in all parts but the one that varies most.
fn by_fixed_sizes(members: Members) -> Vec<(Vec<Law>, Vec<usize>)> {
    let seen = lengths_of(&members);
    let spread = |part: usize| {
        let lengths = seen.iter().map(|lengths| lengths[part]);
        lengths.clone().max().unwrap_or(0) - lengths.min().unwrap_or(0)
    };
    let floating = (0..seen[0].len()).rev().max_by_key(|part| spread(*part)).unwrap_or(0);
    let mut groups: Vec<(Vec<Law>, Vec<usize>)> = Vec::new();
    for (number, lengths) in &members {
        let law = |part: usize| if part == floating { Law::Float } else { Law::Const(lengths[part]) };
        let laws: Vec<Law> = (0..lengths.len()).map(law).collect();
        match groups.iter_mut().find(|(known, _)| *known == laws) {
            Some((_, nodes)) => nodes.push(*number),
            None => groups.push((laws, vec![*number])),
        }
    }
    groups
}

/// The nodes of all trees with their places, children before parents.
struct Forest {
    nodes: Vec<Planted>,
    roots: Vec<usize>,
}

struct Planted {
    bounds: Bounds,
    /// 0 for leaves, one more than the highest child for splits.
    height: usize,
    grown: Grown,
}

enum Grown {
    Nil,
    Leaf(u32),
    /// Lengths and children by their number in the forest.
    Split {
        axis: Axis,
        parts: Vec<(i32, usize)>,
    },
}

impl Forest {
    fn plant(slabs: &[Slab]) -> Forest {
        let mut forest = Forest { nodes: Vec::new(), roots: Vec::new() };
        for slab in slabs {
            let root = forest.plant_tree(&slab.tree, slab.bounds);
            forest.roots.push(root);
        }
        forest
    }

    /// Adds the nodes of a tree, children first.
    fn plant_tree(&mut self, tree: &Tree, bounds: Bounds) -> usize {
        let order = tree.in_levels(bounds);
        let (first, count) = (self.nodes.len(), order.len());
        let number = |at: usize| first + count - 1 - at;
        for (id, bounds, children) in order.into_iter().rev() {
            let grown = match tree.node(id) {
                Node::Nil => Grown::Nil,
                Node::Leaf(label) => Grown::Leaf(label),
                Node::Split { axis, parts } => {
                    let parts = parts.iter().enumerate().map(|(at, part)| (part.len, number(children + at)));
                    Grown::Split { axis, parts: parts.collect() }
                }
            };
            let height = match &grown {
                Grown::Split { parts, .. } => {
                    1 + parts.iter().map(|(_, child)| self.nodes[*child].height).max().unwrap_or(0)
                }
                Grown::Nil | Grown::Leaf(_) => 0,
            };
            self.nodes.push(Planted { bounds, height, grown });
        }
        number(0)
    }

    /// The numbers of the nodes by height, lowest first, each level in the order of the examples.
    fn levels(&self) -> Vec<Vec<usize>> {
        let mut levels: Vec<Vec<usize>> = Vec::new();
        for (number, node) in self.nodes.iter().enumerate() {
            if levels.len() <= node.height {
                levels.resize(node.height + 1, Vec::new());
            }
            levels[node.height].push(number);
        }
        levels
    }
}
