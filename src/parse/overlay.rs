//! Operations that share a scope, that carve parts out of it, or move one about in it.
//!
//! Of operations in one scope the last is looked at first: of all its derivations that one counts which puts most
//! blocks where they stand. These cells are then free for those before it, which have to explain the rest. A part that
//! is not a box is parsed in its box, with all cells outside of it free.

use super::chart::{Backdrop, Choice, Found, Piece};
use super::cost::Cost;
use super::derivation::Step;
use super::lengths::{Law, law};
use super::search::Search;
use super::states::States;
use super::surroundings::Around;
use super::target::{Blocks, Target};
use crate::grammar::ast::Carving;
use crate::graph::{Arg, Expr, NodeIndex, Op, Size};
use crate::run::{Body, Part, carve};
use crate::space::{Axis, Bounds, Cell, Footprint, Length, Scope};
use glam::Vec3Swizzles;
use std::rc::Rc;

/// A building of which some cells are free, and the scope of an operation in it.
struct Layer {
    blocks: Blocks,
    scope: Scope,
    /// What is there of its plan.
    footprint: Option<Rc<Footprint>>,
}

/// What an operation in a layer came to.
struct Peeled {
    cost: Cost,
    steps: Vec<Step>,
}

impl Search<'_, '_> {
    /// Operations in one scope, later ones over earlier ones.
    pub fn overlay(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Found> {
        let peeled = self.peeled(node, around, scope)?;
        let mut cost = peeled.cost;
        cost.steps += 1;
        Some(Found { cost, choice: Choice::Only, pieces: Box::new([]) })
    }

    /// The steps of operations in one scope, in the order of the text.
    pub fn overlaid_steps(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Vec<Step> {
        let peeled = match self.rules.graph.op(node) {
            Op::All => self.peeled(node, around, scope),
            Op::Carve { how, args } => self.carved_steps(node, around, scope, *how, args),
            _ => None,
        };
        peeled.map_or_else(Vec::new, |peeled| peeled.steps)
    }

    fn peeled(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Peeled> {
        let mut layer = self.layer(&self.body(scope)?)?;
        let children: Vec<NodeIndex> = self.rules.graph.children(node).map(|(_, child)| child).collect();
        let mut all = Peeled { cost: Cost::NONE, steps: Vec::new() };
        for (at, child) in children.into_iter().enumerate().rev() {
            let backdrop = if at == 0 { self.backdrop } else { Backdrop::Others };
            let own = self.in_layer(&layer, backdrop, child, around)?;
            layer.free(own.steps.iter(), self);
            let left = if at == 0 { own.cost.left } else { 0 };
            all.cost = all.cost.plus(Cost { left, ..own.cost });
            let steps = own.steps.into_iter().map(|step| step.moved(scope.bounds.min));
            all.steps.splice(0..0, steps.collect::<Vec<Step>>());
        }
        Some(all)
    }

    /// The blocks of a body alone.
    fn layer(&self, body: &Body) -> Option<Layer> {
        let Target::Blocks(blocks) = self.target else { return None };
        let scope = &body.scope;
        let low = scope.bounds.min.xz();
        let footprint = body.footprint.as_ref().map(|footprint| Rc::new(footprint.moved(-low)));
        let bounds = Bounds::of_size(scope.bounds.size());
        let kinds = blocks.rows(scope.bounds).flatten().copied().collect();
        let blocks = Blocks::of_kinds(bounds.size(), kinds, &self.memory.states);
        Some(Layer { blocks, scope: Scope { bounds, ..*scope }, footprint })
    }

    /// Parses an operation in a layer.
    fn in_layer(
        &mut self,
        layer: &Layer,
        backdrop: Backdrop,
        node: NodeIndex,
        around: Around,
    ) -> Option<Peeled> {
        let target = Target::Blocks(layer.blocks.clone());
        let mut search = Search {
            rules: self.rules,
            memory: self.memory,
            target: &target,
            footprint: layer.footprint.clone(),
            backdrop,
            rigour: self.rigour,
            aim: self.aim,
            steps: self.steps,
            ring: self.ring,
            depth: self.depth,
        };
        let cost = search.solve(node, around, &layer.scope);
        let steps = cost.map(|_| search.steps(node, around, &layer.scope)).unwrap_or_default();
        (self.steps, self.ring) = (search.steps, search.ring);
        Some(Peeled { cost: cost?, steps })
    }

    /// Parts that are carved out of a scope: no cell is in two of them.
    pub fn carved(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        how: Carving,
        args: &[Expr],
    ) -> Option<Found> {
        let parts = self.parts_of(node, around, scope, how, args)?;
        let mut found = Found { cost: self.rest(scope, &parts)?, choice: Choice::Only, pieces: Box::new([]) };
        found.cost.steps += 1;
        let are_boxes = parts.iter().all(|part| part.body.footprint.is_none());
        let mut pieces = Vec::new();
        for part in parts {
            let cost = match are_boxes {
                true => self.solve(part.child, around, &part.body.scope)?,
                false => self.masked(&part, around)?.cost,
            };
            found.cost = found.cost.plus(cost);
            pieces.push(Piece::of(part.child, around, &part.body.scope, scope));
        }
        if are_boxes {
            found.pieces = pieces.into();
        }
        Some(found)
    }

    fn carved_steps(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        how: Carving,
        args: &[Expr],
    ) -> Option<Peeled> {
        let mut all = Peeled { cost: Cost::NONE, steps: Vec::new() };
        for part in self.parts_of(node, around, scope, how, args)? {
            let own = self.masked(&part, around)?;
            let low = part.body.scope.bounds.min;
            all.steps.extend(own.steps.into_iter().map(|step| step.moved(low)));
        }
        Some(all)
    }

    fn parts_of(
        &mut self,
        node: NodeIndex,
        around: Around,
        scope: &Scope,
        how: Carving,
        args: &[Expr],
    ) -> Option<Vec<Part>> {
        let sight = self.sight(around, scope);
        let width =
            |arg| Some((sight.certain(arg)?.as_number()? + 0.5).floor()).filter(|width| *width >= 0.0);
        let widths = args.iter().map(|arg| Some(width(arg)?.min(f64::from(i32::MAX >> 2)) as i32));
        let widths = widths.collect::<Option<Vec<i32>>>()?;
        let named = self.rules.graph.children(node).filter_map(|(arg, child)| match arg {
            Arg::Part(selector) => Some((selector, child)),
            _ => None,
        });
        let parts = carve(how, &widths, &self.body(scope)?, &named.collect::<Vec<_>>());
        // A part without depth has cells only where the operation inside gives it some.
        parts.iter().all(|part| !part.body.scope.is_empty()).then_some(parts)
    }

    /// What it costs that nothing is put beside the parts.
    fn rest(&self, scope: &Scope, parts: &[Part]) -> Option<Cost> {
        let Target::Blocks(blocks) = self.target else { return None };
        let inside: u32 = parts.iter().flat_map(|part| part.body.boxes()).map(|own| blocks.solid(own)).sum();
        self.nothing_of(u64::from(blocks.solid(scope.bounds).saturating_sub(inside)))
    }

    /// Parses a part with all cells outside of its footprint free.
    fn masked(&mut self, part: &Part, around: Around) -> Option<Peeled> {
        let mut layer = self.layer(&part.body)?;
        if let Some(footprint) = layer.footprint.clone() {
            layer.free_where(|cell| !footprint.contains(cell.xz()), &self.memory.states);
        }
        self.in_layer(&layer, self.backdrop, part.child, around)
    }

    /// An operation in a scope that is moved and resized, where it stays inside of the first one.
    pub fn placed(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Found> {
        let (mut node, mut inner) = (node, *scope);
        while let Op::Translate(sizes) | Op::Resize(sizes) = self.rules.graph.op(node) {
            let lengths = self.whole_lengths(sizes, around, &inner)?;
            inner = match self.rules.graph.op(node) {
                Op::Translate(_) => inner.moved(lengths),
                _ => inner.resized(lengths.max(Cell::ZERO)),
            };
            node = self.rules.graph.children(node).next()?.1;
        }
        // What is there of a plan moves with it.
        let is_moved = inner.bounds.min.xz() != scope.bounds.min.xz() && self.footprint.is_some();
        if is_moved || !scope.bounds.contains_box(&inner.bounds) {
            return None;
        }
        let solid = |target: &Target<'_>| match target {
            Target::Blocks(blocks) => {
                Some(u64::from(blocks.solid(scope.bounds) - blocks.solid(inner.bounds)))
            }
            Target::Boxes(_) => None,
        };
        let rest = self.nothing_of(solid(self.target)?)?;
        let mut cost = self.solve(node, around, &inner)?.plus(rest);
        cost.steps += 1;
        let pieces = Box::new([Piece::of(node, around, &inner, scope)]);
        Some(Found { cost, choice: Choice::Only, pieces })
    }

    fn whole_lengths(&self, sizes: &[Size; 3], around: Around, scope: &Scope) -> Option<Cell> {
        let sight = self.sight(around, scope);
        let mut lengths = Cell::ZERO;
        for (axis, size) in Axis::ALL.into_iter().zip(sizes) {
            let Law::One(Length::Absolute(length) | Length::Floating(length)) =
                law(size, &sight, scope.len(axis))?
            else {
                return None;
            };
            let reach = f64::from(1 << 20);
            lengths[axis.index()] = (length + 0.5).floor().clamp(-reach, reach) as i32;
        }
        Some(lengths)
    }
}

impl Layer {
    /// Frees the cells that the primitives among some steps put blocks into, and those that were given up.
    fn free<'s>(&mut self, steps: impl Iterator<Item = &'s Step>, search: &mut Search<'_, '_>) {
        let mut free = vec![false; self.blocks.kinds().len()];
        for step in steps {
            let is_given_up = matches!(step.choice, Choice::Other(_));
            let is_primitive = matches!(search.rules.graph.op(step.node), Op::Primitive { .. });
            if is_given_up || is_primitive {
                for cell in search.put(step) {
                    free[self.blocks.place(cell)] = true;
                }
            }
        }
        let kinds = self.blocks.kinds().iter().zip(free);
        let kinds = kinds.map(|(kind, free)| if free { States::FREE } else { *kind }).collect();
        self.blocks = Blocks::of_kinds(self.scope.bounds.size(), kinds, &search.memory.states);
    }

    fn free_where(&mut self, is_free: impl Fn(Cell) -> bool, states: &States) {
        let cells = self.scope.bounds.cells().zip(self.blocks.kinds());
        let kinds = cells.map(|(cell, kind)| if is_free(cell) { States::FREE } else { *kind }).collect();
        self.blocks = Blocks::of_kinds(self.scope.bounds.size(), kinds, states);
    }
}
