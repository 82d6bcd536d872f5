//! Whether examples look as if one plan were behind all of them.

use super::example::{Example, Terminals};
use super::neighbourhood::{Neighbourhood, OUTSIDE, bordered, corners, neighbourhood};
use rustc_hash::{FxHashMap, FxHashSet};

/// Two buildings of one plan may differ in most of what they show.
const FEWEST: usize = 3;
/// Of what the samples of a grammar show, at most three in ten stand in one of them alone; of what houses show that
/// share a style and no plan, nearly half or more.
const MOST_ALONE: f64 = 0.4;

/// What air is in a form.
const AIR: u32 = OUTSIDE - 1;

/// Whether most of the neighbourhoods that examples show stand in several of them, whatever their materials. Few
/// examples, and labelled boxes, may always be of one plan.
pub fn may_be_kin(examples: &[Example]) -> bool {
    alone(examples).is_none_or(|alone| alone <= MOST_ALONE)
}

/// The same, where enough examples say so.
pub fn are_kin(examples: &[Example]) -> bool {
    alone(examples).is_some_and(|alone| alone <= MOST_ALONE)
}

/// The share of neighbourhoods that stand in one example alone; `None` where that tells nothing.
fn alone(examples: &[Example]) -> Option<f64> {
    let mut terminals = Terminals::default();
    let air = terminals.air();
    let mut times: FxHashMap<Neighbourhood, u32> = FxHashMap::default();
    for example in examples {
        let cells = bordered(&example.cells(&mut terminals)?);
        let forms: FxHashSet<Neighbourhood> =
            corners(cells.dim()).map(|corner| form(neighbourhood(&cells, corner), air)).collect();
        forms.into_iter().for_each(|form| *times.entry(form).or_default() += 1);
    }
    let alone = times.values().filter(|times| **times == 1).count();
    (examples.len() >= FEWEST).then(|| alone as f64 / times.len() as f64)
}

/// A neighbourhood with its blocks numbered in order of first sight.
fn form(neighbourhood: Neighbourhood, air: u32) -> Neighbourhood {
    let mut known: Vec<u32> = Vec::with_capacity(8);
    neighbourhood.map(|terminal| match terminal {
        OUTSIDE => OUTSIDE,
        terminal if terminal == air => AIR,
        terminal => {
            let at = known.iter().position(|other| *other == terminal);
            at.unwrap_or_else(|| {
                known.push(terminal);
                known.len() - 1
            }) as u32
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::BlockState;
    use crate::grid::Grid;
    use crate::space::Cell;

    fn building(blocks: &[&str]) -> Example {
        let mut grid = Grid::new(Cell::new(blocks.len() as i32, 1, 1));
        for (x, name) in (0..).zip(blocks) {
            let id = grid.intern(&BlockState::new(name).unwrap()).unwrap();
            grid.set(Cell::new(x, 0, 0), id);
        }
        Example::Blocks(grid)
    }

    #[test]
    fn buildings_of_one_plan_are_kin_whatever_their_materials() {
        let wall = |wall: &str| building(&[wall, wall, "glass", wall]);
        assert!(are_kin(&["stone", "bricks", "oak_planks"].map(wall)));
        let others = [building(&["stone", "glass", "bricks"]), building(&["dirt", "dirt", "dirt", "dirt"])];
        assert!(!are_kin(&[
            others[0].clone(),
            others[1].clone(),
            building(&["stone", "air", "glass", "air"])
        ]));
        assert!(may_be_kin(&others) && !are_kin(&others), "two may be");
    }
}
