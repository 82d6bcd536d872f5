//! How far a grammar says what another one says that is known to be true.

use super::samples::Samples;
use crate::graph::OpGraph;
use crate::grid::Grid;
use crate::parse::{Laws, Parser};
use crate::run::Library;

/// A grammar beside the true one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Agreement {
    /// The share of its fresh samples that the true grammar derives. Runs that fail are not derived; of no fresh
    /// samples, all are.
    pub precision: f64,
    /// The share of the true grammar's fresh samples that it derives.
    pub recall: f64,
    /// The same with any lengths of parts: right structure, whatever sizes were seen.
    pub structural_recall: f64,
    /// How many fresh samples of its own there were.
    pub fresh: usize,
    /// Its operations, equal ones counted once.
    pub rules: usize,
    /// Those of the true grammar.
    pub true_rules: usize,
}

/// How well `learnt` and `truth` agree on `count` samples of each. Samples are fresh: none of the examples.
pub fn agreement(
    learnt: &OpGraph,
    truth: &OpGraph,
    library: &Library,
    examples: &[Grid],
    first_seed: u64,
    count: usize,
) -> Agreement {
    let own = Samples::draw_fresh(learnt, library, first_seed, count, examples);
    let others = Samples::draw_fresh(truth, library, first_seed, count, examples);
    let derived = |graph: &OpGraph, laws: Laws, samples: &Samples| {
        let parser = Parser::new(graph, laws).with_library(library);
        let derived = samples.made.iter().filter(|grid| parser.derives(grid)).count();
        if samples.is_empty() { 1.0 } else { derived as f64 / samples.len() as f64 }
    };
    Agreement {
        precision: derived(truth, Laws::AsWritten, &own),
        recall: derived(learnt, Laws::AsWritten, &others),
        structural_recall: derived(learnt, Laws::Widened, &others),
        fresh: own.made.len(),
        rules: learnt.unified().len(),
        true_rules: truth.unified().len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::score::tests::graph;

    fn beside(learnt: &str, truth: &str) -> Agreement {
        agreement(&graph(learnt), &graph(truth), &Library::new(), &[], 0, 60)
    }

    const TRUTH: &str = "size(9, 1, 1)\na --> split(x){ randint(1, 4) : I(stone) | ~1 : I(glass) }";

    #[test]
    fn a_grammar_agrees_with_itself() {
        let expected = Agreement {
            precision: 1.0,
            recall: 1.0,
            structural_recall: 1.0,
            fresh: 60,
            rules: 3,
            true_rules: 3,
        };
        assert_eq!(beside(TRUTH, TRUTH), expected);
    }

    #[test]
    fn what_makes_too_much_lacks_precision_and_too_little_recall() {
        let narrow = "size(9, 1, 1)\na --> split(x){ randint(1, 2) : I(stone) | ~1 : I(glass) }";
        let few = beside(narrow, TRUTH);
        assert!(few.precision == 1.0 && (0.2..0.8).contains(&few.recall), "{few:?}");
        assert_eq!(few.structural_recall, 1.0);
        let many = beside(TRUTH, narrow);
        assert!(many.recall == 1.0 && (0.2..0.8).contains(&many.precision), "{many:?}");
    }

    #[test]
    fn another_structure_is_not_recalled_with_any_lengths() {
        let other = beside("size(9, 1, 1)\na --> split(x){ ~1 : I(glass) | 2 : I(stone) }", TRUTH);
        assert_eq!((other.precision, other.recall, other.structural_recall), (0.0, 0.0, 0.0));
    }
}
