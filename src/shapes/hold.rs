//! Which shapes of a production hang together.

use super::production::{Production, around};
use crate::space::Cell;
use petgraph::unionfind::UnionFind;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The shapes of a production in groups: those of one group share blocks, or have blocks that share a face.
pub fn groups(production: &Production<'_>) -> Vec<Vec<usize>> {
    let mut holders: FxHashMap<Cell, usize> = FxHashMap::default();
    let mut joined = UnionFind::new(production.placed().len());
    for (index, placed) in production.placed().iter().enumerate() {
        for (cell, _) in production.blocks(placed) {
            joined.union(index, *holders.entry(cell).or_insert(index));
            for beside in around(cell) {
                if let Some(other) = holders.get(&beside) {
                    joined.union(index, *other);
                }
            }
        }
    }
    let mut groups: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for index in 0..production.placed().len() {
        groups.entry(joined.find(index)).or_default().push(index);
    }
    let mut groups: Vec<Vec<usize>> = groups.into_values().collect();
    // By their first shapes: which of a group stands for it is of no account.
    groups.sort();
    groups
}
