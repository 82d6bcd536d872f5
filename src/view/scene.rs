use super::camera::Extent;
use super::options::Corner;
use super::side::Side;
use super::texture::{Texture, is_cut_end, plain, textures};
use crate::block::{BlockState, Cuboid, Family, Rgba, Shape, boxes, color, shape};
use crate::grid::Grid;
use crate::space::{Cell, Turn};
use glam::Vec3;
use ndarray::{Array3, ArrayView1, ArrayView3, Axis, s};

/// A grid, turned so that the camera stands in the south-east, with what its blocks look like.
pub(super) struct Scene<'a> {
    cells: ArrayView3<'a, u16>,
    /// By palette number.
    looks: Vec<Look>,
}

/// How a block state is drawn.
pub(super) struct Look {
    pub sight: Sight,
    pub parts: Vec<Part>,
}

/// How far a block can be looked through.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Sight {
    Empty,
    /// Hides whatever is behind it.
    Solid,
    /// Opaque, but smaller than its cell.
    Open,
    /// Lets light through its color.
    Clear,
    /// As clear, and joined to more of it above.
    Fluid,
}

/// One box of a block, in cells from the corner of its cell.
#[derive(Clone)]
pub(super) struct Part {
    pub low: Vec3,
    pub high: Vec3,
    /// By side.
    pub colors: [Rgba; 3],
    pub textures: [&'static Texture; 3],
}

impl Look {
    fn empty() -> Look {
        Look { sight: Sight::Empty, parts: Vec::new() }
    }

    /// A full block of one colour.
    fn cube(color: Rgba) -> Look {
        let part = Part { low: Vec3::ZERO, high: Vec3::ONE, colors: [color; 3], textures: [plain(); 3] };
        Look { sight: Sight::Solid, parts: vec![part] }
    }
}

impl<'a> Scene<'a> {
    pub fn new(grid: &'a Grid, corner: Corner) -> Scene<'a> {
        let turn = corner.turn();
        let looks = grid.palette().states().iter().map(|state| look(&state.turned(turn))).collect();
        Scene { cells: turned(grid.cells().view(), turn), looks }
    }

    /// Cells of plain colours, by the numbers of the colours; those that are of none are empty.
    pub fn of_colors(cells: &'a Array3<u16>, colors: &[Option<Rgba>], corner: Corner) -> Scene<'a> {
        let looks = colors.iter().map(|color| color.map_or_else(Look::empty, Look::cube)).collect();
        Scene { cells: turned(cells.view(), corner.turn()), looks }
    }

    /// All cells that are not empty with their palette numbers, roughly from the front to the back:
    /// what is drawn first hides most of the rest, and what is hidden costs little.
    pub fn cells(&self) -> impl Iterator<Item = (Cell, u16)> {
        self.rows().flat_map(|(y, z, row)| {
            let found = row.into_iter().enumerate().rev().filter(|(_, id)| self.sight(**id) != Sight::Empty);
            found.map(move |(x, id)| (Cell::new(x as i32, y, z), *id))
        })
    }

    /// Where the blocks are on a picture.
    pub fn extent(&self) -> Option<Extent> {
        let ends = self.rows().flat_map(|(y, z, row)| {
            let seen = |id: &u16| self.sight(*id) != Sight::Empty;
            let first = row.iter().position(seen);
            let last = first.and_then(|_| row.iter().rposition(seen));
            first.into_iter().chain(last).map(move |x| Cell::new(x as i32, y, z))
        });
        ends.map(Extent::of).reduce(Extent::union)
    }

    /// The rows along x with their y and z, the last first.
    fn rows(&self) -> impl Iterator<Item = (i32, i32, ArrayView1<'_, u16>)> {
        let (height, depth, _) = self.cells.dim();
        let places = (0..height).rev().flat_map(move |y| (0..depth).rev().map(move |z| (y, z)));
        places.map(|(y, z)| (y as i32, z as i32, self.cells.slice(s![y, z, ..])))
    }

    /// The same scene with a single plain box for each block.
    pub fn coarse(mut self) -> Scene<'a> {
        for look in &mut self.looks {
            let parts = std::mem::take(&mut look.parts);
            look.parts = parts.into_iter().reduce(merge).into_iter().map(blunt).collect();
        }
        self
    }

    pub fn look(&self, id: u16) -> &Look {
        &self.looks[usize::from(id)]
    }

    fn sight(&self, id: u16) -> Sight {
        self.looks[usize::from(id)].sight
    }

    /// The palette number at `cell`; `None` outside the grid.
    pub fn id(&self, cell: Cell) -> Option<u16> {
        // A negative number becomes one that is far outside.
        self.cells.get([cell.y as usize, cell.z as usize, cell.x as usize]).copied()
    }

    pub fn is_solid(&self, cell: Cell) -> bool {
        self.id(cell).is_some_and(|id| self.sight(id) == Sight::Solid)
    }
}

/// The cells of a grid after a turn about the vertical, indexed `[y, z, x]` as before.
fn turned(cells: ArrayView3<'_, u16>, turn: Turn) -> ArrayView3<'_, u16> {
    const Z: Axis = Axis(1);
    const X: Axis = Axis(2);
    let mut cells = if turn.count() % 2 == 1 { cells.permuted_axes([0, 2, 1]) } else { cells };
    if matches!(turn.count(), 1 | 2) {
        cells.invert_axis(Z);
    }
    if matches!(turn.count(), 2 | 3) {
        cells.invert_axis(X);
    }
    cells
}

fn look(state: &BlockState) -> Look {
    let shape = shape(state);
    let own = color(state);
    let parts = parts(state, shape, own);
    let sight = match (parts.is_empty(), own.is_opaque(), shape) {
        (true, ..) => Sight::Empty,
        (_, true, Shape::Full) => Sight::Solid,
        (_, _, Shape::Fluid(_)) => Sight::Fluid,
        (_, true, _) => Sight::Open,
        (_, false, _) => Sight::Clear,
    };
    Look { sight, parts }
}

fn parts(state: &BlockState, shape: Shape, own: Rgba) -> Vec<Part> {
    // What is cut from planks or bricks looks like them, and so do the ends of a trunk.
    let family = Family::of(state.name());
    let full = family.as_ref().map_or(state, |family| &family.full);
    let material = if shape == Shape::Full { state } else { full };
    let textures = textures(state, material.short_name());
    let colors = Side::ALL.map(|side| if is_cut_end(state, side) { color(full) } else { own });
    let place = |corner: [u8; 3]| Vec3::from(corner.map(f32::from)) / 16.0;
    let part = |cuboid: Cuboid| Part {
        low: place(cuboid.low),
        high: place(cuboid.high),
        colors: cuboid.color.map_or(colors, |color| [color; 3]),
        textures,
    };
    solids(state).into_iter().map(part).collect()
}

/// The boxes of a block, with soil under the turf.
fn solids(state: &BlockState) -> Vec<Cuboid> {
    let soil = match state.short_name() {
        "grass_block" | "podzol" | "mycelium" => Rgba::rgb(0x86, 0x60, 0x43),
        "crimson_nylium" | "warped_nylium" => Rgba::rgb(0x65, 0x26, 0x26),
        _ => return boxes(state),
    };
    let below = Cuboid { low: [0, 0, 0], high: [16, 12, 16], color: Some(soil) };
    vec![below, Cuboid { low: [0, 12, 0], high: [16, 16, 16], color: None }]
}

/// The box around two parts, in the colors of the second.
fn merge(a: Part, b: Part) -> Part {
    Part { low: a.low.min(b.low), high: a.high.max(b.high), ..b }
}

fn blunt(part: Part) -> Part {
    Part { textures: [plain(); 3], ..part }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_cells_are_where_the_turn_puts_them() {
        let size = Cell::new(2, 3, 4);
        let cells = Array3::from_shape_fn((3, 4, 2), |(y, z, x)| (100 * y + 10 * z + x) as u16);
        for turn in Turn::ALL {
            let view = turned(cells.view(), turn);
            let far = turn.apply(size - 1);
            for ((y, z, x), id) in cells.indexed_iter() {
                let at = turn.apply(Cell::new(x as i32, y as i32, z as i32)) - far.min(Cell::ZERO);
                assert_eq!(view.get([at.y as usize, at.z as usize, at.x as usize]), Some(id));
            }
            let dim = turn.apply(size).abs();
            assert_eq!(view.dim(), (dim.y as usize, dim.z as usize, dim.x as usize));
        }
    }
}
