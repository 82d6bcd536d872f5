use super::options::Scale;
use super::side::Side;
use crate::space::Cell;
use glam::{Vec2, Vec3};

/// The height of a block against half its width, for an eye that looks down at 30 degrees:
/// only then do the edges of the ground run two pixels across for each pixel down.
const RISE: f32 = 1.2247;
/// No picture is larger than this either way, in pixels.
const LARGEST: f32 = 8000.0;
/// Samples of a picture, all in all: what bounds the memory.
const MOST_SAMPLES: f32 = 16.0e6;
/// Empty space around the building, in pixels.
const MARGIN: f32 = 10.0;

/// Maps cells to samples. Every pixel of the picture is the mean of `oversampling` squared samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    /// Half the width of a block in samples.
    pub half: f32,
    /// The height of a block in samples.
    pub rise: f32,
    /// Where the low corner of the grid is on the canvas, in samples.
    origin: Vec2,
    pub oversampling: u32,
    /// The picture, in pixels.
    pub width: u32,
    pub height: u32,
}

impl Camera {
    /// The camera for a grid of `size`, seen from its south-east corner.
    pub fn new(size: Cell, scale: Scale) -> Camera {
        let size = size.max(Cell::ONE).as_vec3();
        let extent = Vec2::new(size.x + size.z, (size.x + size.z) / 2.0 + size.y * RISE);
        let pixels = half_width(extent, scale);
        let area = (extent * pixels + 2.0 * MARGIN).element_product();
        let oversampling = if area * 4.0 <= MOST_SAMPLES { 2 } else { 1 };
        Camera::sampled(size, pixels, oversampling)
    }

    fn sampled(size: Vec3, pixels: f32, oversampling: u32) -> Camera {
        let samples = oversampling as f32;
        // Whole samples give every block the same outline; below some size that would waste too much.
        let half = if pixels >= 4.0 { (pixels * samples).round() } else { pixels * samples };
        let rise = if pixels >= 4.0 { (half * RISE).round() } else { half * RISE };
        let margin = MARGIN * samples;
        let extent = Vec2::new((size.x + size.z) * half, (size.x + size.z) * half / 2.0 + size.y * rise);
        let pixels = ((extent + 2.0 * margin) / samples).ceil();
        Camera {
            half,
            rise,
            origin: Vec2::new(size.z * half, size.y * rise) + margin,
            oversampling,
            width: pixels.x as u32,
            height: pixels.y as u32,
        }
    }

    /// The canvas in samples.
    pub fn canvas_size(&self) -> [usize; 2] {
        [self.width, self.height].map(|n| (n * self.oversampling) as usize)
    }

    /// Where a place in the grid is on the canvas.
    pub fn project(&self, place: Vec3) -> Vec2 {
        let across = (place.x - place.z) * self.half;
        let down = (place.x + place.z) * self.half / 2.0 - place.y * self.rise;
        self.origin + Vec2::new(across, down)
    }

    /// What one step along the face's own axes is on the canvas.
    pub fn axes(&self, side: Side) -> [Vec2; 2] {
        let origin = self.project(Vec3::ZERO);
        side.axes().map(|axis| self.project(axis.as_vec3()) - origin)
    }
}

/// Half the width of a block in pixels.
fn half_width(extent: Vec2, scale: Scale) -> f32 {
    let longest = extent.max_element();
    let wanted = match scale {
        // A house of ten blocks gets 400 pixels, one of forty 800: larger, but not as large as it is.
        Scale::Fit => ((90.0 * longest.sqrt()).min(2000.0 - 2.0 * MARGIN) / longest).min(32.0),
        Scale::BlockWidth(width) => f32::from(width.max(1)) / 2.0,
    };
    wanted.min((LARGEST - 2.0 * MARGIN) / longest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size_of(x: i32, y: i32, z: i32, scale: Scale) -> [u32; 2] {
        let camera = Camera::new(Cell::new(x, y, z), scale);
        [camera.width, camera.height]
    }

    #[test]
    fn pictures_grow_with_the_building_up_to_a_bound() {
        let [house, _] = size_of(10, 8, 10, Scale::Fit);
        assert!((380..460).contains(&house), "{house}");
        for size in [[512, 96, 512], [100_000, 1, 1], [3, 4000, 3]] {
            let [width, height] = size_of(size[0], size[1], size[2], Scale::Fit);
            assert!(width.max(height) <= 2001, "{size:?}: {width} x {height}");
        }
        let [width, height] = size_of(5000, 10, 5000, Scale::BlockWidth(100));
        assert!(width.max(height) <= 8001);
    }

    #[test]
    fn a_chosen_scale_is_kept() {
        let [width, _] = size_of(3, 3, 2, Scale::BlockWidth(20));
        assert_eq!(width, 5 * 10 + 20);
    }

    #[test]
    fn the_whole_grid_is_on_the_canvas() {
        let size = Cell::new(7, 30, 3);
        let camera = Camera::new(size, Scale::Fit);
        let [width, height] = camera.canvas_size().map(|n| n as f32);
        for corner in 0..8 {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { size[axis] as f32 } else { 0.0 };
            let place = camera.project(Vec3::new(pick(0), pick(1), pick(2)));
            assert!(place.cmpge(Vec2::ZERO).all() && place.cmple(Vec2::new(width, height)).all());
        }
    }
}
