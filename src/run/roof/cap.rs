//! What lies on top of each column of a roof.

use super::Site;
use super::profile::Surface;
use crate::block::{BlockState, Facing, Family};
use crate::space::{Rect, Spot};
use smallvec::SmallVec;

/// A slope this steep, in blocks up a block on, is laid in stairs; flatter ones in slabs.
const STAIR_PITCH: f64 = 0.7;

/// The topmost block of a column: its number from the floor up, and what it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Top {
    pub level: i32,
    pub cover: Cover,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Cover {
    Full,
    Slab,
    /// Stairs, as the columns around it ask for.
    Stairs,
}

/// The tops of all columns, also of those beside the roof that are not laid.
pub struct Tops {
    area: Rect,
    tops: Vec<Top>,
}

impl Tops {
    pub fn of(site: &Site, family: &Family, surface: &dyn Fn(Spot) -> Surface) -> Tops {
        let area = site.footprint.area().grown(site.margin());
        let top = |spot| {
            let top = top(surface(spot), family);
            if site.footprint.contains(spot) { top.above_floor(family) } else { top }
        };
        Tops { area, tops: area.spots().map(top).collect() }
    }

    pub fn at(&self, spot: Spot) -> Top {
        let from_min = spot.clamp(self.area.min, self.area.max - 1) - self.area.min;
        self.tops[from_min.y as usize * self.area.size().x as usize + from_min.x as usize]
    }

    /// The block on top of a column.
    pub fn block(&self, spot: Spot, family: &Family) -> BlockState {
        match self.at(spot).cover {
            Cover::Full => family.full.clone(),
            Cover::Slab => slab(family),
            Cover::Stairs => stairs(self.bend(spot), family),
        }
    }

    /// The first level over a column that is open to its neighbour on a side: stairs that rise to that side shut it
    /// up to their top, slabs and other stairs do not.
    pub fn open_from(&self, spot: Spot, side: Spot) -> i32 {
        let Top { level, cover } = self.at(spot);
        let is_shut = match cover {
            Cover::Full => true,
            Cover::Slab => false,
            Cover::Stairs => self.bend(spot).shuts(side),
        };
        if is_shut { level + 1 } else { level }
    }

    /// How the stairs on a column turn: down to the sides where the columns are lower.
    fn bend(&self, spot: Spot) -> Bend {
        let level = self.at(spot).level;
        let is_lower = |step: Spot| self.at(spot + step).level < level;
        let is_corner_lower = |side: Facing| is_lower(flat(side) + flat(side.right()));
        let mut low = Facing::HORIZONTAL.into_iter().filter(|side| is_lower(flat(*side)));
        match [low.next(), low.next(), low.next()] {
            [None, ..] => inner_bend(is_corner_lower),
            // Where it is lower behind as well, this is a ridge.
            [Some(side), None, _] => match side.opposite() {
                up if is_corner_lower(up) && is_corner_lower(up.left()) => Bend::Ridge,
                up => Bend::Straight(up),
            },
            [Some(a), Some(b), None] if a != b.opposite() => match [a, b].map(Facing::opposite) {
                [first, second] if is_lower(flat(first) + flat(second)) => Bend::Ridge,
                up => Bend::Outer(up),
            },
            _ => Bend::Ridge,
        }
    }
}

/// The bend of stairs with no lower side, by the lower ones among the corners between a side and that to its right.
fn inner_bend(is_lower: impl Fn(Facing) -> bool) -> Bend {
    let low: SmallVec<[Facing; 4]> = Facing::HORIZONTAL.into_iter().filter(|side| is_lower(*side)).collect();
    match low[..] {
        [side] => Bend::Inner([side.opposite(), side.right().opposite()]),
        // The end of a ridge that runs into a slope.
        [a, b] if a.right() == b => Bend::Straight(b.opposite()),
        [a, b] if b.right() == a => Bend::Straight(a.opposite()),
        // Where ridges cross.
        [_, _, _, ..] => Bend::Ridge,
        _ => Bend::Level,
    }
}

/// How stairs lie on a column: the sides they rise to.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Bend {
    Straight(Facing),
    Outer([Facing; 2]),
    Inner([Facing; 2]),
    /// Lower on opposite sides: a slab.
    Ridge,
    /// Lower nowhere: a full block.
    Level,
}

impl Bend {
    /// Whether the stairs are as high as a full block all along a side.
    fn shuts(self, side: Spot) -> bool {
        match self {
            Bend::Straight(up) => flat(up) == side,
            Bend::Inner(ups) => ups.iter().any(|up| flat(*up) == side),
            Bend::Outer(_) | Bend::Ridge => false,
            Bend::Level => true,
        }
    }
}

fn stairs(bend: Bend, family: &Family) -> BlockState {
    let stairs = |facing: Facing, shape: &str| {
        let stairs = family.stairs.as_ref().unwrap_or(&family.full).clone();
        stairs.with("facing", facing.name()).with("half", "bottom").with("shape", shape)
    };
    let hand = |first: Facing, second| if first.left() == second { "left" } else { "right" };
    match bend {
        Bend::Straight(facing) => stairs(facing, "straight"),
        Bend::Outer([first, second]) => stairs(first, &format!("outer_{}", hand(first, second))),
        Bend::Inner([first, second]) => stairs(first, &format!("inner_{}", hand(first, second))),
        Bend::Ridge => slab(family),
        Bend::Level => family.full.clone(),
    }
}

pub fn slab(family: &Family) -> BlockState {
    family.slab.as_ref().unwrap_or(&family.full).clone()
}

impl Top {
    /// A column of the footprint is a block high at least.
    fn above_floor(self, family: &Family) -> Top {
        match (self.level < 0, self.cover, &family.slab) {
            (false, ..) => self,
            (true, Cover::Stairs, _) => Top { level: 0, ..self },
            (true, _, Some(_)) => Top { level: 0, cover: Cover::Slab },
            (true, _, None) => Top { level: 0, cover: Cover::Full },
        }
    }
}

/// No height is further from the floor than this.
const FAR: f64 = 1e6;

fn top(Surface { height, pitch }: Surface, family: &Family) -> Top {
    let height = height.clamp(-FAR, FAR);
    if pitch >= STAIR_PITCH && family.stairs.is_some() {
        return Top { level: (height - 1e-6).ceil() as i32 - 1, cover: Cover::Stairs };
    }
    if family.slab.is_none() {
        return Top { level: (height + 0.5).floor() as i32 - 1, cover: Cover::Full };
    }
    let halves = (height * 2.0 + 0.5).floor() as i32;
    let cover = if halves.rem_euclid(2) == 1 { Cover::Slab } else { Cover::Full };
    Top { level: (halves + 1).div_euclid(2) - 1, cover }
}

fn flat(side: Facing) -> Spot {
    let step = side.step();
    Spot::new(step.x, step.z)
}
