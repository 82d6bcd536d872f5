//! Ending a random production so that its blocks stand beside one another only as in the examples.

use super::derivation::{Application, Derivation, result};
use super::grammar::ShapeGrammar;
use super::grow::{Growth, may_stand};
use super::production::{Placed, Production};
use crate::space::Cell;
use std::collections::BTreeSet;

type Lows = BTreeSet<[i32; 3]>;

/// So many steps in a row may leave no fewer unseen neighbourhoods than ever before: a shape that is needed has borders
/// itself.
const PATIENCE: usize = 24;

/// Applies, at the shapes with unseen neighbourhoods, the rules that leave the fewest of them, until there is none, no rule
/// fits, or it gets no better; then takes away shapes that are part of one. Nothing at all may be left.
pub fn mend(
    grammar: &ShapeGrammar,
    production: &mut Production<'_>,
    derivation: &mut Derivation,
    growth: &Growth,
) {
    let mut unseen = grammar.seen.unseen(production);
    let (mut fewest, mut since) = (unseen.len(), 0);
    while !unseen.is_empty()
        && since < PATIENCE
        && let Some((step, placed, left)) = best(grammar, production, &unseen, growth)
    {
        production.push(placed);
        derivation.steps.push(step);
        since = if left.len() < fewest { 0 } else { since + 1 };
        fewest = fewest.min(left.len());
        unseen = left;
    }
    take_away(grammar, derivation);
}

/// The step at a shape with an unseen neighbourhood that leaves the fewest.
fn best(
    grammar: &ShapeGrammar,
    production: &mut Production<'_>,
    unseen: &Lows,
    growth: &Growth,
) -> Option<(Application, Placed, Lows)> {
    let mut best: Option<(Application, Placed, Lows)> = None;
    for shape in at_fault(production, unseen) {
        let rules: Vec<usize> =
            grammar.rules_of(production.placed()[shape].form).map(|(rule, _)| rule).collect();
        for rule in rules {
            let step = Application { shape, rule };
            let placed = result(grammar, production, step);
            let Some(placed) = placed.filter(|placed| may_stand(grammar, production, placed, growth)) else {
                continue;
            };
            let left = after(grammar, production, placed, unseen);
            if best.as_ref().is_none_or(|(_, _, fewest)| left.len() < fewest.len()) {
                best = Some((step, placed, left));
            }
        }
    }
    best
}

/// The unseen neighbourhoods after a shape is added: only those that hold one of its blocks change, unless it is below all
/// others.
fn after(grammar: &ShapeGrammar, production: &mut Production<'_>, placed: Placed, unseen: &Lows) -> Lows {
    let ground = |production: &Production<'_>| production.extent().map(|extent| extent.min.y);
    let before = ground(production);
    production.push(placed);
    let left = if ground(production) == before {
        let cells: BTreeSet<[i32; 3]> = production.blocks(&placed).map(|(cell, _)| cell.to_array()).collect();
        let is_near = |low: &&[i32; 3]| {
            cells
                .range([low[0], i32::MIN, i32::MIN]..=[low[0] + 1, i32::MAX, i32::MAX])
                .any(|cell| (0..3).all(|axis| (low[axis]..=low[axis] + 1).contains(&cell[axis])))
        };
        let mut left: Lows = unseen.iter().filter(|low| !is_near(low)).copied().collect();
        left.extend(grammar.seen.unseen_near(production, cells.iter().copied().map(Cell::from_array)));
        left
    } else {
        grammar.seen.unseen(production)
    };
    production.pop();
    left
}

/// The shapes with a block in one of the neighbourhoods.
fn at_fault(production: &Production<'_>, unseen: &Lows) -> Vec<usize> {
    let is_in =
        |cell: Cell| super::seams::CORNERS.cells().any(|step| unseen.contains(&(cell - step).to_array()));
    let placed = production.placed().iter().enumerate();
    placed
        .filter(|(_, placed)| production.blocks(placed).any(|(cell, _)| is_in(cell)))
        .map(|(index, _)| index)
        .collect()
}

/// Takes away the latest shape at fault of what is left in the end, one after the other.
fn take_away(grammar: &ShapeGrammar, derivation: &mut Derivation) {
    while let Ok(production) = derivation.production(grammar) {
        let unseen = grammar.seen.unseen(&production);
        let Some(last) = at_fault(&production, &unseen).pop() else { break };
        derivation.removed.push(production.number(last));
    }
}
