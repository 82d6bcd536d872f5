//! What is left of a body while parts are taken: one plan at the bottom, one between, one on top.

use super::Body;
use super::component::Level;
use crate::space::{Footprint, Rect, Scope, Spot};
use fixedbitset::FixedBitSet;

/// What is left of a body between two heights.
pub struct Story {
    /// Which components it is of, besides those of all heights.
    pub level: Option<Level>,
    heights: [i32; 2],
    area: Rect,
    left: FixedBitSet,
}

/// Cells of the plan between two heights.
pub struct Slab {
    heights: [i32; 2],
    footprint: Footprint,
}

/// The stories of a body, of which the lowest and the highest may be as high as told. Where there is no room
/// for both, the top has its height first.
pub fn stories(body: &Body, bottom: i32, top: i32) -> Vec<Story> {
    let [low, high] = body.levels();
    let under_top = (high - top).max(low);
    let over_bottom = (low + bottom).min(under_top);
    let stories = [
        (Some(Level::Bottom), [low, over_bottom]),
        (None, [over_bottom, under_top]),
        (Some(Level::Top), [under_top, high]),
    ];
    let ground = body.ground();
    let area = ground.area();
    let left: FixedBitSet = ground.spots().map(|spot| number(area, spot)).collect();
    let there = stories.into_iter().filter(|(_, [low, high])| low < high);
    there.map(|(level, heights)| Story { level, heights, area, left: left.clone() }).collect()
}

impl Story {
    /// Takes what is left of a rectangle.
    pub fn take(&mut self, plan: Rect) -> Slab {
        let footprint = self.within(plan);
        for spot in footprint.spots() {
            self.left.remove(number(self.area, spot));
        }
        Slab { heights: self.heights, footprint }
    }

    /// All that is left.
    pub fn rest(&self) -> Slab {
        Slab { heights: self.heights, footprint: self.within(self.area) }
    }

    fn within(&self, plan: Rect) -> Footprint {
        Footprint::from_fn(self.area.intersect(&plan), |spot| self.left.contains(number(self.area, spot)))
    }
}

fn number(area: Rect, spot: Spot) -> usize {
    let from_min = spot - area.min;
    from_min.y as usize * area.size().x as usize + from_min.x as usize
}

/// Scopes of slabs, from the bottom up: those of the same plan that touch are one.
pub fn stacked(slabs: impl Iterator<Item = Slab>, scope: &Scope) -> Vec<Body> {
    let mut stacked: Vec<Slab> = Vec::new();
    for slab in slabs.filter(|slab| !slab.footprint.is_empty()) {
        match stacked.last_mut() {
            Some(below) if below.heights[1] == slab.heights[0] && below.footprint == slab.footprint => {
                below.heights[1] = slab.heights[1];
            }
            _ => stacked.push(slab),
        }
    }
    stacked.into_iter().map(|slab| Body::standing(slab.footprint, slab.heights, scope)).collect()
}
