//! Proof that a grammar gives its layout: each leaf is compared with what its label alone puts there.

use super::emit::emit_leaf;
use super::{Depth, Layout, Meaning, Region};
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::run::{Brushes, Library, Options, RunError, Things, derive};
use crate::space::{Bounds, Cell, Frame, Scope, Turn, Up};

/// How many leaves a run at the layout's own size gives, block for block.
///
/// # Errors
///
/// Where the graph, or a label's own, does not run.
pub fn reproduced(
    graph: &OpGraph,
    layout: &Layout,
    meanings: &[Meaning],
    depth: Depth,
    library: &Library,
) -> Result<usize, RunError> {
    let [width, height] = layout.size();
    let size = Cell::new(width as i32, height as i32, depth.total() as i32);
    let (mut expected, mut made) = (Grid::new(size), Grid::new(size));
    place(graph, Bounds::of_size(size), library, &mut made)?;
    for label in 0..meanings.len() as u32 {
        let alone = emit_leaf(layout.labels(), label, meanings, depth);
        for leaf in layout.leaves().iter().filter(|leaf| leaf.label == label) {
            place(&alone, bounds(&leaf.region, size.z), library, &mut expected)?;
        }
    }
    let is_alike =
        |region: &Region| bounds(region, size.z).cells().all(|cell| made.get(cell) == expected.get(cell));
    Ok(layout.leaves().iter().filter(|leaf| is_alike(&leaf.region)).count())
}

/// The box of a leaf.
fn bounds(region: &Region, depth: i32) -> Bounds {
    let corner = |end: usize, z: i32| Cell::new(region.sides[0][end] as i32, region.sides[1][end] as i32, z);
    Bounds::new(corner(0, 0), corner(1, depth))
}

/// Puts what a graph makes of a box into a grid, as it is before neighbours settle.
fn place(graph: &OpGraph, bounds: Bounds, library: &Library, grid: &mut Grid) -> Result<(), RunError> {
    let things = Things::default();
    let options = Options::default();
    let mut brushes = Brushes::new(library, options.seed);
    let scope = Scope::start(bounds.size(), Frame { up: Up::Y, turn: Turn::NONE });
    let scope = Scope { bounds, ..scope };
    derive(graph, &things, scope, &options, None, &mut |placement| brushes.place(grid, &placement)).map(drop)
}
