//! What a grammar makes that looks like none of the examples it was learnt from, and where.

use super::derivation::Derivation;
use super::seams::window;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::infer::example::{Example, Terminals};
use crate::infer::neighbourhood::OUTSIDE;
use crate::neighbours::settle;
use crate::run::{Library, Options, run, run_observed};
use crate::space::{Bounds, Cell};
use ndarray::Array3;
use rustc_hash::FxHashSet;

/// So many samples are looked at where much is tried, and so many of what is kept: some of what goes wrong is rare.
pub const FEW: u64 = 64;
pub const MANY: u64 = 160;
/// So many faulty samples are enough to go on with.
const ENOUGH: usize = 8;
/// So many neighbourhoods are told of in all; more of them would mostly have the same causes.
const MOST: usize = 48;

/// What the examples show once all blocks stand: every neighbourhood of 2 x 2 x 2, with one layer of air around.
pub struct Shown {
    examples: Vec<Grid>,
    terminals: Terminals,
    windows: FxHashSet<u64>,
}

/// A sample with what went wrong in it.
pub struct Faulty {
    pub derivation: Derivation,
    pub fault: Fault,
}

pub enum Fault {
    /// The operation that was begun last could not be carried out.
    Failed,
    /// These boxes, some of which stand out of the sample, show what no example shows; the cells are without what
    /// neighbours decide.
    Unseen { cells: Array3<u32>, windows: Vec<Bounds> },
}

impl Shown {
    pub fn by(examples: &[&Grid]) -> Shown {
        let settled = examples.iter().map(|example| {
            let mut grid = (*example).clone();
            // A palette that is too full for more states stays as it is.
            let _ = settle(&mut grid);
            grid
        });
        let examples: Vec<Grid> = settled.collect();
        let (mut terminals, mut windows) = (Terminals::default(), FxHashSet::default());
        for example in &examples {
            let around = around(&Example::Blocks(example.clone()), &mut terminals);
            windows.extend(around.into_iter().map(|(_, window)| window));
        }
        Shown { examples, terminals, windows }
    }

    /// The samples that failed, or put side by side what no example shows so. What two samples show is told of once.
    /// `terminals` are those of the examples.
    pub fn faults(&self, graph: &OpGraph, terminals: &mut Terminals) -> Vec<Faulty> {
        let mut own = self.terminals.clone();
        let mut told = FxHashSet::default();
        let mut faults = Vec::new();
        for seed in 0..MANY {
            if faults.len() == ENOUGH {
                break;
            }
            let mut derivation = Derivation::default();
            let options = Options { seed, ..Options::default() };
            let made = run_observed(graph, &Library::new(), &options, Some(&mut derivation));
            let fault = match made {
                Ok(made) => self.unseen(made.made, &mut own, &mut told, terminals),
                Err(_) => Some(Fault::Failed),
            };
            faults.extend(fault.map(|fault| Faulty { derivation, fault }));
        }
        faults
    }

    /// Whether nothing goes wrong in so many samples.
    pub fn is_like(&self, graph: &OpGraph, samples: u64) -> bool {
        let mut own = self.terminals.clone();
        (0..samples).all(|seed| {
            let made = run(graph, &Library::new(), &Options { seed, ..Options::default() });
            let windows = made.map(|made| around(&Example::Blocks(made.made), &mut own));
            windows.is_ok_and(|windows| windows.iter().all(|(_, window)| self.windows.contains(window)))
        })
    }

    /// Whether samples show more than the examples again.
    pub fn is_exceeded(&self, graph: &OpGraph) -> bool {
        (0..FEW).any(|seed| {
            let made = run(graph, &Library::new(), &Options { seed, ..Options::default() });
            made.is_ok_and(|made| !self.examples.iter().any(|example| example.same_blocks(&made.made)))
        })
    }

    fn unseen(
        &self,
        grid: Grid,
        own: &mut Terminals,
        told: &mut FxHashSet<u64>,
        terminals: &mut Terminals,
    ) -> Option<Fault> {
        let sample = Example::Blocks(grid);
        let around = around(&sample, own).into_iter();
        let unseen = around.filter(|(_, window)| {
            !self.windows.contains(window) && told.len() < MOST && told.insert(*window)
        });
        let windows: Vec<Bounds> = unseen.map(|(at, _)| Bounds::new(at, at + Cell::splat(2))).collect();
        let cells = || sample.open().cells(terminals);
        (!windows.is_empty()).then(cells)?.map(|cells| Fault::Unseen { cells, windows })
    }
}

/// The neighbourhoods of a building with where they are.
fn around(building: &Example, terminals: &mut Terminals) -> Vec<(Cell, u64)> {
    let all = building.bounds();
    let Some(cells) = building.cells(terminals) else { return Vec::new() };
    let get = |cell: Cell| match all.contains(cell) {
        true => cells[[cell.y as usize, cell.z as usize, cell.x as usize]],
        false => OUTSIDE,
    };
    let starts = Bounds::new(all.min - Cell::ONE, all.max);
    starts.cells().map(|at| (at, window(Cell::splat(2), |step| get(at + step)))).collect()
}
