//! Footprints: which cells of the plan a shape stands on.

mod depth;
mod parts;
mod rectangles;
mod round;
mod walls;
mod wings;

use super::{Rect, Spot};
use fixedbitset::FixedBitSet;

pub use depth::Depths;
pub use walls::{Corner, Wall};
pub use wings::{shape_h, shape_l, shape_o, shape_t, shape_u};

/// A set of cells of the plan. Its rectangle is the smallest around them, so that equal sets are equal values.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Footprint {
    area: Rect,
    cells: FixedBitSet,
}

impl Footprint {
    pub fn full(area: Rect) -> Footprint {
        Footprint::from_fn(area, |_| true)
    }

    /// All cells of some rectangles, which may overlap.
    pub fn of_rectangles(rectangles: &[Rect]) -> Footprint {
        let around = rectangles.iter().fold(Rect::new(Spot::ZERO, Spot::ZERO), |all, next| all.union(next));
        Footprint::from_fn(around, |spot| rectangles.iter().any(|rect| rect.contains(spot)))
    }

    /// The cells of `area` that `holds` says are in.
    pub fn from_fn(area: Rect, holds: impl Fn(Spot) -> bool) -> Footprint {
        let tight = area
            .spots()
            .filter(|&spot| holds(spot))
            .fold(Rect::new(Spot::ZERO, Spot::ZERO), |all, spot| all.union(&Rect::new(spot, spot + 1)));
        let cells = tight.spots().enumerate().filter(|&(_, spot)| holds(spot)).map(|(number, _)| number);
        let mut set = FixedBitSet::with_capacity(tight.area());
        set.extend(cells);
        Footprint { area: tight, cells: set }
    }

    /// The smallest rectangle around all cells.
    pub fn area(&self) -> Rect {
        self.area
    }

    pub fn is_empty(&self) -> bool {
        self.area.is_empty()
    }

    /// Whether it fills its rectangle.
    pub fn is_rectangle(&self) -> bool {
        self.cells.is_full()
    }

    /// How many cells there are.
    pub fn len(&self) -> usize {
        self.cells.count_ones(..)
    }

    pub fn contains(&self, spot: Spot) -> bool {
        self.area.contains(spot) && self.cells.contains(self.number(spot))
    }

    /// Every cell, row by row.
    pub fn spots(&self) -> impl Iterator<Item = Spot> {
        let (min, width) = (self.area.min, self.area.size().x.max(1));
        self.cells.ones().map(move |number| min + Spot::new(number as i32 % width, number as i32 / width))
    }

    /// The part inside a rectangle.
    pub fn clipped(&self, to: Rect) -> Footprint {
        Footprint::from_fn(self.area.intersect(&to), |spot| self.contains(spot))
    }

    pub fn moved(&self, by: Spot) -> Footprint {
        match self.is_empty() {
            true => self.clone(),
            false => Footprint { area: self.area.moved(by), cells: self.cells.clone() },
        }
    }

    pub fn with(&self, other: &Footprint) -> Footprint {
        let around = self.area.union(&other.area);
        Footprint::from_fn(around, |spot| self.contains(spot) || other.contains(spot))
    }

    pub fn without(&self, other: &Footprint) -> Footprint {
        Footprint::from_fn(self.area, |spot| self.contains(spot) && !other.contains(spot))
    }

    /// With all cells that lie at most `by` cells away, straight or across.
    pub fn dilated(&self, by: i32) -> Footprint {
        let depths = self.depths(by);
        Footprint::from_fn(self.area.grown(by.max(0)), |spot| depths.at(spot) > -by)
    }

    /// Without all cells that lie at most `by` cells from the edge, straight or across.
    pub fn eroded(&self, by: i32) -> Footprint {
        let depths = self.depths(0);
        Footprint::from_fn(self.area, |spot| self.contains(spot) && depths.at(spot) > by)
    }

    fn number(&self, spot: Spot) -> usize {
        let from_min = spot - self.area.min;
        from_min.y as usize * self.area.size().x as usize + from_min.x as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A footprint from a drawing: `#` is in.
    pub(super) fn drawn(rows: &[&str]) -> Footprint {
        let size = Spot::new(rows[0].len() as i32, rows.len() as i32);
        let holds = |spot: Spot| rows[spot.y as usize].as_bytes()[spot.x as usize] == b'#';
        Footprint::from_fn(Rect::new(Spot::ZERO, size), holds)
    }

    /// The drawing of a footprint.
    pub(super) fn drawing(footprint: &Footprint) -> Vec<String> {
        let area = footprint.area();
        let mark = |x, z| if footprint.contains(Spot::new(x, z)) { '#' } else { '.' };
        (area.min.y..area.max.y).map(|z| (area.min.x..area.max.x).map(|x| mark(x, z)).collect()).collect()
    }

    pub(super) fn rects() -> impl Strategy<Value = Rect> {
        (-9..9i32, -9..9i32, 1..9i32, 1..9i32)
            .prop_map(|(x, z, sx, sz)| Rect::new(Spot::new(x, z), Spot::new(x + sx, z + sz)))
    }

    /// Unions of rectangles, and some with single cells struck out.
    pub(super) fn footprints() -> impl Strategy<Value = Footprint> {
        let holes = prop::collection::vec((-9..18i32, -9..18i32), 0..6);
        (prop::collection::vec(rects(), 0..5), holes).prop_map(|(rectangles, holes)| {
            let all = Footprint::of_rectangles(&rectangles);
            Footprint::from_fn(all.area(), |spot| all.contains(spot) && !holes.contains(&(spot.x, spot.y)))
        })
    }

    proptest! {
        #[test]
        fn cells_are_those_that_are_contained(footprint in footprints()) {
            let counted: Vec<Spot> = footprint.area().spots().filter(|&spot| footprint.contains(spot)).collect();
            prop_assert_eq!(&footprint.spots().collect::<Vec<_>>(), &counted);
            prop_assert_eq!(footprint.spots().count(), footprint.len());
            prop_assert_eq!(footprint.is_empty(), counted.is_empty());
        }

        #[test]
        fn equal_sets_are_equal_values(footprint in footprints(), margin in 0..4i32) {
            let wide = Footprint::from_fn(footprint.area().grown(margin), |spot| footprint.contains(spot));
            prop_assert_eq!(&wide, &footprint);
            let there_and_back = footprint.moved(Spot::new(3, -2)).moved(Spot::new(-3, 2));
            prop_assert_eq!(there_and_back, footprint);
        }

        #[test]
        fn a_part_and_the_rest_make_the_whole(footprint in footprints(), cut in rects()) {
            let part = footprint.clipped(cut);
            let rest = footprint.without(&part);
            prop_assert_eq!(part.len() + rest.len(), footprint.len());
            prop_assert_eq!(&part.with(&rest), &footprint);
            prop_assert!(part.spots().all(|spot| cut.contains(spot) && footprint.contains(spot)));
            prop_assert!(rest.spots().all(|spot| !cut.contains(spot)));
        }

        #[test]
        fn growing_and_shrinking_go_by_distance(footprint in footprints(), by in 0..4i32) {
            let near = |spot: Spot| Rect::new(spot, spot + 1).grown(by);
            let grown = footprint.dilated(by);
            for spot in footprint.area().grown(by + 2).spots() {
                prop_assert_eq!(grown.contains(spot), near(spot).spots().any(|other| footprint.contains(other)));
            }
            let shrunk = footprint.eroded(by);
            for spot in footprint.area().spots() {
                prop_assert_eq!(shrunk.contains(spot), near(spot).spots().all(|other| footprint.contains(other)));
            }
        }
    }
}
