use super::camera::Camera;
use super::side::Side;
use super::texture::{FRAME, PLAIN, Texture};
use glam::{Vec2, Vec3};

/// What the camera sees at each sample: color, depth, and which surface it belongs to.
pub(super) struct Canvas {
    pub width: usize,
    pub samples: Vec<Sample>,
}

#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub color: [u8; 3],
    /// Larger is nearer. Of use only to compare places on the same line of sight.
    pub depth: f32,
    /// Equal for neighbours on one even surface of one block state; 0 where there is nothing.
    pub surface: u32,
}

/// A rectangle on one side of a box, ready to be drawn.
pub(super) struct Face<'a> {
    pub side: Side,
    /// Where `u` and `v` are zero, in cells.
    pub origin: Vec3,
    /// The range of `u` and `v`, low then high, in cells.
    pub extent: [[f32; 2]; 2],
    /// The color in full light, for a texel that changes nothing.
    pub color: Vec3,
    pub alpha: f32,
    pub texture: &'a Texture,
    /// How much light reaches each corner, as `[v][u]`.
    pub corners: [[f32; 2]; 2],
    pub surface: u32,
}

/// A place on a face.
#[derive(Clone, Copy)]
struct Spot {
    /// Index of the sample.
    at: usize,
    u: f32,
    v: f32,
    depth: f32,
}

impl Canvas {
    /// A canvas in the color of the background.
    pub fn new(camera: &Camera, background: [u8; 3]) -> Canvas {
        let [width, height] = camera.canvas_size();
        let nothing = Sample { color: background, depth: f32::NEG_INFINITY, surface: 0 };
        Canvas { width, samples: vec![nothing; width * height] }
    }

    /// Draws an opaque face where nothing nearer is.
    pub fn paint(&mut self, camera: &Camera, face: &Face<'_>) {
        let even = face.corners == [[1.0; 2]; 2];
        for_each_spot(camera, face, self.size(), |spot| {
            let sample = &mut self.samples[spot.at];
            if spot.depth < sample.depth {
                return;
            }
            let light = face.texel(spot) * if even { 1.0 } else { face.corner_light(spot) };
            *sample = Sample { color: bytes(face.color * light), depth: spot.depth, surface: face.surface };
        });
    }

    /// Lays a face that lets light through over what is behind it.
    pub fn glaze(&mut self, camera: &Camera, face: &Face<'_>) {
        for_each_spot(camera, face, self.size(), |spot| {
            let sample = &mut self.samples[spot.at];
            if spot.depth < sample.depth {
                return;
            }
            let texel = face.texel(spot);
            let frame = texel >= f32::from(FRAME) / f32::from(PLAIN);
            let alpha = if frame { (face.alpha + 0.35).min(0.9) } else { face.alpha };
            let behind = Vec3::from(sample.color.map(f32::from));
            sample.color = bytes(behind.lerp(face.color * texel.min(1.15), alpha));
            if sample.surface == 0 {
                sample.surface = face.surface;
            }
        });
    }

    fn size(&self) -> [usize; 2] {
        [self.width, self.samples.len() / self.width]
    }
}

impl Face<'_> {
    fn texel(&self, spot: Spot) -> f32 {
        let [u, v] = [spot.u, spot.v].map(|at| ((at * 16.0) as usize).min(15));
        f32::from(self.texture[v][u]) / f32::from(PLAIN)
    }

    fn corner_light(&self, spot: Spot) -> f32 {
        let [top, bottom] = self.corners.map(|[left, right]| left + (right - left) * spot.u);
        top + (bottom - top) * spot.v
    }
}

fn bytes(color: Vec3) -> [u8; 3] {
    color.to_array().map(|channel| channel as u8)
}

/// Calls `draw` for each sample whose middle lies on `face`, column by column.
///
/// On the canvas every face is a parallelogram. Down a column, `v` grows evenly and `u` is `k + shear * v`,
/// where `shear` is 1 on top, whose two axes both run across the canvas, and 0 on upright sides.
fn for_each_spot(camera: &Camera, face: &Face<'_>, size: [usize; 2], mut draw: impl FnMut(Spot)) {
    let [[u0, v0], [u1, v1]] = face.extent;
    let [along_u, along_v] = camera.axes(face.side);
    let origin = camera.project(face.origin);
    let shear = -along_v.x / along_u.x;
    let down = along_v.y + shear * along_u.y;
    let per_row = 1.0 / down;
    let depth = Depth::of(face);
    let columns = across(origin.x, [along_u, along_v], face.extent, size[0]);
    for x in columns {
        let k = (x as f32 + 0.5 - origin.x) / along_u.x;
        if shear == 0.0 && !(u0..u1).contains(&k) {
            continue;
        }
        let (from, to) = if shear == 0.0 { (v0, v1) } else { (v0.max(u0 - k), v1.min(u1 - k)) };
        let top = origin.y + k * along_u.y;
        for y in samples(top + from * down, top + to * down, size[1]) {
            let v = (y as f32 + 0.5 - top) * per_row;
            let u = k + shear * v;
            draw(Spot { at: y * size[0] + x, u, v, depth: depth.at(u, v) });
        }
    }
}

/// The columns that a face can touch.
fn across(
    origin: f32,
    [u, v]: [Vec2; 2],
    [low, high]: [[f32; 2]; 2],
    width: usize,
) -> std::ops::Range<usize> {
    let left = low[0] * u.x + (low[1] * v.x).min(high[1] * v.x);
    let right = high[0] * u.x + (low[1] * v.x).max(high[1] * v.x);
    samples(origin + left, origin + right, width)
}

/// The samples whose middles lie between two places.
fn samples(from: f32, to: f32, size: usize) -> std::ops::Range<usize> {
    let index = |place: f32| ((place - 0.5).ceil().max(0.0) as usize).min(size);
    index(from)..index(to)
}

/// Depth over a face: the sum of x and z, which grows along every line of sight.
struct Depth {
    start: f32,
    along_u: f32,
    along_v: f32,
}

impl Depth {
    fn of(face: &Face<'_>) -> Depth {
        let [along_u, along_v] = face.side.axes().map(|axis| (axis.x + axis.z) as f32);
        Depth { start: face.origin.x + face.origin.z, along_u, along_v }
    }

    fn at(&self, u: f32, v: f32) -> f32 {
        self.start + self.along_u * u + self.along_v * v
    }
}
