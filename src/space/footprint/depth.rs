use super::{Footprint, Wall};
use crate::space::{Rect, Spot};

/// How deep in a footprint cells lie: those at its edge are 1 deep, those just outside 0, and further out it
/// falls. A step across counts as a step straight on, as in offsets with mitred corners.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Depths {
    known: Rect,
    depths: Vec<i32>,
}

/// The depth of cells that are too far out to matter.
const FAR_OUT: i32 = i32::MIN / 2;

impl Depths {
    fn from_fn(known: Rect, depth: impl Fn(Spot) -> i32) -> Depths {
        Depths { known, depths: known.spots().map(depth).collect() }
    }

    /// The depth of a cell: a very low number where it is not known.
    pub fn at(&self, spot: Spot) -> i32 {
        if self.known.contains(spot) { self.depths[number(self.known, spot)] } else { FAR_OUT }
    }
}

impl Footprint {
    /// The depths of all cells, and of those at most `margin` cells outside.
    pub fn depths(&self, margin: i32) -> Depths {
        let around = self.area.grown(margin + 1);
        let to_outside = distances(around, |spot| !self.contains(spot));
        let to_inside = distances(around, |spot| self.contains(spot));
        Depths::from_fn(self.area.grown(margin), |spot| match self.contains(spot) {
            true => to_outside[number(around, spot)],
            false => 1 - to_inside[number(around, spot)],
        })
    }

    /// The depths in the wing behind a wall, as if the wing went on in front of it: only its sides and its far
    /// end count, and of the far end nothing that is one of `open`. Reaches `margin` cells further on all sides.
    pub fn wing_depths(&self, wall: &Wall, open: &[Wall], margin: i32) -> Depths {
        let wing = Wing::behind(wall, open, self);
        // Half the wall's length in front of it, nothing there is nearer than the sides.
        let around = wing.area(wall.len() / 2 + margin + 2, margin + 1);
        let to_outside = distances(around, |spot| !wing.contains(spot));
        let to_inside = distances(around, |spot| wing.contains(spot));
        Depths::from_fn(wing.area(margin, margin), |spot| match wing.contains(spot) {
            true if wing.is_far_in_front(spot, margin) => FAR_OUT,
            true => to_outside[number(around, spot)],
            false => 1 - to_inside[number(around, spot)],
        })
    }

    /// The depths where some walls do not count: the deepest of the whole and of the wings behind them.
    pub fn depths_without(&self, open: &[Wall], margin: i32) -> Depths {
        let wings = open.iter().map(|wall| self.wing_depths(wall, open, margin));
        let all: Vec<Depths> = std::iter::once(self.depths(margin)).chain(wings).collect();
        let deepest = |spot| all.iter().map(|depths| depths.at(spot)).max().unwrap_or(FAR_OUT);
        Depths::from_fn(self.area.grown(margin), deepest)
    }
}

/// What lies straight behind a wall: as many columns of cells as the wall is long.
struct Wing<'w> {
    wall: &'w Wall,
    columns: Vec<Column>,
}

struct Column {
    length: i32,
    /// Whether it goes on behind the footprint, where its end is an open wall.
    end: End,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Closed,
    Open,
}

impl Wing<'_> {
    fn behind<'w>(wall: &'w Wall, open: &[Wall], footprint: &Footprint) -> Wing<'w> {
        let inward = -wall.outward();
        let column = |first: Spot| {
            let length = (0..).take_while(|&step| footprint.contains(first + inward * step)).count() as i32;
            let last = first + inward * (length - 1);
            let is_open = open.iter().any(|end| end.outward() == inward && end.cells.contains(last));
            Column { length, end: if is_open { End::Open } else { End::Closed } }
        };
        Wing { wall, columns: wall.cells.spots().map(column).collect() }
    }

    /// The number of a cell's column, and how many steps behind the wall it lies.
    fn place(&self, spot: Spot) -> (i32, i32) {
        let from_first = spot - self.wall.cells.min;
        let outward = self.wall.outward();
        (from_first.dot(self.wall.right().abs()), -from_first.dot(outward))
    }

    fn column(&self, number: i32) -> Option<&Column> {
        usize::try_from(number).ok().and_then(|number| self.columns.get(number))
    }

    fn contains(&self, spot: Spot) -> bool {
        let (number, steps) = self.place(spot);
        self.column(number).is_some_and(|column| steps < column.length || column.end == End::Open)
    }

    fn is_far_in_front(&self, spot: Spot, margin: i32) -> bool {
        let (number, steps) = self.place(spot);
        let length = self.column(number).map_or(0, |column| column.length);
        steps < -margin || steps >= length + margin
    }

    /// The rectangle of the wing, with more cells in front and behind, and at its sides.
    fn area(&self, ahead: i32, aside: i32) -> Rect {
        let longest = self.columns.iter().map(|column| column.length).max().unwrap_or(1);
        let (outward, right) = (self.wall.outward(), self.wall.right());
        let back = self.wall.cells.moved(-outward * (longest - 1));
        let wing = self.wall.cells.union(&back);
        let more = outward.abs() * ahead + right.abs() * aside;
        Rect::new(wing.min - more, wing.max + more)
    }
}

fn number(area: Rect, spot: Spot) -> usize {
    let from_min = spot - area.min;
    from_min.y as usize * area.size().x as usize + from_min.x as usize
}

/// How far each cell of an area is from the nearest that is a target: two sweeps of the chessboard distance
/// (Rosenfeld and Pfaltz, 1968).
fn distances(area: Rect, is_target: impl Fn(Spot) -> bool) -> Vec<i32> {
    let far = area.size().element_sum().max(1);
    let mut distances: Vec<i32> = area.spots().map(|spot| if is_target(spot) { 0 } else { far }).collect();
    let before = [Spot::new(-1, -1), Spot::new(0, -1), Spot::new(1, -1), Spot::new(-1, 0)];
    let mut sweep = |spot: Spot, sign: i32| {
        let near = before.iter().map(|&step| spot + step * sign).filter(|&near| area.contains(near));
        let nearest = near.map(|near| distances[number(area, near)] + 1).min();
        let own = &mut distances[number(area, spot)];
        *own = nearest.map_or(*own, |nearest| nearest.min(*own));
    };
    area.spots().for_each(|spot| sweep(spot, 1));
    let last = area.min + area.max - 1;
    area.spots().for_each(|spot| sweep(last - spot, -1));
    distances
}

#[cfg(test)]
mod tests {
    use super::super::Corner;
    use super::super::tests::{drawn, footprints};
    use super::*;
    use proptest::prelude::*;

    fn rows(footprint: &Footprint, depths: &Depths, margin: i32) -> Vec<String> {
        let area = footprint.area().grown(margin);
        let row =
            |z| (area.min.x..area.max.x).map(|x| depths.at(Spot::new(x, z)).to_string()).collect::<Vec<_>>();
        (area.min.y..area.max.y).map(|z| row(z).join(" ")).collect()
    }

    #[test]
    fn depth_falls_on_outside() {
        let square = drawn(&["###", "###", "###"]);
        let expected = ["0 0 0 0 0", "0 1 1 1 0", "0 1 2 1 0", "0 1 1 1 0", "0 0 0 0 0"];
        assert_eq!(rows(&square, &square.depths(1), 1), expected);
    }

    #[test]
    fn an_open_wall_does_not_count() {
        let hall = drawn(&["#####", "#####", "#####"]);
        let ends: Vec<Wall> = hall.walls().into_iter().filter(|wall| wall.len() == 3).collect();
        assert_eq!(
            rows(&hall, &hall.depths_without(&ends[..1], 0), 0),
            ["1 1 1 1 1", "1 2 2 2 2", "1 1 1 1 1"]
        );
        assert_eq!(rows(&hall, &hall.depths_without(&ends, 0), 0), ["1 1 1 1 1", "2 2 2 2 2", "1 1 1 1 1"]);
    }

    /// Where a wing's wall does not count, its depth is that of the largest rectangle behind the wall.
    fn wing_by_force(footprint: &Footprint, wall: &Wall, open: &[Wall], at: Spot) -> i32 {
        let inside = |rect: &Rect| rect.contains(at) && rect.spots().all(|spot| footprint.contains(spot));
        let corners: Vec<Spot> = footprint.area().spots().collect();
        let rects = corners.iter().flat_map(|&a| corners.iter().map(move |&b| Rect::new(a, b + 1)));
        rects
            .filter(|rect| !rect.is_empty() && inside(rect))
            .filter_map(|rect| {
                let side = |way: Spot| {
                    let (low, high) = (rect.min, rect.max);
                    let cells = match way.to_array() {
                        [1, 0] => Rect::new(Spot::new(high.x - 1, low.y), high),
                        [-1, 0] => Rect::new(low, Spot::new(low.x + 1, high.y)),
                        [0, 1] => Rect::new(Spot::new(low.x, high.y - 1), high),
                        _ => Rect::new(low, Spot::new(high.x, low.y + 1)),
                    };
                    let of = |wall: &Wall| {
                        wall.outward() == way && cells.spots().all(|spot| wall.cells.contains(spot))
                    };
                    let gap = 1 + match way.max_element() {
                        1 => (high - 1 - at).dot(way),
                        _ => (low - at).dot(way),
                    };
                    (gap, of(wall), open.iter().any(of))
                };
                let out = wall.outward();
                let [front, back, left, right] = [out, -out, wall.right(), -wall.right()].map(side);
                let far = if back.2 { i32::MAX } else { back.0 };
                front.1.then_some(left.0.min(right.0).min(far))
            })
            .max()
            .unwrap_or(0)
    }

    proptest! {
        #[test]
        fn depths_are_distances(footprint in footprints()) {
            let depths = footprint.depths(3);
            let area = footprint.area().grown(3);
            for spot in area.spots() {
                let is_in = footprint.contains(spot);
                let others = area.grown(1).spots().filter(|&other| footprint.contains(other) != is_in);
                if let Some(nearest) = others.map(|other| (other - spot).abs().max_element()).min() {
                    prop_assert_eq!(depths.at(spot), if is_in { nearest } else { 1 - nearest });
                }
            }
        }

        #[test]
        fn wings_are_as_deep_as_their_rectangles(footprint in footprints()) {
            let small = footprint.clipped(Rect::new(footprint.area().min, footprint.area().min + 6));
            let is_end = |wall: &Wall| wall.ends == [Corner::Convex; 2];
            let open: Vec<Wall> = small.walls().into_iter().filter(is_end).take(3).collect();
            for wall in &open {
                let depths = small.wing_depths(wall, &open, 0);
                for spot in small.spots() {
                    prop_assert_eq!(depths.at(spot).max(0), wing_by_force(&small, wall, &open, spot));
                }
            }
        }
    }
}
