//! Sites: boxes of an example that can hold one of several things, none of which stands in the way of another.

use super::holes::Holes;
use super::sound::{Settled, Standing, keeps_fixtures};
use super::{Swap, swaps};
use crate::grid::Grid;
use crate::infer::example::{Example, Terminal, Terminals};
use crate::infer::exchange::Exchange;
use crate::infer::neighbourhood::Shown;
use crate::space::Bounds;
use ndarray::{Array3, s};

/// A box of an example with what it can hold.
#[derive(Clone, PartialEq, Debug)]
pub struct Site {
    pub bounds: Bounds,
    /// What it holds in the example, then what it can hold instead; each indexed `[y, z, x]`, with the number of
    /// examples that show it there.
    pub contents: Vec<(Array3<u32>, u32)>,
}

/// More sites in an example make a grammar that nobody reads.
const MOST_SITES: usize = 12;
/// So many swaps of an example are tried.
const MOST_TRIED: usize = 200;
/// So many things a site can hold besides what it holds in the example.
const MOST_SWAPS: usize = 4;
/// Swaps with at most this many cells between them may decide together how a block stands.
const NEAR: i32 = 3;

/// The sites of each of `examples`, which are the last ones of those shown. What lies beside a plane where an example
/// is exchanged is no part of its own.
pub fn sites(
    examples: &[Example],
    shown: &Shown,
    terminals: &Terminals,
    settled: &mut Settled,
    exchanges: &[Exchange],
) -> Vec<Vec<Site>> {
    let is_whole = |number: usize, bounds: Bounds| {
        let group = exchanges.iter().find(|group| group.members.contains(&number));
        group.is_none_or(|group| group.leaves_whole(bounds))
    };
    let holes = Holes::of(&shown.seen);
    let is_nothing = terminals.are_nothing();
    let mut all = Vec::new();
    for (number, example) in (shown.cells.len() - examples.len()..).zip(examples) {
        let Example::Blocks(grid) = example else { continue };
        let cells = &shown.bordered[number];
        let mut chosen = Chosen {
            grid,
            states: &terminals.list,
            is_nothing: &is_nothing,
            settled,
            standing: Standing::new(cells, &is_nothing),
            places: Vec::new(),
        };
        let fits =
            |swap: &Swap| keeps_fixtures(cells, swap, &terminals.list) && is_whole(number, swap.bounds());
        let swaps = swaps(shown, &holes, &terminals.list, number).into_iter().filter(fits);
        swaps.take(MOST_TRIED).for_each(|swap| chosen.take(swap));
        let sites = chosen.places.iter().map(|(bounds, swaps)| site(shown, number, *bounds, swaps));
        all.push(sites.collect());
    }
    all
}

/// The sites of one example so far.
struct Chosen<'a> {
    grid: &'a Grid,
    states: &'a [Terminal],
    is_nothing: &'a [bool],
    settled: &'a mut Settled,
    standing: Standing,
    places: Vec<(Bounds, Vec<Swap>)>,
}

impl Chosen<'_> {
    /// Takes a swap if it fits beside all that were taken.
    fn take(&mut self, swap: Swap) {
        let own = swap.bounds();
        let site = self.places.iter().position(|(bounds, _)| *bounds == own);
        let has_room = match site {
            Some(site) => self.places[site].1.len() < MOST_SWAPS,
            None => self.places.len() < MOST_SITES,
        };
        if !has_room || !self.stands_apart(&swap, own) || !self.shows_seen(&swap, own) {
            return;
        }
        let Some(standing) = self.standing.with(&swap, self.is_nothing) else { return };
        self.standing = standing;
        match site {
            Some(site) => self.places[site].1.push(swap),
            None => self.places.push((own, vec![swap])),
        }
    }

    /// Whether no other site stands beside it.
    fn stands_apart(&self, swap: &Swap, own: Bounds) -> bool {
        let others = self.places.iter().filter(|(bounds, _)| *bounds != own);
        others.clone().all(|(bounds, _)| gap(own, *bounds) >= 1)
            && others.flat_map(|(_, swaps)| swaps).all(|other| !swap.touches(other))
    }

    /// Whether it shows only what was seen, also beside each swap near it.
    fn shows_seen(&mut self, swap: &Swap, own: Bounds) -> bool {
        let Chosen { settled, grid, states, places, .. } = self;
        let near = places.iter().filter(|(bounds, _)| *bounds != own && gap(own, *bounds) <= NEAR);
        let mut near = near.flat_map(|(_, swaps)| swaps);
        settled.shows(grid, states, &[swap]) && near.all(|other| settled.shows(grid, states, &[swap, other]))
    }
}

/// The cells between two boxes on the axis where they are farthest apart; negative where they overlap on all.
fn gap(a: Bounds, b: Bounds) -> i32 {
    (a.min - b.max).max(b.min - a.max).max_element()
}

fn site(shown: &Shown, example: usize, bounds: Bounds, swaps: &[Swap]) -> Site {
    let own = cut(&shown.cells[example], bounds);
    let instead = swaps.iter().map(|swap| {
        let mut content = own.clone();
        for (cell, terminal) in swap.cells() {
            let at = cell - bounds.min;
            content[[at.y as usize, at.z as usize, at.x as usize]] = terminal;
        }
        content
    });
    let contents = std::iter::once(own.clone()).chain(instead);
    let examples = || shown.cells.iter().take(shown.examples);
    let same_size = || examples().filter(|cells| cells.dim() == shown.cells[example].dim());
    let count = |content: &Array3<u32>| same_size().filter(|cells| cut(cells, bounds) == content).count();
    let contents = contents.map(|content| {
        let count = count(&content).max(1) as u32;
        (content, count)
    });
    Site { bounds, contents: contents.collect() }
}

fn cut(cells: &Array3<u32>, bounds: Bounds) -> Array3<u32> {
    let range = |low: i32, high: i32| low as usize..high as usize;
    let Bounds { min, max } = bounds;
    cells.slice(s![range(min.y, max.y), range(min.z, max.z), range(min.x, max.x)]).to_owned()
}
