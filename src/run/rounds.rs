//! The derivation in rounds, for grammars whose rules ask of other shapes.
//!
//! Whatever asks nothing derives first. When only operations that ask are left, all of them get their answers from one
//! and the same configuration, then they go on: so the order in which shapes are derived cannot matter. Priorities
//! divide the work further: rules of a later one wait for all of an earlier one. What is placed is handed on at the end, in the
//! order of the text.

use super::Options;
use super::body::Body;
use super::context::ShapeId;
use super::derive::{Derivation, Placement, Task};
use super::error::{Kind, RunError};
use super::known::Known;
use crate::grammar::ast::Rule;
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph, Thing};
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::ops::Range;

/// Operations that a derivation keeps, at the most: each takes memory to the end.
const MOST_KEPT: usize = 1 << 22;

/// What shapes of later levels are made of.
const MASS: &str = "white_concrete";

/// Whether a graph has to be derived in rounds.
pub fn needs_rounds(graph: &OpGraph, options: &Options) -> bool {
    options.detail.is_some() || graph.nodes().any(|node| asks(graph, node))
}

fn asks(graph: &OpGraph, node: NodeIndex) -> bool {
    let op = graph.op(node);
    matches!(op, Op::Split { snap: Some(_), .. } | Op::Repeat { snap: Some(_), .. })
        || op.exprs().any(Expr::asks)
        || graph.children(node).any(|(arg, _)| arg.exprs().any(Expr::asks))
}

/// Derives in rounds. `arrange` may put the operations of a round into any order.
pub fn rounds<'g>(
    derivation: &mut Derivation<'_, '_, '_, 'g>,
    root: Task<'g>,
    arrange: &mut dyn FnMut(&mut [Pending<'g>]),
) -> Result<(), RunError> {
    let graph = derivation.graph;
    let asks = graph.nodes().map(|node| asks(graph, node)).collect();
    let mut rounds =
        Rounds { derivation, asks, waiting: BTreeMap::new(), tree: Tree::default(), kept: Vec::new() };
    let tree = rounds.tree.add(1).start;
    let standing = rounds.standing(&root, Standing::Within(None), false);
    let level = rounds.derivation.next_level(root.node, None).unwrap_or(Rule::FIRST);
    rounds.wait(root, tree, standing, level);
    while let Some(((_, asking), mut round)) = rounds.waiting.pop_first() {
        arrange(&mut round);
        if asking == Asking::Others {
            rounds.known(Known::refresh);
        }
        for pending in round {
            let node = pending.task.node;
            rounds.step(pending).map_err(|kind| RunError::at(graph, node, kind))?;
        }
        rounds.known(Known::settle);
    }
    rounds.hand_on()
}

/// An operation that waits for its round.
pub struct Pending<'g> {
    task: Task<'g>,
    /// Its number in the derivation tree.
    tree: u32,
    standing: Standing,
    /// The priority of the rules to try, or of the rule that it stands in.
    level: u32,
}

/// How an operation stands to the shapes.
#[derive(Clone, Copy)]
enum Standing {
    Own(ShapeId),
    /// The innermost shape around it.
    Within(Option<ShapeId>),
}

impl Standing {
    fn shape(self) -> Option<ShapeId> {
        match self {
            Standing::Own(shape) => Some(shape),
            Standing::Within(shape) => shape,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Asking {
    Nothing,
    Others,
}

struct Rounds<'r, 'a, 'o, 's, 'g> {
    derivation: &'r mut Derivation<'a, 'o, 's, 'g>,
    /// Whether a node asks, by its index.
    asks: Vec<bool>,
    /// By level, those that ask nothing first. What has no rules to wait for is at level 0.
    waiting: BTreeMap<(u32, Asking), Vec<Pending<'g>>>,
    tree: Tree,
    /// What is placed, with the operation that places it.
    kept: Vec<(NodeIndex, Placement<'g>)>,
}

impl<'g> Rounds<'_, '_, '_, '_, 'g> {
    fn known(&mut self, change: impl FnOnce(&mut Known<'g>)) {
        if let Some(known) = &mut self.derivation.known {
            change(known);
        }
    }

    fn op(&self, task: &Task<'g>) -> &'g Op {
        let graph = self.derivation.graph;
        graph.op(task.node)
    }

    fn step(&mut self, mut pending: Pending<'g>) -> Result<(), Kind> {
        self.known(|known| known.asker = pending.standing.shape());
        let before = pending.task.trail.clone();
        self.derivation.observe(&mut pending.task);
        match self.op(&pending.task) {
            Op::Choose => {
                self.derivation.count(&pending.task)?;
                let detail = self.derivation.options.detail;
                if detail.is_some_and(|detail| pending.level > detail) {
                    self.derivation.placed = self.mass(&pending.task);
                } else if !self.derivation.choose_at(&pending.task, pending.level)? {
                    // It waits on, as if it had not been looked at.
                    pending.task.trail = before;
                    return self.next_level(pending);
                }
            }
            _ => self.derivation.step(&pending.task)?,
        }
        self.follow(&pending)
    }

    /// Lets a label wait for its rules of the next priority.
    fn next_level(&mut self, pending: Pending<'g>) -> Result<(), Kind> {
        let Pending { task, tree, standing, level } = pending;
        match self.derivation.next_level(task.node, Some(level)) {
            Some(level) => {
                self.wait(task, tree, standing, level);
                Ok(())
            }
            None => Err(task.no_rule()),
        }
    }

    /// Keeps what a step placed, and lets its children wait.
    fn follow(&mut self, pending: &Pending<'g>) -> Result<(), Kind> {
        let mut is_replaced = true;
        if let Some(placement) = self.derivation.placed.take() {
            self.tree.place(pending.tree, self.kept.len());
            self.kept.push((pending.task.node, placement));
            is_replaced = false;
        }
        let children: SmallVec<[Task<'g>; 8]> = self.derivation.stack.drain(..).rev().collect();
        let numbers = self.tree.add(children.len());
        if self.tree.len() > MOST_KEPT {
            return Err(Kind::TooMany(MOST_KEPT as u64));
        }
        self.tree.adopt(pending.tree, &numbers);
        let is_relay = is_relay(self.op(&pending.task));
        for (number, child) in numbers.zip(children) {
            let standing = self.standing(&child, pending.standing, is_relay);
            is_replaced &=
                !matches!((standing, pending.standing), (Standing::Own(a), Standing::Own(b)) if a == b);
            let level = self.derivation.next_level(child.node, None).unwrap_or(pending.level);
            self.wait(child, number, standing, level);
        }
        if let (Standing::Own(shape), true) = (pending.standing, is_replaced) {
            self.known(|known| known.replace(shape));
        }
        Ok(())
    }

    /// How a child stands to the shapes; it becomes one if need be.
    fn standing(&mut self, task: &Task<'g>, parent: Standing, is_relay: bool) -> Standing {
        let label = match (self.op(task), parent) {
            (Op::Shape(label), _) => Some(label.as_str()),
            (_, Standing::Own(shape)) if is_relay => return Standing::Own(shape),
            (op, _) if is_shape(op) || (*op == Op::Choose && self.asks[task.node.index()]) => None,
            _ => return Standing::Within(parent.shape()),
        };
        let mut standing = Standing::Within(None);
        // What a footprint leaves nothing of is no shape.
        if let Some(body) = task.body() {
            self.known(|known| standing = Standing::Own(known.add(parent.shape(), label, &body)));
        }
        standing
    }

    fn wait(&mut self, task: Task<'g>, tree: u32, standing: Standing, level: u32) {
        let asks = self.asks[task.node.index()];
        let is_choice = *self.op(&task) == Op::Choose;
        let asks = asks && (!is_choice || self.asks_at(task.node, level));
        let asking = if asks { Asking::Others } else { Asking::Nothing };
        let at = if is_choice || asks { level } else { 0 };
        self.waiting.entry((at, asking)).or_default().push(Pending { task, tree, standing, level });
    }

    /// Whether the rules of a label that have a priority ask.
    fn asks_at(&self, node: NodeIndex, level: u32) -> bool {
        let graph = self.derivation.graph;
        graph.children(node).any(|(arg, _)| match arg {
            Arg::Alternative(rule) => rule.priority == level && arg.exprs().any(Expr::asks),
            _ => false,
        })
    }

    /// A plain mass in the place of what a later level would make.
    fn mass(&self, task: &Task<'g>) -> Option<Placement<'g>> {
        let Body { scope, footprint } = task.body_within(self.derivation.plot)?;
        let name = self.derivation.world.keep(Thing::Name(MASS.to_owned()));
        let trail = task.trail.clone();
        Some(Placement { name, material: None, options: SmallVec::new(), scope, footprint, trail })
    }

    /// Hands on what was placed, in the order of the text.
    fn hand_on(self) -> Result<(), RunError> {
        let graph = self.derivation.graph;
        let mut kept: Vec<_> = self.kept.into_iter().map(Some).collect();
        for at in self.tree.in_order() {
            if let Some((node, placement)) = kept[at].take() {
                self.derivation.hand_on(node, placement).map_err(|kind| RunError::at(graph, node, kind))?;
            }
        }
        Ok(())
    }
}

/// Whether an operation makes its scope a shape by itself: what is filled is one, and so is what has faces. All that
/// only divides or moves a scope leads to shapes and is none.
fn is_shape(op: &Op) -> bool {
    match op {
        Op::Primitive { .. } => true,
        Op::Carve { how, .. } => how.is_component(),
        _ => false,
    }
}

/// Whether an operation runs its only child in its own place, as the same shape.
fn is_relay(op: &Op) -> bool {
    matches!(op, Op::Choose | Op::Call(_) | Op::Shape(_) | Op::Local | Op::Same(_) | Op::Style(_))
}

/// The derivation tree, as far as the order of what is placed needs it.
#[derive(Default)]
struct Tree(Vec<Branch>);

#[derive(Clone, Default)]
struct Branch {
    children: Range<u32>,
    placed: Option<u32>,
}

impl Tree {
    fn len(&self) -> usize {
        self.0.len()
    }

    /// New branches, numbered in a row.
    fn add(&mut self, count: usize) -> Range<u32> {
        let first = self.0.len() as u32;
        self.0.resize(self.0.len() + count, Branch::default());
        first..self.0.len() as u32
    }

    fn adopt(&mut self, branch: u32, children: &Range<u32>) {
        self.0[branch as usize].children = children.clone();
    }

    fn place(&mut self, branch: u32, placement: usize) {
        self.0[branch as usize].placed = Some(placement as u32);
    }

    /// The numbers of what is placed, in the order of the text.
    fn in_order(&self) -> impl Iterator<Item = usize> {
        let mut open = vec![0];
        std::iter::from_fn(move || {
            let branch = &self.0[open.pop()? as usize];
            open.extend(branch.children.clone().rev());
            Some(branch.placed.map(|placed| placed as usize))
        })
        .flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::super::derive::begin;
    use super::super::eval::Things;
    use super::*;
    use crate::space::{Bounds, Cell, Frame, Scope};
    use rand::SeedableRng;
    use rand::seq::SliceRandom;
    use rand_pcg::Pcg64Mcg;

    /// What is placed, by name and place, where `arrange` puts the operations of each round in order.
    fn placed(text: &str, arrange: &mut dyn FnMut(&mut [Pending<'_>])) -> Vec<(String, Bounds)> {
        let checked = crate::grammar::read(text).unwrap_or_else(|found| panic!("{found:?}"));
        let graph = crate::graph::lower(&checked, None).unwrap();
        let (things, options) = (Things::default(), Options { detail: Some(9), ..Options::default() });
        let mut placed = Vec::new();
        let mut sink = |placement: Placement<'_>| {
            placed.push((placement.name.text().to_owned(), placement.scope.bounds));
            Ok(())
        };
        let start = Scope::start(Cell::new(16, 12, 16), Frame::default());
        let (mut derivation, root) = begin(&graph, &things, start, &options, &mut sink).unwrap();
        rounds(&mut derivation, root, arrange).unwrap();
        placed
    }

    const CROWD: &str = "
        lot --> [ S(9, 9, 9){ mass } T(5, 0, 3){ S(10, 7, 12){ mass } } split(x){ ~1 : yard | 4 : yard } ]
        mass --> [ comp(f){ side : wall } repeat(y, 3){ [ snap(y) I(stone) ] } ]
        yard --> split(x){ ~rand(1, 2) : shed | ~1 : nil | ~1 : shed }
        shed : occ(shed, 1) == none --> I(oak_planks) : 2
        shed : occ(shed, 1) != none --> split(x){ 1 : I(oak_log) | ~1 : shed }
        shed : scope.sx < 2 --> I(hay_block)
        priority 2
        wall : visible(yard) --> repeat(y, 2, snap){ repeat(x, 3){ tile } }
        wall --> split(y, snap){ ~1 : tile | 2 : tile | ~1 : tile }
        tile : occ(noparent) == none --> I(glass)
        tile : occ(active) == part --> split(x){ 1 : I(bricks) | ~1 : tile }
        priority 3
        tile --> I(cobblestone)
    ";

    #[test]
    fn the_order_within_a_round_does_not_matter() {
        let as_written = placed(CROWD, &mut |_| {});
        let names: std::collections::BTreeSet<&str> =
            as_written.iter().map(|(name, _)| name.as_str()).collect();
        assert!(names.len() >= 5, "the crowd has too few answers: {names:?}");
        for seed in 0..40 {
            let mut stream = Pcg64Mcg::seed_from_u64(seed);
            assert_eq!(placed(CROWD, &mut |round| round.shuffle(&mut stream)), as_written);
        }
    }
}
