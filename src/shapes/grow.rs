//! Growing buildings at random (seed 3, "Production of Similar Structures").

use super::derivation::{Application, Derivation, Enclosure, result};
use super::grammar::ShapeGrammar;
use super::production::{Placed, Production};
use super::{enclosure, mend};
use crate::space::{Bounds, Cell};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What must hold of blocks that stand beside one another.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Adjacency {
    #[default]
    Ignored,
    /// Every 2x2x2 neighbourhood is one of an example, as it is or turned.
    Enforced,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Growth {
    /// How many rules are applied.
    pub steps: usize,
    pub enclosure: Enclosure,
    pub adjacency: Adjacency,
    /// The most blocks along each axis.
    pub most: Cell,
    pub seed: u64,
}

/// So often a step is drawn again that cannot be taken, before the building is taken for finished.
const TRIES: usize = 200;

/// So many buildings are grown where something must hold of them, and the best is taken.
const ATTEMPTS: usize = 16;

/// A building of so many random steps, or fewer where none fits any more. The first shape is drawn as well. Where enclosure or
/// adjacency are enforced, little may be left of a building: of several, the one is taken that encloses most, or that has
/// most blocks where none encloses anything. That one may still be nothing.
///
/// # Panics
/// If the grammar has no shapes.
pub fn grow(grammar: &ShapeGrammar, growth: &Growth) -> Derivation {
    let mut random = Pcg64Mcg::seed_from_u64(growth.seed);
    let is_free = growth.enclosure == Enclosure::Ignored && growth.adjacency == Adjacency::Ignored;
    let attempts = if is_free || growth.steps == 0 { 1 } else { ATTEMPTS };
    let grown = (0..attempts).map(|_| grow_once(grammar, growth, &mut random));
    let grown: Vec<Derivation> = grown.collect();
    // The first of those that are as good.
    let best = grown.into_iter().rev().max_by_key(|derivation| worth(grammar, derivation));
    best.expect("one attempt is made at least")
}

/// Enclosed places and blocks.
fn worth(grammar: &ShapeGrammar, derivation: &Derivation) -> (usize, usize) {
    let production = derivation.production(grammar);
    production.map_or((0, 0), |production| (enclosure::enclosed(&production), production.len()))
}

fn grow_once(grammar: &ShapeGrammar, growth: &Growth, random: &mut Pcg64Mcg) -> Derivation {
    let start = random.random_range(0..grammar.parts.parts.len());
    let mut derivation = Derivation { start, enclosure: growth.enclosure, ..Derivation::default() };
    let mut production = Production::new(&grammar.parts);
    production.push(grammar.start(start));
    while derivation.steps.len() < growth.steps
        && let Some((step, placed)) = draw(grammar, &mut production, growth, random)
    {
        production.push(placed);
        derivation.steps.push(step);
    }
    if growth.adjacency == Adjacency::Enforced {
        mend::mend(grammar, &mut production, &mut derivation, growth);
    }
    derivation
}

/// A step that fits, if one is drawn in time: any shape, and any rule that applies to it.
fn draw(
    grammar: &ShapeGrammar,
    production: &mut Production<'_>,
    growth: &Growth,
    random: &mut Pcg64Mcg,
) -> Option<(Application, Placed)> {
    (0..TRIES).find_map(|_| {
        let shape = random.random_range(0..production.placed().len());
        let rules: Vec<usize> =
            grammar.rules_of(production.placed()[shape].form).map(|(rule, _)| rule).collect();
        let step = Application { shape, rule: *rules.choose(random)? };
        let placed = result(grammar, production, step)?;
        may_stand(grammar, production, &placed, growth).then_some((step, placed))
    })
}

/// Whether a shape can be added: it fits, keeps to the size, and where adjacency is enforced, spoils nothing for good.
pub fn may_stand(
    grammar: &ShapeGrammar,
    production: &mut Production<'_>,
    placed: &Placed,
    growth: &Growth,
) -> bool {
    if !production.fits(placed) || !is_within(production, placed, growth.most) {
        return false;
    }
    if growth.adjacency == Adjacency::Ignored {
        return true;
    }
    production.push(*placed);
    let cells = production.blocks(placed).map(|(cell, _)| cell);
    let may_become = grammar.seen.may_become(production, cells);
    production.pop();
    may_become
}

/// Whether a production keeps to a size when a shape is added.
pub fn is_within(production: &Production<'_>, placed: &Placed, most: Cell) -> bool {
    let Some(extent) = production.extent() else { return true };
    let added = Bounds::around(production.blocks(placed).map(|(cell, _)| cell));
    let all = added.map_or(extent, |added| extent.union(&added));
    all.size().cmple(most).all()
}
