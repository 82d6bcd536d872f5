//! What a person reads: names for rules and for materials, and comments.
//!
//! ```text
//! OpGraph --sights--> what the places of each operation have in common --+-----------> notes
//!    \-----rules----> which operations have rules of their own ----------+--labels--> OpGraph with names
//!                            \--roles--> materials and storeys, lifted to constants
//! ```

mod kinds;
mod labels;
mod materials;
mod notes;
mod phrases;
mod roles;
mod rules;
mod sights;
mod storeys;
mod words;

use super::{Example, Learnt};

pub use notes::Notes;

/// Gives names to what was learnt, and comments. What it derives stays the same.
pub fn name(learnt: Learnt, examples: &[Example]) -> Learnt {
    let Learnt { mut graph, labels, by, .. } = learnt;
    let sights = sights::sights(&graph, &labels, examples);
    let rules = rules::rules(&graph);
    storeys::lift(&mut graph, examples);
    materials::lift(&mut graph, &rules, examples);
    labels::label(&mut graph, &rules, &sights);
    let notes = notes::notes(&graph, &sights, examples, by);
    Learnt { graph, labels, by, is_proved: false, notes }
}
