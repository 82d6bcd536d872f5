//! The arguments that say how shapes are inferred.

use crate::shapes::{Cost, Operation, Overlap, Rest, Search, Settings, Specification};
use clap::ValueEnum;
use std::num::NonZeroU32;

#[derive(Clone, Debug, clap::Args)]
pub struct Shaping {
    /// Which sets of blocks may be a shape
    #[arg(long, value_enum, default_value_t)]
    spec: SpecArg,
    /// What a search does with shapes
    #[arg(long, value_enum, default_value_t)]
    operation: OperationArg,
    /// What each shape costs against a bit of entropy: the more, the fewer and larger the shapes
    #[arg(long, default_value = "1", value_parser = alpha, allow_negative_numbers = true)]
    alpha: f64,
    /// What a set of shapes costs
    #[arg(long, value_enum, default_value_t)]
    cost: CostArg,
    /// Let shapes share blocks
    #[arg(long)]
    overlap: bool,
    /// How far a search looks beyond the first set that no step makes cheaper
    #[arg(long, value_enum, default_value_t)]
    search: SearchArg,
    /// How often a search goes on: climbs, or steps for each block
    #[arg(long, value_name = "N", default_value = "20")]
    effort: NonZeroU32,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum SpecArg {
    /// Filled rectangles in one plane
    #[default]
    Rectangular,
    /// Connected blocks in one plane
    #[value(name = "2d")]
    Planar,
    /// Connected blocks
    #[value(name = "3d")]
    Solid,
    /// Of all these, for each part what costs least
    Mixed,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum OperationArg {
    /// Join shapes, from single blocks on
    #[default]
    Merge,
    /// Divide shapes, from the largest on
    Split,
    /// Whichever lowers the cost more, from single blocks on
    Both,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum CostArg {
    /// (1 + number)^alpha times the sum of entropies, as the paper has it
    Paper,
    /// (1 + number) times alpha, plus the sum of entropies, as the authors' program has it
    #[default]
    Additive,
    /// As additive, with each entropy times the number of block types
    Varied,
    /// As additive, with shapes that look alike counted once
    Alike,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum SearchArg {
    /// Take the first step that does not raise the cost, until there is none
    #[default]
    Climb,
    /// Climb again, with the blocks in other orders
    Restarts,
    /// Break some shapes into blocks and climb again
    Backtracking,
    /// Take random steps, which may raise the cost, the less the later
    Annealing,
}

fn alpha(text: &str) -> Result<f64, String> {
    let alpha = text.parse::<f64>().ok().filter(|alpha| alpha.is_finite() && *alpha >= 0.0);
    alpha.ok_or_else(|| "expected a number, 0 or more".to_owned())
}

impl Shaping {
    /// The settings, with what becomes of blocks that no shape holds.
    pub fn settings(&self, rest: Rest, seed: u64) -> Settings {
        Settings {
            specification: match self.spec {
                SpecArg::Rectangular => Specification::Rectangular,
                SpecArg::Planar => Specification::Planar,
                SpecArg::Solid => Specification::Solid,
                SpecArg::Mixed => Specification::Mixed,
            },
            operation: match self.operation {
                OperationArg::Merge => Operation::Merge,
                OperationArg::Split => Operation::Split,
                OperationArg::Both => Operation::Both,
            },
            cost: match self.cost {
                CostArg::Paper => Cost::Paper,
                CostArg::Additive => Cost::Additive,
                CostArg::Varied => Cost::Varied,
                CostArg::Alike => Cost::Alike,
            },
            alpha: self.alpha,
            overlap: if self.overlap { Overlap::Shared } else { Overlap::Apart },
            rest,
            search: match self.search {
                SearchArg::Climb => Search::Climb,
                SearchArg::Restarts => Search::Restarts(self.effort),
                SearchArg::Backtracking => Search::Backtracking(self.effort),
                SearchArg::Annealing => Search::Annealing(self.effort),
            },
            seed,
        }
    }
}
