//! Shapes learnt from buildings, and new buildings grown from them: SIGI (seed 3).
//!
//! ```text
//! Grid --Building::of--> Building --infer--> ShapeSet --rules--> ShapeGrammar --grow--> Grid
//! ```

mod alike;
mod building;
mod choose;
mod cost;
mod cut;
mod derivation;
mod enclosure;
mod grammar;
mod graph;
mod grow;
mod hold;
mod layer;
mod mend;
mod paint;
mod part;
mod price;
mod production;
mod seams;
mod search;
mod settings;
mod shape;
mod statistics;
mod tally;

pub use building::{Block, Building};
pub use cost::cost;
pub use cut::cut;
pub use derivation::{Application, BadDerivation, Derivation, Enclosure, grid, result};
pub use grammar::{Rule, ShapeGrammar};
pub use graph::dot;
pub use grow::{Adjacency, Growth, grow, is_within};
pub use layer::Layer;
pub use paint::{Spread, colors, paint};
pub use part::{Form, FormId, Part, Parts, Placement};
pub use production::{Placed, Production};
pub use search::{search, search_in};
pub use settings::{Cost, LEAST, Operation, Overlap, Rest, Search, Settings, Specification};
pub use shape::Shape;
pub use statistics::Statistics;
