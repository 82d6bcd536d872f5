use crate::block::{BlockState, Facing, Family};
use crate::space::{Cell, Rect, Scope, Spot, View};

/// A wall with an opening under a half circle, or a half ellipse where it is low, which leaves `thickness` blocks at
/// its sides and on top. Stairs hang where the opening steps up.
pub fn arch(thickness: i32, family: &Family, scope: &Scope, put: &mut dyn FnMut(Cell, &BlockState)) {
    let view = View::of(Rect::under(&scope.bounds), scope.frame);
    let [width, depth] = view.lengths().to_array();
    let (low, height) = (scope.bounds.min.y, scope.bounds.size().y);
    let opening = Opening { width, height, thickness };
    for u in 0..width {
        let open = opening.over(u);
        let springer = opening.stairs(u, family, view.directions()[0]);
        for v in 0..depth {
            let spot = view.spot(Spot::new(u, v));
            for level in open..height {
                let state = springer.as_ref().filter(|_| level == open).unwrap_or(&family.full);
                put(Cell::new(spot.x, low + level, spot.y), state);
            }
        }
    }
}

struct Opening {
    width: i32,
    height: i32,
    thickness: i32,
}

impl Opening {
    /// How many blocks are open over a place along the arch.
    fn over(&self, u: i32) -> i32 {
        let half = f64::from(self.width) / 2.0 - f64::from(self.thickness);
        let out = (f64::from(u) + 0.5 - f64::from(self.width) / 2.0).abs() / half;
        if half <= 0.0 || out >= 1.0 {
            return 0;
        }
        let most = f64::from((self.height - self.thickness).max(0));
        let rise = half.min(most);
        (most - rise + rise * (1.0 - out * out).sqrt()).round() as i32
    }

    /// The stairs under a column, if the opening is higher on one side of it: their foot is at the other.
    fn stairs(&self, u: i32, family: &Family, right: Spot) -> Option<BlockState> {
        let (open, after, before) = (self.over(u), self.over(u + 1), self.over(u - 1));
        let way = match (after > open, before > open) {
            (true, false) => -right,
            (false, true) => right,
            _ => return None,
        };
        let facing = Facing::HORIZONTAL.into_iter().find(|side| side.step() == Cell::new(way.x, 0, way.y))?;
        let stairs = family.stairs.clone().filter(|_| open > 0)?;
        Some(stairs.with("facing", facing.name()).with("half", "top").with("shape", "straight"))
    }
}
