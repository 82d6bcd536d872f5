use super::MagicaError;
use super::chunks::{File, Model, Node, parse};
use super::colors::{default_palette, without_alpha};
use super::paints;
use super::scene::{Placed, visit};
use crate::grid::Grid;
use crate::io::error::Size;
use crate::io::{Limits, ReadError, Warning};
use crate::space::{Bounds, Cell};

/// The grid of the models of a scene where they stand.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<(Grid, Vec<Warning>), ReadError> {
    let file = parse(bytes)?;
    let Extent { bounds, voxels, hidden } = extent(&file)?;
    let cells = bounds.volume().max(voxels);
    if cells > limits.max_cells {
        return Err(ReadError::TooManyCells { size: Size(bounds.size()), cells, limit: limits.max_cells });
    }
    let mut grid = Grid::new(bounds.size());
    let blocks = blocks(&file, &mut grid)?;
    let mut outside = 0;
    visit(&file, &mut |placed| {
        outside += fill(&mut grid, bounds.min, &blocks, &file.models[placed.model], &placed);
        Ok(())
    })?;
    let frames = later_frames(&file);
    let warnings = [
        (hidden > 0).then_some(Warning::ModelsHidden(hidden)),
        (frames > 0).then_some(Warning::FramesLater(frames)),
        (outside > 0).then_some(Warning::VoxelsOutside(outside)),
    ];
    Ok((grid, warnings.into_iter().flatten().collect()))
}

/// The frames of an animation after the first. Models without a scene are such; in a scene each part has its own.
fn later_frames(file: &File) -> usize {
    match file.nodes.is_empty() {
        true => file.models.len().saturating_sub(1),
        false => file.nodes.values().map(Node::later_frames).max().unwrap_or(0),
    }
}

/// What the models of a scene come to.
struct Extent {
    /// Where all of them lie together.
    bounds: Bounds,
    /// How many are placed: a scene may hold a model many times.
    voxels: u64,
    /// Models that are left out.
    hidden: usize,
}

fn extent(file: &File) -> Result<Extent, MagicaError> {
    let mut bounds: Option<Bounds> = None;
    let mut voxels = 0;
    let hidden = visit(file, &mut |placed| {
        let model = &file.models[placed.model];
        let [a, b] = [[0; 3], model.size.map(|n| n - 1)].map(|corner| cell(&placed, corner, model.size));
        let (a, b) = (a.ok_or(MagicaError::TooFar)?, b.ok_or(MagicaError::TooFar)?);
        let here = Bounds::new(a.min(b), a.max(b) + 1);
        bounds = Some(bounds.map_or(here, |bounds| bounds.union(&here)));
        voxels += model.voxels.len() as u64;
        Ok(())
    })?;
    Ok(Extent { bounds: bounds.ok_or(MagicaError::NoModel)?, voxels, hidden })
}

/// The cell of the voxel `at` of a model; `None` where it lies too far away to be built.
fn cell(placed: &Placed, at: [i32; 3], size: [i32; 3]) -> Option<Cell> {
    const FAR: i64 = 1 << 29;
    let [x, y, z] = placed.motion.apply(at, size);
    let cell = [x, z, -1 - y];
    cell.iter().all(|n| (-FAR..FAR).contains(n)).then(|| Cell::from_array(cell.map(|n| n as i32)))
}

/// The palette numbers of `grid` for each colour number that is used; air for those that are not.
fn blocks(file: &File, grid: &mut Grid) -> Result<[u16; 256], ReadError> {
    let default = default_palette();
    let colors = file.palette.unwrap_or(&default);
    let mut blocks = [0; 256];
    let mut used = [false; 256];
    file.models.iter().flat_map(|model| model.voxels).for_each(|voxel| used[usize::from(voxel[3])] = true);
    for number in (1..256).filter(|&number| used[number]) {
        let color = colors.get(number - 1).copied().unwrap_or_default();
        if let Some(block) = paints::block(without_alpha(color)) {
            let full = |problem| ReadError::PaletteFull { path: "RGBA".to_owned(), problem };
            blocks[number] = grid.intern(&block).map_err(full)?;
        }
    }
    Ok(blocks)
}

/// Puts a model into the grid whose low corner is at `low`. Gives the number of voxels outside of the model, which
/// are left out.
fn fill(grid: &mut Grid, low: Cell, blocks: &[u16; 256], model: &Model, placed: &Placed) -> usize {
    let mut outside = 0;
    for &[x, y, z, color] in model.voxels {
        let at = [x, y, z].map(i32::from);
        let inside = at.iter().zip(model.size).all(|(&n, size)| n < size);
        match cell(placed, at, model.size).filter(|_| inside) {
            Some(cell) if color > 0 => grid.set(cell - low, blocks[usize::from(color)]),
            Some(_) => {}
            None => outside += 1,
        }
    }
    outside
}
