//! Whether a building holds together: nothing floats, halves are whole, states are of the game.

use super::cells::settled;
use crate::grid::{self, Grid, Oddity};

/// What is wrong with a building.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Soundness {
    /// Pieces that do not rest on the lowest layer that has blocks. Blocks that share a face or an edge hold
    /// each other.
    pub floating: usize,
    /// Doors, beds and tall plants of which a half is missing.
    pub halves: usize,
    /// Kinds of states that are not of the game, and of blocks that are not known.
    pub illegal: usize,
}

impl Soundness {
    pub fn of(grid: &Grid) -> Soundness {
        let grid = settled(grid);
        let (mut halves, mut illegal) = (0, 0);
        for oddity in grid.oddities() {
            match oddity {
                Oddity::Halves(counts) => halves += counts.values().sum::<u64>() as usize,
                Oddity::UnknownBlocks(names) | Oddity::BadStates(names) => illegal += names.len(),
                _ => {}
            }
        }
        Soundness { floating: floating(&grid), halves, illegal }
    }

    /// The worst of several buildings in each respect.
    pub fn worst(all: impl IntoIterator<Item = Soundness>) -> Soundness {
        all.into_iter().fold(Soundness::default(), |worst, next| Soundness {
            floating: worst.floating.max(next.floating),
            halves: worst.halves.max(next.halves),
            illegal: worst.illegal.max(next.illegal),
        })
    }

    /// Whether nothing is worse than in `worst`: buildings of players have oddities of their own.
    pub fn is_no_worse_than(self, worst: Soundness) -> bool {
        self.floating <= worst.floating && self.halves <= worst.halves && self.illegal <= worst.illegal
    }
}

fn floating(grid: &Grid) -> usize {
    let is_solid: Vec<bool> = grid.palette().states().iter().map(|state| !state.is_nothing()).collect();
    grid::floating(&grid.cells().mapv(|id| is_solid[usize::from(id)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Cell;

    fn tower(names: &[&str]) -> Grid {
        let mut grid = Grid::new(Cell::new(1, names.len() as i32, 1));
        for (y, name) in (0..).zip(names) {
            let id = grid.intern(&name.parse().unwrap()).unwrap();
            grid.set(Cell::new(0, y, 0), id);
        }
        grid
    }

    #[test]
    fn each_fault_is_found() {
        let sound = tower(&["air", "stone", "oak_door[half=lower]", "oak_door[half=upper]"]);
        assert_eq!(Soundness::of(&sound), Soundness::default());
        let broken = tower(&["stone", "air", "glass[lit=true]", "oak_door[half=lower]", "air", "dirt"]);
        assert_eq!(Soundness::of(&broken), Soundness { floating: 2, halves: 1, illegal: 1 });
    }

    #[test]
    fn blocks_hold_each_other_by_edges() {
        let mut grid = Grid::new(Cell::new(3, 3, 3));
        let stone = grid.intern(&"stone".parse().unwrap()).unwrap();
        grid.set(Cell::ZERO, stone);
        grid.set(Cell::new(1, 1, 0), stone);
        assert_eq!(Soundness::of(&grid).floating, 0);
        grid.set(Cell::new(2, 2, 1), stone);
        assert_eq!(Soundness::of(&grid).floating, 1, "a corner holds nothing");
    }

    #[test]
    fn an_example_with_a_fault_allows_it() {
        let (one, two) =
            (Soundness { floating: 1, ..Default::default() }, Soundness { halves: 1, ..Default::default() });
        assert!(one.is_no_worse_than(Soundness::worst([one, two])));
        assert!(!one.is_no_worse_than(two));
    }
}
