//! Solids with slopes, built of a family of blocks: full blocks inside, stairs and slabs on the surface.

use super::ramp::{Rise, Slope, Surface, Way};
use crate::block::{BlockState, Facing, Family};
use crate::space::{Cell, Frame, Scope};

/// A slope this steep, in blocks up a block on, is laid in stairs; flatter ones in slabs.
const STAIR_PITCH: f64 = 0.7;

/// What lies on top of a column.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Cap {
    None,
    Slab,
    Stairs { uphill: Way },
    OuterCorner([Way; 2]),
    InnerCorner([Way; 2]),
}

/// A column of a solid: full blocks from its foot, then a cap.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Column {
    full: i32,
    cap: Cap,
}

/// Calls `put` with every cell of the solid in `scope` and the block that goes there.
pub fn build(slope: Slope, family: &Family, scope: &Scope, mut put: impl FnMut(Cell, &BlockState)) {
    let plan = Plan::of(scope);
    let [lu, lv] = plan.lengths;
    for v in 0..lv {
        for u in 0..lu {
            let column = column(slope, family, [u, v], &plan);
            for w in 0..column.full {
                put(plan.cell(u, v, w), &family.full);
            }
            if let Some(cap) = cap_block(column.cap, family, scope.frame) {
                put(plan.cell(u, v, column.full), &cap);
            }
        }
    }
}

/// The scope as a plan with heights.
struct Plan {
    corner: Cell,
    directions: [Cell; 2],
    lengths: [i32; 2],
    height: i32,
}

impl Plan {
    fn of(scope: &Scope) -> Plan {
        let directions = scope.frame.plan();
        let (size, last) = (scope.bounds.size(), scope.bounds.max - Cell::ONE);
        let lengths = directions.map(|direction| (direction * size).element_sum().abs());
        let mut corner = scope.bounds.min;
        for direction in directions {
            for axis in [0, 2] {
                if direction[axis] < 0 {
                    corner[axis] = last[axis];
                }
            }
        }
        Plan { corner, directions, lengths, height: size.y }
    }

    fn cell(&self, u: i32, v: i32, w: i32) -> Cell {
        self.corner + self.directions[0] * u + self.directions[1] * v + Cell::Y * w
    }
}

fn column(slope: Slope, family: &Family, at: [i32; 2], plan: &Plan) -> Column {
    let surface = slope.surface(at, plan.lengths, plan.height);
    let (Surface::Plain(rise) | Surface::Hip(rise, _) | Surface::Valley(rise, _)) = surface;
    let has_stairs = family.stairs.is_some();
    match surface {
        _ if rise.pitch < STAIR_PITCH || !has_stairs => flat(rise, family),
        // Stairs do not bend into a slope of slabs.
        Surface::Hip(_, other) | Surface::Valley(_, other) if other.pitch < STAIR_PITCH => {
            plain(rise, slope, at, plan)
        }
        Surface::Plain(rise) => plain(rise, slope, at, plan),
        Surface::Hip(a, b) => hip(a, b),
        Surface::Valley(a, b) => valley(a, b),
    }
}

/// A column of a flat slope: rounded to whole blocks, or to half ones where there are slabs.
fn flat(rise: Rise, family: &Family) -> Column {
    if family.slab.is_none() {
        return Column { full: (rise.height.round() as i32).max(1), cap: Cap::None };
    }
    let halves = ((rise.height * 2.0).round() as i32).max(1);
    Column { full: halves / 2, cap: if halves % 2 == 1 { Cap::Slab } else { Cap::None } }
}

fn plain(rise: Rise, slope: Slope, at: [i32; 2], plan: &Plan) -> Column {
    match rise.uphill {
        _ if rise.is_level() => level(rise),
        Some(uphill) => Column { full: rise.top(), cap: Cap::Stairs { uphill } },
        None => ridge(rise.top(), slope, at, plan),
    }
}

fn level(rise: Rise) -> Column {
    Column { full: rise.top() + 1, cap: Cap::None }
}

/// The ridge between two slopes: a slab where it rises above both, a full block where it is level with them.
fn ridge(full: i32, slope: Slope, [u, v]: [i32; 2], plan: &Plan) -> Column {
    let [lu, lv] = plan.lengths;
    let neighbours = [[u - 1, v], [u + 1, v], [u, v - 1], [u, v + 1]];
    let highest = neighbours
        .into_iter()
        .filter(|[u, v]| (0..lu).contains(u) && (0..lv).contains(v))
        .filter_map(|at| match slope.surface(at, plan.lengths, plan.height) {
            Surface::Plain(Rise { uphill: None, .. }) => None,
            Surface::Plain(rise) | Surface::Hip(rise, _) | Surface::Valley(rise, _) => Some(rise.top()),
        })
        .max();
    match highest {
        Some(level) if level >= full => Column { full: full + 1, cap: Cap::None },
        _ => Column { full, cap: Cap::Slab },
    }
}

fn hip(a: Rise, b: Rise) -> Column {
    match (a.is_level(), b.is_level()) {
        (true, true) => level(a),
        (true, false) => bend([b.uphill, None], Cap::OuterCorner, a),
        (false, true) => bend([a.uphill, None], Cap::OuterCorner, a),
        (false, false) => bend([a.uphill, b.uphill], Cap::OuterCorner, a),
    }
}

fn valley(a: Rise, b: Rise) -> Column {
    if a.is_level() || b.is_level() { level(a) } else { bend([a.uphill, b.uphill], Cap::InnerCorner, a) }
}

fn bend(uphill: [Option<Way>; 2], corner: fn([Way; 2]) -> Cap, rise: Rise) -> Column {
    let cap = match uphill {
        [Some(first), Some(second)] => corner([first, second]),
        [Some(uphill), None] | [None, Some(uphill)] => Cap::Stairs { uphill },
        [None, None] => Cap::Slab,
    };
    Column { full: rise.top(), cap }
}

fn cap_block(cap: Cap, family: &Family, frame: Frame) -> Option<BlockState> {
    let stairs = |facing: Facing, shape: &str| {
        let stairs = family.stairs.clone()?;
        Some(stairs.with("facing", facing.name()).with("half", "bottom").with("shape", shape))
    };
    let [first, second] = match cap {
        Cap::None => return None,
        Cap::Slab => return Some(family.slab.as_ref().unwrap_or(&family.full).clone()),
        Cap::Stairs { uphill } => return stairs(facing(uphill, frame), "straight"),
        Cap::OuterCorner(ways) | Cap::InnerCorner(ways) => ways.map(|way| facing(way, frame)),
    };
    let side = if first.left() == second { "left" } else { "right" };
    let bend = if matches!(cap, Cap::InnerCorner(_)) { "inner" } else { "outer" };
    stairs(first, &format!("{bend}_{side}"))
}

/// The side of the world that a direction of the plan points to.
fn facing(way: Way, frame: Frame) -> Facing {
    let [right, away] = frame.plan();
    let direction = match way {
        Way::Right => right,
        Way::Left => -right,
        Way::Away => away,
        Way::Towards => -away,
    };
    let found = Facing::HORIZONTAL.into_iter().find(|facing| facing.step() == direction);
    found.unwrap_or(Facing::North)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Turn, Up};

    /// The tops of a solid's columns, row by row from the front: the height of the full blocks, and then
    /// `_` for a slab, `>` and its like for stairs by the way they rise, `o` and `i` for corners.
    fn tops(slope: Slope, size: [i32; 3]) -> Vec<String> {
        let family = Family::of("oak").expect("oak is a material");
        let frame = Frame { up: Up::Y, turn: Turn::NONE };
        let scope = Scope::start(Cell::from(size), frame);
        let plan = Plan::of(&scope);
        let top = |u, v| {
            let column = column(slope, &family, [u, v], &plan);
            let cap = match column.cap {
                Cap::None => "",
                Cap::Slab => "_",
                Cap::Stairs { uphill: Way::Right } => ">",
                Cap::Stairs { uphill: Way::Left } => "<",
                Cap::Stairs { uphill: Way::Away } => "^",
                Cap::Stairs { uphill: Way::Towards } => "v",
                Cap::OuterCorner(_) => "o",
                Cap::InnerCorner(_) => "i",
            };
            format!("{}{cap}", column.full)
        };
        let row = |v| (0..size[0]).map(|u| top(u, v)).collect::<Vec<_>>().join(" ");
        (0..size[2]).map(row).collect()
    }

    #[test]
    fn a_gable_of_pitch_one_is_laid_in_stairs() {
        assert_eq!(tops(Slope::Gable, [1, 2, 4]), ["0^", "1^", "1v", "0v"]);
        assert_eq!(tops(Slope::Gable, [1, 3, 5]), ["0^", "1^", "2_", "1v", "0v"]);
    }

    #[test]
    fn steps_of_two_blocks_are_level_at_the_back() {
        assert_eq!(tops(Slope::RightAngleTriangle, [5, 4, 1]), ["3< 2< 2 1< 0<"]);
    }

    #[test]
    fn a_corner_bends_on_its_diagonal() {
        assert_eq!(tops(Slope::Corner, [3, 3, 3]), ["0o 0^ 0^", "0> 1o 1^", "0> 1> 2o"]);
        assert_eq!(tops(Slope::Trough, [3, 3, 3]), ["0i 1> 2>", "1^ 1i 2>", "2^ 2^ 2i"]);
    }

    #[test]
    fn a_corner_of_two_pitches_bends_where_its_steps_are_level() {
        assert_eq!(
            tops(Slope::Corner, [5, 4, 4]),
            ["0o 0^ 0^ 0^ 0^", "0> 1o 1^ 1^ 1^", "0> 1> 2 2o 2^", "0> 1> 2 2> 3o"]
        );
    }

    #[test]
    fn the_ridge_of_a_steep_hip_is_straight() {
        assert_eq!(
            tops(Slope::Hip, [7, 3, 4]),
            ["0o 0^ 0^ 0^ 0^ 0^ 0o", "0> 2o 2^ 2^ 2^ 2o 0<", "0> 2o 2v 2v 2v 2o 0<", "0o 0v 0v 0v 0v 0v 0o"]
        );
    }

    #[test]
    fn a_hip_of_one_pitch_goes_all_around() {
        assert_eq!(tops(Slope::Hip, [4, 2, 4]), ["0o 0^ 0^ 0o", "0> 1o 1o 0<", "0> 1o 1o 0<", "0o 0v 0v 0o"]);
    }
}
