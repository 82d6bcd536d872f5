//! Inference: examples become an op graph. Knows nothing of running grammars or of files.
//!
//! ```text
//! Grid --cuboids--> boxes of one block state --split_boxes--> Tree --combine--> Kinds --emit--> OpGraph
//! ```

pub mod boxes;
mod combine;
pub mod cuboids;
mod derivable;
mod emit;
mod example;
mod fold;
mod law;
mod naming;
pub mod tree;

use crate::graph::OpGraph;

pub use boxes::{BadBoxes, split_boxes};
pub use cuboids::cuboids;
pub use derivable::{Derivable, derivable};
pub use example::{Example, Terminal, Terminals};
pub use tree::{Node, NodeId, Part, Tree, TreeBuilder};

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

/// Learns one op graph from all examples by the method of seed 1 (chapters 9 and 10): split each into its
/// terminals, then make one operation of what is equal or differs in size only.
///
/// The graph derives every example; [`derivable`] proves it.
pub fn infer(examples: &[Example]) -> Result<OpGraph, InferError> {
    let mut terminals = Terminals::default();
    let mut trees = Vec::with_capacity(examples.len());
    for (number, example) in examples.iter().enumerate() {
        if example.is_empty() {
            return Err(InferError::Empty { example: number });
        }
        if std::mem::discriminant(example) != std::mem::discriminant(&examples[0]) {
            return Err(InferError::Mixed { example: number });
        }
        let tree = example.tree(&mut terminals);
        let tree = tree.map_err(|problem| InferError::Boxes { example: number, problem })?;
        trees.push((tree, example.bounds()));
    }
    let chance = match examples.first() {
        None => return Err(InferError::NoExample),
        Some(Example::Blocks(_)) => combine::Chance::Bodies,
        Some(Example::Boxes(_)) => combine::Chance::Anywhere,
    };
    let kinds = combine::combine(&trees, chance);
    Ok(emit::emit(&kinds, &terminals, examples))
}
