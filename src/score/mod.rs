//! Scores: how good a grammar is, as numbers. Knows nothing of files.
//!
//! What each number means is in `docs/scores.md`.

mod agreement;
mod cells;
mod compressed;
mod distance;
mod explained;
mod length;
mod model;
mod novelty;
mod odd;
mod parts;
mod patterns;
mod rooms;
mod samples;
mod scores;
mod seams;
mod soundness;
mod template;

pub use agreement::{Agreement, agreement};
pub use cells::{AIR, Alphabet, Cells, OUTSIDE, settled};
pub use compressed::zlib_bits;
pub use distance::distance;
pub use explained::Explained;
pub use length::Length;
pub use model::model_bits;
pub use novelty::{Novelty, novelty};
pub use odd::Lengths;
pub use patterns::{Pattern, Patterns, Seams, Surroundings};
pub use rooms::Rooms;
pub use samples::Samples;
pub use scores::{Beside, Outline, Scores, outline, scores};
pub use seams::unseen_seams;
pub use soundness::Soundness;
pub use template::template_share;

/// What the tests of several scores take.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{OpGraph, lower};
    use crate::parse::{Derivation, Laws, Parser};
    use crate::run::{Library, Options, run};
    use crate::space::Cell;

    pub fn graph(text: &str) -> OpGraph {
        lower(&crate::grammar::read(text).unwrap(), None).unwrap().unified()
    }

    /// The derivation of what a grammar makes at each of these sizes.
    pub fn derivations(graph: &OpGraph, sizes: &[[i32; 3]]) -> Vec<Derivation> {
        let parser = Parser::new(graph, Laws::AsWritten);
        let of_size = |size: &[i32; 3]| {
            let options = Options { size: Some(Cell::from(*size)), ..Options::default() };
            parser.parse(&run(graph, &Library::new(), &options).unwrap().made).unwrap()
        };
        sizes.iter().map(of_size).collect()
    }

    #[test]
    fn a_grammar_scores_well_beside_its_own_samples() {
        let hut = graph(
            "size(randint(5, 8), 5, randint(5, 8))
             hut   --> split(y){ 1 : I(stone) | 3 : walls | ~1 : I(oak_slab) }
             walls --> split(x){ 1 : I(bricks) | ~1 : split(z){ 1 : I(bricks) | ~1 : nil | 1 : front } | 1 : I(bricks) }
             front --> split(x){ ~1 : I(bricks) | 1 : door | ~1 : I(bricks) }
             door  --> split(y){ 1 : I(oak_door[half=lower]) | 1 : I(oak_door[half=upper]) | 1 : I(bricks) }",
        );
        let examples = Samples::draw(&hut, &Library::new(), 1000, 30).made;
        let found = scores(&hut, &Library::new(), &examples, 0, 20);
        assert_eq!((found.reproduced, found.coverage, found.failed), (30, 1.0, 0));
        assert!(found.length.unwrap().ratio() < 0.5, "{found:?}");
        assert_eq!((found.template, found.seams, found.odd, found.sound), (Some(0.0), 0.0, 0.0, 1.0));
        assert_eq!(found.rooms.samples.reachable, 20);
        assert_eq!(found.rooms.samples.roofless, 0);
        let other = graph("size(5, 5, 5)\na --> split(x){ 1 : I(dirt) | ~1 : I(stone) }");
        let wrong = scores(&other, &Library::new(), &examples, 0, 20);
        assert_eq!((wrong.reproduced, wrong.length, wrong.template), (0, None, None));
        assert!(wrong.coverage < 0.5 && wrong.seams > 100.0, "{wrong:?}");
        assert!(wrong.distances[0] > found.distances[0] && wrong.distances[1] > found.distances[1]);
        assert_eq!(wrong.novelty.variety, 0.05);
    }
}
