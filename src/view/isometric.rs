use super::camera::Camera;
use super::canvas::{Canvas, Face};
use super::develop::develop;
use super::options::ViewOptions;
use super::scene::{Look, Part, Scene, Sight, turned_size};
use super::side::Side;
use super::texture::noise;
use crate::grid::Grid;
use crate::space::Cell;
use glam::Vec3;
use image::RgbaImage;

/// Light that a corner loses for each of up to three blocks that crowd it.
const CROWDING: f32 = 0.13;

/// A picture of a grid from above one of its corners, in parallel projection.
pub fn isometric(grid: &Grid, options: &ViewOptions) -> RgbaImage {
    let size = turned_size(grid.size(), options.corner.turn());
    let camera = Camera::new(size, options.scale);
    let scene = Scene::new(grid, options.corner, &camera);
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
