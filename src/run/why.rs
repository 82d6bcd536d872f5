//! Why a block stands where it stands.

use super::trail::{Observer, Step, Trail};
use super::{Kind, Library, Options, RunError, Warning, brush, derive, start_scope};
use crate::block::BlockState;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::neighbours::settle;
use crate::run::Things;
use crate::space::Cell;

/// Blocks that were put at a place and overwritten, of which more is told than their number, at the most.
const MOST_TOLD: usize = 100;

/// What stands at a place, and all that led to it.
#[derive(Debug)]
pub struct Why {
    /// As the neighbours have made it.
    pub state: BlockState,
    /// What put a block there: the last stands.
    pub causes: Vec<Cause>,
    /// How many causes before these are not told.
    pub untold: u64,
    pub warnings: Vec<Warning>,
}

/// One primitive that put a block at a place.
#[derive(Debug)]
pub struct Cause {
    /// The block, before its neighbours had a say.
    pub state: BlockState,
    /// The operations from the start down to the primitive.
    pub steps: Vec<Step>,
}

/// Runs a graph and looks on at one place of the grid, which has to lie inside.
pub fn why(graph: &OpGraph, library: &Library, options: &Options, cell: Cell) -> Result<Why, RunError> {
    let scope = start_scope(graph, options)?;
    let mut grid = Grid::new(scope.bounds.size());
    if !grid.bounds().contains(cell) {
        return Err(RunError::anywhere(Kind::OutsidePlot));
    }
    let things = Things::default();
    let mut brushes = brush::Brushes::new(library, options.seed);
    let (mut causes, mut untold) = (Vec::new(), 0);
    let mark = mark(&mut grid)?;
    let warnings = derive(graph, &things, scope, options, Some(&mut Trails), &mut |placement| {
        if !placement.scope.bounds.contains(cell) {
            return brushes.place(&mut grid, &placement);
        }
        // What a primitive writes shows even where the same block stood before.
        let before = grid.id(cell);
        grid.set(cell, mark);
        brushes.place(&mut grid, &placement)?;
        if grid.id(cell) == mark {
            grid.set(cell, before);
            return Ok(());
        }
        if causes.len() == MOST_TOLD {
            causes.remove(0);
            untold += 1;
        }
        let mut steps: Vec<Step> = placement.trail.steps().cloned().collect();
        steps.reverse();
        causes.push(Cause { state: grid.get(cell).clone(), steps });
        Ok(())
    })?;
    settle(&mut grid).map_err(|_| RunError::anywhere(Kind::PaletteFull))?;
    Ok(Why { state: grid.get(cell).clone(), causes, untold, warnings })
}

/// A block that no grammar can name.
fn mark(grid: &mut Grid) -> Result<u16, RunError> {
    let state = BlockState::new("vox:unwritten").map_err(|_| RunError::anywhere(Kind::PaletteFull))?;
    grid.intern(&state).map_err(|_| RunError::anywhere(Kind::PaletteFull))
}

/// Keeps what led to each operation.
struct Trails;

impl Observer for Trails {
    fn step(&mut self, step: Step) -> Trail {
        Trail::of(step)
    }
}
