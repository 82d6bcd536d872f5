use crate::space::{Axis, Bounds, Cell, Footprint, Rect, SIDES, Scope};

/// A circle or ellipse on every level, or its walls alone.
pub fn cylinder(thickness: Option<i32>, scope: &Scope, mut put: impl FnMut(Cell)) {
    let ground = Rect::under(&scope.bounds);
    let whole = Footprint::round(ground);
    let hole = thickness.map(|thickness| Footprint::round(ground.grown(-thickness)));
    // A cell at the edge is wall, so that walls have no gaps.
    let is_edge = |spot| SIDES.iter().any(|&side| !whole.contains(spot + side));
    let is_wall = |&spot: &_| hole.as_ref().is_none_or(|hole| !hole.contains(spot) || is_edge(spot));
    for spot in whole.spots().filter(is_wall) {
        for y in scope.bounds.min.y..scope.bounds.max.y {
            put(Cell::new(spot.x, y, spot.y));
        }
    }
}

/// A ball or ellipsoid, or its shell alone.
pub fn sphere(thickness: Option<i32>, scope: &Scope, mut put: impl FnMut(Cell)) {
    let whole = Ball::of(scope.bounds);
    let hole = thickness.map(|thickness| {
        let (min, max) = (scope.bounds.min + thickness, scope.bounds.max - thickness);
        Ball::of(Bounds::new(min, max))
    });
    let is_edge = |cell| {
        Axis::ALL.iter().any(|axis| {
            let step = axis.unit();
            !whole.contains(cell + step) || !whole.contains(cell - step)
        })
    };
    for cell in scope.bounds.cells().filter(|&cell| whole.contains(cell)) {
        if hole.as_ref().is_none_or(|hole| !hole.contains(cell) || is_edge(cell)) {
            put(cell);
        }
    }
}

/// The cells of a box whose middle lies in the largest ellipsoid inside. In flat boxes it is a little larger, so
/// that no side is left bare.
struct Ball {
    bounds: Bounds,
    limit: f64,
}

impl Ball {
    fn of(bounds: Bounds) -> Ball {
        let middle = bounds.min + (bounds.size() - 1) / 2;
        let ends = Axis::ALL.map(|axis| {
            let mut end = middle;
            end[axis.index()] = axis.of(bounds.min);
            off_centre(&bounds, end)
        });
        Ball { bounds, limit: ends.into_iter().fold(1.0, f64::max) + 1e-9 }
    }

    fn contains(&self, cell: Cell) -> bool {
        self.bounds.contains(cell) && off_centre(&self.bounds, cell) <= self.limit
    }
}

/// How far out a cell lies, squared: 1 is on the ellipsoid.
fn off_centre(bounds: &Bounds, cell: Cell) -> f64 {
    let half = bounds.size().as_dvec3() / 2.0;
    ((cell.as_dvec3() + 0.5 - bounds.min.as_dvec3() - half) / half).length_squared()
}
