use super::ObjProblem;

/// How many blocks one unit of an OBJ file is: positive and finite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Scale(f64);

/// Exporters write about six digits, so coordinates carry noise.
const TOLERANCE: f64 = 1e-3;

/// As far as the game's world goes.
const FARTHEST: f64 = 30_000_000.0;

/// Scales up to here are tried where the given one does not fit.
const LARGEST_ADVICE: u32 = 64;

impl Default for Scale {
    fn default() -> Scale {
        Scale(1.0)
    }
}

impl Scale {
    /// `None` where `blocks_per_unit` is not positive or not finite.
    pub fn new(blocks_per_unit: f64) -> Option<Scale> {
        (blocks_per_unit > 0.0 && blocks_per_unit.is_finite()).then_some(Scale(blocks_per_unit))
    }

    pub fn blocks_per_unit(self) -> f64 {
        self.0
    }

    /// The whole number of blocks that `value` is up to noise. `all` is asked for a better scale.
    pub(super) fn snap(self, value: f64, all: impl Fn() -> Vec<f64>) -> Result<i32, ObjProblem> {
        let scaled = value * self.0;
        if scaled.abs() > FARTHEST {
            return Err(ObjProblem::TooFar(value));
        }
        match self.fits(value) {
            true => Ok(scaled.round() as i32),
            false => Err(ObjProblem::OffGrid { value, scaled, scale: self.0, fitting: fitting(&all()) }),
        }
    }

    fn fits(self, value: f64) -> bool {
        let scaled = value * self.0;
        (scaled - scaled.round()).abs() <= TOLERANCE
    }
}

/// The least whole scale that makes all values whole.
fn fitting(values: &[f64]) -> Option<u32> {
    (1..=LARGEST_ADVICE).find(|&scale| values.iter().all(|&value| Scale(scale.into()).fits(value)))
}
