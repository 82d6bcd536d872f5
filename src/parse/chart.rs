//! What was found for which part: equal parts are parsed once.

use super::cost::Cost;
use super::surroundings::Around;
use crate::graph::NodeIndex;
use crate::grid::Content;
use crate::space::{Bounds, Cell, Scope, Turn};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What cells that nothing was put into have to be.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Backdrop {
    Air,
    /// Whatever other operations put there.
    Others,
}

/// How exactly a derivation has to give its target.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Rigour {
    Exact,
    /// With as few other cells as there can be.
    Nearest,
}

/// A part of the target under an operation. Where the part lies does not matter.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Key {
    pub content: Content,
    pub node: NodeIndex,
    pub around: Around,
    pub turn: Turn,
    /// The number of what is there of its plan; 0 is all.
    pub footprint: u32,
    pub backdrop: Backdrop,
    pub rigour: Rigour,
}

/// What a derivation chose at one of its operations.
#[derive(Clone, PartialEq, Debug)]
pub enum Choice {
    /// There was nothing to choose.
    Only,
    /// The child of that number.
    Alternative(u32),
    /// The lengths of the parts that are not empty.
    Lengths(Arc<[i32]>),
    /// So many repetitions.
    Times(u32),
    /// Lengths that the grammar does not give: those of the parts that are not empty, by their numbers.
    Stretched(Arc<[(u32, i32)]>),
    /// The child of that number, whose condition does not hold.
    StretchedAlternative(u32),
    /// A number of repetitions that the grammar does not give.
    StretchedTimes(u32),
    /// The arguments of a call, as texts.
    Arguments(Arc<[String]>),
    /// So many cells are other than the operation says; nothing below was looked at.
    Other(u64),
}

/// A child of an operation and where it stands.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Piece {
    pub node: NodeIndex,
    pub around: Around,
    pub turn: Turn,
    /// From the low corner of the scope around it.
    pub bounds: Bounds,
}

impl Piece {
    pub fn of(node: NodeIndex, around: Around, scope: &Scope, outer: &Scope) -> Piece {
        let low = outer.bounds.min;
        let bounds = Bounds::new(scope.bounds.min - low, scope.bounds.max - low);
        Piece { node, around, turn: scope.frame.turn, bounds }
    }

    pub fn scope(&self, outer: &Scope) -> Scope {
        let low: Cell = outer.bounds.min;
        let bounds = Bounds::new(self.bounds.min + low, self.bounds.max + low);
        let mut scope = Scope { bounds, ..*outer };
        scope.frame.turn = self.turn;
        scope
    }
}

/// The cheapest way to derive a part.
#[derive(Clone, PartialEq, Debug)]
pub struct Found {
    pub cost: Cost,
    pub choice: Choice,
    pub pieces: Box<[Piece]>,
}

#[derive(Clone, Debug)]
pub enum Entry {
    /// It is being looked for, at that depth.
    Open(u32),
    /// What was found while an operation around it was still open: there may be more.
    Sofar(Arc<Found>),
    Done(Option<Arc<Found>>),
}

/// More entries are not kept from one building to the next.
const MOST_KEPT: usize = 1 << 20;

#[derive(Debug, Default)]
pub struct Chart(FxHashMap<Key, Entry>);

impl Chart {
    pub fn get(&self, key: &Key) -> Option<&Entry> {
        self.0.get(key)
    }

    pub fn set(&mut self, key: Key, entry: Entry) {
        self.0.insert(key, entry);
    }

    pub fn forget(&mut self, key: &Key) {
        self.0.remove(key);
    }

    pub fn found(&self, key: &Key) -> Option<Arc<Found>> {
        match self.0.get(key) {
            Some(Entry::Done(found)) => found.clone(),
            Some(Entry::Sofar(found)) => Some(found.clone()),
            _ => None,
        }
    }

    /// Ready for the next building.
    pub fn is_full(&self) -> bool {
        self.0.len() > MOST_KEPT
    }
}
