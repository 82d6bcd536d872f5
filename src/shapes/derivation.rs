//! How a building is grown: which shape it begins with, and which rules are applied to which of its shapes.

use super::enclosure;
use super::grammar::ShapeGrammar;
use super::production::{Placed, Production};
use crate::block::PaletteFull;
use crate::grid::Grid;
use crate::space::Cell;

/// A rule applied to a shape of a production, both by number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Application {
    pub shape: usize,
    pub rule: usize,
}

/// What is kept of a production besides its steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Enclosure {
    /// All shapes.
    #[default]
    Ignored,
    /// Shapes that enclose something, and those that are open in the examples.
    Enforced,
}

/// A building as the choices that give it. The same grammar gives the same blocks.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Derivation {
    /// The shape of the examples that it begins with.
    pub start: usize,
    pub steps: Vec<Application>,
    /// Shapes that are taken away again at the end, by number.
    pub removed: Vec<usize>,
    pub enclosure: Enclosure,
}

/// A step that cannot be taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum BadDerivation {
    #[error("it begins with shape {0}, and the examples have {1}")]
    Start(usize, usize),
    #[error("step {0} does not fit these examples")]
    Step(usize),
    #[error("it takes away shape {0}, which is not there")]
    Removed(usize),
}

impl Derivation {
    /// The shapes that it gives in the end.
    pub fn production<'a>(&self, grammar: &'a ShapeGrammar) -> Result<Production<'a>, BadDerivation> {
        let mut production = self.production_as_chosen(grammar)?;
        remove(&mut production, &self.removed)?;
        if self.enclosure == Enclosure::Enforced {
            enclosure::enclose(&mut production);
        }
        if self.enclosure == Enclosure::Enforced || !self.removed.is_empty() {
            keep_largest(&mut production);
        }
        Ok(production)
    }

    /// The shapes that its steps give, before any is taken away.
    pub fn production_as_chosen<'a>(
        &self,
        grammar: &'a ShapeGrammar,
    ) -> Result<Production<'a>, BadDerivation> {
        let shapes = grammar.parts.parts.len();
        if self.start >= shapes {
            return Err(BadDerivation::Start(self.start, shapes));
        }
        let mut production = Production::new(&grammar.parts);
        production.push(grammar.start(self.start));
        for (number, step) in self.steps.iter().enumerate() {
            let placed = result(grammar, &production, *step).filter(|placed| production.fits(placed));
            production.push(placed.ok_or(BadDerivation::Step(number + 1))?);
        }
        Ok(production)
    }
}

/// The shape that a rule gives where it is applied; none if there is no such shape or rule, or the rule is of another form.
pub fn result(grammar: &ShapeGrammar, production: &Production<'_>, step: Application) -> Option<Placed> {
    let left = production.placed().get(step.shape)?;
    let rule = grammar.rules.get(step.rule).filter(|rule| rule.left == left.form)?;
    Some(grammar.right(rule, left))
}

fn remove(production: &mut Production<'_>, removed: &[usize]) -> Result<(), BadDerivation> {
    for number in removed {
        let index = production.index(*number).ok_or(BadDerivation::Removed(*number))?;
        production.remove(index);
    }
    Ok(())
}

/// Of shapes that touch one another, those with the most blocks: nothing floats beside a building.
pub fn keep_largest(production: &mut Production<'_>) {
    let groups = super::hold::groups(production);
    let size = |group: &Vec<usize>| -> usize {
        group.iter().map(|index| production.blocks(&production.placed()[*index]).count()).sum()
    };
    // The first of those that are as large.
    let Some(largest) = groups.iter().rev().max_by_key(|group| size(group)).cloned() else { return };
    for index in (0..production.placed().len()).rev() {
        if !largest.contains(&index) {
            production.remove(index);
        }
    }
}

/// The blocks of a production, from its low corner; air where nothing stands.
pub fn grid(production: &Production<'_>) -> Result<Grid, PaletteFull> {
    let Some(extent) = production.extent() else { return Ok(Grid::new(Cell::ZERO)) };
    let mut grid = Grid::new(extent.size());
    for placed in production.placed() {
        for (cell, state) in production.blocks(placed) {
            let id = grid.intern(production.parts().states.get(state))?;
            grid.set(cell - extent.min, id);
        }
    }
    Ok(grid)
}
