//! Snapping: planes that shapes mark, and the splits and repeats that keep to them (seed 2, figure 9).

use super::Label;
use crate::space::Axis;
use std::collections::BTreeSet;
use std::ops::Bound::Excluded;

/// How far a plane reaches: the whole run, or what lies within one `local`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Region(pub u64);

/// The planes that are marked, by region, label, axis of the world and place on it. All of them stand under no label.
#[derive(Clone, Default, Debug)]
pub struct Planes(BTreeSet<(Region, Option<Label>, Axis, i32)>);

impl Planes {
    /// A plane with a label is found by it and among all; so it is kept twice.
    pub fn mark(&mut self, region: Region, label: Option<Label>, axis: Axis, at: i32) {
        self.0.insert((region, None, axis, at));
        self.0.insert((region, label, axis, at));
    }

    /// The planes of a label, or all, that lie between two places and on neither, in order.
    pub fn between(
        &self,
        region: Region,
        label: Option<Label>,
        axis: Axis,
        low: i32,
        high: i32,
    ) -> impl DoubleEndedIterator<Item = i32> {
        let plane = |at| Excluded((region, label, axis, at));
        let is_range = low < high;
        let range = is_range.then(|| self.0.range((plane(low), plane(high))));
        range.into_iter().flatten().map(|(_, _, _, at)| *at)
    }
}

/// The sections into which planes cut a scope of `total` blocks: a repeat runs in each.
pub fn sections(total: i32, planes: &[i32]) -> Vec<(i32, i32)> {
    let inner = within(planes, 0, total);
    let starts = std::iter::once(0).chain(inner.iter().copied());
    let ends = inner.iter().copied().chain([total]);
    starts.zip(ends).collect()
}

/// The boundaries of a split, moved onto planes: each plane takes one boundary that is not an end, as far as there are
/// any, and the others stay. Of all ways to do so that keep the boundaries in order, the one with the shortest way to go in
/// all; of several, the one that takes lower boundaries, or lower planes where these are more.
///
/// A single plane so moves the boundary nearest to it. Takes as many steps as there are boundaries times planes.
pub fn snapped(boundaries: &[i32], planes: &[i32]) -> Vec<i32> {
    let mut moved = boundaries.to_vec();
    let [first, inner @ .., last] = boundaries else { return moved };
    let planes = within(planes, *first, *last);
    match planes.len() <= inner.len() {
        true => {
            for (plane, boundary) in planes.iter().zip(matched(&planes, inner)) {
                moved[boundary + 1] = *plane;
            }
        }
        false => {
            for (boundary, plane) in matched(inner, &planes).into_iter().enumerate() {
                moved[boundary + 1] = planes[plane];
            }
        }
    }
    // Of boundaries around a part without a block any may have moved.
    moved.sort_unstable();
    moved
}

/// Those of the planes that lie between two places and on neither, in order, each once.
fn within(planes: &[i32], low: i32, high: i32) -> Vec<i32> {
    let mut inner: Vec<i32> = planes.iter().copied().filter(|plane| low < *plane && *plane < high).collect();
    inner.sort_unstable();
    inner.dedup();
    inner
}

/// For each of `few` the number of one of `many`, rising, with the least sum of distances. Both are in order, and
/// `few` is not the longer one.
fn matched(few: &[i32], many: &[i32]) -> Vec<usize> {
    // With the first i of the few matched among the first i + k of the many: the least sum, and whether the last of
    // the many is taken. There are no more than `spare` to leave out.
    let spare = many.len() - few.len();
    let mut sums = vec![0u64; spare + 1];
    let mut taken = Vec::with_capacity(few.len());
    for (i, place) in few.iter().enumerate() {
        let mut row = vec![false; spare + 1];
        for k in 0..=spare {
            let taking = sums[k] + u64::from(place.abs_diff(many[i + k]));
            row[k] = k == 0 || taking < sums[k - 1];
            sums[k] = if row[k] { taking } else { sums[k - 1] };
        }
        taken.push(row);
    }
    let mut k = spare;
    let mut found: Vec<usize> = (0..few.len())
        .rev()
        .map(|i| {
            while !taken[i][k] {
                k -= 1;
            }
            i + k
        })
        .collect();
    found.reverse();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn planes_are_found_by_all_that_they_are_known_by() {
        let mut planes = Planes::default();
        let (here, label) = (Region(1), Some(Label(3)));
        for at in [9, 2, 5, 2, 7] {
            planes.mark(here, None, Axis::Y, at);
        }
        planes.mark(here, label, Axis::Y, 4);
        planes.mark(Region(2), None, Axis::Y, 6);
        planes.mark(here, None, Axis::X, 6);
        let between =
            |label, axis, low, high| planes.between(here, label, axis, low, high).collect::<Vec<_>>();
        assert_eq!(between(None, Axis::Y, 2, 9), [4, 5, 7]);
        assert_eq!(between(None, Axis::Y, 0, 10), [2, 4, 5, 7, 9]);
        assert_eq!(between(label, Axis::Y, 0, 10), [4]);
        assert_eq!(between(None, Axis::Z, 0, 10), [0; 0]);
        assert_eq!(between(None, Axis::Y, 9, 2), [0; 0]);
        assert_eq!(between(None, Axis::Y, 5, 5), [0; 0]);
    }

    #[test]
    fn a_plane_cuts_a_repeat_in_two() {
        assert_eq!(sections(12, &[5]), [(0, 5), (5, 12)]);
        assert_eq!(sections(12, &[0, 12, 15, -3]), [(0, 12)]);
    }

    #[test]
    fn a_plane_moves_the_boundary_nearest_to_it() {
        assert_eq!(snapped(&[0, 3, 6, 9, 12], &[7]), [0, 3, 7, 9, 12]);
        assert_eq!(snapped(&[0, 4, 6, 9], &[5]), [0, 5, 6, 9], "half way between two, the lower one goes");
        assert_eq!(snapped(&[0, 5, 9], &[4, 6]), [0, 4, 9], "of two planes as near, the lower one is taken");
        assert_eq!(snapped(&[0, 4, 5, 20, 30], &[6, 7]), [0, 6, 7, 20, 30], "a boundary moves once");
        assert_eq!(snapped(&[0, 9], &[4]), [0, 9], "ends stay");
        assert_eq!(snapped(&[], &[4]), [0; 0]);
    }

    /// The least way in all, by trying every choice.
    fn least(few: &[i32], many: &[i32]) -> Option<u64> {
        let Some((place, few)) = few.split_first() else { return Some(0) };
        let ways = many.iter().enumerate().filter_map(|(at, other)| {
            least(few, &many[at + 1..]).map(|rest| rest + u64::from(place.abs_diff(*other)))
        });
        ways.min()
    }

    proptest! {
        #[test]
        fn snapped_boundaries_keep_their_order_and_hit_the_planes(
            total in 1..30i32,
            inner in prop::collection::vec(0..30i32, 0..6),
            planes in prop::collection::btree_set(-2..32i32, 0..6),
        ) {
            let mut boundaries: Vec<i32> = inner.iter().map(|b| *b.min(&total)).collect();
            boundaries.sort_unstable();
            boundaries.insert(0, 0);
            boundaries.push(total);
            let planes: Vec<i32> = planes.into_iter().collect();
            let moved = snapped(&boundaries, &planes);
            prop_assert_eq!((moved[0], moved[moved.len() - 1], moved.len()), (0, total, boundaries.len()));
            prop_assert!(moved.is_sorted(), "{:?} to {:?}", boundaries, moved);
            let inside = within(&planes, 0, total);
            let hit = inside.iter().filter(|plane| moved[1..moved.len() - 1].contains(plane)).count();
            prop_assert_eq!(hit, inside.len().min(inner.len()));
            let way: u64 = moved.iter().zip(&boundaries).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
            let own = &boundaries[1..boundaries.len() - 1];
            let (few, many) = if inside.len() <= own.len() { (&inside[..], own) } else { (own, &inside[..]) };
            prop_assert_eq!(Some(way), least(few, many));
        }

        #[test]
        fn sections_tile_their_scope(total in 0..30i32, planes in prop::collection::vec(-2..32i32, 0..6)) {
            let sections = sections(total, &planes);
            prop_assert_eq!((sections[0].0, sections[sections.len() - 1].1), (0, total));
            prop_assert!(sections.windows(2).all(|pair| pair[0].1 == pair[1].0));
            prop_assert!(total == 0 || sections.iter().all(|(low, high)| low < high));
        }
    }
}
