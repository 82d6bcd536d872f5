//! What a grammar makes.

use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::run::{Library, Options, run};

/// Buildings that a grammar made.
#[derive(Clone, Debug, Default)]
pub struct Samples {
    pub made: Vec<Grid>,
    /// Runs that ended in an error.
    pub failed: usize,
}

/// So many runs are made for each sample that is asked for: small grammars make little that is new.
const MOST_RUNS: usize = 20;

impl Samples {
    /// The first `count` runs from a seed on, at sizes that the grammar draws.
    pub fn draw(graph: &OpGraph, library: &Library, first_seed: u64, count: usize) -> Samples {
        Samples::collect(graph, library, first_seed, count, count, |_| true)
    }

    /// As [`Samples::draw`], of buildings that are none of these. There may be fewer: not every grammar has so many.
    pub fn draw_fresh(
        graph: &OpGraph,
        library: &Library,
        first_seed: u64,
        count: usize,
        known: &[Grid],
    ) -> Samples {
        let is_fresh = |grid: &Grid| !known.iter().any(|known| known.same_blocks(grid));
        Samples::collect(graph, library, first_seed, count, count.saturating_mul(MOST_RUNS), is_fresh)
    }

    fn collect(
        graph: &OpGraph,
        library: &Library,
        first_seed: u64,
        count: usize,
        runs: usize,
        is_wanted: impl Fn(&Grid) -> bool,
    ) -> Samples {
        let mut samples = Samples::default();
        for seed in (first_seed..).take(runs) {
            if samples.len() >= count {
                break;
            }
            match run(graph, library, &Options { seed, ..Options::default() }) {
                Ok(made) if is_wanted(&made.made) => samples.made.push(made.made),
                Ok(_) => {}
                Err(_) => samples.failed += 1,
            }
        }
        samples
    }

    /// How many there are, those that failed among them.
    pub fn len(&self) -> usize {
        self.made.len() + self.failed
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::read;
    use crate::graph::lower;

    fn graph(text: &str) -> OpGraph {
        lower(&read(text).unwrap(), None).unwrap()
    }

    #[test]
    fn fresh_samples_are_none_of_those_known() {
        let graph = graph("size(randint(1, 3), 1, 1)\na --> I(stone)");
        let known = Samples::draw(&graph, &Library::new(), 0, 1).made;
        let fresh = Samples::draw_fresh(&graph, &Library::new(), 0, 10, &known).made;
        assert_eq!(fresh.len(), 10);
        assert!(fresh.iter().all(|grid| grid.size() != known[0].size()));
    }

    #[test]
    fn a_grammar_that_makes_only_what_is_known_makes_nothing_fresh() {
        let graph = graph("size(2, 1, 1)\na --> I(stone)");
        let known = Samples::draw(&graph, &Library::new(), 0, 3).made;
        assert_eq!(known.len(), 3);
        assert!(Samples::draw_fresh(&graph, &Library::new(), 0, 3, &known).is_empty());
    }

    #[test]
    fn runs_that_fail_are_counted() {
        let graph = graph("size(randint(1, 2), 1, 1)\na --> split(x){ 2 : I(stone) }");
        let samples = Samples::draw(&graph, &Library::new(), 0, 20);
        assert!(samples.failed > 0 && !samples.made.is_empty());
        assert_eq!(samples.len(), 20);
    }
}
