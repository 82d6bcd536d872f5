use super::Footprint;
use crate::space::{Rect, Spot};
use glam::Vec2Swizzles;

impl Footprint {
    /// Few rectangles that together are the footprint and do not overlap: runs of rows, or of columns
    /// where these are fewer.
    pub fn rectangles(&self) -> Vec<Rect> {
        let rows = bands(self.area, |spot| self.contains(spot));
        let across = |rect: &Rect| Rect::new(rect.min.yx(), rect.max.yx());
        let columns = bands(across(&self.area), |spot| self.contains(spot.yx()));
        if rows.len() <= columns.len() { rows } else { columns.iter().map(across).collect() }
    }
}

/// The runs of each row, joined to those of the row before that are as long.
fn bands(area: Rect, holds: impl Fn(Spot) -> bool) -> Vec<Rect> {
    let (mut done, mut open) = (Vec::new(), Vec::<Rect>::new());
    for z in area.min.y..area.max.y {
        let runs = runs(area.min.x..area.max.x, |x| holds(Spot::new(x, z)));
        let longer = |&[low, high]: &[i32; 2]| {
            let same = open.iter().find(|rect| [rect.min.x, rect.max.x] == [low, high]);
            Rect::new(Spot::new(low, same.map_or(z, |rect| rect.min.y)), Spot::new(high, z + 1))
        };
        let next: Vec<Rect> = runs.iter().map(longer).collect();
        done.extend(open.iter().filter(|rect| !next.iter().any(|longer| longer.min == rect.min)));
        open = next;
    }
    done.append(&mut open);
    done
}

/// The longest stretches of numbers that all hold.
pub(super) fn runs(range: std::ops::Range<i32>, holds: impl Fn(i32) -> bool) -> Vec<[i32; 2]> {
    let mut runs: Vec<[i32; 2]> = Vec::new();
    for at in range.filter(|&at| holds(at)) {
        match runs.last_mut() {
            Some([_, end]) if *end == at => *end += 1,
            _ => runs.push([at, at + 1]),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::super::tests::{drawn, footprints};
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn wings_are_few_rectangles() {
        assert_eq!(drawn(&["###", "#..", "###"]).rectangles().len(), 3);
        assert_eq!(drawn(&["####", "####", "##.."]).rectangles().len(), 2);
        assert_eq!(drawn(&["##.##", "#####", "##.##"]).rectangles().len(), 3);
    }

    proptest! {
        #[test]
        fn rectangles_tile_the_footprint(footprint in footprints()) {
            let rectangles = footprint.rectangles();
            prop_assert_eq!(rectangles.iter().map(Rect::area).sum::<usize>(), footprint.len());
            prop_assert_eq!(Footprint::of_rectangles(&rectangles), footprint);
        }
    }
}
