use super::options::Scale;
use super::side::Side;
use crate::space::Cell;
use glam::{Vec2, Vec3};

/// The height of a block against half its width: an eye that looks down at 30 degrees, under which the
/// edges of the ground run two pixels across for each pixel down, has 1.22. With this, heights are whole too.
const RISE: f32 = 1.25;
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
    /// Where the low corner of the grid is on the canvas, in samples.
    origin: Vec2,
    pub oversampling: u32,
    /// The picture, in pixels.
    pub width: u32,
    pub height: u32,
}

/// A rectangle on the picture, in half widths of a block from where the low corner of the grid is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Extent {
    low: Vec2,
    high: Vec2,
}

impl Extent {
    /// Where a cell is.
    pub fn of(cell: Cell) -> Extent {
        let top = flatten((cell + Cell::Y).as_vec3());
        let bottom = flatten((cell + Cell::X + Cell::Z).as_vec3());
        Extent { low: top - Vec2::X, high: bottom + Vec2::X }
    }

    pub fn union(self, other: Extent) -> Extent {
        Extent { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

/// A single cell.
impl Default for Extent {
    fn default() -> Extent {
        Extent::of(Cell::ZERO)
    }
}

/// Where a place in the grid is on the picture, in half widths of a block.
fn flatten(place: Vec3) -> Vec2 {
    Vec2::new(place.x - place.z, (place.x + place.z) / 2.0 - place.y * RISE)
}

impl Camera {
    /// A camera that has all of `extent` in its picture.
    pub fn new(extent: Extent, scale: Scale) -> Camera {
        let size = extent.high - extent.low;
        let pixels = half_width(size, scale);
        let area = (size * pixels + 2.0 * MARGIN).element_product();
        let oversampling = if area * 4.0 <= MOST_SAMPLES { 2 } else { 1 };
        let samples = oversampling as f32;
        let half = whole(pixels * samples);
        let [width, height] = (size * half / samples + 2.0 * MARGIN).ceil().to_array().map(|n| n as u32);
        let origin = MARGIN * samples - extent.low * half;
        Camera { half, origin, oversampling, width, height }
    }

    /// The canvas in samples.
    pub fn canvas_size(&self) -> [usize; 2] {
        [self.width, self.height].map(|n| (n * self.oversampling) as usize)
    }

    /// Where a place in the grid is on the canvas.
    pub fn project(&self, place: Vec3) -> Vec2 {
        self.origin + flatten(place) * self.half
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

/// Multiples of four samples give every block the same outline; blocks too small for that need none.
fn whole(half: f32) -> f32 {
    if half >= 16.0 { (half / 4.0).floor() * 4.0 } else { half }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(x: i32, y: i32, z: i32) -> Extent {
        Extent::of(Cell::ZERO)
            .union(Extent::of(Cell::new(x, y, z) - 1))
            .union(Extent::of(Cell::new(x, 1, 1) - 1))
            .union(Extent::of(Cell::new(1, 1, z) - 1))
            .union(Extent::of(Cell::new(1, y, 1) - 1))
            .union(Extent::of(Cell::new(x, 1, z) - 1))
    }

    fn size_of(x: i32, y: i32, z: i32, scale: Scale) -> [u32; 2] {
        let camera = Camera::new(extent(x, y, z), scale);
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
        let camera = Camera::new(extent(7, 30, 3), Scale::Fit);
        let [width, height] = camera.canvas_size().map(|n| n as f32);
        for corner in 0..8 {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { size[axis] as f32 } else { 0.0 };
            let place = camera.project(Vec3::new(pick(0), pick(1), pick(2)));
            assert!(place.cmpge(Vec2::ZERO).all() && place.cmple(Vec2::new(width, height)).all());
        }
    }
}
