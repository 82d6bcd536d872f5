//! Whether a grammar still runs.

use super::texts::Program;
use crate::run::{Library, Options, run};
use crate::space::Cell;

/// So many runs are tried.
pub const TRIALS: u64 = 24;

/// How many of some runs end in an error: on the sizes that a grammar says, or on this one where it says none.
pub fn failures(program: &Program, size: Cell, library: &Library) -> usize {
    let size = program.graph.sizes.is_empty().then_some(size);
    let fails = |seed: &u64| {
        run(&program.graph, library, &Options { seed: *seed, size, ..Options::default() }).is_err()
    };
    (0..TRIALS).filter(fails).count()
}

/// Whether every run on a size ends in an error.
pub fn always_fails(program: &Program, size: Cell, library: &Library) -> bool {
    let options = |seed| Options { seed, size: Some(size), ..Options::default() };
    (0..TRIALS).all(|seed| run(&program.graph, library, &options(seed)).is_err())
}
