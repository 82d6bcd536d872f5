//! Which operations led to a place in a derivation, and how often each ran, for those who look on.

use crate::graph::{NodeIndex, OpGraph};
use crate::space::Scope;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Looks on at a derivation.
pub trait Observer {
    /// Sees an operation run, and gives back what the operations behind it have as their trail.
    fn step(&mut self, step: Step) -> Trail;
}

/// One operation that ran.
#[derive(Clone, Debug)]
pub struct Step {
    pub node: NodeIndex,
    /// Which child of the operation before it this is.
    pub number: u32,
    pub scope: Scope,
    pub before: Trail,
}

/// The operations that led to a place, the last first; none where nobody keeps them. A trail lives as long as what
/// follows from it, so that the memory of all is bounded by what is open and what is asked for.
#[derive(Clone, Debug, Default)]
pub struct Trail(Option<Rc<Step>>);

impl Trail {
    pub fn of(step: Step) -> Trail {
        Trail(Some(Rc::new(step)))
    }

    /// The steps, the last first.
    pub fn steps(&self) -> impl Iterator<Item = &Step> {
        std::iter::successors(self.0.as_deref(), |step| step.before.0.as_deref())
    }
}

/// A long trail ends step by step, without a stack as deep as it is long.
impl Drop for Trail {
    fn drop(&mut self) {
        while let Some(step) = self.0.take() {
            match Rc::try_unwrap(step) {
                Ok(mut step) => self.0 = step.before.0.take(),
                Err(_) => return,
            }
        }
    }
}

/// Counts how often each operation runs.
#[derive(Debug)]
pub struct Labels<'g> {
    graph: &'g OpGraph,
    times: Vec<u64>,
}

impl<'g> Labels<'g> {
    pub fn new(graph: &'g OpGraph) -> Labels<'g> {
        Labels { graph, times: vec![0; graph.len()] }
    }

    /// How often each label was derived. One that is only another name of a label is not told apart from it.
    pub fn counts(&self) -> BTreeMap<&'g str, u64> {
        let mut counts = BTreeMap::new();
        for node in self.graph.nodes() {
            if let Some(name) = self.graph.name(node) {
                *counts.entry(name.label.as_str()).or_insert(0) += self.times[node.index()];
            }
        }
        counts
    }
}

impl Observer for Labels<'_> {
    fn step(&mut self, step: Step) -> Trail {
        self.times[step.node.index()] += 1;
        Trail::default()
    }
}
