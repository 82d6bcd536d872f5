//! From samples to a picture: lines where surfaces end, then the mean of the samples of each pixel.

use super::camera::Camera;
use super::canvas::{Canvas, Sample};
use crate::block::Rgba;
use image::RgbaImage;

/// What is left of the light on a line where something stands before something else.
const OUTLINE: f32 = 0.55;
/// What is left of it where two surfaces meet.
const CREASE: f32 = 0.84;

pub(super) fn develop(canvas: &Canvas, camera: &Camera, background: Rgba) -> RgbaImage {
    let lines = Lines::new(camera);
    RgbaImage::from_fn(camera.width, camera.height, |x, y| {
        image::Rgba(pixel(canvas, camera.oversampling as usize, &lines, background, [x as usize, y as usize]))
    })
}

/// The mean of the samples of a pixel; those of the background count as it is transparent.
fn pixel(canvas: &Canvas, step: usize, lines: &Lines, background: Rgba, [x, y]: [usize; 2]) -> [u8; 4] {
    let mut sum = [0.0; 3];
    let mut covered = 0.0;
    for at in (0..step).flat_map(|j| (0..step).map(move |i| (y * step + j) * canvas.width + x * step + i)) {
        let sample = &canvas.samples[at];
        let light = lines.light(canvas, at, sample);
        let weight = if sample.surface == 0 { f32::from(background.0[3]) / 255.0 } else { 1.0 };
        for (sum, channel) in sum.iter_mut().zip(sample.color) {
            *sum += f32::from(channel) * light * weight;
        }
        covered += weight;
    }
    let [red, green, blue] = sum.map(|sum| if covered > 0.0 { (sum / covered + 0.5) as u8 } else { 0 });
    let alpha = covered / (step * step) as f32 * 255.0;
    [red, green, blue, (alpha + 0.5) as u8]
}

/// How strong lines are, and how far apart two depths are that make an outline.
struct Lines {
    gap: f32,
    outline: f32,
    crease: f32,
}

impl Lines {
    fn new(camera: &Camera) -> Lines {
        // Lines are one sample wide whatever the scale: where blocks are small, they must be fainter.
        let strength = (camera.half / 16.0).clamp(0.15, 1.0);
        let weaker = |light: f32| 1.0 - (1.0 - light) * strength;
        Lines { gap: 4.0 / camera.half + 0.15, outline: weaker(OUTLINE), crease: weaker(CREASE) }
    }

    /// The light that lines leave to a sample.
    fn light(&self, canvas: &Canvas, at: usize, sample: &Sample) -> f32 {
        if sample.surface == 0 {
            return 1.0;
        }
        let neighbours = [at.wrapping_sub(1), at + 1, at.wrapping_sub(canvas.width), at + canvas.width];
        let others = neighbours.into_iter().filter_map(|at| canvas.samples.get(at));
        others.map(|other| self.between(sample, other)).fold(1.0, f32::min)
    }

    /// The nearer of two surfaces has the outline.
    fn between(&self, sample: &Sample, other: &Sample) -> f32 {
        match sample.depth - other.depth {
            _ if sample.surface == other.surface => 1.0,
            nearer if nearer > self.gap => self.outline,
            nearer if nearer < -self.gap => 1.0,
            _ => self.crease,
        }
    }
}
