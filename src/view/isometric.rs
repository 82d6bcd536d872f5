use super::camera::Camera;
use super::canvas::{Canvas, Face};
use super::develop::develop;
use super::options::ViewOptions;
use super::scene::{Look, Part, Scene, Sight};
use super::side::Side;
use super::texture::noise;
use crate::block::Rgba;
use crate::grid::Grid;
use crate::space::Cell;
use glam::Vec3;
use image::RgbaImage;
use ndarray::Array3;

/// Light that a corner loses for each of up to three blocks that crowd it.
const CROWDING: f32 = 0.13;

/// Blocks with less than this many samples from their middle to their side are drawn as plain boxes.
const SMALLEST_DETAIL: f32 = 4.0;

/// A picture of a grid from above one of its corners, in parallel projection.
pub fn isometric(grid: &Grid, options: &ViewOptions) -> RgbaImage {
    picture(Scene::new(grid, options.corner), options)
}

/// The same of full blocks in plain colours: each cell, indexed `[y, z, x]`, is the number of its colour. Where there is none,
/// the cell is empty.
pub fn isometric_colors(cells: &Array3<u16>, colors: &[Option<Rgba>], options: &ViewOptions) -> RgbaImage {
    picture(Scene::of_colors(cells, colors, options.corner), options)
}

fn picture(scene: Scene<'_>, options: &ViewOptions) -> RgbaImage {
    let camera = Camera::new(scene.extent().unwrap_or_default(), options.scale);
    let scene = if camera.half < SMALLEST_DETAIL { scene.coarse() } else { scene };
    let [red, green, blue, _] = options.background.0;
    let mut canvas = Canvas::new(&camera, [red, green, blue]);
    let clear = draw_opaque(&scene, &camera, &mut canvas);
    draw_clear(&scene, &camera, &mut canvas, clear);
    develop(&canvas, &camera, options.background)
}

/// Draws all that hides what is behind it, and gives back the cells that do not.
fn draw_opaque(scene: &Scene<'_>, camera: &Camera, canvas: &mut Canvas) -> Vec<(Cell, u16)> {
    let mut clear = Vec::new();
    for (cell, id) in scene.cells() {
        let hidden = Side::ALL.iter().all(|side| scene.is_solid(cell + side.normal()));
        let look = scene.look(id);
        match look.sight {
            _ if hidden => {}
            Sight::Clear | Sight::Fluid => clear.push((cell, id)),
            _ => draw(scene, (cell, id), look, |face| canvas.paint(camera, face)),
        }
    }
    clear
}

/// Draws what can be seen through, the farthest first.
fn draw_clear(scene: &Scene<'_>, camera: &Camera, canvas: &mut Canvas, mut cells: Vec<(Cell, u16)>) {
    cells.sort_by_key(|(cell, _)| cell.element_sum());
    for (cell, id) in cells {
        draw(scene, (cell, id), scene.look(id), |face| canvas.glaze(camera, face));
    }
}

/// Calls `paint` for every face of a block that nothing covers.
fn draw(scene: &Scene<'_>, (cell, id): (Cell, u16), look: &Look, mut paint: impl FnMut(&Face<'_>)) {
    let flooded = look.sight == Sight::Fluid && scene.id(cell + Cell::Y) == Some(id);
    for part in &look.parts {
        let high = if flooded { part.high.with_y(1.0) } else { part.high };
        for side in Side::ALL {
            let at_border = high.dot(side.normal().as_vec3()) == 1.0;
            if !(at_border && is_covered(scene, cell + side.normal(), id, look.sight)) {
                let corners = if at_border { corners(scene, cell, side) } else { [[1.0; 2]; 2] };
                paint(&face(part, high, side, (cell, id), corners));
            }
        }
    }
}

/// Whether the block at `cell` covers the whole side of its neighbour: it is solid, or more of the same glass.
fn is_covered(scene: &Scene<'_>, cell: Cell, id: u16, sight: Sight) -> bool {
    let same = matches!(sight, Sight::Clear | Sight::Fluid) && scene.id(cell) == Some(id);
    same || scene.is_solid(cell)
}

fn face<'a>(
    part: &'a Part,
    high: Vec3,
    side: Side,
    (cell, id): (Cell, u16),
    corners: [[f32; 2]; 2],
) -> Face<'a> {
    let color = part.colors[side as usize].0.map(f32::from);
    let origin = cell.as_vec3() + side.origin(high);
    let plane = origin.dot(side.normal().as_vec3()) * 16.0;
    Face {
        side,
        origin,
        extent: side.extent(part.low, high),
        color: Vec3::new(color[0], color[1], color[2]) * side.light() * mottle(cell),
        alpha: color[3] / 255.0,
        texture: part.textures[side as usize],
        corners,
        surface: surface(side, plane as u32, id),
    }
}

/// Blocks of one kind differ a little in brightness, so that single blocks can be told on a wall.
fn mottle(cell: Cell) -> f32 {
    1.0 + noise(cell.x + 31 * cell.y, cell.z - 17 * cell.y, 100) as f32 * 0.0003
}

/// A number, never 0, that differs where side, plane or block state do, chance collisions aside.
fn surface(side: Side, plane: u32, id: u16) -> u32 {
    let mixed = plane.wrapping_mul(0x9e37_79b1) ^ u32::from(id).wrapping_mul(0x85eb_ca77);
    mixed.wrapping_add(side as u32) | 1 << 31
}

/// The light at the four corners of a side, as `[v][u]`: corners between blocks are darker.
fn corners(scene: &Scene<'_>, cell: Cell, side: Side) -> [[f32; 2]; 2] {
    let outside = cell + side.normal();
    let [u, v] = side.axes();
    let crowd = |du: i32, dv: i32| {
        let sides = [outside + u * du, outside + v * dv].map(|cell| i32::from(scene.is_solid(cell)));
        match sides {
            [1, 1] => 3,
            [a, b] => a + b + i32::from(scene.is_solid(outside + u * du + v * dv)),
        }
    };
    [-1, 1].map(|dv| [-1, 1].map(|du| 1.0 - CROWDING * crowd(du, dv) as f32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{BlockState, all};
    use crate::view::{Corner, Scale};

    /// A grid with one block every other cell.
    fn apart(states: &[BlockState]) -> Grid {
        let side = (states.len() as f32).sqrt().ceil() as usize;
        let mut grid = Grid::new(Cell::new(2 * side as i32, 1, 2 * side as i32));
        for (at, state) in states.iter().enumerate() {
            let id = grid.intern(state).unwrap();
            grid.set(Cell::new(2 * (at % side) as i32, 0, 2 * (at / side) as i32), id);
        }
        grid
    }

    fn from(corner: Corner) -> ViewOptions {
        ViewOptions { corner, ..ViewOptions::default() }
    }

    /// The mean place of the pixels that are much more red than green, from the left.
    fn middle_of_red(image: &RgbaImage) -> f32 {
        let red = image.enumerate_pixels().filter(|(.., pixel)| pixel.0[0] / 2 > pixel.0[1]);
        let columns: Vec<f32> = red.map(|(x, ..)| x as f32).collect();
        columns.iter().sum::<f32>() / columns.len() as f32
    }

    #[test]
    fn every_known_block_shows_unless_it_is_invisible() {
        let background = ViewOptions::PAPER.0;
        for known in all() {
            let state = known.default_state();
            let image = isometric(&apart(std::slice::from_ref(&state)), &ViewOptions::default());
            let shows = image.pixels().any(|pixel| pixel.0 != background);
            // Vines and the like have no face in their default state.
            let invisible = crate::block::boxes(&state).is_empty();
            assert_eq!(shows, !invisible, "{}", known.name());
        }
    }

    #[test]
    fn the_same_grid_gives_the_same_picture() {
        let states: Vec<BlockState> = all().iter().step_by(7).map(|known| known.default_state()).collect();
        let grid = apart(&states);
        let first = isometric(&grid, &ViewOptions::default());
        assert!(first == isometric(&grid.clone(), &ViewOptions::default()));
        assert!(first != isometric(&grid, &from(Corner::NorthWest)));
    }

    #[test]
    fn east_is_to_the_right_from_the_south_and_to_the_left_from_the_north() {
        let grid = Grid::row(&["stone", "stone", "stone", "redstone_block"]);
        for corner in Corner::ALL {
            let image = isometric(&grid, &from(corner));
            let right = middle_of_red(&image) > image.width() as f32 / 2.0;
            assert_eq!(right, matches!(corner, Corner::SouthEast | Corner::SouthWest), "{corner:?}");
        }
    }

    #[test]
    fn near_blocks_hide_far_ones_but_glass_does_not() {
        let redness = |near: &str| {
            let image = isometric(&Grid::row(&["redstone_block", near]), &ViewOptions::default());
            image.pixels().filter(|pixel| i32::from(pixel.0[0]) > i32::from(pixel.0[1]) + 40).count()
        };
        assert!(redness("glass") > redness("stone"));
    }

    #[test]
    fn empty_grids_and_single_blocks_have_a_picture() {
        for grid in [Grid::new(Cell::ZERO), Grid::new(Cell::splat(5)), Grid::row(&["stone"])] {
            let image = isometric(&grid, &ViewOptions::default());
            assert!(image.width() > 20 && image.height() > 20);
        }
    }

    #[test]
    fn air_around_a_building_does_not_make_it_smaller() {
        let small = Grid::row(&["stone", "oak_planks"]);
        let mut large = Grid::new(Cell::splat(9));
        for x in 0..2 {
            let id = large.intern(small.get(Cell::new(x, 0, 0))).unwrap();
            large.set(Cell::new(x + 4, 3, 5), id);
        }
        let options = ViewOptions { scale: Scale::BlockWidth(32), ..ViewOptions::default() };
        assert_eq!(isometric(&large, &options).dimensions(), isometric(&small, &options).dimensions());
    }

    #[test]
    fn a_clear_background_stays_clear() {
        let options = ViewOptions { background: ViewOptions::CLEAR, ..ViewOptions::default() };
        let image = isometric(&Grid::row(&["stone"]), &options);
        assert_eq!(image.get_pixel(0, 0).0[3], 0);
        assert_eq!(image.get_pixel(image.width() / 2, image.height() / 2).0[3], 255);
    }
}
