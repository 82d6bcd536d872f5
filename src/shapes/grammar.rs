//! The shape grammar of examples (seed 3, "Shape Grammar Induction").

use super::building::{Block, Building};
use super::part::{FormId, Parts, Placement};
use super::production::Placed;
use super::search::search;
use super::settings::Settings;
use super::shape::Shape;
use super::{enclosure, seams};
use crate::grid::Grid;
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// Where a shape of the left side's form stands, one of the right side's form may be put beside it (seed 3, equations 5
/// and 6): matching shapes share their rules.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Rule {
    pub left: FormId,
    pub right: FormId,
    /// How the right stands to the left, when the left stands as its form.
    pub placement: Placement,
    /// Whether the right encloses nothing in an example.
    pub is_open: bool,
}

/// The shapes of examples, and which of them stand beside which.
#[derive(Debug)]
pub struct ShapeGrammar {
    pub parts: Parts,
    /// Ordered by their left sides.
    pub rules: Vec<Rule>,
    /// Where the rules of each form begin.
    starts: Vec<usize>,
    /// What the examples show of blocks beside one another.
    pub seen: seams::Seen,
}

impl ShapeGrammar {
    /// Infers the shapes of every example and joins them in one grammar.
    pub fn learn(examples: Vec<Grid>, settings: &Settings) -> ShapeGrammar {
        let found = examples.into_iter().map(|grid| {
            let building = Building::of(&grid);
            let shapes = search(&building, settings);
            (grid, building, shapes)
        });
        ShapeGrammar::of(&found.collect::<Vec<_>>())
    }

    /// The grammar of examples of which the shapes are known. Through matching shapes, rules of one example go on where those of
    /// another end.
    pub fn of(examples: &[(Grid, Building, Vec<Shape>)]) -> ShapeGrammar {
        let mut parts = Parts::default();
        let mut rules = Rules::new();
        let mut seen = seams::Seen::default();
        for (number, (grid, building, shapes)) in examples.iter().enumerate() {
            let first = parts.parts.len();
            parts.enter(number, grid, building, shapes);
            enclosure::mark_open(&mut parts, first);
            enter_rules(&mut rules, &parts, first, building, shapes);
            seen.enter(&parts, grid);
        }
        let rules: Vec<Rule> = rules
            .into_iter()
            .map(|((left, right, placement), is_open)| Rule { left, right, placement, is_open })
            .collect();
        let starts =
            (0..=parts.forms.len()).map(|form| rules.partition_point(|rule| rule.left < form)).collect();
        ShapeGrammar { parts, rules, starts, seen }
    }

    /// A number that is another for other shapes or rules.
    pub fn checksum(&self) -> u32 {
        let parts: Vec<_> =
            self.parts.parts.iter().map(|part| (part.form, part.placement, part.is_open)).collect();
        let states: Vec<String> = self.parts.states().map(ToString::to_string).collect();
        let text = format!("{states:?}{:?}{parts:?}{:?}", self.parts.forms, self.rules);
        twox_hash::XxHash32::oneshot(0, text.as_bytes())
    }

    /// The rules that apply to a form, with their numbers.
    pub fn rules_of(&self, form: FormId) -> impl ExactSizeIterator<Item = (usize, &Rule)> {
        let range = self.starts[form]..self.starts[form + 1];
        range.clone().zip(&self.rules[range])
    }

    /// The shape that a rule puts beside one of its left form.
    pub fn right(&self, rule: &Rule, left: &Placed) -> Placed {
        Placed { form: rule.right, placement: left.placement.after(rule.placement), is_open: rule.is_open }
    }

    /// A shape of the examples, where it stands there.
    pub fn start(&self, part: usize) -> Placed {
        let part = &self.parts.parts[part];
        Placed { form: part.form, placement: part.placement, is_open: part.is_open }
    }
}

type Rules = BTreeMap<(FormId, FormId, Placement), bool>;

/// Two rules for every two shapes that touch.
fn enter_rules(rules: &mut Rules, parts: &Parts, first: usize, building: &Building, shapes: &[Shape]) {
    for (left, right) in touching(building, shapes) {
        let [one, other] = [left, right].map(|shape| &parts.parts[first + shape]);
        let placement = one.placement.inverse().after(other.placement);
        *rules.entry((one.form, other.form, placement)).or_default() |= other.is_open;
    }
}

/// The shapes that touch, each pair in both orders.
fn touching(building: &Building, shapes: &[Shape]) -> BTreeSet<(usize, usize)> {
    let mut holders: Vec<Vec<usize>> = vec![Vec::new(); building.len()];
    for (number, shape) in shapes.iter().enumerate() {
        shape.blocks.iter().for_each(|block| holders[*block as usize].push(number));
    }
    let mut pairs = BTreeSet::new();
    for block in 0..building.len() as Block {
        for other in building.beside(block, &Axis::ALL) {
            for left in &holders[block as usize] {
                pairs.extend(
                    holders[other as usize]
                        .iter()
                        .filter(|right| *right != left)
                        .map(|right| (*left, *right)),
                );
            }
        }
    }
    pairs
}
