//! What sets of shapes cost, and which steps do not make them dearer.

use super::settings::{Cost, LEAST};
use super::tally::Tally;

/// A cost with its parameter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Price {
    pub cost: Cost,
    pub alpha: f64,
}

/// A set of shapes as its cost sees it.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Sum {
    /// The number of shapes.
    pub count: usize,
    /// What they measure in all.
    pub measure: f64,
}

impl Price {
    /// What the types of one shape add to a set, before the number of shapes counts.
    pub fn measure(self, tally: &Tally) -> f64 {
        let entropy = tally.entropy() + LEAST;
        if self.cost == Cost::Varied { entropy * tally.kinds() as f64 } else { entropy }
    }

    /// What one more shape costs, where that does not depend on the others.
    pub fn per_shape(self) -> f64 {
        self.alpha + LEAST
    }

    pub fn of(self, sum: Sum) -> f64 {
        let shapes = 1.0 + sum.count as f64;
        match self.cost {
            Cost::Paper => libm::pow(shapes, self.alpha) * sum.measure,
            _ => shapes * self.per_shape() + sum.measure,
        }
    }

    /// How much the cost rises by a step that leaves `count` shapes and changes the measure by `change`: told from the
    /// difference alone, without the sum over all shapes. Not for shapes that count once where they are alike.
    pub fn rise(self, sum: Sum, count: usize, change: f64) -> f64 {
        let scale = match self.cost {
            Cost::Paper => libm::pow(1.0 + count as f64, self.alpha),
            _ => 1.0,
        };
        scale * (change - self.room(sum, count))
    }

    /// The most that the measure may change by where `count` shapes are left, so that the cost does not rise.
    pub fn room(self, sum: Sum, count: usize) -> f64 {
        let [before, after] = [sum.count, count].map(|count| 1.0 + count as f64);
        match self.cost {
            Cost::Paper => sum.measure * (libm::pow(before / after, self.alpha) - 1.0),
            _ => (before - after) * self.per_shape(),
        }
    }
}
