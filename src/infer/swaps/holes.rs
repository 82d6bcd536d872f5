//! Neighbourhoods by what is left of them where some cells are left out.

use crate::infer::neighbourhood::{Neighbourhood, Seen};
use rustc_hash::{FxHashMap, FxHasher};
use std::hash::{Hash, Hasher};

/// So many cells of a neighbourhood are left out at most.
pub const MOST_HOLES: usize = 3;
/// Of more neighbourhoods than this only one cell is left out: the index grows with the ways to leave out.
const MANY: usize = 30_000;

/// An index of neighbourhoods. A set of cells is a number with one bit for each.
#[derive(Debug)]
pub struct Holes<'s> {
    all: &'s [Neighbourhood],
    /// Hashes of what is left, sorted, each with the neighbourhood.
    left: Vec<(u64, u32)>,
    /// Where each hash begins in that.
    first: FxHashMap<u64, usize>,
    /// The sets of cells that are left out, small ones first.
    holes: Vec<u8>,
}

impl Holes<'_> {
    pub fn of(seen: &Seen) -> Holes<'_> {
        let all = seen.all();
        let most = if all.len() > MANY { 1 } else { MOST_HOLES };
        let mut holes: Vec<u8> = (0..=u8::MAX).filter(|holes| holes.count_ones() as usize <= most).collect();
        holes.sort_by_key(|holes| holes.count_ones());
        let each = all.iter().zip(0..);
        let mut left: Vec<(u64, u32)> =
            each.flat_map(|(own, at)| holes.iter().map(move |holes| (hash(own, *holes), at))).collect();
        left.sort_unstable();
        // Several ways to leave cells out may have one hash.
        left.dedup();
        // The first of equal ones is entered last.
        let first = left.iter().enumerate().rev().map(|(at, (hash, _))| (*hash, at)).collect();
        Holes { all, left, first, holes }
    }

    /// Those that differ from a neighbourhood in at most `most` of the cells in `free`, those first that differ least.
    pub fn alike(&self, own: &Neighbourhood, free: u8, most: usize) -> Vec<Neighbourhood> {
        let holes = self.holes.iter().filter(|holes| **holes & !free == 0);
        let few = holes.take_while(|holes| holes.count_ones() as usize <= most);
        few.flat_map(|holes| self.differing(own, *holes)).collect()
    }

    /// Those that differ from a neighbourhood in just these cells.
    fn differing<'a>(
        &'a self,
        own: &'a Neighbourhood,
        holes: u8,
    ) -> impl Iterator<Item = Neighbourhood> + 'a {
        let hash = hash(own, holes);
        let first = self.first.get(&hash).copied().unwrap_or(self.left.len());
        let same = self.left[first..].iter().take_while(move |(other, _)| *other == hash);
        let differs = move |shown: &Neighbourhood| {
            (0..8).all(|cell| (own[cell] != shown[cell]) == (holes >> cell & 1 == 1))
        };
        same.map(|(_, at)| self.all[*at as usize]).filter(differs)
    }
}

/// The hash of a neighbourhood without some of its cells.
fn hash(own: &Neighbourhood, holes: u8) -> u64 {
    let mut hasher = FxHasher::default();
    holes.hash(&mut hasher);
    (0..8).filter(|cell| holes >> cell & 1 == 0).for_each(|cell| own[cell].hash(&mut hasher));
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::Array3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn those_alike_are_those_that_differ_in_few_free_cells(
            cells in prop::collection::vec(0..3u32, 4 * 4 * 4),
            own in prop::array::uniform8(0..3u32),
            free in 0..=u8::MAX,
            most in 0..=MOST_HOLES,
        ) {
            let seen = Seen::of([&Array3::from_shape_vec((4, 4, 4), cells).unwrap()]);
            let differs = |shown: &&Neighbourhood| {
                let differing = (0..8).filter(|cell| own[*cell] != shown[*cell]);
                differing.clone().all(|cell| free >> cell & 1 == 1) && differing.count() <= most
            };
            let mut expected: Vec<Neighbourhood> = seen.all().iter().filter(differs).copied().collect();
            let mut alike = Holes::of(&seen).alike(&own, free, most);
            expected.sort_unstable();
            alike.sort_unstable();
            prop_assert_eq!(alike, expected);
        }
    }
}
