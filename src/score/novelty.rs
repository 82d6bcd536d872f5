//! Whether samples are new.

use super::cells::{Alphabet, Cells};
use crate::grid::Grid;
use crate::space::Turn;
use std::collections::BTreeSet;

/// How many of some samples are new, as shares of all.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Novelty {
    /// Those equal to no example.
    pub novelty: f64,
    /// Different ones.
    pub variety: f64,
    /// Those equal to an example, turned or not.
    pub copies: f64,
}

/// How new `samples` are beside `examples`. Of no samples none are new, different or copies.
pub fn novelty(samples: &[Grid], examples: &[Grid]) -> Novelty {
    let mut alphabet = Alphabet::default();
    let shown: BTreeSet<Key> = alphabet.all(examples).into_iter().map(key).collect();
    let turned: BTreeSet<Key> = (0..4)
        .flat_map(|quarters| examples.iter().map(move |example| example.turned(Turn::quarters(quarters))))
        .map(|grid| key(alphabet.cells(&grid)))
        .collect();
    let made: Vec<Key> = alphabet.all(samples).into_iter().map(key).collect();
    let distinct: BTreeSet<&Key> = made.iter().collect();
    let share = |count: usize| count as f64 / made.len().max(1) as f64;
    Novelty {
        novelty: share(made.iter().filter(|sample| !shown.contains(*sample)).count()),
        variety: share(distinct.len()),
        copies: share(made.iter().filter(|sample| turned.contains(*sample)).count()),
    }
}

/// What tells buildings apart.
type Key = ((usize, usize, usize), Vec<u32>);

fn key(cells: Cells) -> Key {
    (cells.dim(), cells.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Cell;
    use proptest::prelude::*;

    const BLOCKS: [&str; 5] = ["air", "stone", "oak_stairs[facing=east]", "oak_fence", "oak_log[axis=x]"];

    proptest! {
        #[test]
        fn a_turned_example_is_a_copy(blocks in prop::collection::vec(0..BLOCKS.len(), 12), quarters in 0..4i32) {
            let mut example = Grid::new(Cell::new(3, 2, 2));
            for (cell, block) in example.bounds().cells().zip(blocks) {
                let id = example.intern(&BLOCKS[block].parse().unwrap()).unwrap();
                example.set(cell, id);
            }
            let turned = example.turned(Turn::quarters(quarters));
            prop_assert_eq!(novelty(&[turned], &[example]).copies, 1.0);
        }
    }

    #[test]
    fn copies_turned_copies_and_new_ones_are_told_apart() {
        let example = Grid::row(&["stone", "oak_stairs[facing=east]", "air"]);
        let turned = example.turned(Turn::quarters(1));
        let new = Grid::row(&["stone", "stone", "air"]);
        let found = novelty(&[example.clone(), turned, new.clone(), new], &[example]);
        assert_eq!(found, Novelty { novelty: 0.75, variety: 0.75, copies: 0.5 });
    }

    #[test]
    fn what_neighbours_decide_makes_no_sample_new() {
        let open = Grid::row(&["oak_fence", "oak_fence"]);
        let written = Grid::row(&[
            "oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]",
            "oak_fence[east=false,north=false,south=false,waterlogged=false,west=true]",
        ]);
        assert_eq!(novelty(&[open], &[written]).novelty, 0.0);
    }

    #[test]
    fn of_no_samples_none_are_new() {
        assert_eq!(novelty(&[], &[]), Novelty { novelty: 0.0, variety: 0.0, copies: 0.0 });
    }
}
