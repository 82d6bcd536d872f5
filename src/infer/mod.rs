//! Inference: examples become an op graph. Knows nothing of running grammars or of files.
//!
//! ```text
//! Grid --cuboids--> boxes of one block state --split_boxes--> Tree --combine--> Kinds --emit--> OpGraph
//!   \--exchanges--> planes where examples can be exchanged ------------------------/
//! ```

pub mod boxes;
mod combine;
pub mod cuboids;
mod derivable;
mod emit;
mod example;
mod exchange;
mod fold;
mod law;
mod naming;
pub mod tree;
mod variety;

use crate::graph::OpGraph;
use combine::Slab;
use std::collections::BTreeMap;

pub use boxes::{BadBoxes, PLAN_FIRST, Turns, UPRIGHT_FIRST, split_boxes};
pub use cuboids::cuboids;
pub use derivable::{Derivable, derivable};
pub use example::{Example, Terminal, Terminals};
pub use tree::{Node, NodeId, Part, Tree, TreeBuilder};
pub use variety::variety;

/// Why nothing could be learnt.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum InferError {
    #[error("there is no example to learn from")]
    NoExample,
    #[error("the example is empty: it holds nothing but air")]
    Empty { example: usize },
    #[error("{problem}")]
    Boxes { example: usize, problem: BadBoxes },
    #[error("some examples are blocks and some are labelled boxes: learn from one kind at a time")]
    Mixed { example: usize },
}

impl InferError {
    /// The number of the example that the error is about, from 0.
    pub fn example(&self) -> Option<usize> {
        match self {
            InferError::NoExample => None,
            InferError::Empty { example }
            | InferError::Boxes { example, .. }
            | InferError::Mixed { example } => Some(*example),
        }
    }
}

/// The label that each constant of a learnt graph stands for, by the constant's name.
pub type Labels = BTreeMap<String, String>;

/// What was learnt.
#[derive(Clone, Debug)]
pub struct Learnt {
    pub graph: OpGraph,
    pub labels: Labels,
}

/// Learns one op graph from all examples by the method of seed 1 (chapters 9 and 10): split each into its
/// terminals, then make one operation of what is equal or differs in size only. Examples of blocks that
/// have one size are first cut at the planes where they can be exchanged.
///
/// The graph derives every example; [`derivable`] proves it.
pub fn infer(examples: &[Example]) -> Result<Learnt, InferError> {
    let examples: &[Example] = &examples.iter().map(Example::open).collect::<Vec<_>>();
    let first = examples.first().ok_or(InferError::NoExample)?;
    let mut terminals = Terminals::default();
    let exchanges = exchange::exchanges(examples, &mut terminals);
    let mut slabs = Vec::new();
    for (number, example) in examples.iter().enumerate() {
        if example.is_empty() {
            return Err(InferError::Empty { example: number });
        }
        if std::mem::discriminant(example) != std::mem::discriminant(first) {
            return Err(InferError::Mixed { example: number });
        }
        let boxes = example.boxes(&mut terminals);
        let group = exchanges.iter().find(|group| group.members.contains(&number));
        for bounds in group.map_or_else(Vec::new, |group| group.slabs(example.bounds())) {
            let tree = example.tree(bounds, &boxes);
            let tree = tree.map_err(|problem| InferError::Boxes { example: number, problem })?;
            slabs.push(Slab { example: number, bounds, tree });
        }
    }
    let chance = match first {
        Example::Blocks(_) => combine::Chance::Bodies,
        Example::Boxes(_) => combine::Chance::Anywhere,
    };
    let kinds = combine::combine(&slabs, chance);
    Ok(emit::emit(&kinds, &exchanges, &terminals, examples))
}
