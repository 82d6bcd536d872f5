//! Slopes on the block grid: where a roof's surface lies over each cell of its plan.

/// How a solid rises over its plan. The plan's first direction runs to the right, its second away from
/// the front; the shapes are those of seed 1's roofs (sections 7.1 and 7.2).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Slope {
    /// Ridge from left to right.
    Gable,
    /// Falls to the right from its high left end.
    RightAngleTriangle,
    /// The corner of a hip: highest at the right and the back.
    Corner,
    /// The valley between two slopes: lowest at the left and the front.
    Trough,
    /// Rises from all four sides at one pitch, to a ridge along the longer axis.
    Hip,
    /// Rises from all four sides to a point.
    Pyramid,
}

/// A direction in the plan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Way {
    Right,
    Left,
    Away,
    Towards,
}

/// The surface over one cell of a slope: a height in blocks, and where it rises to.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rise {
    pub height: f64,
    /// Blocks up a block on.
    pub pitch: f64,
    /// `None` on a ridge.
    pub uphill: Option<Way>,
}

impl Rise {
    /// The index of the topmost block that the surface touches.
    pub fn top(self) -> i32 {
        top(self.height)
    }

    /// Whether the block downhill has the same top. Below a pitch of 1 some steps are two blocks deep:
    /// the upper block of such a step is level.
    pub fn is_level(self) -> bool {
        self.height > self.pitch && top(self.height - self.pitch) == self.top()
    }
}

fn top(height: f64) -> i32 {
    ((height - 1e-6).ceil() as i32 - 1).max(0)
}

/// The surface over one cell of a plan. Two slopes meet where their topmost blocks are level; the first of
/// the two is the surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Surface {
    Plain(Rise),
    /// Two slopes meet on an outward edge, as on a hip.
    Hip(Rise, Rise),
    /// Two slopes meet in a valley.
    Valley(Rise, Rise),
}

impl Slope {
    /// The surface over cell (`u`, `v`) of a plan of `lu` by `lv`, for a solid `lw` high.
    pub fn surface(self, [u, v]: [i32; 2], [lu, lv]: [i32; 2], lw: i32) -> Surface {
        let full = |at, length, way| ramp(at, f64::from(length), lw, way);
        let (right, away) = (full(u, lu, Way::Right), full(v, lv, Way::Away));
        match self {
            Slope::RightAngleTriangle => Surface::Plain(full(lu - 1 - u, lu, Way::Left)),
            Slope::Corner => lower(right, away),
            Slope::Trough => higher(right, away),
            Slope::Gable => Surface::Plain(folded(v, lv, lv, lw, [Way::Away, Way::Towards])),
            Slope::Hip | Slope::Pyramid => {
                let run = lu.min(lv);
                let runs = if self == Slope::Hip { [run, run] } else { [lu, lv] };
                lower(
                    folded(u, lu, runs[0], lw, [Way::Right, Way::Left]),
                    folded(v, lv, runs[1], lw, [Way::Away, Way::Towards]),
                )
            }
        }
    }
}

/// A slope that rises by `high` over `run` cells, over the cell `at` from its foot. It goes on
/// rising behind them: there the other slopes of a hip are the lower ones.
fn ramp(at: i32, run: f64, high: i32, way: Way) -> Rise {
    let pitch = f64::from(high) / run;
    Rise { height: (f64::from(at) + 0.5) * pitch, pitch, uphill: Some(way) }
}

/// Two slopes that rise from both ends of `length` over half of `run` each.
fn folded(at: i32, length: i32, run: i32, high: i32, [up, down]: [Way; 2]) -> Rise {
    let from_end = length - 1 - at;
    let rise = |at, way| ramp(at, f64::from(run) / 2.0, high, way);
    match at.cmp(&from_end) {
        std::cmp::Ordering::Less => rise(at, up),
        std::cmp::Ordering::Greater => rise(from_end, down),
        std::cmp::Ordering::Equal => Rise { uphill: None, ..rise(at, up) },
    }
}

fn lower(a: Rise, b: Rise) -> Surface {
    let (low, high) = if a.height <= b.height { (a, b) } else { (b, a) };
    if low.top() == high.top() { Surface::Hip(low, high) } else { Surface::Plain(low) }
}

fn higher(a: Rise, b: Rise) -> Surface {
    let (low, high) = if a.height <= b.height { (a, b) } else { (b, a) };
    if low.top() == high.top() { Surface::Valley(high, low) } else { Surface::Plain(high) }
}
