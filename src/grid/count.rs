use super::Grid;
use crate::block::BlockState;

impl Grid {
    /// How often each block state stands here, the most frequent first. States that stand nowhere are left out.
    pub fn counts(&self) -> Vec<(&BlockState, u64)> {
        let states = self.palette.states().iter().zip(self.counts_by_id());
        let mut counted: Vec<(&BlockState, u64)> = states.filter(|(_, count)| *count > 0).collect();
        counted.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
        counted
    }

    /// How many cells are not air of any kind nor left alone.
    pub fn blocks(&self) -> u64 {
        let states = self.palette.states().iter().zip(self.counts_by_id());
        states.filter(|(state, _)| !state.is_nothing()).map(|(_, count)| count).sum()
    }

    fn counts_by_id(&self) -> Vec<u64> {
        let mut counts = vec![0; self.palette.states().len()];
        self.cells.iter().for_each(|id| counts[usize::from(*id)] += 1);
        counts
    }
}
