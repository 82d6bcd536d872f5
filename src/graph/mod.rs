//! The op graph: operations as nodes, ordered edges that carry sizes and weights, on petgraph.
//! Lowering from a grammar, raising back to one, equality, simplification and dot output.
//! Knows nothing of grids or files.

mod build;
mod constants;
mod dot;
mod expr;
mod lower;
mod op;
mod raise;
mod settings;
mod unify;

pub use build::Builder;
pub use dot::dot;
pub use expr::{Expr, Number, Thing};
pub use lower::{BadStart, lower};
pub use op::{
    Alternative, Arg, Attribute, Constant, Group, Op, OpGraph, Origin, RuleName, Size, StartSize, Style,
};
pub use petgraph::graph::NodeIndex;
pub use raise::raise;
pub use settings::BadSetting;
pub use unify::Renumbered;
