use super::{Bounds, Cell};
use glam::{IVec2, Vec3Swizzles};

/// A place in the plan of the world: `x` is east, and `y` is the world's z, south.
pub type Spot = IVec2;

/// The steps to the four neighbours of a place.
pub const SIDES: [Spot; 4] = [Spot::X, Spot::Y, Spot::NEG_X, Spot::NEG_Y];

/// A half-open rectangle of the world's plan.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Rect {
    pub min: Spot,
    pub max: Spot,
}

/// Nothing, at the origin: what all empty rectangles are once they are `tidy`.
const NOTHING: Rect = Rect { min: Spot::ZERO, max: Spot::ZERO };

impl Rect {
    pub fn new(min: Spot, max: Spot) -> Rect {
        Rect { min, max }
    }

    /// The ground that a box stands on.
    pub fn under(bounds: &Bounds) -> Rect {
        Rect::new(bounds.min.xz(), bounds.max.xz())
    }

    /// The box of this plan from `low` to `high`.
    pub fn between(&self, low: i32, high: i32) -> Bounds {
        let at = |spot: Spot, y| Cell::new(spot.x, y, spot.y);
        Bounds::new(at(self.min, low), at(self.max, high))
    }

    pub fn size(&self) -> Spot {
        self.max - self.min
    }

    pub fn is_empty(&self) -> bool {
        self.size().min_element() <= 0
    }

    /// How many cells there are.
    pub fn area(&self) -> usize {
        let size = self.size().max(Spot::ZERO);
        size.x as usize * size.y as usize
    }

    pub fn contains(&self, spot: Spot) -> bool {
        spot.cmpge(self.min).all() && spot.cmplt(self.max).all()
    }

    pub fn intersect(&self, other: &Rect) -> Rect {
        Rect::new(self.min.max(other.min), self.max.min(other.max)).tidy()
    }

    /// The smallest rectangle around both.
    pub fn union(&self, other: &Rect) -> Rect {
        match (self.is_empty(), other.is_empty()) {
            (true, _) => other.tidy(),
            (_, true) => *self,
            _ => Rect::new(self.min.min(other.min), self.max.max(other.max)),
        }
    }

    /// The rectangle with `margin` more cells on every side; a negative margin takes them away.
    pub fn grown(&self, margin: i32) -> Rect {
        Rect::new(self.min - margin, self.max + margin).tidy()
    }

    pub fn moved(&self, by: Spot) -> Rect {
        Rect::new(self.min + by, self.max + by)
    }

    /// Every cell, row by row.
    pub fn spots(self) -> impl Iterator<Item = Spot> {
        (self.min.y..self.max.y).flat_map(move |z| (self.min.x..self.max.x).map(move |x| Spot::new(x, z)))
    }

    fn tidy(self) -> Rect {
        if self.is_empty() { NOTHING } else { self }
    }
}
