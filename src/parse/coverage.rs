//! What no rule explains. Where there is no derivation of a building, there is one that comes nearest: it gives a
//! building that differs in the fewest cells. An operation that fits nowhere may be left out, which counts as if all
//! cells of its scope differed. What the nearest building has in common with the target is explained.

use super::chart::{Choice, Rigour};
use super::derivation::{Derivation, Step};
use super::search::{Aim, Memory, Rules, Search};
use super::target::Target;
use crate::grid::Grid;
use crate::space::{Bounds, Cell, Scope};

/// Why there is no derivation.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Reason {
    #[error("no derivation of the grammar gives this building")]
    NoDerivation,
    #[error("no derivation was found within {0} steps")]
    TooManySteps(u64),
    #[error("the building has more than 65,536 block states")]
    PaletteFull,
}

/// What the grammar does not explain of a building.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unexplained {
    pub reason: Reason,
    /// Where the nearest derivation differs most: the scope of one operation, or the cells of it that differ.
    pub region: Bounds,
    /// All such places, those with most cells first.
    pub regions: Vec<Bounds>,
    /// How many cells that are not air the nearest derivation explains.
    pub explained: u64,
    /// How many cells are not air.
    pub cells: u64,
}

impl Unexplained {
    pub(super) fn unread(grid: &Grid) -> Unexplained {
        let cells = grid.cells().iter().filter(|id| **id != crate::block::Palette::AIR).count() as u64;
        let region = grid.bounds();
        Unexplained { reason: Reason::PaletteFull, region, regions: vec![region], explained: 0, cells }
    }

    /// The share of the cells that the grammar explains.
    pub fn coverage(&self) -> f64 {
        if self.cells == 0 { 1.0 } else { self.explained as f64 / self.cells as f64 }
    }
}

/// What the nearest derivation leaves open; all, if there is none.
pub fn unexplained(
    rules: &Rules<'_>,
    memory: &mut Memory,
    target: &Target<'_>,
    reason: Reason,
    nearest: Option<Derivation>,
) -> Unexplained {
    let cells = solid(target, target.bounds());
    let mut search = Search::new(rules, memory, target, (Rigour::Nearest, Aim::Cheapest), 0);
    let mut places: Vec<(u64, u64, Bounds)> = Vec::new();
    for step in nearest.iter().flat_map(|nearest| &nearest.steps) {
        if let Choice::Other(lost) = step.choice {
            let (lost_solid, region) = search.differing(step, lost);
            places.push((lost, lost_solid, region));
        }
    }
    places.sort_by_key(|(lost, _, region)| (std::cmp::Reverse(*lost), region.min.to_array()));
    let lost: u64 = places.iter().map(|(_, solid, _)| solid).sum();
    let regions: Vec<Bounds> = places.into_iter().map(|(_, _, region)| region).collect();
    let (explained, region) = match (&nearest, regions.first()) {
        (Some(_), Some(region)) => (cells.saturating_sub(lost), *region),
        _ => (0, target.bounds()),
    };
    Unexplained { reason, region, regions, explained, cells }
}

fn solid(target: &Target<'_>, bounds: Bounds) -> u64 {
    match target {
        Target::Blocks(blocks) => u64::from(blocks.solid(bounds)),
        Target::Boxes(boxes) => boxes.volume(bounds),
    }
}

impl Search<'_, '_> {
    /// How many of the cells in which a step differs are not air, and the box around them.
    fn differing(&mut self, step: &Step, lost: u64) -> (u64, Bounds) {
        let whole = step.scope.bounds;
        let around = self.seen_by(step.node, step.around);
        let is_cell_by_cell = self.leaf(step.node, around, &step.scope).is_some();
        let (Target::Blocks(_), true) = (self.target, is_cell_by_cell && lost < whole.volume()) else {
            return (solid(self.target, whole).min(lost), whole);
        };
        let mut count = 0;
        let mut region: Option<Bounds> = None;
        for cell in whole.cells() {
            let bounds = Bounds::new(cell, cell + Cell::ONE);
            let cost = self.leaf(step.node, around, &Scope { bounds, ..step.scope }).flatten();
            if cost.is_some_and(|cost| cost.lost > 0) {
                count += solid(self.target, bounds);
                region = Some(region.map_or(bounds, |region| region.union(&bounds)));
            }
        }
        (count, region.unwrap_or(whole))
    }
}
