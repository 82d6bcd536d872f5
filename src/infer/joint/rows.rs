//! Rows of single cells, each drawn by itself, but none beside another that it was never seen beside.

use super::boxes::Boxes;
use super::corpus::{Class, Corpus, is_parameter};
use super::estimate::{ALTERNATIVE, choice};
use crate::space::Axis;
use std::collections::BTreeSet;

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
}

impl Row {
    /// The row that all boxes are, if they are rows of several kinds of cells.
    pub fn of(corpus: &Corpus, boxes: &Boxes) -> Option<Row> {
        if !corpus.draws_rows {
            return None;
        }
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
        sets.all(|set| set.len() == self.kinds.len())
    }

    /// The sets of what may stand next, each once: at the start, and behind some cell.
    pub fn states(&self) -> BTreeSet<&BTreeSet<usize>> {
        let next = self.next.iter().filter(|next| !next.is_empty());
        next.chain([&self.first]).collect()
    }

    /// The bits of writing down what may stand where, beside the kinds.
    pub fn model(&self) -> f64 {
        let alternatives =
            if self.is_free() { self.kinds.len() } else { self.states().iter().map(|set| set.len()).sum() };
        ALTERNATIVE * (alternatives + self.states().len()) as f64
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

fn cells(corpus: &Corpus, class: Class, axis: Axis) -> Vec<u32> {
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
        corpus.draws_rows = true;
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
