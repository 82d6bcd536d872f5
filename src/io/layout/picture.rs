//! Pictures with one colour a label: a pixel is a unit, and every region of one colour is a leaf.

use super::LayoutError;
use super::colours::{Colours, hex};
use crate::facade::{Area, Drawing, Place};
use crate::io::Limits;
use image::{ImageFormat, ImageReader, RgbaImage};
use std::collections::{BTreeMap, VecDeque};
use std::io::Cursor;

/// Larger pictures are photographs.
const MOST_PIXELS: u64 = 1 << 24;

/// The leaves of a picture. Regions of wall that are not rectangular are cut into rectangles, row by row.
pub fn decode(
    bytes: &[u8],
    colours: &Colours,
    is_wall: &dyn Fn(&str) -> bool,
    limits: &Limits,
) -> Result<Drawing, LayoutError> {
    let picture = read(bytes, limits)?;
    let labelled = Labelled::of(&picture, colours)?;
    let walls = labelled.walls(is_wall);
    let mut areas = Vec::new();
    let mut seen = vec![false; labelled.pixels.len()];
    for start in 0..labelled.pixels.len() {
        if !seen[start] {
            let region = labelled.region(start, &mut seen);
            labelled.areas(&region, &walls, &mut areas)?;
        }
    }
    Ok(Drawing { areas })
}

fn read(bytes: &[u8], limits: &Limits) -> Result<RgbaImage, LayoutError> {
    let failed = |error: &dyn std::fmt::Display| LayoutError::Picture(error.to_string());
    let reader = || ImageReader::with_format(Cursor::new(bytes), ImageFormat::Png);
    let (width, height) = reader().into_dimensions().map_err(|error| failed(&error))?;
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(LayoutError::LargePicture { width, height, most: MOST_PIXELS });
    }
    let mut reader = reader();
    let mut most = image::Limits::default();
    most.max_alloc = Some(limits.max_bytes);
    reader.limits(most);
    reader.decode().map(|picture| picture.to_rgba8()).map_err(|error| failed(&error))
}

/// A picture as numbers of labels.
struct Labelled {
    width: usize,
    height: usize,
    labels: Vec<String>,
    /// Row by row from the top.
    pixels: Vec<u32>,
}

impl Labelled {
    fn of(picture: &RgbaImage, colours: &Colours) -> Result<Labelled, LayoutError> {
        let mut numbers: BTreeMap<[u8; 3], u32> = BTreeMap::new();
        let mut labels: Vec<String> = Vec::new();
        let mut pixels = Vec::with_capacity(picture.pixels().len());
        for (x, y, pixel) in picture.enumerate_pixels() {
            let [red, green, blue, _] = pixel.0;
            let colour = [red, green, blue];
            let number = match numbers.get(&colour) {
                Some(number) => *number,
                None => {
                    let unknown = || LayoutError::Colour {
                        place: Place::Pixel { x, y },
                        colour: hex(colour),
                        nearest: colours.nearest(colour),
                    };
                    let label = colours.label(colour).ok_or_else(unknown)?;
                    let number = labels.iter().position(|known| known == label).unwrap_or_else(|| {
                        labels.push(label.to_owned());
                        labels.len() - 1
                    });
                    numbers.insert(colour, number as u32);
                    number as u32
                }
            };
            pixels.push(number);
        }
        Ok(Labelled { width: picture.width() as usize, height: picture.height() as usize, labels, pixels })
    }

    /// By label, whether it is wall: the one that covers most where none is.
    fn walls(&self, is_wall: &dyn Fn(&str) -> bool) -> Vec<bool> {
        let mut walls: Vec<bool> = self.labels.iter().map(|label| is_wall(label)).collect();
        if !walls.contains(&true) {
            let mut counts = vec![0_u64; self.labels.len()];
            self.pixels.iter().for_each(|label| counts[*label as usize] += 1);
            let largest = (0..counts.len()).max_by_key(|label| counts[*label]);
            largest.into_iter().for_each(|label| walls[label] = true);
        }
        walls
    }

    /// The pixels of one label that are joined to `start`, in order.
    fn region(&self, start: usize, seen: &mut [bool]) -> Vec<usize> {
        let label = self.pixels[start];
        let mut region = Vec::new();
        let mut open = VecDeque::from([start]);
        seen[start] = true;
        while let Some(at) = open.pop_front() {
            region.push(at);
            let (x, y) = (at % self.width, at / self.width);
            let left = (x > 0).then(|| at - 1);
            let right = (x + 1 < self.width).then_some(at + 1);
            let above = (y > 0).then(|| at - self.width);
            let below = (y + 1 < self.height).then_some(at + self.width);
            for next in [left, right, above, below].into_iter().flatten() {
                if self.pixels[next] == label && !std::mem::replace(&mut seen[next], true) {
                    open.push_back(next);
                }
            }
        }
        region.sort_unstable();
        region
    }

    fn areas(&self, region: &[usize], walls: &[bool], areas: &mut Vec<Area>) -> Result<(), LayoutError> {
        let label = self.pixels[region[0]] as usize;
        let rectangles = self.rectangles(region);
        if rectangles.len() > 1 && !walls[label] {
            let place =
                Place::Pixel { x: (region[0] % self.width) as u32, y: (region[0] / self.width) as u32 };
            return Err(LayoutError::NoRectangle { place, label: self.labels[label].clone() });
        }
        areas.extend(rectangles.into_iter().map(|[left, right, top, bottom]| Area {
            label: self.labels[label].clone(),
            // Pictures count down from the top.
            sides: [[left as f64, right as f64], [(self.height - bottom) as f64, (self.height - top) as f64]],
            front: None,
            place: Place::Pixel { x: left as u32, y: top as u32 },
        }));
        Ok(())
    }

    /// A region as rectangles (left, right, top, bottom): runs of pixels, joined with those below that are as long.
    fn rectangles(&self, region: &[usize]) -> Vec<[usize; 4]> {
        let mut done = Vec::new();
        let mut open: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut rows = region.chunk_by(|a, b| a / self.width == b / self.width).peekable();
        while let Some(row) = rows.next() {
            let y = row[0] / self.width;
            let runs = row
                .chunk_by(|a, b| a + 1 == *b)
                .map(|run| [run[0] % self.width, run[run.len() - 1] % self.width + 1]);
            let next: BTreeMap<[usize; 2], usize> =
                runs.map(|run| (run, open.remove(&run).unwrap_or(y))).collect();
            done.extend(open.iter().map(|([left, right], top)| [*left, *right, *top, y]));
            open = next;
            if rows.peek().is_none() {
                done.extend(open.iter().map(|([left, right], top)| [*left, *right, *top, y + 1]));
            }
        }
        done
    }
}
