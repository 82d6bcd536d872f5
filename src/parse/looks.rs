//! What primitives look like, and whether a part of the target looks so.

use super::chart::{Backdrop, Choice, Found, Rigour};
use super::cost::Cost;
use super::derivation::Step;
use super::search::{Search, keep};
use super::states::{KindId, StateId, States};
use super::surroundings::Around;
use super::target::{Blocks, Placed, Target};
use super::value::Value;
use crate::block::BlockState;
use crate::graph::{Expr, NodeIndex, Op, Thing};
use crate::grid::Grid;
use crate::run::{self, Body, Brush, Brushes, Placement, Trail};
use crate::space::{Axis, Bounds, Cell, Scope, Turn};
use glam::Vec3Swizzles;
use rustc_hash::FxHashMap;
use std::rc::Rc;
use std::sync::Arc;

/// How a primitive fills its scope.
#[derive(Debug)]
pub enum Look {
    Fill(StateId),
    /// Of each cell, with its chance.
    Mix(Vec<(StateId, f64)>),
    Gradient(Axis, Vec<StateId>),
    /// As a run paints it, whatever the seed.
    Painted(Painted),
}

#[derive(Debug)]
pub struct Painted {
    name: Arc<Thing>,
    material: Option<Arc<Thing>>,
    options: Vec<(String, Value)>,
}

/// The looks that a primitive may have, with the cost of each.
type Drawn = Arc<[(Cost, Look)]>;

/// Looks by primitive, what it sees, and how it is turned.
#[derive(Debug, Default)]
pub struct Looks(FxHashMap<(NodeIndex, Around, Turn), Drawn>);

/// More looks of one primitive than this are not told apart.
const MOST_LOOKS: usize = 1 << 10;

impl Search<'_, '_> {
    /// The cost of a primitive whose cells can be looked at one by one.
    pub fn plain(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Option<Cost>> {
        let target = self.target;
        match target {
            Target::Boxes(boxes) => Some(self.label(node, boxes, scope).then_some(Cost::NONE)),
            Target::Blocks(blocks) => {
                let looks = self.looks(node, around, scope)?;
                let is_plain = looks.iter().all(|(_, look)| !matches!(look, Look::Painted(_)));
                is_plain.then(|| self.likeliest(blocks, &looks, scope))
            }
        }
    }

    fn likeliest(&self, blocks: &Blocks, looks: &[(Cost, Look)], scope: &Scope) -> Option<Cost> {
        let mut best: Option<Cost> = None;
        for (cost, look) in looks {
            let own = self.likeness(blocks, look, scope).map(|own| own.plus(*cost));
            best = own.filter(|own| best.is_none_or(|best| own.is_less(best))).or(best);
        }
        best
    }

    fn likeness(&self, blocks: &Blocks, look: &Look, scope: &Scope) -> Option<Cost> {
        let states = &self.memory.states;
        match look {
            Look::Fill(state) => {
                let kinds = || blocks.rows(scope.bounds).flatten();
                match self.rigour {
                    Rigour::Exact => kinds().all(|kind| states.gives(*state, *kind)).then_some(Cost::NONE),
                    Rigour::Nearest => Some(Cost::of_lost(
                        kinds().filter(|kind| !states.gives(*state, **kind)).count() as u64,
                    )),
                }
            }
            Look::Mix(parts) => self.cells(blocks, scope, |_, kind| chance(states, parts, kind)),
            Look::Gradient(axis, steps) => self.cells(blocks, scope, |cell, kind| {
                let step = (steps.len() - 1) as f64 * scope.along(*axis, cell);
                let (low, rest) = (step as usize, step.fract());
                let near = [(low, 1.0 - rest), (low + 1, rest)];
                let near = near.map(|(at, chance)| (steps[at.min(steps.len() - 1)], chance));
                super::looks::chance(states, &near, kind)
            }),
            Look::Painted(_) => None,
        }
    }

    /// The cost of cells that are drawn each for itself.
    fn cells(&self, blocks: &Blocks, scope: &Scope, chance: impl Fn(Cell, KindId) -> f64) -> Option<Cost> {
        let mut cost = Cost::NONE;
        for cell in scope.bounds.cells() {
            cost = cost.plus(match (chance(cell, blocks.kind(cell)), self.rigour) {
                (chance, _) if chance > 0.0 => Cost::of_chance(chance.min(1.0)),
                (_, Rigour::Exact) => return None,
                (_, Rigour::Nearest) => Cost::of_lost(1),
            });
        }
        Some(cost)
    }

    /// Whether the box of a scope has the label of a primitive, turned like it.
    fn label(&self, node: NodeIndex, boxes: &Placed<'_>, scope: &Scope) -> bool {
        let graph = self.rules.graph;
        let Op::Primitive { name, .. } = graph.op(node) else { return false };
        let label = match name {
            Expr::Thing(thing) => Some(thing.text()),
            Expr::Constant(at) => graph.constants.get(*at).map(|constant| {
                self.rules.labels.get(&constant.name).map_or(constant.name.as_str(), String::as_str)
            }),
            _ => None,
        };
        label.is_some_and(|label| boxes.label(scope.bounds) == Some((label, scope.frame.turn)))
    }

    /// What a primitive may look like in a scope; `None` where it is no block or shape.
    fn looks(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Drawn> {
        let key = (node, around, scope.frame.turn);
        if let Some(looks) = self.memory.looks.0.get(&key) {
            return Some(looks.clone());
        }
        let looks: Drawn = self.drawn(node, around, scope).unwrap_or_default().into();
        if !asks_for_size(self.rules.graph.op(node)) {
            self.memory.looks.0.insert(key, looks.clone());
        }
        Some(looks)
    }

    fn drawn(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Vec<(Cost, Look)>> {
        let Op::Primitive { name, material, options } = self.rules.graph.op(node) else { return None };
        let sight = self.sight(around, scope);
        let exprs = std::iter::once(name).chain(material).chain(options.iter().map(|(_, value)| value));
        let drawn = exprs.map(|expr| Some(sight.draw(expr)?.values())).collect::<Option<Vec<_>>>()?;
        let ways = drawn.iter().try_fold(1, |ways: usize, values| ways.checked_mul(values.len()));
        let mut looks = Vec::new();
        for mut way in 0..ways.filter(|ways| *ways <= MOST_LOOKS)? {
            let mut chance = 1.0;
            let mut values = drawn.iter().map(|values| {
                let (value, own) = &values[way % values.len()];
                way /= values.len();
                chance *= own;
                value.clone()
            });
            let name = values.next()?.as_thing()?.clone();
            let material = match material {
                Some(_) => Some(values.next()?.as_thing()?.clone()),
                None => None,
            };
            let options = options.iter().map(|(option, _)| option.clone()).zip(values).collect();
            let look = self.look(Painted { name, material, options }, scope.frame.turn);
            looks.extend(look.map(|look| (Cost::of_chance(chance), look)));
        }
        Some(looks)
    }

    /// `None` for a name that is no block.
    fn look(&mut self, painted: Painted, turn: Turn) -> Option<Look> {
        let states = &mut self.memory.states;
        let mut number = |state: &BlockState| states.written(&state.turned(turn));
        let brush = Brush::of(self.rules.library, &painted.name, painted.material.as_deref()).ok()?;
        Some(match brush {
            Brush::Fill(state) => Look::Fill(number(&state)),
            Brush::Mix(parts) => {
                let total = parts.last().map_or(0.0, |(sum, _)| *sum);
                let mut before = 0.0;
                let parts = parts.iter().map(|(sum, state)| {
                    let chance = (sum - before) / total;
                    before = *sum;
                    (number(state), chance)
                });
                Look::Mix(parts.collect())
            }
            Brush::Gradient(axis, blocks) => Look::Gradient(axis, blocks.iter().map(number).collect()),
            Brush::Roof(..) | Brush::Solid(..) | Brush::Door(_) | Brush::Stamp(_) => Look::Painted(painted),
        })
    }

    /// Compares a part of the target with what a run would paint there.
    pub fn painted(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Found> {
        let target = self.target;
        let Target::Blocks(blocks) = target else { return None };
        let looks = self.looks(node, around, scope)?;
        let mut best = None;
        for (cost, look) in looks.iter() {
            let own = match look {
                Look::Painted(painted) => self.compared(blocks, painted, scope),
                look => self.likeness(blocks, look, scope),
            };
            let found = own.map(|own| {
                let choice = if own.lost > 0 { Choice::Other(own.lost) } else { Choice::Only };
                Found { cost: own.plus(*cost), choice, pieces: Box::new([]) }
            });
            keep(&mut best, found);
        }
        best
    }

    fn paint(&self, painted: &Painted, scope: &Scope) -> Option<Grid> {
        paint(self.rules.library, painted, &self.body(scope)?)
    }

    /// The cells that a step put blocks into.
    pub fn put(&mut self, step: &Step) -> Vec<Cell> {
        let (node, scope) = (step.node, &step.scope);
        let around = self.seen_by(node, step.around);
        let looks = self.looks(node, around, scope);
        let painted = looks.iter().flat_map(|looks| looks.iter()).find_map(|(_, look)| match look {
            Look::Painted(painted) => self.paint(painted, scope),
            _ => None,
        });
        let cells = scope.bounds.cells();
        match painted {
            None => cells.collect(),
            Some(paint) => {
                cells.zip(paint.cells()).filter(|(_, id)| **id != BARE).map(|(cell, _)| cell).collect()
            }
        }
    }

    fn compared(&mut self, blocks: &Blocks, painted: &Painted, scope: &Scope) -> Option<Cost> {
        let paint = self.paint(painted, scope)?;
        let states = &mut self.memory.states;
        let ids: Vec<StateId> = paint.palette().states().iter().map(|state| states.written(state)).collect();
        let mut cost = Cost::NONE;
        for (cell, id) in scope.bounds.cells().zip(paint.cells()) {
            let kind = blocks.kind(cell);
            let is_air = states.is_air(kind);
            cost = cost.plus(match (*id == BARE, self.backdrop) {
                (true, Backdrop::Others) => Cost { left: u64::from(!is_air), ..Cost::NONE },
                (true, Backdrop::Air) => Cost::of_bare(u64::from(!is_air)),
                (false, _) => Cost::of_lost(u64::from(!states.gives(ids[usize::from(*id)], kind))),
            });
            if self.rigour == Rigour::Exact && cost.lost > 0 {
                return None;
            }
        }
        Some(cost)
    }
}

/// The palette number of cells that nothing was painted in.
const BARE: u16 = 1;

/// A block that no grammar writes.
const NO_BLOCK: &str = "vox:bare";

/// What a run puts into what is there of a scope, in a grid of the scope's size.
fn paint(library: &run::Library, painted: &Painted, body: &Body) -> Option<Grid> {
    let scope = &body.scope;
    let size = scope.bounds.size();
    let mut grid = Grid::new(size);
    let bare = grid.intern(&BlockState::new(NO_BLOCK).ok()?).ok()?;
    grid.fill(Bounds::of_size(size), bare);
    let options = painted.options.iter().map(|(option, value)| (option.as_str(), lent(value)));
    let placement = Placement {
        name: &painted.name,
        material: painted.material.as_deref(),
        options: options.collect(),
        scope: Scope { bounds: Bounds::of_size(size), ..*scope },
        footprint: body.footprint.as_ref().map(|footprint| Rc::new(footprint.moved(-scope.bounds.min.xz()))),
        trail: Trail::default(),
    };
    match Brushes::new(library, 0).place(&mut grid, &placement) {
        // A door without room is left out.
        Ok(()) | Err(run::Kind::NoRoomForDoor) => Some(grid),
        Err(_) => None,
    }
}

/// A value as a run has it.
fn lent(value: &Value) -> run::Value<'_> {
    match value {
        Value::Number(number) => run::Value::Number(number.0),
        Value::Axis(axis) => run::Value::Axis(*axis),
        Value::Thing(thing) => run::Value::Thing(thing),
        Value::Between(low, high) => run::Value::Number((low.0 + high.0) / 2.0),
    }
}

/// The chance that a cell of that kind comes of these states.
fn chance(states: &States, parts: &[(StateId, f64)], kind: KindId) -> f64 {
    parts.iter().filter(|(state, _)| states.gives(*state, kind)).map(|(_, chance)| chance).sum()
}

fn asks_for_size(op: &Op) -> bool {
    let mut asks = false;
    for expr in op.exprs() {
        expr.for_each(&mut |part| asks |= matches!(part, Expr::ScopeSize(_)));
    }
    asks
}
