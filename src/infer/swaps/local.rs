//! Swaps of few cells, put together from neighbourhoods of all examples.
//!
//! One cell is given another terminal. Each neighbourhood around what was changed then has to become one that the
//! examples show: it stays, or more of its cells change; what was decided once stays decided. Cells change in the
//! order of their places, so that each swap is found once: all before the first one stay as they are.

use super::Swap;
use super::holes::{Holes, MOST_HOLES};
use crate::infer::neighbourhood::{
    Neighbourhood, OUTSIDE, Place, Seen, corners_around, neighbourhood, places,
};
use ndarray::Array3;
use std::collections::BTreeSet;

/// A swap has this many cells at most: the first one, and as many more as one neighbourhood may change.
const MOST_CELLS: usize = 1 + MOST_HOLES;
/// From one start so many ways are followed at most.
const MOST_WAYS: usize = 24;

/// The swaps of an array with a border, none of which holds a smaller one.
pub fn local(cells: &Array3<u32>, seen: &Seen, holes: &Holes<'_>) -> BTreeSet<Swap> {
    let mut search = Search { cells, seen, holes, ways: 0, found: BTreeSet::new() };
    // Amid nothing but its like, a cell has nothing to hold on to.
    let is_beside_others = |place: Place| {
        let mut near = corners_around(place).into_iter().flat_map(places);
        near.any(|near| cells[near] != cells[place] && cells[near] != OUTSIDE)
    };
    let inside = cells.indexed_iter().filter(|(_, own)| **own != OUTSIDE).map(|((y, z, x), _)| [y, z, x]);
    inside.filter(|place| is_beside_others(*place)).for_each(|place| search.begin_at(place));
    let found = search.found;
    found.iter().filter(|swap| !swap.parts().any(|part| found.contains(&part))).cloned().collect()
}

struct Search<'a> {
    cells: &'a Array3<u32>,
    seen: &'a Seen,
    holes: &'a Holes<'a>,
    ways: usize,
    found: BTreeSet<Swap>,
}

/// A swap in the making.
#[derive(Clone)]
struct Draft {
    /// The cells changed; none before the first one changes.
    changed: Vec<(Place, u32)>,
    /// Cells after the first one that stay as they are.
    kept: Vec<Place>,
    /// The corners of neighbourhoods to look at.
    open: Vec<Place>,
}

impl Draft {
    fn begin(place: Place, terminal: u32) -> Draft {
        Draft { changed: Vec::new(), kept: Vec::new(), open: Vec::new() }.with(place, terminal)
    }

    fn with(mut self, place: Place, terminal: u32) -> Draft {
        self.changed.push((place, terminal));
        for corner in corners_around(place) {
            if !self.open.contains(&corner) {
                self.open.push(corner);
            }
        }
        self
    }

    /// With a neighbourhood as the examples show it.
    fn decided(mut self, places: &[Place; 8], now: &Neighbourhood, shown: &Neighbourhood) -> Draft {
        for ((place, old), new) in places.iter().zip(now).zip(shown) {
            if old != new {
                self = self.with(*place, *new);
            } else if !self.is_decided(place) {
                self.kept.push(*place);
            }
        }
        self
    }

    fn is_decided(&self, place: &Place) -> bool {
        self.changed.first().is_some_and(|(first, _)| place < first)
            || self.kept.contains(place)
            || self.changed.iter().any(|(changed, _)| changed == place)
    }
}

impl Search<'_> {
    /// Finds the swaps of which this is the first cell: in the neighbourhood where it is the last one, no other cell
    /// changes.
    fn begin_at(&mut self, place: Place) {
        self.ways = 0;
        let now = neighbourhood(self.cells, place.map(|n| n - 1));
        for shown in self.holes.alike(&now, 1 << 7, 1) {
            if shown[7] == now[7] || shown[7] == OUTSIDE {
                continue;
            }
            let draft = Draft::begin(place, shown[7]);
            match draft.open.iter().all(|corner| self.seen.contains(&self.now(&draft, *corner))) {
                // Every longer one would hold it.
                true => _ = self.found.insert(Swap::new(draft.changed)),
                false => self.settle(draft),
            }
        }
    }

    /// Follows all ways to make every open neighbourhood one of those seen.
    fn settle(&mut self, mut draft: Draft) {
        self.ways += 1;
        if self.ways > MOST_WAYS {
            return;
        }
        let Some(corner) = self.next(&mut draft) else {
            self.found.insert(Swap::new(draft.changed));
            return;
        };
        let (places, now) = (places(corner), self.now(&draft, corner));
        let is_free = |cell: &usize| now[*cell] != OUTSIDE && !draft.is_decided(&places[*cell]);
        let free = (0..8).filter(is_free).fold(0, |mask, cell| mask | 1 << cell);
        let alike = self.holes.alike(&now, free, MOST_CELLS - draft.changed.len());
        let inside = |shown: &Neighbourhood| {
            shown.iter().zip(now).all(|(new, old)| (*new == OUTSIDE) == (old == OUTSIDE))
        };
        for shown in alike.into_iter().filter(inside) {
            self.settle(draft.clone().decided(&places, &now, &shown));
        }
    }

    /// The next open neighbourhood: one that is not seen, if there is any.
    fn next(&self, draft: &mut Draft) -> Option<Place> {
        let unseen = |corner: &Place| !self.seen.contains(&self.now(draft, *corner));
        let at = draft.open.iter().position(unseen).or_else(|| draft.open.len().checked_sub(1))?;
        Some(draft.open.remove(at))
    }

    /// A neighbourhood with what was changed in it.
    fn now(&self, draft: &Draft, corner: Place) -> Neighbourhood {
        let mut now = neighbourhood(self.cells, corner);
        for (cell, place) in now.iter_mut().zip(places(corner)) {
            let changed = draft.changed.iter().find(|(changed, _)| *changed == place);
            *cell = changed.map_or(*cell, |(_, terminal)| *terminal);
        }
        now
    }
}
