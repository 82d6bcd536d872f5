//! Rows of single cells, each drawn by itself, but none beside another that it was never seen beside.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, is_parameter};
use super::estimate::{ALTERNATIVE, choice};
use super::feasible::Lengths;
use crate::space::Axis;
use std::collections::{BTreeMap, BTreeSet};

/// A row at least as long as this tells a row from a few things side by side.
const LONG: i32 = 3;
/// So many runs on average are a wall with one feature, as a window, at the most.
const FEATURE: u32 = 3;
/// More kinds of cells are no row of things that may stand anywhere.
const MOST: usize = 8;

/// What the cells of rows are, and what may stand behind what.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Row {
    pub axis: Axis,
    /// The terminals, each with how often it was seen.
    pub kinds: Vec<(u32, u32)>,
    /// The kinds that may stand first.
    pub first: BTreeSet<usize>,
    /// By kind, those that may stand behind it.
    pub next: Vec<BTreeSet<usize>>,
    /// The kinds that may stand last.
    pub last: BTreeSet<usize>,
    /// What may not stand behind what, at one end or between the ends, though it was seen elsewhere to.
    pub barred: BTreeSet<(Pair, usize, usize)>,
}

/// Which two cells of a row.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Pair {
    First,
    Inner,
    Last,
}

/// What may stand next in a row.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct State {
    /// The kinds that may stand before others.
    pub before: BTreeSet<usize>,
    /// The kinds that may stand last.
    pub last: BTreeSet<usize>,
    /// Which pair the next cell and the one behind it are.
    from: Pair,
}

impl Row {
    /// The row that all boxes are, if they are rows of several kinds of cells.
    pub fn of(corpus: &Corpus, boxes: &Boxes) -> Option<Row> {
        // What stands on what is no chance.
        let axis = [Axis::X, Axis::Z].into_iter().find(|axis| is_along(corpus, boxes, *axis))?;
        let rows: Vec<(Vec<u32>, u32)> =
            boxes.iter().map(|(class, count)| (cells(corpus, class, axis), count)).collect();
        let runs: u32 = rows.iter().map(|(cells, count)| count * runs(cells)).sum();
        if runs <= FEATURE * boxes.count() {
            return None;
        }
        let terminals: BTreeSet<u32> = rows.iter().flat_map(|(cells, _)| cells.iter().copied()).collect();
        if !(2..=MOST).contains(&terminals.len()) || terminals.iter().copied().any(is_parameter) {
            return None;
        }
        let mut row = Row {
            axis,
            kinds: terminals.into_iter().map(|terminal| (terminal, 0)).collect(),
            first: BTreeSet::new(),
            next: Vec::new(),
            last: BTreeSet::new(),
            barred: BTreeSet::new(),
        };
        row.next = vec![BTreeSet::new(); row.kinds.len()];
        rows.iter().for_each(|(cells, count)| row.see(cells, *count));
        Some(row)
    }

    fn see(&mut self, cells: &[u32], count: u32) {
        let kinds: Vec<usize> = cells.iter().filter_map(|terminal| self.kind(*terminal)).collect();
        kinds.iter().for_each(|kind| self.kinds[*kind].1 += count);
        self.first.extend(kinds.first());
        self.last.extend(kinds.last());
        for pair in kinds.windows(2) {
            self.next[pair[0]].insert(pair[1]);
        }
    }

    pub fn kind(&self, terminal: u32) -> Option<usize> {
        self.kinds.iter().position(|(known, _)| *known == terminal)
    }

    /// Whether any cell may stand anywhere.
    pub fn is_free(&self) -> bool {
        let mut sets = self.next.iter().chain([&self.first, &self.last]);
        self.barred.is_empty() && sets.all(|set| set.len() == self.kinds.len())
    }

    /// What may stand first.
    pub fn start(&self) -> State {
        let is_told = self.barred.iter().any(|(pair, ..)| *pair == Pair::First);
        State {
            before: self.first.clone(),
            last: &self.first & &self.last,
            from: if is_told { Pair::First } else { Pair::Inner },
        }
    }

    /// What may stand behind a cell of a kind that stood next.
    pub fn after(&self, state: &State, kind: usize) -> State {
        let may = |pair: Pair| {
            let is_barred = move |other: &usize| self.barred.contains(&(pair, kind, *other));
            self.next[kind].iter().copied().filter(move |other| !is_barred(other))
        };
        let last: BTreeSet<usize> = may(Pair::Last).filter(|other| self.last.contains(other)).collect();
        State { before: may(state.from).collect(), last, from: Pair::Inner }
    }

    /// All that may stand next somewhere: first, and behind some cell.
    pub fn states(&self) -> BTreeSet<State> {
        let mut states = BTreeSet::new();
        let mut open = vec![self.start()];
        while let Some(state) = open.pop() {
            if states.insert(state.clone()) {
                open.extend(state.before.iter().map(|kind| self.after(&state, *kind)));
            }
        }
        states
    }

    /// How long what stands next and all behind it can be together, by state.
    pub fn lengths(&self) -> BTreeMap<State, Lengths> {
        let mut lengths: BTreeMap<State, Lengths> =
            self.states().into_iter().map(|state| (state, Lengths::NONE)).collect();
        loop {
            let longer: Vec<(State, Lengths)> = lengths
                .keys()
                .map(|state| {
                    let kinds = state.before.iter().chain(&state.last);
                    let all = kinds.map(|kind| self.lengths_with(state, *kind, &lengths));
                    (state.clone(), all.fold(Lengths::NONE, Lengths::or))
                })
                .collect();
            if longer.iter().all(|(state, all)| lengths[state] == *all) {
                return lengths;
            }
            lengths.extend(longer);
        }
    }

    /// The same with a cell of that kind next.
    pub fn lengths_with(&self, state: &State, kind: usize, lengths: &BTreeMap<State, Lengths>) -> Lengths {
        let alone = if state.last.contains(&kind) { Lengths::of([1]) } else { Lengths::NONE };
        match state.before.contains(&kind) {
            true => alone.or(Lengths::of([1]).plus(lengths[&self.after(state, kind)])),
            false => alone,
        }
    }

    /// The pair of a row's cells whose first one has that number, of kinds that no row of `seen` has there.
    pub fn unseen(&self, cells: &[u32], number: usize, seen: &[Vec<u32>]) -> Option<(Pair, usize, usize)> {
        let which = |len: usize, number: usize| match (number == 0, number + 2 == len) {
            (true, _) => Pair::First,
            (false, true) => Pair::Last,
            (false, false) => Pair::Inner,
        };
        let pair = which(cells.len(), number);
        let own = [*cells.get(number)?, *cells.get(number + 1)?];
        let has = |row: &Vec<u32>| {
            let mut pairs = row.windows(2).enumerate();
            pairs.any(|(at, other)| which(row.len(), at) == pair && other == own)
        };
        let [one, other] = own.map(|terminal| self.kind(terminal));
        (!seen.iter().any(has)).then_some((pair, one?, other?))
    }

    /// The bits of writing down what may stand where, beside the kinds.
    pub fn model(&self) -> f64 {
        let states = self.states();
        let alternatives = match self.is_free() {
            true => self.kinds.len(),
            false => states.iter().map(|state| state.before.union(&state.last).count()).sum(),
        };
        ALTERNATIVE * (alternatives + states.len()) as f64
    }

    /// The bits of drawing all cells.
    pub fn chance(&self) -> f64 {
        choice(self.kinds.iter().map(|(_, count)| count))
    }
}

fn is_along(corpus: &Corpus, boxes: &Boxes, axis: Axis) -> bool {
    let len = |class: Class, axis: Axis| corpus.profile(class).len(axis);
    let others = || Axis::ALL.into_iter().filter(|other| *other != axis);
    boxes.classes().all(|class| others().all(|other| len(class, other) == 1))
        && boxes.classes().any(|class| len(class, axis) >= LONG)
        && boxes
            .classes()
            .all(|class| (1..len(class, axis)).all(|at| !corpus.is_whole_across(class, axis, at)))
}

fn runs(cells: &[u32]) -> u32 {
    1 + cells.windows(2).filter(|pair| pair[0] != pair[1]).count() as u32
}

/// The terminals of a row.
pub fn cells(corpus: &Corpus, class: Class, axis: Axis) -> Vec<u32> {
    let place = corpus.profile(class).place;
    let cells = place.bounds.cells().map(|cell| corpus.volume(place).get(cell)).collect::<Vec<u32>>();
    debug_assert_eq!(cells.len() as i32, place.bounds.len(axis));
    cells
}

#[cfg(test)]
mod tests {
    use super::super::volume::Volume;
    use super::*;
    use ndarray::Array3;

    const AIR: u32 = 0;

    fn row(rows: &[&str]) -> Option<Row> {
        let volume = |row: &&str| {
            let cells = row.bytes().map(u32::from).collect();
            Volume::new(Array3::from_shape_vec((1, 1, row.len()), cells).unwrap_or_default(), &[])
        };
        let mut corpus = Corpus::new(rows.iter().map(volume).collect(), AIR);
        let places = corpus.examples();
        let boxes = Boxes::of(places.into_iter().map(|place| (corpus.class(place), 1)));
        Row::of(&corpus, &boxes)
    }

    #[test]
    fn what_may_follow_is_what_was_seen_to() {
        let row = row(&["aabab", "bab"]).expect("a row");
        assert_eq!(row.kinds, [(u32::from(b'a'), 4), (u32::from(b'b'), 4)]);
        assert_eq!(row.next, [BTreeSet::from([0, 1]), BTreeSet::from([0])]);
        assert_eq!((row.first.len(), row.last.len()), (2, 1));
        assert!(!row.is_free());
        assert_eq!(row.states().len(), 2);
    }

    #[test]
    fn what_is_barred_at_the_end_stands_elsewhere() {
        let row = row(&["aabab", "bab"]).expect("a row");
        let rows = ["aabab", "bab"].map(|row| row.bytes().map(u32::from).collect::<Vec<u32>>());
        let made: Vec<u32> = "babaab".bytes().map(u32::from).collect();
        assert_eq!(row.unseen(&made, 0, &rows), None, "ba stands first");
        assert_eq!(row.unseen(&made, 3, &rows), Some((Pair::Inner, 0, 0)), "aa stands first only");
        assert_eq!(row.unseen(&made, 4, &rows), None, "ab stands last");
        let barred = Row { barred: [(Pair::First, 1, 0)].into(), ..row.clone() };
        let start = barred.start();
        assert_eq!(barred.after(&start, 1).before, BTreeSet::new());
        let later = barred.after(&start, 0);
        assert_eq!(barred.after(&later, 1).before, BTreeSet::from([0]));
        let lengths = barred.lengths();
        assert!(barred.lengths_with(&start, 1, &lengths) == Lengths::of([1]), "b alone is a row");
    }

    #[test]
    fn where_all_was_seen_beside_all_cells_are_free() {
        assert!(row(&["aabbaba", "bab"]).is_some_and(|row| row.is_free()));
    }

    #[test]
    fn two_cells_one_kind_and_walls_with_a_window_are_no_row() {
        assert_eq!(row(&["aabaa", "abaa", "aaa"]), None);
        assert_eq!(row(&["ab", "ba"]), None);
        assert_eq!(row(&["aaa", "aaaa"]), None);
    }
}
