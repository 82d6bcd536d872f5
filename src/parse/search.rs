//! The search for the cheapest derivation: operation by operation from the root, each part of the target once.

use super::Laws;
use super::chart::{Backdrop, Chart, Choice, Entry, Found, Key, Piece, Rigour};
use super::cost::Cost;
use super::draw::Sight;
use super::looks::Looks;
use super::needs::Needs;
use super::split::Written;
use super::stack::stacked;
use super::states::States;
use super::surroundings::{Around, Known};
use super::target::Target;
use super::value::Value;
use super::widened::STRETCHED_CHANCE;
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph};
use crate::run::{Body, Library, quarter_turns};
use crate::space::{Bounds, Footprint, Rect, Scope, Spot};
use glam::Vec3Swizzles;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

/// What stays the same over all searches of a parser.
#[derive(Debug)]
pub struct Rules<'g> {
    pub graph: &'g OpGraph,
    pub laws: Laws,
    /// By node.
    pub needs: Vec<Needs>,
    pub library: &'g Library,
    /// The label that each constant stands for.
    pub labels: &'g BTreeMap<String, String>,
}

/// What searches learn and leave to the next.
#[derive(Debug)]
pub struct Memory {
    pub states: States,
    pub known: Known,
    pub chart: Chart,
    pub looks: Looks,
    /// Footprints as they lie in their scopes, by number from 1.
    pub footprints: FxHashMap<Footprint, u32>,
    /// Splits as they are written, by what they see and the lengths of their scope.
    pub written: FxHashMap<(NodeIndex, Around, [i32; 3]), Option<Rc<Written>>>,
}

/// More arguments of one call than this are not tried.
const MOST_CALLS: usize = 1 << 12;

/// Operations in a chain: as many as a run may have.
const MOST_DEPTH: u32 = 10_000;

/// Which of several derivations is looked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Aim {
    Cheapest,
    /// The first one that is found, if it is exact.
    Any,
}

pub struct Search<'a, 'g> {
    pub rules: &'a Rules<'g>,
    pub memory: &'a mut Memory,
    pub target: &'a Target<'a>,
    /// The cells of the target's plan that are there; `None` is all of them.
    pub footprint: Option<Rc<Footprint>>,
    pub backdrop: Backdrop,
    pub rigour: Rigour,
    pub aim: Aim,
    /// Steps that are left.
    pub steps: u64,
    /// The least depth of an open operation that was come back to.
    pub ring: u32,
    pub depth: u32,
}

impl<'a, 'g> Search<'a, 'g> {
    pub fn new(
        rules: &'a Rules<'g>,
        memory: &'a mut Memory,
        target: &'a Target<'a>,
        (rigour, aim): (Rigour, Aim),
        steps: u64,
    ) -> Search<'a, 'g> {
        Search {
            rules,
            memory,
            target,
            footprint: None,
            backdrop: Backdrop::Air,
            rigour,
            aim,
            steps,
            ring: u32::MAX,
            depth: 0,
        }
    }

    /// Whether the first derivation that is found will do.
    pub fn takes_any(&self) -> bool {
        (self.aim, self.rigour) == (Aim::Any, Rigour::Exact)
    }

    pub fn key(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Key {
        Key {
            content: self.target.content(scope.bounds),
            node,
            around,
            turn: scope.frame.turn,
            footprint: self.footprint_number(scope),
            backdrop: self.backdrop,
            rigour: self.rigour,
        }
    }

    /// What is there of a scope, if anything is.
    pub fn body(&self, scope: &Scope) -> Option<Body> {
        Body::within(*scope, self.footprint.as_ref())
    }

    fn footprint_number(&mut self, scope: &Scope) -> u32 {
        let Some(footprint) = self.footprint.as_ref() else { return 0 };
        let inside = Body::within(*scope, Some(footprint)).map(|body| body.footprint);
        let inside = match inside {
            Some(None) => return 0,
            Some(Some(inside)) => inside.moved(-scope.bounds.min.xz()),
            None => Footprint::full(Rect::new(Spot::ZERO, Spot::ZERO)),
        };
        let next = self.memory.footprints.len() as u32 + 1;
        *self.memory.footprints.entry(inside).or_insert(next)
    }

    pub fn seen_by(&mut self, node: NodeIndex, around: Around) -> Around {
        self.memory.known.seen_by(node, &self.rules.needs[node.index()], around)
    }

    /// The cost of the cheapest derivation of a scope, if there is one.
    pub fn solve(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Cost> {
        if scope.is_empty() {
            return Some(Cost::NONE);
        }
        let around = self.seen_by(node, around);
        if let Some(cost) = self.leaf(node, around, scope) {
            return cost;
        }
        if self.rigour == Rigour::Nearest {
            self.rigour = Rigour::Exact;
            let exact = self.looked_up(node, around, scope);
            self.rigour = Rigour::Nearest;
            if exact.is_some() {
                return exact;
            }
        }
        self.looked_up(node, around, scope)
    }

    /// The cost of what is seen at once; `None` for other operations.
    pub fn leaf(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Option<Cost>> {
        match self.rules.graph.op(node) {
            Op::Nil | Op::Snap { .. } => Some(self.nothing(scope.bounds)),
            Op::Primitive { .. } => self.plain(node, around, scope),
            _ => None,
        }
    }

    fn looked_up(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Cost> {
        let key = self.key(node, around, scope);
        match self.memory.chart.get(&key) {
            Some(Entry::Done(found)) => return found.as_ref().map(|found| found.cost),
            Some(Entry::Open(at)) => {
                self.ring = self.ring.min(*at);
                return None;
            }
            Some(Entry::Sofar(_)) | None => {}
        }
        if self.steps == 0 || self.depth >= MOST_DEPTH {
            return self.given_up(scope).map(|found| found.cost);
        }
        self.steps -= 1;
        self.depth += 1;
        self.memory.chart.set(key, Entry::Open(self.depth));
        let outer = std::mem::replace(&mut self.ring, u32::MAX);
        let found = stacked(|| self.expand(node, around, scope));
        let found = self.or_given_up(found, scope).map(Arc::new);
        let cost = found.as_ref().map(|found| found.cost);
        self.enter(key, found);
        self.ring = self.ring.min(outer);
        self.depth -= 1;
        cost
    }

    /// Keeps what was found, as far as it holds whatever is open around it.
    fn enter(&mut self, key: Key, found: Option<Arc<Found>>) {
        let is_whole = self.ring >= self.depth && self.steps > 0;
        match (is_whole, found) {
            (true, found) => self.memory.chart.set(key, Entry::Done(found)),
            (false, Some(found)) => self.memory.chart.set(key, Entry::Sofar(found)),
            (false, None) => self.memory.chart.forget(&key),
        }
        if self.ring >= self.depth {
            self.ring = u32::MAX;
        }
    }

    /// Where cells may be other than an operation says, the operation may be left out.
    fn or_given_up(&self, found: Option<Found>, scope: &Scope) -> Option<Found> {
        match (found, self.given_up(scope)) {
            (Some(found), Some(other)) if other.cost.is_less(found.cost) => Some(other),
            (found, other) => found.or(other),
        }
    }

    fn given_up(&self, scope: &Scope) -> Option<Found> {
        let lost = scope.bounds.volume();
        let found = Found { cost: Cost::of_bare(lost), choice: Choice::Other(lost), pieces: Box::new([]) };
        (self.rigour == Rigour::Nearest).then_some(found)
    }

    /// What it costs that nothing is put into a box.
    pub fn nothing(&self, bounds: Bounds) -> Option<Cost> {
        let solid = match self.target {
            Target::Blocks(blocks) => u64::from(blocks.solid(bounds)),
            Target::Boxes(_) => u64::from(!self.target.is_empty(bounds)),
        };
        self.nothing_of(solid)
    }

    /// What it costs that nothing is put into cells of which so many are not air.
    pub fn nothing_of(&self, solid: u64) -> Option<Cost> {
        match (self.backdrop, self.rigour) {
            (Backdrop::Others, _) => Some(Cost { left: solid, ..Cost::NONE }),
            (Backdrop::Air, Rigour::Exact) => (solid == 0).then_some(Cost::NONE),
            (Backdrop::Air, Rigour::Nearest) => Some(Cost::of_bare(solid)),
        }
    }

    fn expand(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Found> {
        let graph = self.rules.graph;
        match graph.op(node) {
            Op::Nil | Op::Snap { .. } | Op::Primitive { .. } => self.painted(node, around, scope),
            Op::Choose => self.choose(node, around, scope),
            Op::Split { axis, groups, .. } => {
                let axis = self.sight(around, scope).certain(axis)?.as_axis()?;
                self.split(node, around, scope, axis, groups)
            }
            Op::Repeat { axis, size, .. } => {
                let axis = self.sight(around, scope).certain(axis)?.as_axis()?;
                self.repeat(node, around, scope, axis, size)
            }
            Op::RepeatN { axis, count } => {
                let axis = self.sight(around, scope).certain(axis)?.as_axis()?;
                self.repeat_times(node, around, scope, axis, count)
            }
            Op::Rotate { axis, angle } => {
                let sight = self.sight(around, scope);
                let turn = quarter_turns(sight.certain(angle)?.as_number()?).ok()?;
                let is_upright = sight.certain(axis)?.as_axis()? == graph.up.axis();
                is_upright.then(|| self.only(node, around, scope, &scope.turned(turn), Choice::Only))?
            }
            Op::Local | Op::Same(_) | Op::Shape(_) => self.only(node, around, scope, scope, Choice::Only),
            Op::Style(style) => {
                let styled = self.memory.known.with_style(around, style + 1);
                self.only(node, styled, scope, scope, Choice::Only)
            }
            Op::Call(args) => self.call(node, around, scope, args),
            Op::Translate(_) | Op::Resize(_) => self.placed(node, around, scope),
            Op::All => self.overlay(node, around, scope),
            Op::Carve { how, args } => self.carved(node, around, scope, *how, args),
        }
    }

    pub fn sight<'s>(&'s self, around: Around, scope: &'s Scope) -> Sight<'s> {
        self.memory.known.sight(around, self.rules.graph.constants.len(), scope)
    }

    /// The only child, in `inner`.
    fn only(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        inner: &Scope,
        choice: Choice,
    ) -> Option<Found> {
        let (_, child) = self.rules.graph.children(node).next()?;
        let cost = self.solve(child, around, inner)?;
        Some(one(cost, choice, Piece::of(child, around, inner, scope)))
    }

    fn call(&mut self, node: NodeIndex, around: Around, scope: &Scope, args: &[Expr]) -> Option<Found> {
        let sight = self.sight(around, scope);
        let drawn = args.iter().map(|arg| Some(sight.draw(arg)?.handed_on()));
        let drawn = drawn.collect::<Option<Vec<Vec<(Value, f64)>>>>()?;
        let ways = drawn.iter().try_fold(1, |ways: usize, values| ways.checked_mul(values.len()));
        let mut best: Option<Found> = None;
        for mut way in 0..ways.filter(|ways| *ways <= MOST_CALLS)? {
            let (mut params, mut chance) = (Vec::with_capacity(args.len()), 1.0);
            for values in &drawn {
                let (value, own) = &values[way % values.len()];
                way /= values.len();
                params.push(value.clone());
                chance *= own;
            }
            let texts = params.iter().map(Value::to_string).collect();
            let called = self.memory.known.with_params(around, params);
            let choice = Choice::Arguments(texts);
            let found = self.only(node, called, scope, scope, choice);
            keep(&mut best, found.map(|found| dearer(found, Cost::of_chance(chance))));
            if best.is_some() && self.takes_any() {
                break;
            }
        }
        best
    }

    fn choose(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Found> {
        let mut best = None;
        let mut open = self.open(node, around, scope)?;
        if self.takes_any() {
            open.sort_by(|one, other| other.chance.total_cmp(&one.chance));
        }
        for Open { choice, child, chance } in open {
            let cost = self.solve(child, around, scope).map(|cost| cost.plus(Cost::of_chance(chance)));
            keep(&mut best, cost.map(|cost| one(cost, choice, Piece::of(child, around, scope, scope))));
            if best.is_some() && self.takes_any() {
                break;
            }
        }
        best
    }

    /// The rules that apply, with their chances, level by level as far as one may be reached.
    fn open(&self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Vec<Open>> {
        let sight = self.sight(around, scope);
        let (mut all, mut closed) = (Vec::new(), Vec::new());
        for (number, (arg, child)) in self.rules.graph.children(node).enumerate() {
            if let Arg::Alternative(alternative) = arg {
                let holds = match &alternative.condition {
                    None => 1.0,
                    Some(condition) => sight.draw(condition)?.truth()?,
                };
                if holds > 0.0 {
                    let weight = sight.weight(&alternative.weight)?;
                    all.push((alternative.priority, holds, weight, number as u32, child));
                } else if self.rules.laws == Laws::Stretched {
                    let choice = Choice::StretchedAlternative(number as u32);
                    closed.push(Open { choice, child, chance: STRETCHED_CHANCE });
                }
            }
        }
        all.sort_by_key(|(level, ..)| *level);
        let mut open = Vec::new();
        let mut reached = 1.0;
        for level in all.chunk_by(|a, b| a.0 == b.0) {
            let total: f64 = level.iter().map(|(_, holds, weight, ..)| holds * weight).sum();
            let weighted = level.iter().filter(|(_, _, weight, ..)| *weight > 0.0);
            open.extend(weighted.map(|&(_, holds, weight, number, child)| Open {
                choice: Choice::Alternative(number),
                child,
                chance: reached * holds * weight / total,
            }));
            reached *= level.iter().map(|(_, holds, ..)| 1.0 - holds).product::<f64>();
            if reached <= 0.0 {
                break;
            }
        }
        open.extend(closed);
        Some(open)
    }

    /// Whether the cheapest derivation of a part is known to be none.
    pub fn is_hopeless(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> bool {
        let around = self.seen_by(node, around);
        self.rigour == Rigour::Exact && self.leaf(node, around, scope).is_some_and(|cost| cost.is_none())
    }
}

/// A rule that applies.
struct Open {
    choice: Choice,
    child: NodeIndex,
    chance: f64,
}

pub fn one(cost: Cost, choice: Choice, piece: Piece) -> Found {
    let cost = Cost { steps: cost.steps + 1, ..cost };
    Found { cost, choice, pieces: Box::new([piece]) }
}

pub fn dearer(found: Found, cost: Cost) -> Found {
    Found { cost: found.cost.plus(cost), ..found }
}

/// Keeps the cheaper one.
pub fn keep(best: &mut Option<Found>, found: Option<Found>) {
    if let Some(found) = found
        && best.as_ref().is_none_or(|best| found.cost.is_less(best.cost))
    {
        *best = Some(found);
    }
}
