//! What of some buildings a grammar explains.

use crate::grid::Grid;
use crate::parse::{Derivation, Parser, Unexplained};

/// The cheapest derivation of each of some buildings, or what there is of one.
#[derive(Clone, Debug, Default)]
pub struct Explained {
    of_each: Vec<Result<Derivation, Unexplained>>,
}

impl Explained {
    pub fn of(parser: &Parser<'_>, buildings: &[Grid]) -> Explained {
        Explained { of_each: buildings.iter().map(|grid| parser.parse(grid)).collect() }
    }

    /// How many are reproduced, block for block.
    pub fn reproduced(&self) -> usize {
        self.derivations().count()
    }

    /// The derivations of those that are reproduced.
    pub fn derivations(&self) -> impl Iterator<Item = &Derivation> {
        self.of_each.iter().filter_map(|one| one.as_ref().ok())
    }

    /// The bits of all derivations; `None` unless every building is reproduced.
    pub fn bits(&self) -> Option<f64> {
        self.of_each.iter().map(|one| one.as_ref().ok().map(|derivation| derivation.bits)).sum()
    }

    /// The share of the cells that is explained, air left out, on average over the buildings. All of none.
    pub fn coverage(&self) -> f64 {
        let shares = self.of_each.iter().map(|one| one.as_ref().map_or_else(Unexplained::coverage, |_| 1.0));
        match self.of_each.len() {
            0 => 1.0,
            count => shares.sum::<f64>() / count as f64,
        }
    }
}
