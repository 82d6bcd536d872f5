//! Plans as rules, and how long rules are.

use super::Side;
use super::plan::{Item, Node, NodeId, Plan};
use rustc_hash::FxHashMap;

/// Rules: splits that have the same parts in the same order are one, if they differ in the length of one part only, which
/// then takes what the others leave.
#[derive(Clone, PartialEq, Debug)]
pub struct Rules {
    pub list: Vec<Rule>,
    pub labels: usize,
    /// The rule or the label of each node of the plan.
    pub of: Vec<Symbol>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symbol {
    Label(u32),
    Rule(usize),
}

#[derive(Clone, PartialEq, Debug)]
pub struct Rule {
    pub axis: Side,
    pub items: Vec<RuleItem>,
}

#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct RuleItem {
    pub times: u32,
    pub parts: Vec<(Length, Symbol)>,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Length {
    Blocks(u32),
    /// What the other parts leave.
    Rest,
}

/// A rule but for its lengths.
type Pattern = (Side, Vec<(u32, Vec<Symbol>)>);

impl Rules {
    pub fn of(plan: &Plan, labels: usize) -> Rules {
        let mut rules = Rules { list: Vec::new(), labels, of: vec![Symbol::Label(0); plan.nodes.len()] };
        // Nodes stand after those below them, so nodes of one height can be compared once all below are.
        let mut by_height: Vec<Vec<NodeId>> = Vec::new();
        for (height, node) in heights(plan).into_iter().zip(0..) {
            by_height.resize_with(by_height.len().max(height + 1), Vec::new);
            by_height[height].push(node);
        }
        for nodes in by_height {
            rules.enter(plan, &nodes);
        }
        rules
    }

    fn enter(&mut self, plan: &Plan, nodes: &[NodeId]) {
        let mut order: Vec<Pattern> = Vec::new();
        let mut alike: FxHashMap<Pattern, Vec<(NodeId, Vec<u32>)>> = FxHashMap::default();
        for node in nodes {
            match &plan.nodes[*node] {
                Node::Leaf(label) => self.of[*node] = Symbol::Label(*label),
                Node::Split { axis, items } => {
                    let parts = items.iter().flat_map(|item| &item.parts);
                    let lengths = parts.map(|part| part.length).collect();
                    let pattern = (*axis, self.pattern(items));
                    let group = alike.entry(pattern.clone()).or_default();
                    if group.is_empty() {
                        order.push(pattern);
                    }
                    group.push((*node, lengths));
                }
            }
        }
        for pattern in order {
            let alike = alike.remove(&pattern).unwrap_or_default();
            self.join(&pattern, &alike);
        }
    }

    fn pattern(&self, items: &[Item]) -> Vec<(u32, Vec<Symbol>)> {
        let item = |item: &Item| (item.times, item.parts.iter().map(|part| self.of[part.node]).collect());
        items.iter().map(item).collect()
    }

    /// Makes as few rules as can be of splits that differ in their lengths.
    fn join(&mut self, pattern: &Pattern, alike: &[(NodeId, Vec<u32>)]) {
        let count = alike[0].1.len();
        // The rest beside a repeat would say how often it is repeated.
        let may_rest = alike.len() > 1 && pattern.1.iter().all(|(times, _)| *times == 1);
        let without = |rest: usize| {
            let mut kinds: Vec<(Vec<u32>, Vec<NodeId>)> = Vec::new();
            for (node, lengths) in alike {
                let mut fixed = lengths.clone();
                fixed[rest] = 0;
                match kinds.iter_mut().find(|(known, _)| *known == fixed) {
                    Some((_, nodes)) => nodes.push(*node),
                    None => kinds.push((fixed, vec![*node])),
                }
            }
            (rest, kinds)
        };
        let best = may_rest.then(|| (0..count).map(without).min_by_key(|(_, kinds)| kinds.len())).flatten();
        match best.filter(|(_, kinds)| kinds.len() < alike.len()) {
            Some((rest, kinds)) => {
                for (lengths, nodes) in kinds {
                    let law = |at: usize| if at == rest { Length::Rest } else { Length::Blocks(lengths[at]) };
                    self.add(pattern, law, &nodes);
                }
            }
            None => {
                for (node, lengths) in alike {
                    self.add(pattern, |at| Length::Blocks(lengths[at]), &[*node]);
                }
            }
        }
    }

    fn add(&mut self, (axis, items): &Pattern, length: impl Fn(usize) -> Length, nodes: &[NodeId]) {
        let mut at = 0..;
        let mut item = |(times, symbols): &(u32, Vec<Symbol>)| RuleItem {
            times: *times,
            parts: symbols.iter().map(|symbol| (length(at.next().unwrap_or(0)), *symbol)).collect(),
        };
        let rule = Rule { axis: *axis, items: items.iter().map(&mut item).collect() };
        nodes.iter().for_each(|node| self.of[*node] = Symbol::Rule(self.list.len()));
        self.list.push(rule);
    }

    /// The bits that it takes to write the rules down (Rissanen's description length).
    pub fn length(&self) -> f64 {
        let symbol = ((self.list.len() + self.labels) as f64).log2();
        let rules = self.list.iter().map(|rule| rule.length(symbol));
        rules.sum::<f64>() + NESTED * self.nested() as f64
    }

    /// How many parts of rules are cut along the axis of the rule once more.
    fn nested(&self) -> usize {
        let is_nested = |axis: Side, symbol: &Symbol| matches!(symbol, Symbol::Rule(rule) if self.list[*rule].axis == axis);
        let parts = self.list.iter().flat_map(|rule| {
            let parts = rule.items.iter().flat_map(|item| &item.parts);
            parts.map(move |(_, symbol)| (rule.axis, symbol))
        });
        parts.filter(|(axis, symbol)| is_nested(*axis, symbol)).count()
    }
}

/// The name of a rule, its axis and its end.
const HEAD: f64 = 8.0;
/// Where a repeat begins and ends.
const REPEAT: f64 = 4.0;
/// A length in blocks.
const LENGTH: f64 = 7.0;
/// That a part takes the rest.
const REST: f64 = 1.0;
/// A part of the second half of a rule that mirrors the first.
const MIRRORED: f64 = 1.0;
/// A part that is cut along the axis of its rule once more: a row of rows is harder to read than one row, and to stretch.
const NESTED: f64 = 10.0;

impl Rule {
    /// Its bits, where a symbol takes so many. Symmetry is preferred: what the second half mirrors is said once.
    pub fn length(&self, symbol: f64) -> f64 {
        let said = if self.is_symmetric() { self.items.len().div_ceil(2) } else { self.items.len() };
        let items = self.items[..said].iter().map(|item| item.length(symbol));
        let mirrored = self.items[said..].iter().map(|item| MIRRORED * item.parts.len() as f64);
        HEAD + items.sum::<f64>() + mirrored.sum::<f64>()
    }

    fn is_symmetric(&self) -> bool {
        self.items.len() > 2 && self.items.iter().eq(self.items.iter().rev())
    }
}

impl RuleItem {
    fn length(&self, symbol: f64) -> f64 {
        let parts = self.parts.iter().map(|(length, _)| match length {
            Length::Blocks(_) => symbol + LENGTH,
            Length::Rest => symbol + REST,
        });
        let repeat = if self.times > 1 { REPEAT } else { 0.0 };
        repeat + parts.sum::<f64>()
    }
}

fn heights(plan: &Plan) -> Vec<usize> {
    let mut heights: Vec<usize> = Vec::with_capacity(plan.nodes.len());
    for node in 0..plan.nodes.len() {
        let below = plan.parts(node).map(|part| heights[part.node] + 1).max();
        heights.push(below.unwrap_or(0));
    }
    heights
}
