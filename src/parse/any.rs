//! Any derivation of a split of drawn sizes, in place of the cheapest one.

use super::chart::Found;
use super::free::drawn;
use super::lengths::Law;
use super::search::Search;
use super::split::{Laid, Row};
use crate::graph::NodeIndex;
use crate::space::Length;

/// The parts of a split of which all but one have whole lengths.
#[derive(Clone, Copy)]
struct Parts<'p> {
    row: Row<'p>,
    laws: &'p [Law],
    children: &'p [NodeIndex],
    /// By part, the lengths that it may have.
    whole: &'p [Option<Vec<(i32, f64)>>],
    /// The part that takes what the others leave.
    floating: usize,
}

/// The ends of the parts that are laid: those of the first ones, and where the last ones begin, from the last on.
#[derive(Default)]
struct Ends {
    before: Vec<i32>,
    behind: Vec<i32>,
}

impl Search<'_, '_> {
    /// The first derivation of a split of which one part takes what is left; `None` for other splits.
    pub fn first_way(
        &mut self,
        row: Row<'_>,
        laws: &[Law],
        children: &[NodeIndex],
        whole: &[Option<Vec<(i32, f64)>>],
    ) -> Option<Option<Found>> {
        let mut others = (0..laws.len()).filter(|at| whole[*at].is_none());
        let floating = others.next().filter(|at| others.next().is_none() && floats(&laws[*at]))?;
        let parts = Parts { row, laws, children, whole, floating };
        let mut ends = Ends { before: vec![0], behind: vec![row.total()] };
        if !self.lay(parts, &mut ends) {
            return Some(None);
        }
        let all: Vec<i32> = ends.before.iter().copied().chain(ends.behind.iter().rev().copied()).collect();
        let laid: Vec<Laid> = (0..laws.len()).map(|at| parts.laid(at, all[at], all[at + 1])).collect();
        let cost = drawn(row, laws, &all);
        Some(self.row(row, &laid, cost))
    }

    /// Lays one part after the other, the floating one last.
    fn lay(&mut self, parts: Parts<'_>, ends: &mut Ends) -> bool {
        let (low, high) = (ends.before[ends.before.len() - 1], ends.behind[ends.behind.len() - 1]);
        let at = ends.before.len() - 1;
        if at < parts.floating {
            return self.lay_drawn(parts, at, ends, (low, high));
        }
        let last = parts.laws.len() - ends.behind.len();
        if last > parts.floating {
            return self.lay_drawn(parts, last, ends, (low, high));
        }
        self.holds(parts, parts.laid(parts.floating, low, high))
    }

    fn lay_drawn(&mut self, parts: Parts<'_>, at: usize, ends: &mut Ends, (low, high): (i32, i32)) -> bool {
        let is_before = at < parts.floating;
        let laid = |len: i32| {
            if is_before { parts.laid(at, low, low + len) } else { parts.laid(at, high - len, high) }
        };
        let lengths = parts.whole[at].iter().flatten().map(|(len, _)| *len);
        let mut laid: Vec<Laid> = lengths.filter(|len| (0..=high - low).contains(len)).map(laid).collect();
        // Where a box ends, a part is likely to.
        laid.sort_by_key(|laid| !parts.row.is_face(if is_before { laid.high } else { laid.low }));
        laid.into_iter().any(|laid| {
            if !self.holds(parts, laid) {
                return false;
            }
            let side = if is_before { &mut ends.before } else { &mut ends.behind };
            side.push(if is_before { laid.high } else { laid.low });
            let found = self.lay(parts, ends);
            if !found {
                if is_before {
                    ends.before.pop()
                } else {
                    ends.behind.pop()
                };
            }
            found
        })
    }

    fn holds(&mut self, parts: Parts<'_>, laid: Laid) -> bool {
        self.part(parts.row, &laid, parts.laws.len() as u32).is_some()
    }
}

impl Parts<'_> {
    fn laid(&self, at: usize, low: i32, high: i32) -> Laid {
        Laid { child: self.children[at], low, high, number: at as u32 }
    }
}

fn floats(law: &Law) -> bool {
    matches!(law.certain(), Some(Length::Floating(weight)) if weight > 0.0)
}
