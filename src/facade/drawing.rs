//! A layout as it was drawn, and the layout on numbered lines that is made of it.

use super::{FacadeError, Layout, Leaf, Region};
use std::fmt;

/// Labelled rectangles in real coordinates: x to the right, y up.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Drawing {
    pub areas: Vec<Area>,
}

/// A rectangle with a label.
#[derive(Clone, PartialEq, Debug)]
pub struct Area {
    pub label: String,
    /// The low and the high end along x and y.
    pub sides: [[f64; 2]; 2],
    /// How far it reaches to the front, where the drawing says it.
    pub front: Option<f64>,
    pub place: Place,
}

/// Where in a file something stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// A line of a text, from 1.
    Line(usize),
    /// A pixel, from the top left.
    Pixel { x: u32, y: u32 },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}"),
            Place::Pixel { x, y } => write!(f, "pixel ({x}, {y})"),
        }
    }
}

/// A drawing whose coordinates are numbers of lines: what remains once noise and lengths are taken off.
#[derive(Clone, PartialEq, Debug)]
pub struct Lined {
    pub layout: Layout,
    /// Where the lines across x and across y stand, rising.
    pub lines: [Vec<f64>; 2],
    /// How far the leaves reach to the front, where the drawing says it.
    pub fronts: Vec<Option<f64>>,
}

/// Coordinates closer together than this part of the longer side are one line, measured twice: seed 4's files carry
/// noise of about 1e-6.
const NOISE: f64 = 5e-6;

impl Drawing {
    /// The lines of a drawing, and its leaves between them.
    ///
    /// # Errors
    ///
    /// Where an area is empty, or the areas overlap or leave gaps.
    pub fn lined(&self) -> Result<Lined, FacadeError> {
        let first = self.areas.first().ok_or(FacadeError::NoAreas)?;
        if let Some(area) = self.areas.iter().find(|area| area.sides.iter().any(|[low, high]| low >= high)) {
            return Err(FacadeError::ZeroArea { label: area.label.clone(), place: area.place });
        }
        let span = |axis: usize| {
            let ends = self.areas.iter().map(|area| area.sides[axis]);
            ends.fold(first.sides[axis], |[low, high], [l, h]| [low.min(l), high.max(h)])
        };
        let longest = [span(0), span(1)].map(|[low, high]| high - low).into_iter().fold(0.0, f64::max);
        let lines =
            [0, 1].map(|axis| lines(self.areas.iter().flat_map(|area| area.sides[axis]), NOISE * longest));
        let mut labels: Vec<String> = Vec::new();
        let mut leaves = Vec::with_capacity(self.areas.len());
        for area in &self.areas {
            let sides = [0, 1].map(|axis| area.sides[axis].map(|at| nearest(&lines[axis], at)));
            if sides.iter().any(|[low, high]| low == high) {
                return Err(FacadeError::ZeroArea { label: area.label.clone(), place: area.place });
            }
            let known = labels.iter().position(|label| *label == area.label);
            let label = known.unwrap_or_else(|| {
                labels.push(area.label.clone());
                labels.len() - 1
            });
            leaves.push(Leaf { label: label as u32, region: Region { sides } });
        }
        let size = [0, 1].map(|axis: usize| lines[axis].len() as u32 - 1);
        let layout = Layout::new(size, labels, leaves).map_err(|fault| self.told(&fault, &lines))?;
        Ok(Lined { layout, lines, fronts: self.areas.iter().map(|area| area.front).collect() })
    }

    /// A fault in the words of the drawing.
    fn told(&self, fault: &Fault, lines: &[Vec<f64>; 2]) -> FacadeError {
        let area = |leaf: usize| (self.areas[leaf].label.clone(), self.areas[leaf].place);
        match fault {
            Fault::Overlap(first, second) => {
                FacadeError::Overlap { first: area(*first), second: area(*second) }
            }
            Fault::Gap(region) => FacadeError::Gap {
                from: [0, 1].map(|axis| lines[axis][region.sides[axis][0] as usize]),
                to: [0, 1].map(|axis| lines[axis][region.sides[axis][1] as usize]),
            },
        }
    }
}

/// Why leaves do not tile their layout.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Fault {
    /// Two leaves, by number.
    Overlap(usize, usize),
    /// Nothing is here.
    Gap(Region),
}

/// The distinct values, each the mean of those that noise alone tells apart.
fn lines(values: impl Iterator<Item = f64>, noise: f64) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let heaps = values.chunk_by(|a, b| b - a <= noise);
    heaps.map(|heap| heap.iter().sum::<f64>() / heap.len() as f64).collect()
}

fn nearest(lines: &[f64], at: f64) -> u32 {
    let after = lines.partition_point(|line| *line < at);
    let before = after.saturating_sub(1);
    let distance = |number: usize| lines.get(number).map_or(f64::INFINITY, |line| (line - at).abs());
    (if distance(before) <= distance(after) { before } else { after }) as u32
}
