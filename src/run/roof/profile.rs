/// A height over the plan, and how steep the roof is there in blocks up a block on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Surface {
    pub height: f64,
    pub pitch: f64,
}

/// How a slope rises from the eave to the ridge.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Profile {
    Straight,
    /// Steep up to `at`, a share of the way, and flat above; the ridge is as high as that of a straight slope.
    Bent {
        at: f64,
        /// The lower pitch, in pitches of the straight slope.
        lower: f64,
    },
}

/// The lower slope of a gambrel of pitch 1 is laid of two blocks up a block on, the upper one in slabs.
pub const GAMBREL: Profile = Profile::Bent { at: 1.0 / 3.0, lower: 2.0 };

pub const MANSARD: Profile = Profile::Bent { at: 0.3, lower: 2.5 };

/// Differences below this are noise of floating-point arithmetic.
const NOISE: f64 = 1e-6;

impl Surface {
    /// The surface `out` blocks inside the eave of a straight slope. Eaves are never steeper than a block down a block
    /// on, lest they fall off.
    pub fn slope(out: f64, pitch: f64) -> Surface {
        let pitch = if out < 0.0 { pitch.min(1.0) } else { pitch };
        Surface { height: pitch * out, pitch }
    }
}

impl Profile {
    /// The surface `out` blocks inside the eave, of a roof whose ridge is `run` blocks inside.
    pub fn at(self, out: f64, run: f64, pitch: f64) -> Surface {
        match self {
            Profile::Bent { at, lower } if out > at * run - NOISE => {
                let upper = (1.0 - lower * at) / (1.0 - at);
                let height = pitch * (lower * at * run + upper * (out - at * run));
                Surface { height, pitch: pitch * upper }
            }
            Profile::Bent { lower, .. } => Surface::slope(out, pitch * lower),
            Profile::Straight => Surface::slope(out, pitch),
        }
    }
}
