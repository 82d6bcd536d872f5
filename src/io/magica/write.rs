use super::MOST;
use super::colors::{MOST_COLORS, reduce};
use crate::block::{BlockState, Rgba, Shape, shape};
use crate::grid::Grid;
use crate::io::error::Size;
use crate::io::{Encoded, Lost, WriteError};
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;

/// The version of the format, which every program reads.
const VERSION: u32 = 150;

/// The file of `grid` as coloured voxels, in the colours that `color` gives the blocks. Builds longer than a model are
/// a scene of several. The same grid always gives the same bytes.
pub fn encode_vox(grid: &Grid, color: impl Fn(&BlockState) -> Rgba) -> Result<Encoded, WriteError> {
    let painted = Painted::of(grid, color);
    let models = models(grid.bounds());
    if models.is_empty() {
        return Err(WriteError::Empty(Size(grid.size())));
    }
    let mut main = Vec::new();
    for &bounds in &models {
        chunk(&mut main, b"SIZE", &numbers(&size(bounds).map(|n| n as u32)))?;
        chunk(&mut main, b"XYZI", &painted.voxels(bounds)?)?;
    }
    if models.len() > 1 {
        scene(&mut main, grid.size(), &models)?;
    }
    chunk(&mut main, b"RGBA", &painted.palette())?;
    let mut bytes = [&b"VOX "[..], &VERSION.to_le_bytes(), b"MAIN", &[0; 4]].concat();
    bytes.extend(length(main.len())?.to_le_bytes());
    bytes.extend(main);
    Ok(Encoded { bytes, lost: lost(grid, &painted) })
}

/// A grid by the colours of its blocks.
struct Painted<'a> {
    grid: &'a Grid,
    colors: Vec<[u8; 4]>,
    /// How many colours there were before some were joined.
    found: usize,
    /// The colour number of each palette number; 0 for what is not there to see.
    by_id: Vec<u8>,
}

impl Painted<'_> {
    fn of(grid: &Grid, color: impl Fn(&BlockState) -> Rgba) -> Painted<'_> {
        let states = grid.palette().states();
        let color = |state: &BlockState| (shape(state) != Shape::Air).then(|| color(state).0);
        let by_state: Vec<Option<[u8; 4]>> = states.iter().map(color).collect();
        let mut counts = BTreeMap::new();
        for color in grid.cells().iter().filter_map(|&id| by_state[usize::from(id)]) {
            *counts.entry(color).or_insert(0) += 1;
        }
        let (colors, places) = reduce(&counts);
        let number = |color: &Option<[u8; 4]>| {
            color.and_then(|color| places.get(&color)).map_or(0, |&place| (place + 1) as u8)
        };
        Painted { grid, colors, found: counts.len(), by_id: by_state.iter().map(number).collect() }
    }

    fn voxels(&self, bounds: Bounds) -> Result<Vec<u8>, WriteError> {
        let mut voxels = vec![0; 4];
        for cell in bounds.cells() {
            let color = self.by_id[usize::from(self.grid.id(cell))];
            if color > 0 {
                let Cell { x, y, z } = cell - bounds.min;
                let back = bounds.size().z - 1 - z;
                voxels.extend([x as u8, back as u8, y as u8, color]);
            }
        }
        let count = length(voxels.len() / 4 - 1)?;
        voxels[..4].copy_from_slice(&count.to_le_bytes());
        Ok(voxels)
    }

    fn palette(&self) -> Vec<u8> {
        let mut palette = self.colors.concat();
        palette.resize(4 * 256, 0);
        palette
    }
}

/// The parts of a build that are models.
fn models(bounds: Bounds) -> Vec<Bounds> {
    let parts = |len: i32| (0..len).step_by(MOST as usize);
    let Cell { x, y, z } = bounds.size();
    let corners =
        parts(y).flat_map(|y| parts(z).flat_map(move |z| parts(x).map(move |x| Cell::new(x, y, z))));
    corners
        .map(|low| Bounds::new(low, low + MOST).intersect(&bounds))
        .filter(|part| !part.is_empty())
        .collect()
}

/// Along the axes of the format.
fn size(bounds: Bounds) -> [i32; 3] {
    let Cell { x, y, z } = bounds.size();
    [x, z, y]
}

/// A group of all models at their places, so that the build stands on the middle of the ground.
fn scene(out: &mut Vec<u8>, whole: Cell, models: &[Bounds]) -> Result<(), WriteError> {
    const NO_LAYER: u32 = u32::MAX;
    const LAYER: u32 = 0;
    transform(out, 0, 1, NO_LAYER, None)?;
    let transforms: Vec<u32> = (0..models.len() as u32).map(|index| 2 + 2 * index).collect();
    let group = [&[1, 0, transforms.len() as u32][..], &transforms].concat();
    chunk(out, b"nGRP", &numbers(&group))?;
    for ((&bounds, &node), model) in models.iter().zip(&transforms).zip(0..) {
        transform(out, node, node + 1, LAYER, Some(middle(whole, bounds)))?;
        chunk(out, b"nSHP", &numbers(&[node + 1, 0, 1, model, 0]))?;
    }
    Ok(())
}

/// Where the middle of a model stands, rounded down within the model.
fn middle(whole: Cell, bounds: Bounds) -> [i32; 3] {
    let [x, y, z] = size(bounds);
    let low = [bounds.min.x - whole.x / 2, whole.z / 2 - bounds.max.z, bounds.min.y];
    [low[0] + x / 2, low[1] + y / 2, low[2] + z / 2]
}

fn transform(
    out: &mut Vec<u8>,
    node: u32,
    child: u32,
    layer: u32,
    shift: Option<[i32; 3]>,
) -> Result<(), WriteError> {
    const RESERVED: u32 = u32::MAX;
    let frame = match shift {
        None => numbers(&[0]),
        Some([x, y, z]) => [&numbers(&[1])[..], &text("_t"), &text(&format!("{x} {y} {z}"))].concat(),
    };
    let head = numbers(&[node, 0, child, RESERVED, layer, 1]);
    chunk(out, b"nTRN", &[head, frame].concat())
}

fn numbers(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|n| n.to_le_bytes()).collect()
}

fn text(text: &str) -> Vec<u8> {
    [&numbers(&[text.len() as u32])[..], text.as_bytes()].concat()
}

/// Adds a chunk that holds no other ones.
fn chunk(out: &mut Vec<u8>, name: &[u8; 4], content: &[u8]) -> Result<(), WriteError> {
    out.extend(name);
    out.extend(length(content.len())?.to_le_bytes());
    out.extend([0; 4]);
    out.extend(content);
    Ok(())
}

fn length(len: usize) -> Result<u32, WriteError> {
    u32::try_from(len).map_err(|_| WriteError::LongModel)
}

/// Whether any block is there, be it without a colour.
fn has_blocks(grid: &Grid) -> bool {
    let is_nothing: Vec<bool> = grid.palette().states().iter().map(BlockState::is_nothing).collect();
    grid.cells().iter().any(|&id| !is_nothing[usize::from(id)])
}

fn lost(grid: &Grid, painted: &Painted) -> Vec<Lost> {
    let colors = Lost::Colors { found: painted.found, kept: MOST_COLORS };
    let lost = [
        has_blocks(grid).then_some(Lost::States),
        (painted.found > MOST_COLORS).then_some(colors),
        Lost::block_entities(grid),
        Lost::entities(grid),
        Lost::biomes(grid),
        Lost::offset(grid),
        Lost::metadata(grid),
        Lost::own(grid, None),
        Lost::regions(grid),
        Lost::variants(grid),
    ];
    lost.into_iter().flatten().collect()
}
