use super::Footprint;
use crate::space::{Rect, Spot};
use glam::Vec2Swizzles;

/// Circles larger than this look round by the plain rule.
const LARGE: i32 = 64;

impl Footprint {
    /// The circle or ellipse that fills a rectangle: the one, among those of nearly its radius, whose outline
    /// bends most evenly, and of these the one nearest in area.
    pub fn round(area: Rect) -> Footprint {
        let size = area.size().max(Spot::ZERO);
        let least = least_limit(size);
        let limit = if size.max_element() > LARGE { least.max(1.0) } else { best_limit(size, least) };
        Footprint::from_fn(area, |spot| off_centre(spot - area.min, size) <= limit)
    }
}

/// How far out a cell lies in an ellipse of `size`, squared: 1 is on its edge.
fn off_centre(at: Spot, size: Spot) -> f64 {
    let part = |at: i32, length: i32| f64::from(2 * at + 1 - length) / f64::from(length);
    part(at.x, size.x).powi(2) + part(at.y, size.y).powi(2)
}

/// The least limit that leaves no side of the rectangle bare.
fn least_limit(size: Spot) -> f64 {
    let middle = (size - 1) / 2;
    off_centre(Spot::new(0, middle.y), size).max(off_centre(Spot::new(middle.x, 0), size)) + 1e-9
}

/// The limits worth a try are those that cells lie at; the corners of the rectangle are never in.
fn best_limit(size: Spot, least: f64) -> f64 {
    let corner = off_centre(Spot::ZERO, size);
    let most = if size.min_element() < 3 { corner } else { corner - 1e-9 };
    let quarter = Rect::new(Spot::ZERO, (size + 1) / 2);
    let mut limits: Vec<f64> = quarter.spots().map(|at| off_centre(at, size)).collect();
    limits.retain(|limit| (least..=most.max(least)).contains(limit) && *limit <= least.max(1.05));
    let tried = std::iter::once(least).chain(limits.into_iter().map(|limit| limit + 1e-9));
    let scored = tried.map(|limit| (score(size, limit), limit));
    scored.min_by(|(a, _), (b, _)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))).map_or(1.0, |(_, limit)| limit)
}

/// How uneven the outline is, then how far the area is from the true one.
fn score(size: Spot, limit: f64) -> (i32, f64) {
    let (rows, columns) = (rows(size, limit), rows(size.yx(), limit));
    let cells: i32 = (0..size.y).map(|z| rows[z.min(size.y - 1 - z) as usize]).sum();
    let area = std::f64::consts::FRAC_PI_4 * f64::from(size.x) * f64::from(size.y);
    (unevenness(&rows) + unevenness(&columns), (f64::from(cells) - area).abs())
}

/// How many cells of each row are in, from the end to the middle.
fn rows(size: Spot, limit: f64) -> Vec<i32> {
    let row = |z| (0..size.x).filter(|&x| off_centre(Spot::new(x, z), size) <= limit).count() as i32;
    (0..(size.y + 1) / 2).map(row).collect()
}

/// From the end of an ellipse to its middle each line is longer than the last by less and less.
fn unevenness(lines: &[i32]) -> i32 {
    let steps: Vec<i32> = lines.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.windows(2).map(|pair| (pair[1] - pair[0]).max(0)).sum()
}

#[cfg(test)]
mod tests {
    use super::super::tests::drawing;
    use super::*;

    fn round(x: i32, z: i32) -> Footprint {
        Footprint::round(Rect::new(Spot::ZERO, Spot::new(x, z)))
    }

    fn widths(diameter: i32) -> Vec<usize> {
        let rows = drawing(&round(diameter, diameter));
        rows.iter().map(|row| row.matches('#').count()).collect()
    }

    #[test]
    fn small_circles_are_those_that_builders_lay() {
        assert_eq!(widths(1), [1]);
        assert_eq!(widths(2), [2, 2]);
        assert_eq!(widths(3), [1, 3, 1]);
        assert_eq!(widths(4), [2, 4, 4, 2]);
        assert_eq!(widths(5), [3, 5, 5, 5, 3]);
        assert_eq!(widths(6), [4, 6, 6, 6, 6, 4]);
        assert_eq!(widths(7), [3, 5, 7, 7, 7, 5, 3]);
        assert_eq!(widths(8), [4, 6, 8, 8, 8, 8, 6, 4]);
        assert_eq!(widths(9), [5, 7, 9, 9, 9, 9, 9, 7, 5]);
        assert_eq!(widths(10), [4, 6, 8, 10, 10, 10, 10, 8, 6, 4]);
    }

    #[test]
    fn ellipses_fill_their_rectangle_and_are_symmetric() {
        for x in 1..70 {
            for z in [1, 2, 3, 8, 13, 40, x] {
                let ellipse = round(x, z);
                let size = Spot::new(x, z);
                assert_eq!(ellipse.area().size(), size);
                let mirrored = |spot: Spot| ellipse.contains(Spot::new(x - 1 - spot.x, spot.y));
                let turned = |spot: Spot| ellipse.contains(size - 1 - spot);
                assert!(ellipse.spots().all(|spot| mirrored(spot) && turned(spot)), "{size}");
            }
        }
    }
}
