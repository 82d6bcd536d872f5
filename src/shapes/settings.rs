//! How shapes are inferred.

use std::num::NonZeroU32;

/// Which sets of blocks may be a shape (seed 3, "Definitions").
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Specification {
    /// Filled rectangles in one plane.
    #[default]
    Rectangular,
    /// Connected blocks in one plane: 2D shapes.
    Planar,
    /// Connected blocks: 3D shapes.
    Solid,
    /// Of all three, for each part of a building what costs least (seed 3, "SIGI and Related Work").
    Mixed,
}

/// The steps that a search takes (seed 3, "Local search").
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Operation {
    /// From single blocks, two shapes become one.
    #[default]
    Merge,
    /// From the largest shapes, one becomes two.
    Split,
    /// From single blocks, whichever of the first merge and the first split lowers the cost more.
    Both,
}

/// What a set of shapes costs. `n` is their number, `H` the entropy of a shape in bits, `e` is [`LEAST`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Cost {
    /// `(1 + n)^alpha * sum(H + e)`: equation 4 of seed 3. As printed, without `e`, any number of shapes of one block
    /// type each would cost nothing, and a search from single blocks would end where it begins.
    Paper,
    /// `(1 + n) * (alpha + e) + sum(H + e)`: what the authors' program computes.
    #[default]
    Additive,
    /// As additive, with the entropy of each shape times the number of its block types: the program's second cost.
    Varied,
    /// As additive, with shapes that are alike counted once: the program's third cost.
    Alike,
}

/// What is left of an entropy of zero, so that fewer shapes cost less.
pub const LEAST: f64 = 1e-5;

/// Whether shapes may share blocks.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Overlap {
    #[default]
    Apart,
    Shared,
}

/// What becomes of blocks that no shape holds, where shapes may not share blocks: the largest shapes are kept, and those
/// that cross them are not.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Rest {
    /// They are in no shape, as in the authors' program.
    Left,
    /// They are searched for shapes again, until every block is in one.
    #[default]
    Searched,
}

/// How far a search looks beyond the first set that no step makes cheaper.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Search {
    /// Hill climbing that takes the first step that does not raise the cost (seed 3, "Local search").
    #[default]
    Climb,
    /// Climbs so many more times, each with the blocks in another order.
    Restarts(NonZeroU32),
    /// Breaks some shapes of the best set into blocks and climbs again, so many times.
    Backtracking(NonZeroU32),
    /// Steps at random, which may raise the cost, the less the later; so many for each block. Then climbs.
    Annealing(NonZeroU32),
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Settings {
    pub specification: Specification,
    pub operation: Operation,
    pub cost: Cost,
    /// What each shape costs, against a bit of entropy. Finite and not negative.
    pub alpha: f64,
    pub overlap: Overlap,
    pub rest: Rest,
    pub search: Search,
    /// Of searches that draw.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            specification: Specification::default(),
            operation: Operation::default(),
            cost: Cost::default(),
            alpha: 1.0,
            overlap: Overlap::default(),
            rest: Rest::default(),
            search: Search::default(),
            seed: 0,
        }
    }
}
