//! From a plan to an op graph.

use super::labels::{Meaning, What, area};
use super::plan::{Node, NodeId, Plan};
use super::rules::{Length as RuleLength, Rules, Symbol};
use super::search::Parsed;
use super::stretch::{self, Giving, Length, Stretched, Stretchy};
use super::{Layout, Side, Stretch};
use crate::block;
use crate::grammar::ast::{BinaryOp, Function};
use crate::grammar::{is_primitive, is_reserved};
use crate::graph::{
    Alternative, Arg, Attribute, Builder, Constant, Expr, Group, NodeIndex, Op, OpGraph, RuleName, Size,
    Thing,
};
use crate::space::Axis;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The label of the rule for a facade, and that for the choice of several.
const FACADE: &str = "facade";
const FACADES: &str = "facades";

/// The label of the rule for all of a facade, by its number from 0.
pub fn facade_label(number: usize) -> String {
    if number == 0 { FACADE.to_owned() } else { format!("{FACADE}_{}", number + 1) }
}

/// Rules of so many parts are rules of their own.
const LARGE: usize = 4;

/// Facades as a graph, before they are given a form.
pub struct Emitted {
    pub builder: Builder,
    pub constants: Vec<Constant>,
    pub root: NodeIndex,
    pub names: Vec<(NodeIndex, String, Vec<String>)>,
}

/// How deep a facade is: the blocks before its walls, and behind their front.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Depth {
    pub before: u32,
    pub behind: u32,
}

impl Depth {
    /// What the labels need.
    pub fn of(meanings: &[Meaning]) -> Depth {
        let offsets = || meanings.iter().map(|meaning| meaning.offset);
        let before = offsets().max().unwrap_or(0).max(0) as u32;
        let behind = offsets().map(|offset| -offset).max().unwrap_or(0).max(0) as u32 + 1;
        Depth { before, behind }
    }

    pub fn total(self) -> u32 {
        self.before + self.behind
    }
}

/// One graph of several facades with one list of labels: a choice of them, by chance.
pub fn emit(parsed: &[(Layout, Parsed)], meanings: &[Meaning], depth: Depth, variety: Variety) -> Emitted {
    let labels = parsed.first().map_or([].as_slice(), |(layout, _)| layout.labels());
    let mut shared = Shared::new(labels, meanings, depth, variety);
    let wall = wall(parsed.iter().map(|(layout, _)| layout), meanings);
    let roots: Vec<NodeIndex> =
        parsed.iter().map(|(layout, parsed)| shared.facade(layout.size(), parsed, wall)).collect();
    for (number, root) in roots.iter().enumerate() {
        shared.names.insert(number, (*root, facade_label(number), Vec::new()));
    }
    let root = shared.builder.choose(roots.iter().map(|root| (1.0, *root)));
    if roots.iter().any(|facade| *facade != root) {
        shared.names.insert(0, (root, FACADES.to_owned(), Vec::new()));
    }
    shared.emitted(root)
}

/// The soft label that covers most.
fn wall<'l>(layouts: impl Iterator<Item = &'l Layout> + Clone, meanings: &[Meaning]) -> u32 {
    let soft = (0..meanings.len()).filter(|label| meanings[*label].stretch == Stretch::Soft);
    soft.max_by_key(|label| layouts.clone().map(|layout| area(layout, *label)).sum::<u64>()).unwrap_or(0)
        as u32
}

/// What leaves of a label are, as a graph.
pub fn emit_leaf(labels: &[String], label: u32, meanings: &[Meaning], depth: Depth) -> OpGraph {
    let mut shared = Shared::new(labels, meanings, depth, Variety::None);
    let root = shared.leaf(label);
    let mut graph = shared.emitted(root).finish(root);
    graph.sizes.clear();
    graph
}

impl Emitted {
    /// The graph with this root.
    pub fn finish(self, root: NodeIndex) -> OpGraph {
        let Emitted { builder, constants, names, .. } = self;
        let (mut graph, numbers) = builder.finish(root);
        graph.constants = constants;
        let mut taken: BTreeMap<String, u32> = BTreeMap::new();
        for (node, name, params) in names {
            let Some(node) = numbers.get(&node).filter(|node| graph.name(**node).is_none()) else { continue };
            // Small rules that stand in one place are read there.
            let is_small =
                graph.children(*node).count() < LARGE && !graph.is_shared(*node) && *node != graph.root();
            if is_small && params.is_empty() {
                continue;
            }
            let times = taken.entry(name.clone()).or_default();
            *times += 1;
            let label = if *times == 1 { name } else { format!("{name}_{times}") };
            graph.set_name(*node, RuleName { label, params, comments: Vec::new() });
        }
        graph
    }
}

/// One for each label: what it is made of.
fn constants(labels: &[String], meanings: &[Meaning]) -> Vec<Constant> {
    let mut constants: Vec<Constant> = Vec::new();
    for (label, meaning) in labels.iter().zip(meanings) {
        let value = match &meaning.what {
            What::Thing(thing) | What::Mesh { block: thing, .. } => Expr::Thing(thing.clone()),
            What::Shape { material, .. } => {
                Expr::Thing(material.clone().unwrap_or(Thing::Name("stone_bricks".to_owned())))
            }
            What::Door { wood } => Expr::name(wood.as_str()),
            What::Nothing => Expr::name("air"),
        };
        let name = free_name(label, &meaning.what, &constants);
        constants.push(Constant { name, value, attribute: None });
    }
    constants
}

/// The label as a name that means nothing else yet. Windows and doors may be called so: their constants say what these
/// primitives are made of.
fn free_name(label: &str, what: &What, taken: &[Constant]) -> String {
    let mut name: String = label.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    if !name.starts_with(|c: char| c.is_alphabetic()) {
        name.insert_str(0, "label_");
    }
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_itself = matches!((base, what), ("window", What::Thing(_)) | ("door", What::Door { .. }));
    let is_free = |name: &String| {
        let is_else = is_primitive(name) && !is_itself;
        !is_reserved(name)
            && !is_else
            && block::known(name).is_none()
            && taken.iter().all(|known| known.name != *name)
    };
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let own = [name.clone(), format!("{name}_label")];
    own.into_iter().chain(numbered).find(is_free).unwrap_or_default()
}

/// What the facades of a graph have in common.
struct Shared<'p> {
    labels: usize,
    meanings: &'p [Meaning],
    depth: Depth,
    variety: Variety,
    builder: Builder,
    constants: Vec<Constant>,
    leaves: BTreeMap<u32, NodeIndex>,
    names: Vec<(NodeIndex, String, Vec<String>)>,
}

/// One facade on its way to a graph.
struct Emitter<'p, 's> {
    shared: &'s mut Shared<'p>,
    plan: &'p Plan,
    rules: &'p Rules,
    giving: Giving,
    size: [u32; 2],
    /// Rules at the lengths that they were drawn with.
    fixed: FxHashMap<Symbol, NodeIndex>,
    elastic: FxHashMap<Place, NodeIndex>,
}

/// A node that takes other lengths along some axes: those that it was drawn with, and what fills gaps.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Place {
    node: NodeId,
    natural: [Option<u32>; 2],
    wall: u32,
}

impl<'p> Shared<'p> {
    fn new(labels: &[String], meanings: &'p [Meaning], depth: Depth, variety: Variety) -> Shared<'p> {
        let constants = constants(labels, meanings);
        let (builder, leaves, names) = (Builder::default(), BTreeMap::new(), Vec::new());
        Shared { labels: labels.len(), meanings, depth, variety, builder, constants, leaves, names }
    }

    fn facade(&mut self, size: [u32; 2], parsed: &'p Parsed, wall: u32) -> NodeIndex {
        let stretch: Vec<Stretch> = self.meanings.iter().map(|meaning| meaning.stretch).collect();
        let is_door = |meaning: &Meaning| matches!(meaning.what, What::Door { .. });
        let doors: Vec<bool> = self.meanings.iter().map(is_door).collect();
        let Parsed { plan, rules } = parsed;
        let giving = Giving::of(plan, &stretch, &doors);
        let (fixed, elastic) = (FxHashMap::default(), FxHashMap::default());
        let mut emitter = Emitter { shared: self, plan, rules, giving, size, fixed, elastic };
        emitter.elastic(Place { node: plan.root, natural: size.map(Some), wall })
    }

    fn emitted(self, root: NodeIndex) -> Emitted {
        let Shared { builder, constants, names, .. } = self;
        Emitted { builder, constants, root, names }
    }
}

/// How much of what was drawn may be exchanged.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Variety {
    /// Every run gives what was drawn.
    #[default]
    None,
    /// By chance, parts with windows stand in for others of their size beside them.
    Exchanged,
}

/// What says how often parts are exchanged.
pub const VARIETY: &str = "variety";

fn variety_constant() -> Constant {
    let about = "how often windows and storeys stand in for others of their size: at 0 never";
    let attribute = Attribute {
        range: Some([Expr::number(0.0), Expr::number(1.0)]),
        group: None,
        about: Some(about.to_owned()),
    };
    Constant { name: VARIETY.to_owned(), value: Expr::number(1.0), attribute: Some(attribute) }
}

impl Emitter<'_, '_> {
    fn elastic(&mut self, place: Place) -> NodeIndex {
        if place.natural == [None, None] {
            return self.fixed(self.rules.of[place.node]);
        }
        if let Some(known) = self.elastic.get(&place) {
            return *known;
        }
        let made = self.make_elastic(place);
        self.elastic.insert(place, made);
        made
    }

    fn make_elastic(&mut self, place: Place) -> NodeIndex {
        let stiff = Side::ALL.into_iter().find(|axis| {
            place.natural[axis.index()].is_some()
                && !self.giving.stretches[axis.index()][place.node]
                && !self.must_stretch(place, *axis)
        });
        if let Some(axis) = stiff {
            return self.walled(place, axis);
        }
        let Node::Split { axis, .. } = &self.plan.nodes[place.node] else {
            return self.fixed(self.rules.of[place.node]);
        };
        let axis = *axis;
        let wall = self.wall_of(place);
        let (split, own) = match place.natural[axis.index()] {
            None => (as_drawn(self.plan, place.node), None),
            Some(length) => match stretch::stretched(self.plan, &self.giving, place.node) {
                Some(split) => (split, Some(length)),
                None => return self.walled(place, axis),
            },
        };
        let node = self.split(axis, &split, |part| {
            let mut natural = place.natural;
            natural[axis.index()] = match part.length {
                Length::Share(share) if own.is_some() => Some(share as u32),
                _ => None,
            };
            (natural, wall)
        });
        self.name(node, place.node, [place.natural[0].unwrap_or(0), place.natural[1].unwrap_or(0)]);
        node
    }

    /// The root has to take any size, across its split as well: its parts then stand in walls, one by one.
    fn must_stretch(&self, place: Place, axis: Side) -> bool {
        let is_across = matches!(&self.plan.nodes[place.node], Node::Split { axis: own, .. } if *own != axis);
        place.node == self.plan.root && is_across
    }

    /// A node at its own length along an axis, with wall on both sides where the scope is longer.
    fn walled(&mut self, place: Place, axis: Side) -> NodeIndex {
        let Some(length) = place.natural[axis.index()] else { return self.elastic(place) };
        let split = stretch::walled(place.node, length);
        let node = self.split(axis, &split, |_| {
            let mut natural = place.natural;
            natural[axis.index()] = None;
            (natural, place.wall)
        });
        let label = match &self.plan.nodes[place.node] {
            Node::Leaf(label) => Some(*label),
            Node::Split { .. } => self.main_label(place.node),
        };
        if let Some(label) = label {
            let name = format!("{}_in_wall", self.shared.constants[label as usize].name);
            self.shared.names.push((node, name, Vec::new()));
        }
        node
    }

    /// The soft label that most of the parts of a node are, else that of the node around it.
    fn wall_of(&self, place: Place) -> u32 {
        let mut lengths: BTreeMap<u32, u32> = BTreeMap::new();
        for part in self.plan.parts(place.node) {
            if let Node::Leaf(label) = &self.plan.nodes[part.node]
                && self.shared.meanings[*label as usize].stretch == Stretch::Soft
            {
                *lengths.entry(*label).or_default() += part.length;
            }
        }
        lengths
            .into_iter()
            .max_by_key(|(label, length)| (*length, std::cmp::Reverse(*label)))
            .map_or(place.wall, |(label, _)| label)
    }

    fn split(
        &mut self,
        axis: Side,
        split: &Stretched,
        place: impl Fn(&Stretchy) -> ([Option<u32>; 2], u32),
    ) -> NodeIndex {
        let mut children = Vec::with_capacity(split.parts.len());
        for part in &split.parts {
            let (natural, wall) = place(part);
            let child = match part.node {
                Some(node) => self.elastic(Place { node, natural, wall }),
                None => self.shared.leaf(wall),
            };
            children.push((Arg::Size(size(axis, part.length)), child));
        }
        if self.shared.variety == Variety::Exchanged {
            self.exchange(split, &mut children);
        }
        let groups = split.repeats.iter().map(|range| Group { children: range.clone() }).collect();
        self.shared
            .builder
            .node(Op::Split { axis: Expr::Axis(space_axis(axis)), snap: None, groups }, children)
    }

    /// Lets parts with windows stand in for others of their length in one split, as often as each was seen.
    fn exchange(&mut self, split: &Stretched, children: &mut [(Arg, NodeIndex)]) {
        let length = |at: usize| match split.parts[at].length {
            Length::Whole { blocks, .. } => Some(blocks),
            Length::Share(_) => None,
        };
        let may = |at: &usize| {
            let node = split.parts[*at]
                .node
                .filter(|node| self.giving.has_window[*node] && !self.giving.has_door[*node]);
            node.is_some() && length(*at).is_some()
        };
        let places: Vec<usize> = (0..children.len()).filter(may).collect();
        let own: Vec<NodeIndex> = children.iter().map(|(_, child)| *child).collect();
        for at in &places {
            let others: Vec<NodeIndex> = places
                .iter()
                .filter(|other| length(**other) == length(*at))
                .map(|other| own[*other])
                .collect();
            if others.iter().any(|other| *other != own[*at]) {
                children[*at].1 = self.shared.any_of(own[*at], &others);
            }
        }
    }

    /// A rule or a label at the lengths it was drawn with.
    fn fixed(&mut self, symbol: Symbol) -> NodeIndex {
        let rule = match symbol {
            Symbol::Label(label) => return self.shared.leaf(label),
            Symbol::Rule(rule) => rule,
        };
        if let Some(known) = self.fixed.get(&symbol) {
            return *known;
        }
        let rules = self.rules;
        let rule = &rules.list[rule];
        let (mut children, mut groups) = (Vec::new(), Vec::new());
        for item in &rule.items {
            let start = children.len();
            for (length, symbol) in &item.parts {
                let size = match length {
                    RuleLength::Blocks(blocks) => Size::absolute(Expr::number(f64::from(*blocks))),
                    RuleLength::Rest => Size::floating(1.0),
                };
                children.push((Arg::Size(size), self.fixed(*symbol)));
            }
            if item.times > 1 {
                groups.push(Group { children: start..children.len() });
            }
        }
        let node = self
            .shared
            .builder
            .node(Op::Split { axis: Expr::Axis(space_axis(rule.axis)), snap: None, groups }, children);
        let plan_node = rules.of.iter().position(|known| *known == symbol).unwrap_or(0);
        self.name(node, plan_node, [0, 0]);
        self.fixed.insert(symbol, node);
        node
    }

    /// A name for what has several parts.
    fn name(&mut self, node: NodeIndex, plan_node: NodeId, natural: [u32; 2]) {
        let Node::Split { axis, .. } = &self.plan.nodes[plan_node] else { return };
        let is_wide = |axis: Side| 5 * natural[axis.index()] >= 3 * self.size[axis.index()];
        let has_wall = self.plan.parts(plan_node).any(|part| !self.giving.has_window[part.node]);
        let noun = match axis {
            _ if !self.giving.has_window[plan_node] => "panel".to_owned(),
            _ if self.giving.has_door[plan_node] => "entrance".to_owned(),
            Side::X if is_wide(Side::X) => "storey".to_owned(),
            Side::Y if is_wide(Side::Y) => "column".to_owned(),
            _ => match self.main_label(plan_node) {
                Some(label) if has_wall => format!("{}_bay", self.shared.constants[label as usize].name),
                Some(label) => format!("{}_frame", self.shared.constants[label as usize].name),
                None => "bay".to_owned(),
            },
        };
        self.shared.names.push((node, noun, Vec::new()));
    }

    /// The hard label that takes most of a node.
    fn main_label(&self, node: NodeId) -> Option<u32> {
        let hard = self.plan.parts(node).filter(|part| self.giving.has_window[part.node]);
        let longest = hard.max_by_key(|part| part.length)?;
        match &self.plan.nodes[longest.node] {
            Node::Leaf(label) => Some(*label),
            Node::Split { .. } => self.main_label(longest.node),
        }
    }
}

impl Shared<'_> {
    /// Its own node, or one of all by chance.
    fn any_of(&mut self, own: NodeIndex, all: &[NodeIndex]) -> NodeIndex {
        if self.constants.len() == self.labels {
            self.constants.push(variety_constant());
        }
        let variety = || Box::new(Expr::Constant(self.labels));
        let binary = |op, left: Box<Expr>, right: f64| Expr::Binary(op, left, Box::new(Expr::number(right)));
        let kept = Expr::Binary(BinaryOp::Subtract, Box::new(Expr::number(1.0)), variety());
        let mut counted: Vec<(NodeIndex, u32)> = Vec::new();
        for node in all {
            match counted.iter_mut().find(|(known, _)| known == node) {
                Some((_, count)) => *count += 1,
                None => counted.push((*node, 1)),
            }
        }
        counted.sort_unstable();
        let share = |count: u32| {
            binary(
                BinaryOp::Divide,
                Box::new(binary(BinaryOp::Multiply, variety(), count.into())),
                all.len() as f64,
            )
        };
        let weights =
            std::iter::once((kept, own)).chain(counted.into_iter().map(|(node, count)| (share(count), node)));
        let alternatives =
            weights.map(|(weight, node)| (Arg::Alternative(Alternative::plain(weight)), node)).collect();
        let node = self.builder.node(Op::Choose, alternatives);
        self.names.push((node, "any".to_owned(), Vec::new()));
        node
    }

    fn leaf(&mut self, label: u32) -> NodeIndex {
        if let Some(known) = self.leaves.get(&label) {
            return *known;
        }
        let made = self.make_leaf(label);
        self.leaves.insert(label, made);
        made
    }

    /// What a label stands for: at its depth, with room before it.
    fn make_leaf(&mut self, label: u32) -> NodeIndex {
        let meaning = &self.meanings[label as usize];
        let before = (self.depth.before as i32 - meaning.offset).max(0) as u32;
        let material = Expr::Constant(label as usize);
        let is_pane = meaning.offset < 0;
        match &meaning.what {
            What::Nothing => self.builder.nil(),
            What::Thing(_) => match before {
                0 => self.builder.primitive(material),
                _ => {
                    let own = self.builder.primitive(Expr::Param(0));
                    let body = self.at_depth(own, before, is_pane);
                    let word = if is_pane {
                        "set_back"
                    } else if meaning.offset > 0 {
                        "set_out"
                    } else {
                        "flush"
                    };
                    self.names.push((body, word.to_owned(), vec!["what".to_owned()]));
                    self.builder.node(Op::Call(vec![material]), vec![(Arg::None, body)])
                }
            },
            What::Shape { name, .. } => {
                let op = Op::Primitive {
                    name: Expr::name(name.as_str()),
                    material: Some(material),
                    options: Vec::new(),
                };
                let own = self.builder.node(op, Vec::new());
                self.at_depth(own, before, is_pane)
            }
            What::Mesh { file, .. } => {
                let name = Expr::Thing(Thing::File(file.clone()));
                let own = self
                    .builder
                    .node(Op::Primitive { name, material: Some(material), options: Vec::new() }, Vec::new());
                self.at_depth(own, before, is_pane)
            }
            What::Door { .. } => {
                let door = self.door(material);
                let node = self.at_depth(door, before, true);
                self.names.push((node, format!("{}_way", self.constants[label as usize].name), Vec::new()));
                node
            }
        }
    }

    /// So many blocks behind the front; as a pane, with nothing behind it.
    fn at_depth(&mut self, own: NodeIndex, before: u32, is_pane: bool) -> NodeIndex {
        let nil = self.builder.nil();
        let left =
            Expr::Binary(BinaryOp::Subtract, Box::new(Expr::ScopeSize(Axis::Z)), Box::new(Expr::number(1.0)));
        let front =
            (Size::absolute(Expr::Call(Function::Min, vec![Expr::number(f64::from(before)), left])), nil);
        let one = Size::absolute(Expr::number(1.0));
        let parts = match (is_pane, before) {
            (false, 0) => return own,
            (false, _) => vec![(Size::floating(1.0), own), front],
            (true, 0) => vec![(Size::floating(1.0), nil), (one, own)],
            (true, _) => vec![(Size::floating(1.0), nil), (one, own), front],
        };
        self.builder.split(Expr::Axis(Axis::Z), parts)
    }

    /// A door two blocks high and one or two wide, in the middle of the floor; all around it its planks. Too low a leaf is
    /// all planks.
    fn door(&mut self, wood: Expr) -> NodeIndex {
        let op = |name: &str| Op::Primitive {
            name: Expr::name(name),
            material: Some(wood.clone()),
            options: Vec::new(),
        };
        let (door, planks) =
            (self.builder.node(op("door"), Vec::new()), self.builder.node(op("cuboid"), Vec::new()));
        let number = Expr::number;
        let binary = |op, left: Expr, right: Expr| Expr::Binary(op, Box::new(left), Box::new(right));
        let height = binary(
            BinaryOp::Multiply,
            number(2.0),
            binary(BinaryOp::GreaterEqual, Expr::ScopeSize(Axis::Y), number(2.0)),
        );
        let width = binary(
            BinaryOp::Subtract,
            number(2.0),
            binary(BinaryOp::Remainder, Expr::ScopeSize(Axis::X), number(2.0)),
        );
        let column = self
            .builder
            .split(Expr::Axis(Axis::Y), vec![(Size::absolute(height), door), (Size::floating(1.0), planks)]);
        let floating = Size::floating(1.0);
        self.builder.split(
            Expr::Axis(Axis::X),
            vec![(floating.clone(), planks), (Size::absolute(width), column), (floating, planks)],
        )
    }
}

/// A split at its own lengths.
fn as_drawn(plan: &Plan, node: NodeId) -> Stretched {
    let Node::Split { items, .. } = &plan.nodes[node] else {
        return Stretched { parts: Vec::new(), repeats: Vec::new() };
    };
    let mut split = Stretched { parts: Vec::new(), repeats: Vec::new() };
    for item in items {
        let start = split.parts.len();
        let part = |part: &super::plan::Part| Stretchy {
            node: Some(part.node),
            length: Length::Whole { blocks: part.length, from: 0 },
        };
        split.parts.extend(item.parts.iter().map(part));
        if item.times > 1 {
            split.repeats.push(start..split.parts.len());
        }
    }
    split
}

fn space_axis(axis: Side) -> Axis {
    match axis {
        Side::X => Axis::X,
        Side::Y => Axis::Y,
    }
}

fn size(axis: Side, length: Length) -> Size {
    match length {
        Length::Share(share) => Size::floating(share),
        Length::Whole { blocks, from } if from <= blocks && from == 0 => {
            Size::absolute(Expr::number(f64::from(blocks)))
        }
        Length::Whole { blocks, from } => {
            let scope = Box::new(Expr::ScopeSize(space_axis(axis)));
            let fits = Expr::Binary(BinaryOp::GreaterEqual, scope, Box::new(Expr::number(f64::from(from))));
            Size::absolute(Expr::Binary(
                BinaryOp::Multiply,
                Box::new(Expr::number(f64::from(blocks))),
                Box::new(fits),
            ))
        }
    }
}
