use super::Footprint;
use super::rectangles::runs;
use crate::space::{Rect, Spot, Turn};
use glam::{IVec3, Vec2Swizzles, Vec3Swizzles};

/// A straight run of the edge of a footprint, as long as it goes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Wall {
    /// The cells along it, one thick, inside the footprint.
    pub cells: Rect,
    /// What turns the south to where the wall faces.
    pub turn: Turn,
    /// What is at its left and right ends, seen from outside.
    pub ends: [Corner; 2],
}

/// How the edge of a footprint goes on at the end of a wall.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Corner {
    /// Away from who looks at the wall from outside.
    Convex,
    /// Towards who looks at the wall.
    Reflex,
}

impl Wall {
    /// The step that leaves the footprint.
    pub fn outward(&self) -> Spot {
        self.turn.apply(IVec3::Z).xz()
    }

    /// The step along the wall to the right, seen from outside.
    pub fn right(&self) -> Spot {
        self.turn.apply(IVec3::X).xz()
    }

    /// How many cells long it is.
    pub fn len(&self) -> i32 {
        self.cells.size().max_element()
    }

    /// A wall has a cell at least.
    pub fn is_empty(&self) -> bool {
        false
    }
}

impl Footprint {
    /// All walls: those that face south first, then east, north and west, each from north-west on.
    pub fn walls(&self) -> Vec<Wall> {
        Turn::ALL.into_iter().flat_map(|turn| self.walls_to(turn)).collect()
    }

    fn walls_to(&self, turn: Turn) -> Vec<Wall> {
        let outward = turn.apply(IVec3::Z).xz();
        let along = outward.abs().yx();
        let area = self.area;
        let lines = area.min.dot(outward.abs())..area.max.dot(outward.abs());
        let range = area.min.dot(along)..area.max.dot(along);
        let mut walls = Vec::new();
        for line in lines {
            let spot = |at| outward.abs() * line + along * at;
            let is_edge = |at| self.contains(spot(at)) && !self.contains(spot(at) + outward);
            for [low, high] in runs(range.clone(), is_edge) {
                let cells = Rect::new(spot(low), spot(high - 1) + 1);
                walls.push(Wall { cells, turn, ends: self.ends(&cells, turn) });
            }
        }
        walls
    }

    /// At the end of a wall the edge turns outward if the cell beyond it is inside, for then the one in front is.
    fn ends(&self, cells: &Rect, turn: Turn) -> [Corner; 2] {
        let right = turn.apply(IVec3::X).xz();
        [-right, right].map(|way| {
            let last = if way.max_element() > 0 { cells.max - 1 } else { cells.min };
            if self.contains(last + way) { Corner::Reflex } else { Corner::Convex }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{drawn, footprints};
    use super::*;
    use crate::space::SIDES;
    use proptest::prelude::*;

    #[test]
    fn an_l_has_six_walls() {
        let walls = drawn(&["##..", "####"]).walls();
        let told: Vec<_> =
            walls.iter().map(|wall| (wall.outward().to_array(), wall.len(), wall.ends)).collect();
        use Corner::{Convex, Reflex};
        let expected = [
            ([0, 1], 4, [Convex, Convex]),
            ([1, 0], 1, [Reflex, Convex]),
            ([1, 0], 1, [Convex, Convex]),
            ([0, -1], 2, [Convex, Convex]),
            ([0, -1], 2, [Convex, Reflex]),
            ([-1, 0], 2, [Convex, Convex]),
        ];
        assert_eq!(told, expected);
    }

    proptest! {
        #[test]
        fn walls_are_the_edge_once(footprint in footprints()) {
            let mut told = Vec::new();
            for wall in footprint.walls() {
                told.extend(wall.cells.spots().map(|spot| (spot.to_array(), wall.outward().to_array())));
            }
            let mut edge = Vec::new();
            for spot in footprint.spots() {
                for way in SIDES {
                    if !footprint.contains(spot + way) {
                        edge.push((spot.to_array(), way.to_array()));
                    }
                }
            }
            told.sort_unstable();
            edge.sort_unstable();
            prop_assert_eq!(told, edge);
        }

        #[test]
        fn walls_close(footprint in footprints()) {
            let walls = footprint.walls();
            prop_assert_eq!(walls.iter().map(|wall| wall.outward() * wall.len()).sum::<Spot>(), Spot::ZERO);
            // Walls end where others do, at a corner of the same kind.
            for kind in [Corner::Convex, Corner::Reflex] {
                let ends = |side: usize| walls.iter().filter(move |wall| wall.ends[side] == kind).count();
                prop_assert_eq!(ends(0), ends(1), "{:?}", kind);
            }
        }
    }
}
