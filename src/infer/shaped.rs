//! SIGI's shapes as terminals (seed 3, "Split Grammar Induction").

use super::example::{Example, Terminals};
use super::swaps::Site;
use crate::grid::Grid;
use crate::shapes::{Building, Settings, Shape, search};
use crate::space::Bounds;
use ndarray::{Array3, s};

/// What the shapes of an example are to a split tree.
#[derive(Debug, Default)]
pub struct Shaped {
    /// Shapes of several blocks: each is a rule of its own, and shapes that are the same are one.
    pub sites: Vec<Site>,
    /// Shapes of one block state, with its terminal.
    pub plain: Vec<(Bounds, u32)>,
}

/// The shapes of an example: rectangles, which are boxes one block thick, that share no block. Those that would share a cell
/// with `taken` are left out.
pub fn shaped(example: &Example, taken: &[Site], terminals: &mut Terminals) -> Shaped {
    let (Example::Blocks(grid), Some(cells)) = (example, example.cells(terminals)) else {
        return Shaped::default();
    };
    let building = Building::of(grid);
    let mut shaped = Shaped::default();
    for shape in search(&building, &Settings::default()) {
        let bounds = bounds(&building, &shape);
        if taken.iter().all(|site| site.bounds.intersect(&bounds).is_empty()) {
            enter(&mut shaped, grid, &cells, bounds);
        }
    }
    shaped
}

fn bounds(building: &Building, shape: &Shape) -> Bounds {
    let cells = shape.blocks.iter().map(|block| building.cell(*block));
    Bounds::around(cells).expect("a shape holds blocks")
}

fn enter(shaped: &mut Shaped, grid: &Grid, cells: &Array3<u32>, bounds: Bounds) {
    let [x0, y0, z0] = bounds.min.to_array().map(|n| n as usize);
    let [x1, y1, z1] = bounds.max.to_array().map(|n| n as usize);
    let content = cells.slice(s![y0..y1, z0..z1, x0..x1]).to_owned();
    let first = grid.id(bounds.min);
    match bounds.cells().all(|cell| grid.id(cell) == first) {
        true => shaped.plain.push((bounds, content[[0, 0, 0]])),
        false => shaped.sites.push(Site { bounds, contents: vec![(content, 1)] }),
    }
}
