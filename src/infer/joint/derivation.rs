//! Which operations made a sample, each with its scope.

use crate::graph::NodeIndex;
use crate::run::{Observer, Step, Trail};
use crate::space::Bounds;

/// An operation that ran.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    pub node: NodeIndex,
    pub bounds: Bounds,
    /// Which child of the operation before it this is.
    pub number: usize,
    depth: usize,
}

/// The operations in the order in which they ran: what follows from one stands right behind it.
#[derive(Default, Debug)]
pub struct Derivation(Vec<Operation>);

/// The number of an operation in a derivation.
pub type At = usize;

impl Derivation {
    pub fn get(&self, at: At) -> Operation {
        self.0[at]
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The operation that was begun last.
    pub fn last(&self) -> Option<At> {
        self.0.len().checked_sub(1)
    }

    /// The last of the operations whose scopes hold a box and are the smallest to do so.
    pub fn innermost(&self, window: Bounds) -> Option<At> {
        let holding = (0..self.0.len()).filter(|at| self.0[*at].bounds.contains_box(&window));
        holding.min_by_key(|at| (self.0[*at].bounds.volume(), std::cmp::Reverse(*at)))
    }

    /// The operations that follow from one at once.
    pub fn children(&self, at: At) -> impl Iterator<Item = Operation> + '_ {
        let depth = self.0[at].depth;
        let within = self.0[at + 1..].iter().take_while(move |operation| operation.depth > depth);
        within.filter(move |operation| operation.depth == depth + 1).copied()
    }

    pub fn before(&self, at: At) -> Option<At> {
        (0..at).rev().find(|before| self.0[*before].depth + 1 == self.0[at].depth)
    }

    /// The operation and those that led to it, the last one first.
    pub fn from(&self, at: At) -> impl Iterator<Item = At> + '_ {
        std::iter::successors(Some(at), |at| self.before(*at))
    }
}

impl Observer for Derivation {
    fn step(&mut self, step: Step) -> Trail {
        let operation = Operation {
            node: step.node,
            bounds: step.scope.bounds,
            number: step.number as usize,
            depth: step.before.steps().count(),
        };
        self.0.push(operation);
        Trail::of(step)
    }
}
