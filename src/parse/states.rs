//! Block states and kinds of cells by number.

use crate::block::{BlockState, Version, as_in, complete_in};
use crate::neighbours::decided;
use rustc_hash::FxHashMap;

/// The number of a block state.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct StateId(u32);

/// The number of a kind of cell: its state as a grammar writes it, and as it is among its neighbours.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct KindId(u32);

impl KindId {
    pub fn number(self) -> u32 {
        self.0
    }
}

#[derive(Debug)]
pub struct States {
    /// The version of the game that the states are of.
    version: Version,
    numbers: FxHashMap<BlockState, StateId>,
    /// The numbers of states as grammars write them.
    written: FxHashMap<BlockState, StateId>,
    kinds: Vec<Kind>,
    kind_numbers: FxHashMap<(StateId, StateId), KindId>,
}

#[derive(Clone, Copy, Debug)]
struct Kind {
    open: StateId,
    settled: StateId,
}

impl States {
    const AIR: StateId = StateId(0);

    /// The kind of a cell that may be anything.
    pub const FREE: KindId = KindId(0);

    pub fn of(version: Version) -> States {
        let numbers = FxHashMap::from_iter([(BlockState::air(), States::AIR)]);
        let free = Kind { open: States::AIR, settled: States::AIR };
        States {
            version,
            numbers,
            written: FxHashMap::default(),
            kinds: vec![free],
            kind_numbers: FxHashMap::default(),
        }
    }

    pub fn version(&self) -> Version {
        self.version
    }

    pub fn number(&mut self, state: &BlockState) -> StateId {
        if let Some(&id) = self.numbers.get(state) {
            return id;
        }
        let id = StateId(self.numbers.len() as u32);
        self.numbers.insert(state.clone(), id);
        id
    }

    /// The number of a state that a grammar writes: what the version has and the state leaves out is at its default,
    /// but for what neighbours decide.
    pub fn written(&mut self, state: &BlockState) -> StateId {
        if let Some(&id) = self.written.get(state) {
            return id;
        }
        let keys = decided(state).iter().filter(|key| state.get(key).is_none());
        let full = complete_in(&as_in(state, self.version), self.version);
        let open = keys.fold(full, |open, key| open.without(key));
        let id = self.number(&open);
        self.written.insert(state.clone(), id);
        id
    }

    pub fn kind(&mut self, open: StateId, settled: StateId) -> KindId {
        *self.kind_numbers.entry((open, settled)).or_insert_with(|| {
            self.kinds.push(Kind { open, settled });
            KindId(self.kinds.len() as u32 - 1)
        })
    }

    /// Whether a grammar that writes `state` may have made a cell of that kind.
    pub fn gives(&self, state: StateId, kind: KindId) -> bool {
        let Kind { open, settled } = self.kinds[kind.0 as usize];
        kind == States::FREE || state == open || state == settled
    }

    pub fn is_air(&self, kind: KindId) -> bool {
        self.kinds[kind.0 as usize].settled == States::AIR
    }
}
