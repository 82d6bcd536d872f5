//! Swaps: what some cells of an example can hold instead, with nothing beside them that stands so in no example.
//!
//! ```text
//! examples --aligned, local--> Swaps --sites--> boxes of an example with what they can hold
//! ```

mod aligned;
mod holes;
mod local;
mod sites;
mod sound;

use super::example::Terminal;
use super::neighbourhood::{Place, Seen, Shown, cell, corners_around, places};
use crate::space::{Bounds, Cell};
use holes::Holes;
use ndarray::Array3;
use std::cmp::Reverse;
use std::collections::BTreeSet;

pub use sites::{Site, sites};
pub use sound::{Frame, Settled};

/// Cells of one example, in the order of their places in its array with a border, each with the terminal that it
/// holds instead.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Swap(Vec<(Place, u32)>);

impl Swap {
    fn new(mut cells: Vec<(Place, u32)>) -> Swap {
        cells.sort_unstable();
        Swap(cells)
    }

    /// Its cells, each with the terminal that it holds instead.
    fn cells(&self) -> impl Iterator<Item = (Cell, u32)> {
        self.0.iter().map(|(place, terminal)| (cell(*place), *terminal))
    }

    /// The box around its cells.
    fn bounds(&self) -> Bounds {
        let cells = self.cells().map(|(cell, _)| Bounds::new(cell, cell + Cell::ONE));
        cells.reduce(|all, next| all.union(&next)).unwrap_or(Bounds::of_size(Cell::ZERO))
    }

    /// The swaps that lie in this one: all ways to leave some of its cells as they are.
    fn parts(&self) -> impl Iterator<Item = Swap> {
        let whole = (1u32 << self.0.len()) - 1;
        (1..whole).map(|chosen| {
            let cells = self.0.iter().enumerate().filter(|(at, _)| chosen >> at & 1 == 1);
            Swap(cells.map(|(_, cell)| *cell).collect())
        })
    }

    /// Whether a cell of one lies in a neighbourhood with a cell of the other.
    fn touches(&self, other: &Swap) -> bool {
        let is_near = |a: &Place, b: &Place| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= 1);
        self.0.iter().any(|(a, _)| other.0.iter().any(|(b, _)| is_near(a, b)))
    }
}

/// The swaps of an example, those first that are worth most: what another example holds in the same place, from
/// small to large, then what was put together of neighbourhoods, from many cells to few, and of as many what was seen
/// most often. What no example shows as a whole digs no holes and builds no walls.
fn swaps(shown: &Shown, holes: &Holes<'_>, states: &[Terminal], example: usize) -> Vec<Swap> {
    let own = &shown.bordered[example];
    let others = shown.bordered.iter().enumerate().filter(|(other, _)| *other != example);
    let aligned: BTreeSet<Swap> = others.flat_map(|(_, other)| aligned::aligned(own, other)).collect();
    let local = local::local(own, &shown.seen, holes);
    let local = local.difference(&aligned).filter(|swap| sound::keeps_body(own, swap, states));
    let mut local: Vec<Swap> = local.cloned().collect();
    local.sort_by_cached_key(|swap| (Reverse(swap.0.len()), Reverse(evidence(own, &shown.seen, swap))));
    let mut all: Vec<Swap> = aligned.into_iter().collect();
    all.sort_by_key(|swap| swap.0.len());
    all.extend(local);
    all
}

/// How often the rarest of the neighbourhoods was seen that a swap makes.
fn evidence(own: &Array3<u32>, seen: &Seen, swap: &Swap) -> u32 {
    let corners: BTreeSet<Place> = swap.0.iter().flat_map(|(place, _)| corners_around(*place)).collect();
    let made = |corner: Place| {
        places(corner).map(|place| {
            let swapped = swap.0.iter().find(|(other, _)| *other == place);
            swapped.map_or(own[place], |(_, terminal)| *terminal)
        })
    };
    corners.into_iter().map(|corner| seen.count(&made(corner))).min().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::infer::neighbourhood::{bordered, corners, neighbourhood};
    use proptest::prelude::*;

    /// Two small examples of one size, with a border.
    fn examples() -> impl Strategy<Value = [Array3<u32>; 2]> {
        let cells = || prop::collection::vec(prop_oneof![4 => Just(0u32), 1 => 1..3u32], 4 * 3 * 5);
        let example = || cells().prop_map(|cells| Array3::from_shape_vec((4, 3, 5), cells).unwrap());
        (example(), example()).prop_map(|(a, b)| [bordered(&a), bordered(&b)])
    }

    fn swapped(own: &Array3<u32>, swap: &Swap) -> Array3<u32> {
        let mut swapped = own.clone();
        swap.0.iter().for_each(|(place, terminal)| swapped[*place] = *terminal);
        swapped
    }

    proptest! {
        #[test]
        fn a_swap_shows_what_is_seen_and_is_another_building([own, other] in examples()) {
            let seen = Seen::of([&own, &other]);
            let mut all: BTreeSet<Swap> = aligned::aligned(&own, &other).into_iter().collect();
            all.extend(local::local(&own, &seen, &Holes::of(&seen)));
            for swap in all {
                let swapped = swapped(&own, &swap);
                prop_assert!(corners(own.dim()).all(|corner| seen.contains(&neighbourhood(&swapped, corner))));
                prop_assert!(swapped != own && swapped != other);
            }
        }

        #[test]
        fn all_swaps_of_one_cell_are_found(own in examples().prop_map(|[own, _]| own)) {
            let seen = Seen::of([&own]);
            let found = local::local(&own, &seen, &Holes::of(&seen));
            let inside = corners(own.dim()).filter(|place| !place.contains(&0));
            for place in inside.filter(|place| own[*place] != 0) {
                for terminal in (0..3).filter(|terminal| *terminal != own[place]) {
                    let swap = Swap::new(vec![(place, terminal)]);
                    let swapped = swapped(&own, &swap);
                    let is_seen = corners_around(place)
                        .into_iter()
                        .all(|corner| seen.contains(&neighbourhood(&swapped, corner)));
                    let is_alone = corners_around(place)
                        .into_iter()
                        .flat_map(places)
                        .all(|near| [own[place], crate::infer::neighbourhood::OUTSIDE].contains(&own[near]));
                    prop_assert_eq!(found.contains(&swap), is_seen && !is_alone);
                }
            }
        }
    }

    #[test]
    fn places_that_differ_far_apart_are_swapped_by_themselves() {
        let row =
            |cells: &[u32]| bordered(&Array3::from_shape_vec((1, 1, cells.len()), cells.to_vec()).unwrap());
        let swaps = aligned::aligned(&row(&[1, 5, 1, 1, 5, 1]), &row(&[1, 6, 1, 1, 7, 1]));
        let expected = [(2, 6), (5, 7)].map(|(x, terminal)| Swap::new(vec![([1, 1, x], terminal)]));
        assert_eq!(swaps, expected);
        assert_eq!(
            aligned::aligned(&row(&[1, 5, 1]), &row(&[1, 6, 1])),
            [],
            "all of it is the other example"
        );
    }
}
