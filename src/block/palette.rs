use super::BlockState;
use rustc_hash::FxHashMap;

/// The distinct block states of a grid, numbered in order of first use. Number 0 is always air.
#[derive(Clone, Debug)]
pub struct Palette {
    states: Vec<BlockState>,
    ids: FxHashMap<BlockState, u16>,
}

/// A grid holds at most 65,536 distinct block states.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
#[error("more than 65,536 distinct block states")]
pub struct PaletteFull;

impl Palette {
    pub const AIR: u16 = 0;

    /// The number of `state`, which is given one if it has none yet.
    pub fn intern(&mut self, state: &BlockState) -> Result<u16, PaletteFull> {
        if let Some(&id) = self.ids.get(state) {
            return Ok(id);
        }
        let id = u16::try_from(self.states.len()).map_err(|_| PaletteFull)?;
        self.states.push(state.clone());
        self.ids.insert(state.clone(), id);
        Ok(id)
    }

    pub fn get(&self, id: u16) -> &BlockState {
        &self.states[usize::from(id)]
    }

    pub fn find(&self, state: &BlockState) -> Option<u16> {
        self.ids.get(state).copied()
    }

    /// All states in order of their numbers.
    pub fn states(&self) -> &[BlockState] {
        &self.states
    }
}

impl Default for Palette {
    fn default() -> Palette {
        let air = BlockState::air();
        Palette { ids: FxHashMap::from_iter([(air.clone(), Palette::AIR)]), states: vec![air] }
    }
}
