use super::options::ViewOptions;
use crate::block::{self, Rgba};
use crate::facade::{Area, Drawing, Meaning, Meanings, What, meant};
use crate::graph::Thing;
use image::{Rgba as Pixel, RgbaImage};

/// The longer side of the picture in pixels.
const LONGEST: f64 = 640.0;
const LINE: Pixel<u8> = Pixel([0x3a, 0x38, 0x34, 255]);

/// A layout as it was drawn: its leaves in the colours of the blocks that their labels mean, with their edges. What does
/// not tile shows the paper.
pub fn drawing(drawing: &Drawing) -> RgbaImage {
    let span = |axis: usize| {
        let ends = || drawing.areas.iter().flat_map(|area| area.sides[axis]);
        [ends().fold(f64::INFINITY, f64::min), ends().fold(f64::NEG_INFINITY, f64::max)]
    };
    let [[left, right], [bottom, top]] = [span(0), span(1)];
    let scale = LONGEST / (right - left).max(top - bottom);
    if !scale.is_finite() {
        return RgbaImage::from_pixel(1, 1, Pixel(ViewOptions::PAPER.0));
    }
    let side = |length: f64| (length * scale).round().max(1.0) as u32;
    let mut picture =
        RgbaImage::from_pixel(side(right - left), side(top - bottom), Pixel(ViewOptions::PAPER.0));
    let colours = colours(drawing);
    for (area, colour) in drawing.areas.iter().zip(colours) {
        // Pictures count down from the top.
        let columns = area.sides[0].map(|at| ((at - left) * scale).round() as u32);
        let [high, low] = area.sides[1].map(|at| ((top - at) * scale).round() as u32);
        fill(&mut picture, columns, [low, high], colour);
    }
    picture
}

fn fill(picture: &mut RgbaImage, [left, right]: [u32; 2], [top, bottom]: [u32; 2], colour: Rgba) {
    for y in top..bottom.min(picture.height()) {
        for x in left..right.min(picture.width()) {
            let is_edge = x == left || y == top;
            picture.put_pixel(x, y, if is_edge { LINE } else { Pixel(colour.0) });
        }
    }
}

/// The colours of all areas; of a drawing that does not tile, one for all.
fn colours(drawing: &Drawing) -> Vec<Rgba> {
    let plain = Rgba::rgb(0xb0, 0xac, 0xa4);
    let Ok(lined) = drawing.lined() else { return vec![plain; drawing.areas.len()] };
    let meant = meant(std::slice::from_ref(&lined.layout), &Meanings::default(), &[]);
    let colour = |area: &Area| {
        let label = lined.layout.labels().iter().position(|label| *label == area.label);
        label.map_or(plain, |label| colour(&meant.list[label], plain))
    };
    drawing.areas.iter().map(colour).collect()
}

fn colour(meaning: &Meaning, plain: Rgba) -> Rgba {
    let thing = match &meaning.what {
        What::Thing(thing) | What::Mesh { block: thing, .. } => thing.clone(),
        What::Door { wood } => Thing::Name(format!("{wood}_planks")),
        What::Shape { .. } | What::Nothing => return plain,
    };
    let Rgba([red, green, blue, _]) = thing.block().map_or(plain, |state| block::color(&state));
    Rgba([red, green, blue, 255])
}
