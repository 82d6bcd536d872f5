//! Roofs: height fields over a footprint, laid in blocks of a family: full blocks, stairs and slabs.

mod cap;
mod ends;
mod heights;
mod lay;
mod profile;

use super::solid::Options;
use crate::block::{BlockState, Family};
use crate::space::{Cell, Footprint, Rect, Scope, Spot, View};
use std::borrow::Cow;

/// How a roof rises over its footprint. The shapes of the pieces are those of seed 1 (sections 7.1 and 7.2).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    /// One pitch from all walls but the ends of wings. Over a rectangle the ridge runs from left to right.
    Gable,
    /// One pitch from all walls.
    Hip,
    /// A gable in two slopes, the lower one steep.
    Gambrel,
    /// A hip in two slopes, the lower one steeper still.
    Mansard,
    /// Gables at the ends of all wings, with ridges of the same height: over a rectangle, at all four walls.
    CrossGable,
    /// One straight ridge from left to right, whatever the footprint.
    Ridge,
    /// One slope that rises away from the front.
    Shed,
    /// Rises from all four sides of the rectangle to a point.
    Pyramid,
    /// Rises straight from a round eave to a point.
    Cone,
    /// Rises from a round eave as a half ball.
    Dome,
    /// Falls to the right from its high left end.
    RightAngleTriangle,
    /// The corner of a hip: highest at the right and the back.
    Corner,
    /// The valley between two slopes: lowest at the left and the front.
    Trough,
}

impl Kind {
    /// Whether it stands on a round footprint, unless another is given.
    fn is_round(self) -> bool {
        matches!(self, Kind::Cone | Kind::Dome)
    }
}

/// No eave reaches further out.
const WIDEST_OVERHANG: i32 = 64;

/// Where a roof stands.
struct Site<'f> {
    footprint: Cow<'f, Footprint>,
    /// The footprint with its eaves.
    reach: Footprint,
    view: View,
    floor: i32,
    height: i32,
    overhang: i32,
}

impl<'f> Site<'f> {
    fn of(kind: Kind, scope: &Scope, footprint: Option<&'f Footprint>, options: &Options) -> Site<'f> {
        let ground = Rect::under(&scope.bounds);
        let footprint = match footprint {
            Some(footprint) => Cow::Borrowed(footprint),
            None if kind.is_round() => Cow::Owned(Footprint::round(ground)),
            None => Cow::Owned(Footprint::full(ground)),
        };
        let overhang = options.overhang.clamp(0, WIDEST_OVERHANG);
        let reach = reach(kind, &footprint, overhang);
        Site {
            reach,
            view: View::of(footprint.area(), scope.frame),
            floor: scope.bounds.min.y,
            height: scope.bounds.size().y,
            overhang,
            footprint,
        }
    }

    /// How far from the footprint heights are asked for: those beside the outermost eaves.
    fn margin(&self) -> i32 {
        self.overhang + 1
    }

    fn cell(&self, spot: Spot, level: i32) -> Cell {
        Cell::new(spot.x, self.floor + level, spot.y)
    }
}

/// A footprint with eaves of the same shape.
fn reach(kind: Kind, footprint: &Footprint, overhang: i32) -> Footprint {
    let near = footprint.dilated(overhang);
    if !kind.is_round() || *footprint != Footprint::round(footprint.area()) {
        return near;
    }
    let round = Footprint::round(near.area());
    Footprint::from_fn(near.area(), |spot| {
        near.contains(spot) && round.contains(spot) || footprint.contains(spot)
    })
}

/// Calls `put` with every cell of a roof and the block that goes there. It stands on `footprint`, or on the whole
/// ground of `scope`; eaves lie outside, and below its floor.
pub fn build(
    kind: Kind,
    family: &Family,
    options: &Options,
    (scope, footprint): (&Scope, Option<&Footprint>),
    put: &mut dyn FnMut(Cell, &BlockState),
) {
    let site = Site::of(kind, scope, footprint, options);
    if !site.footprint.is_empty() {
        let surface = heights::surface(kind, options.pitch, &site);
        let tops = cap::Tops::of(&site, family, &*surface);
        lay::lay(&site, &tops, family, options, put);
    }
}

#[cfg(test)]
mod tests;
