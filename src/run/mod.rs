//! Running an op graph: a scope and a seed become placements, and placements become a grid.
//! Knows nothing of inference or files.

mod body;
mod brush;
mod carve;
pub mod context;
mod derive;
mod error;
mod eval;
mod known;
mod place;
mod rhythm;
mod roof;
mod rounds;
mod settings;
mod solid;
mod start;
mod trail;
mod why;

use crate::block::{BlockState, PaletteFull, as_in};
use crate::grammar::is_mesh;
use crate::graph::{OpGraph, Thing};
use crate::grid::{Grid, LabelledBox};
use crate::neighbours::settle;
use crate::space::{Bounds, Cell, Frame, Scope, Turn};
use std::collections::BTreeMap;

pub use body::Body;
pub use brush::{Brush, Brushes};
pub use carve::{Part, carve};
pub use derive::{Placement, derive, quarter_turns};
pub use error::{Kind, RunError, Warning};
pub use eval::{Things, Value};
pub use rhythm::written_out;
pub use start::start_size;
pub use trail::{Labels, Observer, Step, Trail};
pub use why::{Cause, Why, why};

/// What to do where sizes do not fit their scope.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Overrun {
    /// Stop with an error that names the rule.
    #[default]
    Refuse,
    /// Cut off what runs over, leave free what is not filled, and warn.
    Clip,
}

/// Bounds on what a derivation may take, so that a slip in a grammar ends in an error.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Cells of the grid.
    pub cells: u64,
    /// Operations derived from one another in a chain.
    pub depth: u32,
    /// Operations in all.
    pub steps: u64,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { cells: 1 << 28, depth: 10_000, steps: 100_000_000 }
    }
}

/// How to run a graph.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Options {
    pub seed: u64,
    /// The size of the start scope in the grammar's axes; `None` to draw one of the grammar's own.
    pub size: Option<Cell>,
    pub overrun: Overrun,
    /// The last priority whose rules run; shapes that wait for a later one stay plain masses. `None` for all.
    pub detail: Option<u32>,
    pub limits: Limits,
}

/// The schematic files that a graph names as primitives, by name.
pub type Library = BTreeMap<String, Grid>;

/// What a run made, and what there is to say about it.
#[derive(Debug)]
pub struct Made<T> {
    pub made: T,
    pub warnings: Vec<Warning>,
}

/// Runs a graph and fills a grid of the start scope's size. What blocks leave open their neighbours decide, once
/// all stand.
pub fn run(graph: &OpGraph, library: &Library, options: &Options) -> Result<Made<Grid>, RunError> {
    run_observed(graph, library, options, None)
}

/// As [`run`], with someone who looks on.
pub fn run_observed(
    graph: &OpGraph,
    library: &Library,
    options: &Options,
    observer: Option<&mut dyn Observer>,
) -> Result<Made<Grid>, RunError> {
    let scope = start_scope(graph, options)?;
    let mut grid = Grid::new(scope.bounds.size());
    let things = Things::default();
    let mut brushes = brush::Brushes::new(library, options.seed);
    let warnings = derive(graph, &things, scope, options, observer, &mut |placement| {
        brushes.place(&mut grid, &placement)
    })?;
    grid.metadata.data_version = graph.data_version;
    to_its_version(&mut grid)
        .and_then(|()| settle(&mut grid))
        .map_err(|_| RunError::anywhere(Kind::PaletteFull))?;
    Ok(Made { made: grid, warnings })
}

/// Takes off what the version that a grid is of, if it says one, does not know.
fn to_its_version(grid: &mut Grid) -> Result<(), PaletteFull> {
    let version = grid.version();
    let is_known = |state: &BlockState| as_in(state, version) == *state;
    match grid.metadata.data_version.is_none() || grid.palette().states().iter().all(is_known) {
        true => Ok(()),
        false => grid.map_states(|state| as_in(state, version)),
    }
}

/// Runs a graph and lists its primitives as labelled boxes in the world's axes, in the order placed. A
/// primitive that is turned carries its angle in degrees: `corner@90`.
pub fn run_boxes(graph: &OpGraph, options: &Options) -> Result<Made<Vec<LabelledBox>>, RunError> {
    run_boxes_observed(graph, options, None)
}

/// As [`run_boxes`], with someone who looks on.
pub fn run_boxes_observed(
    graph: &OpGraph,
    options: &Options,
    observer: Option<&mut dyn Observer>,
) -> Result<Made<Vec<LabelledBox>>, RunError> {
    let scope = start_scope(graph, options)?;
    let mut boxes = Vec::new();
    let things = Things::default();
    let warnings = derive(graph, &things, scope, options, observer, &mut |placement| {
        let degrees = 90 * u32::from(placement.scope.frame.turn.count());
        let name = placement.name.text();
        let label = if degrees == 0 { name.to_owned() } else { format!("{name}@{degrees}") };
        let filled = brush::boxes(&placement);
        boxes.extend(filled.map(|bounds| LabelledBox { label: label.clone(), bounds }));
        Ok(())
    })?;
    Ok(Made { made: boxes, warnings })
}

/// A mesh that stands among the blocks of a building.
#[derive(Clone, PartialEq, Debug)]
pub struct MeshPlace {
    pub file: String,
    /// The block that stands for it where there are blocks only.
    pub block: Option<BlockState>,
    pub bounds: Bounds,
    pub turn: Turn,
}

/// Runs a graph and lists the meshes that it places.
pub fn run_meshes(graph: &OpGraph, options: &Options) -> Result<Vec<MeshPlace>, RunError> {
    let scope = start_scope(graph, options)?;
    let mut meshes = Vec::new();
    let things = Things::default();
    derive(graph, &things, scope, options, None, &mut |placement| {
        if let Thing::File(file) = placement.name
            && is_mesh(file)
        {
            meshes.push(MeshPlace {
                file: file.clone(),
                block: placement.material.and_then(Thing::block),
                bounds: placement.scope.bounds,
                turn: placement.scope.frame.turn,
            });
        }
        Ok(())
    })?;
    Ok(meshes)
}

fn start_scope(graph: &OpGraph, options: &Options) -> Result<Scope, RunError> {
    let size = match options.size {
        Some(size) => size,
        None => start_size(graph, options.seed)?,
    };
    let volume = Bounds::of_size(size).volume();
    if size.min_element() < 1 || volume > options.limits.cells {
        return Err(RunError::anywhere(Kind::Size { size, limit: options.limits.cells }));
    }
    Ok(Scope::start(size, Frame { up: graph.up, turn: Turn::NONE }))
}
