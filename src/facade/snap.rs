//! Lines in real coordinates onto whole blocks.
//!
//! Lines keep their order, and the two lines of a leaf stay a block apart at the least, so no leaf is lost at any
//! scale. Leaves of one label that were drawn equally long become equally long in blocks: rounding each line by itself
//! would give a row of equal windows two widths, and a rule for each.

use super::drawing::Lined;
use super::labels::{Meanings, is_wall};
use super::{FacadeError, Layout, Side};
use std::collections::BTreeMap;

/// How many blocks a layout is large.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub enum Scale {
    /// The thinnest leaf is a block, and no side is longer than [`LONGEST`] unless the leaves need it.
    #[default]
    Fitting,
    /// Blocks per unit.
    PerUnit(f64),
    /// Blocks along x.
    Width(u32),
}

/// What becomes of lines that lie closer together than a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Near {
    /// Lines meet where no leaf stands between them, as in rows that are a hair out of line.
    #[default]
    Meet,
    /// No two lines meet.
    Apart,
}

/// A layout in blocks, and what it took.
#[derive(Clone, PartialEq, Debug)]
pub struct Snapped {
    pub layout: Layout,
    pub blocks_per_unit: f64,
    /// How many lines met others.
    pub met: usize,
    /// How far a line moved at the most, in blocks.
    pub moved: f64,
}

/// The side of a large facade in blocks, if nothing asks for more.
const LONGEST: f64 = 256.0;

/// More blocks than this along a side make no building.
const MOST: f64 = 30_000.0;

/// How much larger than the least a fitting scale may be.
const TIMES: [f64; 11] = [1.0, 1.03, 1.06, 1.09, 1.12, 1.15, 1.18, 1.25, 4.0 / 3.0, 1.5, 2.0];
/// As far even layouts that are long already may go, and others for nothing.
const LITTLE: f64 = 1.2;
/// What it costs each line to be at twice the scale and more: as much as leaves that are not alike.
const LARGER: f64 = 2.0;

/// The layout in blocks.
///
/// # Errors
///
/// Where so many leaves stand in a row that the scale has no block for each.
pub fn snap(lined: &Lined, scale: Scale, near: Near) -> Result<Snapped, FacadeError> {
    let axes = Side::ALL.map(|axis| Axis::of(lined, axis, near));
    let [width, height] = [axes[0].extent(), axes[1].extent()];
    // A side may be a block longer or shorter where the scale is ours to choose.
    let at = |scale: f64, give: i64| -> Result<(Snapped, f64), FacadeError> {
        let side = |axis: &Axis<'_>| {
            let total = (scale * axis.extent()).round().clamp(1.0, MOST) as i64;
            let placed = axis.snapped(total, scale);
            let others =
                [total - give, total + give].into_iter().filter(|other| *other != total && *other > 0);
            let others = others.filter_map(|other| axis.snapped(other, scale).ok());
            placed.map(|placed| {
                others.fold(placed, |best, other| if other.cost < best.cost { other } else { best })
            })
        };
        let [x, y] = [side(&axes[0])?, side(&axes[1])?];
        let met = [&x, &y].map(|lines| lines.at.windows(2).filter(|pair| pair[0] == pair[1]).count());
        let cost = (x.cost + y.cost) / (axes[0].lines.len() + axes[1].lines.len()) as f64;
        let moved = x.moved.max(y.moved);
        let layout = lined.layout.moved(&[x.at, y.at]);
        Ok((Snapped { layout, blocks_per_unit: scale, met: met.iter().sum(), moved }, cost))
    };
    if ![width, height].iter().all(|length| length.is_finite()) {
        return Err(FacadeError::NoAreas);
    }
    let fixed = match scale {
        Scale::PerUnit(scale) => Some(scale),
        Scale::Width(blocks) => Some(f64::from(blocks) / width),
        Scale::Fitting => None,
    };
    if let Some(scale) = fixed {
        return match scale * width.max(height) > MOST {
            true => Err(FacadeError::TooLarge { blocks: scale * width.max(height), most: MOST }),
            false => at(scale, 0).map(|(snapped, _)| snapped),
        };
    }
    let thinnest = axes[0].thinnest().min(axes[1].thinnest());
    let needed = axes.iter().map(|axis| axis.longest_row().1 as f64 / axis.extent()).fold(0.0, f64::max);
    let least = (1.0 / thinnest).min(LONGEST / width.max(height)).max(needed);
    if least * width.max(height) > MOST {
        return Err(FacadeError::TooLarge { blocks: least * width.max(height), most: MOST });
    }
    // Layouts that were drawn in blocks stay as they are.
    let own = (least < 1.0 && least * 2.0 >= 1.0).then_some(1.0 / least);
    let is_long = |times: &f64| *times > LITTLE && least * times * width.max(height) > LONGEST;
    let times = TIMES.into_iter().chain(own).filter(|times| !is_long(times));
    let tried = times.map(|times| {
        at(least * times, 1).map(|(snapped, cost)| (snapped, cost + LARGER * (times - LITTLE).max(0.0)))
    });
    let tried = tried.collect::<Result<Vec<_>, _>>()?;
    let best = tried.into_iter().min_by(|(_, a), (_, b)| a.total_cmp(b));
    best.map(|(snapped, _)| snapped).ok_or(FacadeError::NoAreas)
}

/// The lines across one axis, and what holds them apart.
struct Axis<'l> {
    axis: Side,
    lines: &'l [f64],
    /// Pairs of lines that stand a block apart at the least, low before high, without doubles.
    apart: Vec<(usize, usize)>,
    /// Whether a label is wall, or covers most.
    is_wall: Vec<bool>,
    /// The leaves along the axis: their lines, label and number.
    spans: Vec<(usize, usize, u32, f64)>,
}

/// Lines of one axis in blocks.
struct Placed {
    at: Vec<u32>,
    cost: f64,
    moved: f64,
}

impl Axis<'_> {
    fn of(lined: &Lined, axis: Side, near: Near) -> Axis<'_> {
        let mut spans: BTreeMap<(usize, usize, u32), f64> = BTreeMap::new();
        for leaf in lined.layout.leaves() {
            let [low, high] = leaf.region.sides[axis.index()].map(|line| line as usize);
            *spans.entry((low, high, leaf.label)).or_default() += 1.0;
        }
        let lines = &lined.lines[axis.index()];
        let mut apart: Vec<(usize, usize)> = spans.keys().map(|(low, high, _)| (*low, *high)).collect();
        if near == Near::Apart {
            apart.extend((1..lines.len()).map(|line| (line - 1, line)));
        }
        apart.sort_unstable();
        apart.dedup();
        let spans = spans.into_iter().map(|((low, high, label), times)| (low, high, label, times)).collect();
        let layout = &lined.layout;
        let mut is_wall: Vec<bool> =
            layout.labels().iter().map(|label| is_wall(label, &Meanings::default())).collect();
        if !is_wall.contains(&true) {
            let mut areas = vec![0.0; is_wall.len()];
            for leaf in layout.leaves() {
                let side = |axis: usize| {
                    let [low, high] = leaf.region.sides[axis].map(|line| lined.lines[axis][line as usize]);
                    high - low
                };
                areas[leaf.label as usize] += side(0) * side(1);
            }
            let largest = (0..areas.len()).max_by(|a, b| areas[*a].total_cmp(&areas[*b]));
            largest.into_iter().for_each(|label| is_wall[label] = true);
        }
        Axis { axis, lines, apart, is_wall, spans }
    }

    fn extent(&self) -> f64 {
        self.lines[self.lines.len() - 1] - self.lines[0]
    }

    fn thinnest(&self) -> f64 {
        self.apart
            .iter()
            .map(|(low, high)| self.lines[*high] - self.lines[*low])
            .fold(f64::INFINITY, f64::min)
    }

    /// The row of leaves that takes most blocks: its thinnest pair of lines, and how many blocks it takes.
    fn longest_row(&self) -> ((usize, usize), u32) {
        let count = self.lines.len();
        let mut depth = vec![0; count];
        let mut before: Vec<Option<usize>> = vec![None; count];
        let mut by_high = self.apart.clone();
        by_high.sort_by_key(|(low, high)| (*high, *low));
        for (low, high) in by_high {
            if depth[low] + 1 > depth[high] {
                (depth[high], before[high]) = (depth[low] + 1, Some(low));
            }
        }
        let mut thinnest = (0, count - 1);
        let mut at = count - 1;
        while let Some(low) = before[at] {
            if self.lines[at] - self.lines[low] < self.lines[thinnest.1] - self.lines[thinnest.0] {
                thinnest = (low, at);
            }
            at = low;
        }
        (thinnest, depth[count - 1])
    }

    fn snapped(&self, total: i64, scale: f64) -> Result<Placed, FacadeError> {
        let (thinnest, needed) = self.longest_row();
        if i64::from(needed) > total {
            return Err(FacadeError::TooCoarse {
                axis: self.axis,
                scale,
                lines: [self.lines[thinnest.0], self.lines[thinnest.1]],
                needed: scale_for(needed, self.extent()),
            });
        }
        let ideal: Vec<f64> =
            self.lines.iter().map(|line| (line - self.lines[0]) * total as f64 / self.extent()).collect();
        let mut search = Search::new(self, ideal, total);
        search.improve();
        let cost = search.cost();
        let moved = search.at.iter().zip(&search.ideal).map(|(at, ideal)| (*at as f64 - ideal).abs());
        let moved = moved.fold(0.0, f64::max);
        Ok(Placed { at: search.at.iter().map(|at| *at as u32).collect(), cost, moved })
    }
}

/// The least scale, in steps of a hundredth, that gives a side so many blocks.
fn scale_for(blocks: u32, extent: f64) -> f64 {
    ((f64::from(blocks) - 0.5) / extent * 100.0).ceil() / 100.0
}

/// What it costs a leaf to be a block longer or shorter than leaves that were drawn like it, in squares of blocks
/// that a line moves: nobody sees where a window is off by a block, and everybody that it is wider than its neighbour.
const UNLIKE: f64 = 40.0;
/// The part of that for walls, which take what room is left over.
const WALL: f64 = 0.2;
/// What it costs two lines that were drawn in one place, but for a hair, to stand apart.
const JOG: f64 = 20.0;
/// Lengths within so many blocks of one another are one.
const ALIKE: f64 = 0.25;
/// So many lines may move together, where there are few and where there are many.
const TOGETHER: [usize; 2] = [100, 12];
const FEW: usize = 250;
const ROUNDS: usize = 30;

/// Lines as they are placed, which small moves make better.
struct Search {
    ideal: Vec<f64>,
    at: Vec<i64>,
    /// For each line, the lines below that it stays apart from, those above, and the spans that end at it.
    below: Vec<Vec<usize>>,
    above: Vec<Vec<usize>>,
    /// Lines, the length they should have, and what a block of difference costs.
    wishes: Vec<(usize, usize, i64, f64)>,
    wishes_of: Vec<Vec<usize>>,
}

impl Search {
    fn new(axis: &Axis<'_>, ideal: Vec<f64>, total: i64) -> Search {
        let count = ideal.len();
        let (mut below, mut above) = (vec![Vec::new(); count], vec![Vec::new(); count]);
        for (low, high) in &axis.apart {
            below[*high].push(*low);
            above[*low].push(*high);
        }
        let wishes = wishes(axis, &ideal);
        let mut wishes_of = vec![Vec::new(); count];
        for (number, (low, high, ..)) in wishes.iter().enumerate() {
            wishes_of[*low].push(number);
            wishes_of[*high].push(number);
        }
        let mut search = Search {
            at: ideal.iter().map(|at| at.round() as i64).collect(),
            ideal,
            below,
            above,
            wishes,
            wishes_of,
        };
        search.spread(total);
        search
    }

    /// Moves lines apart where rounding brought them together.
    fn spread(&mut self, total: i64) {
        let count = self.at.len();
        self.at[0] = 0;
        for line in 1..count {
            let least = self.below[line].iter().map(|low| self.at[*low] + 1).max().unwrap_or(0);
            self.at[line] = self.at[line].max(least).max(self.at[line - 1]);
        }
        self.at[count - 1] = total;
        for line in (0..count - 1).rev() {
            let most = self.above[line].iter().map(|high| self.at[*high] - 1).min().unwrap_or(total);
            self.at[line] = self.at[line].min(most).min(self.at[line + 1]);
        }
    }

    /// Moves lines by a block, alone or with their neighbours, as long as that makes them better.
    fn improve(&mut self) {
        let inner = 1..self.at.len().saturating_sub(1);
        let together = TOGETHER[usize::from(inner.len() > FEW)];
        for _ in 0..ROUNDS {
            let mut is_better = false;
            for first in inner.clone() {
                for last in first..(first + together).min(inner.end) {
                    for step in [1, -1] {
                        is_better |= self.try_move(first, last, step);
                    }
                }
            }
            if !is_better {
                break;
            }
        }
    }

    fn try_move(&mut self, first: usize, last: usize, step: i64) -> bool {
        if !self.may_move(first, last, step) {
            return false;
        }
        let before = self.cost_around(first, last);
        self.at[first..=last].iter_mut().for_each(|at| *at += step);
        let is_better = self.cost_around(first, last) < before - 1e-9;
        if !is_better {
            self.at[first..=last].iter_mut().for_each(|at| *at -= step);
        }
        is_better
    }

    fn may_move(&self, first: usize, last: usize, step: i64) -> bool {
        let moves = first..=last;
        match step > 0 {
            true => {
                self.at[last] < self.at[last + 1]
                    && moves.clone().all(|line| {
                        let outer = self.above[line].iter().filter(|high| !moves.contains(high));
                        outer.into_iter().all(|high| self.at[line] + 1 < self.at[*high])
                    })
            }
            false => {
                self.at[first] > self.at[first - 1]
                    && moves.clone().all(|line| {
                        let outer = self.below[line].iter().filter(|low| !moves.contains(low));
                        outer.into_iter().all(|low| self.at[*low] + 1 < self.at[line])
                    })
            }
        }
    }

    /// What lines cost that a move of these changes.
    fn cost_around(&self, first: usize, last: usize) -> f64 {
        let own: f64 = (first..=last).map(|line| self.off(line)).sum();
        let jogs = self.jog(first) + self.jog(last + 1);
        let wishes = (first..=last).flat_map(|line| self.wishes_of[line].iter());
        own + jogs + wishes.map(|wish| self.unlike(*wish)).sum::<f64>()
    }

    fn cost(&self) -> f64 {
        let own: f64 = (0..self.at.len()).map(|line| self.off(line)).sum();
        let jogs: f64 = (1..self.at.len()).map(|line| self.jog(line)).sum();
        own + jogs + 2.0 * (0..self.wishes.len()).map(|wish| self.unlike(wish)).sum::<f64>()
    }

    fn off(&self, line: usize) -> f64 {
        (self.at[line] as f64 - self.ideal[line]).powi(2)
    }

    fn jog(&self, line: usize) -> f64 {
        match line
            .checked_sub(1)
            .filter(|before| line < self.at.len() && self.ideal[line] - self.ideal[*before] < ALIKE)
        {
            Some(before) => JOG * (self.at[line] - self.at[before]) as f64,
            None => 0.0,
        }
    }

    fn unlike(&self, wish: usize) -> f64 {
        let (low, high, length, weight) = self.wishes[wish];
        weight * (self.at[high] - self.at[low] - length).abs() as f64
    }
}

/// The lengths that leaves should have: those of one label that were drawn alike, one length.
fn wishes(axis: &Axis<'_>, ideal: &[f64]) -> Vec<(usize, usize, i64, f64)> {
    let length = |span: &(usize, usize, u32, f64)| ideal[span.1] - ideal[span.0];
    let mut spans = axis.spans.clone();
    spans.sort_by(|a, b| a.2.cmp(&b.2).then(length(a).total_cmp(&length(b))));
    let mut wishes = Vec::with_capacity(spans.len());
    for alike in spans.chunk_by(|a, b| a.2 == b.2 && length(b) - length(a) < ALIKE) {
        let times: f64 = alike.iter().map(|span| span.3).sum();
        let mean = alike.iter().map(|span| span.3 * length(span)).sum::<f64>() / times;
        let wished = mean.round().max(1.0) as i64;
        let unlike = if axis.is_wall[alike[0].2 as usize] { WALL * UNLIKE } else { UNLIKE };
        wishes.extend(alike.iter().map(|span| (span.0, span.1, wished, unlike * span.3.sqrt())));
    }
    wishes
}
