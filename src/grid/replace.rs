use super::Grid;
use crate::block::{BlockState, PaletteFull, Replacement};
use crate::space::Cell;
use std::collections::BTreeSet;

/// What replacing did.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Replaced {
    /// How many blocks each of the replacements was for.
    pub blocks: Vec<u64>,
    /// Blocks of a material to replace, by name, that the other material has no counterpart of.
    pub left: BTreeSet<String>,
    /// What was in blocks whose successors hold nothing of the kind.
    pub block_entities: usize,
}

impl Grid {
    /// Replaces blocks, each by the first that applies, here and in the variants.
    pub fn replace(&mut self, replacements: &[Replacement]) -> Result<Replaced, PaletteFull> {
        let mut replaced =
            Replaced { blocks: vec![0; replacements.len()], left: BTreeSet::new(), block_entities: 0 };
        for grid in std::iter::once(&*self).chain(&self.variants) {
            for (state, count) in grid.counts() {
                match first(replacements, state) {
                    Some((at, _)) => replaced.blocks[at] += count,
                    None if replacements.iter().any(|rule| rule.covers(state)) => {
                        replaced.left.insert(state.short_name().to_owned());
                    }
                    None => {}
                }
            }
        }
        let before = self.holders();
        self.map_states(|old| first(replacements, old).map_or_else(|| old.clone(), |(_, new)| new))?;
        replaced.block_entities = self.drop_strangers(&before);
        Ok(replaced)
    }

    /// The kinds of blocks that block entities belong to.
    fn holders(&self) -> Vec<([i32; 3], String)> {
        let places = self.block_entities.keys();
        places.map(|place| (*place, kind(self.get(Cell::from_array(*place))).to_owned())).collect()
    }

    /// Takes away block entities whose blocks are of another kind than before. How many they were.
    fn drop_strangers(&mut self, before: &[([i32; 3], String)]) -> usize {
        let changed = |(place, old): &&([i32; 3], String)| kind(self.get(Cell::from_array(*place))) != old;
        let strangers: Vec<[i32; 3]> = before.iter().filter(changed).map(|(place, _)| *place).collect();
        strangers.iter().for_each(|place| drop(self.block_entities.remove(place)));
        strangers.len()
    }
}

fn first(replacements: &[Replacement], state: &BlockState) -> Option<(usize, BlockState)> {
    replacements.iter().enumerate().find_map(|(at, rule)| Some((at, rule.apply(state)?)))
}

/// The last word of a name: signs, beds and banners of any material are of one kind.
fn kind(state: &BlockState) -> &str {
    state.name().rsplit(['_', ':']).next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nbt::Compound;

    #[test]
    fn blocks_are_exchanged_and_counted_and_lose_what_no_longer_fits() {
        let names = ["oak_wall_sign", "chest", "spruce_planks", "oak_fence"];
        let mut grid = Grid::new(Cell::new(4, 1, 1));
        for (x, name) in (0..).zip(names) {
            let id = grid.intern(&name.parse().unwrap()).unwrap();
            grid.set(Cell::new(x, 0, 0), id);
        }
        for x in 0..2 {
            grid.block_entities.insert([x, 0, 0], Compound::new());
        }
        let rules = ["oak=stone", "oak_wall_sign=spruce_wall_sign", "spruce=oak", "chest=stone"];
        let replaced = grid.replace(&rules.map(|rule| rule.parse().unwrap())).unwrap();
        let found: Vec<String> = grid.bounds().cells().map(|cell| grid.get(cell).short()).collect();
        assert_eq!(found, ["spruce_wall_sign", "stone", "oak_planks", "oak_fence"]);
        assert_eq!(replaced.blocks, [0, 1, 1, 1]);
        assert_eq!(replaced.left, BTreeSet::from(["oak_fence".to_owned()]));
        assert_eq!((replaced.block_entities, grid.block_entities.len()), (1, 1));
    }
}
