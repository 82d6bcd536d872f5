//! A derivation as a list of its steps.

use super::chart::{Choice, Found, Piece, Rigour};
use super::search::Search;
use super::surroundings::Around;
use crate::graph::{NodeIndex, Op};
use crate::space::{Bounds, Cell, Scope};
use std::sync::Arc;

/// One way to derive a building.
#[derive(Clone, PartialEq, Debug)]
pub struct Derivation {
    /// What it takes to say the draws: the lower, the likelier.
    pub bits: f64,
    /// Each operation before those inside it.
    pub steps: Vec<Step>,
}

impl Derivation {
    /// How many cells are other than the derivation says.
    pub fn lost(&self) -> u64 {
        let lost = |step: &Step| if let Choice::Other(lost) = step.choice { lost } else { 0 };
        self.steps.iter().map(lost).sum()
    }
}

/// An operation that runs, and where.
#[derive(Clone, PartialEq, Debug)]
pub struct Step {
    pub node: NodeIndex,
    pub scope: Scope,
    /// How many operations it is inside of.
    pub depth: u32,
    pub choice: Choice,
    pub(super) around: Around,
}

impl Step {
    /// The same step elsewhere.
    pub(super) fn moved(self, by: Cell) -> Step {
        let Bounds { min, max } = self.scope.bounds;
        Step { scope: Scope { bounds: Bounds::new(min + by, max + by), ..self.scope }, ..self }
    }
}

impl Found {
    /// Whether the operations inside have to be looked for anew: each sees what those over it leave.
    fn is_overlaid(&self, op: &Op) -> bool {
        matches!(op, Op::All | Op::Carve { .. }) && self.choice == Choice::Only && self.pieces.is_empty()
    }
}

/// Steps of a derivation that are listed, at the most.
const MOST_STEPS: usize = 1 << 24;

impl Search<'_, '_> {
    /// Lists the steps of what was found from a node on.
    pub fn steps(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Vec<Step> {
        let mut steps = Vec::new();
        let mut open = vec![(node, around, *scope, 0)];
        while let Some((node, around, scope, depth)) = open.pop() {
            if scope.is_empty() || steps.len() >= MOST_STEPS {
                continue;
            }
            let found = self.found(node, around, &scope);
            let choice = found.as_ref().map_or(Choice::Only, |found| found.choice.clone());
            steps.push(Step { node, scope, depth, choice, around });
            if found.as_ref().is_some_and(|found| found.is_overlaid(self.rules.graph.op(node))) {
                let inside = self.overlaid_steps(node, around, &scope).into_iter();
                steps.extend(inside.map(|step| Step { depth: step.depth + depth + 1, ..step }));
            }
            let pieces: &[Piece] = found.as_ref().map_or(&[], |found| &found.pieces);
            open.extend(
                pieces.iter().rev().map(|piece| (piece.node, piece.around, piece.scope(&scope), depth + 1)),
            );
        }
        steps
    }

    /// What was found for a part that was solved.
    fn found(&mut self, node: NodeIndex, around: Around, scope: &Scope) -> Option<Arc<Found>> {
        let around = self.seen_by(node, around);
        if let Some(cost) = self.leaf(node, around, scope) {
            let lost = cost.map_or(0, |cost| cost.lost);
            let choice = if lost > 0 { Choice::Other(lost) } else { Choice::Only };
            return Some(Arc::new(Found { cost: cost?, choice, pieces: Box::new([]) }));
        }
        let rigours = match self.rigour {
            Rigour::Exact => [Rigour::Exact; 2],
            Rigour::Nearest => [Rigour::Exact, Rigour::Nearest],
        };
        let key = self.key(node, around, scope);
        rigours.into_iter().find_map(|rigour| self.memory.chart.found(&super::chart::Key { rigour, ..key }))
    }
}
