//! Whether what a grammar makes looks like what it was learnt from, and which operations are to blame if not.

use super::seams::window;
use crate::graph::{NodeIndex, Op, OpGraph};
use crate::grid::Grid;
use crate::infer::example::{Example, Terminals};
use crate::neighbours::settle;
use crate::run::{Library, Observer, Options, Step, Trail, run_observed};
use crate::space::{Bounds, Cell};
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// So many samples are looked at.
const SAMPLES: u64 = 64;

/// What the examples show once all blocks stand: every neighbourhood of 2 x 2 x 2, with one layer of air around.
pub struct Shown {
    terminals: Terminals,
    windows: FxHashSet<u64>,
}

impl Shown {
    pub fn by(examples: &[&Grid]) -> Shown {
        let mut shown = Shown { terminals: Terminals::default(), windows: FxHashSet::default() };
        for example in examples {
            let mut grid = (*example).clone();
            // A palette that is too full for more states stays as it is.
            let _ = settle(&mut grid);
            let windows = shown.around(grid);
            shown.windows.extend(windows.into_iter().map(|(_, window)| window));
        }
        shown
    }

    /// What went wrong in samples: where one failed, or put side by side what no example shows so. Of each place
    /// the operations around it, the innermost first.
    pub fn blamed(&mut self, graph: &OpGraph) -> BTreeSet<Vec<NodeIndex>> {
        (0..SAMPLES).flat_map(|seed| self.blamed_in(graph, seed)).collect()
    }

    /// Whether nothing goes wrong in samples.
    pub fn is_like(&mut self, graph: &OpGraph) -> bool {
        (0..SAMPLES).all(|seed| self.blamed_in(graph, seed).is_empty())
    }

    fn blamed_in(&mut self, graph: &OpGraph, seed: u64) -> BTreeSet<Vec<NodeIndex>> {
        let options = Options { seed, ..Options::default() };
        let mut steps = Steps { graph, taken: Vec::new(), last: None };
        let Ok(made) = run_observed(graph, &Library::new(), &options, Some(&mut steps)) else {
            return steps.last.map(|bounds| steps.around(bounds)).into_iter().collect();
        };
        let bounds = made.made.bounds();
        let windows = self.around(made.made);
        let unseen = windows.into_iter().filter(|(_, window)| !self.windows.contains(window));
        unseen.map(|(at, _)| steps.around(Bounds::new(at, at + Cell::splat(2)).intersect(&bounds))).collect()
    }

    /// The neighbourhoods of a building with where they are.
    fn around(&mut self, grid: Grid) -> Vec<(Cell, u64)> {
        let all = grid.bounds();
        let outside = self.terminals.air();
        let Some(cells) = Example::Blocks(grid).cells(&mut self.terminals) else { return Vec::new() };
        let get = |cell: Cell| match all.contains(cell) {
            true => cells[[cell.y as usize, cell.z as usize, cell.x as usize]],
            false => outside,
        };
        let starts = Bounds::new(all.min - Cell::ONE, all.max);
        starts.cells().map(|at| (at, window(Cell::splat(2), |step| get(at + step)))).collect()
    }
}

/// The splits and repeats of a derivation, with their scopes.
struct Steps<'g> {
    graph: &'g OpGraph,
    taken: Vec<(NodeIndex, Bounds)>,
    /// The scope of the operation that was begun last.
    last: Option<Bounds>,
}

impl Steps<'_> {
    /// The operations that put together what is in a box, the innermost first.
    fn around(&self, window: Bounds) -> Vec<NodeIndex> {
        let mut around: Vec<&(NodeIndex, Bounds)> =
            self.taken.iter().filter(|(_, bounds)| bounds.contains_box(&window)).collect();
        around.sort_by_key(|(_, bounds)| bounds.volume());
        around.into_iter().map(|(node, _)| *node).collect()
    }
}

impl Observer for Steps<'_> {
    fn step(&mut self, step: Step) -> Trail {
        self.last = Some(step.scope.bounds);
        if matches!(self.graph.op(step.node), Op::Split { .. } | Op::Repeat { .. } | Op::Call(_)) {
            self.taken.push((step.node, step.scope.bounds));
        }
        Trail::default()
    }
}
