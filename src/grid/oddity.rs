use super::Grid;
use crate::block::{self, BlockState, Version};
use crate::nbt::Tag;
use crate::space::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Something in a build that its maker hardly meant.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Oddity {
    /// Blocks of the game, by name, that are not known.
    UnknownBlocks(BTreeSet<String>),
    /// States that known blocks cannot be in, in words.
    BadStates(BTreeSet<String>),
    /// How many blocks lack their other half, by name.
    Halves(BTreeMap<String, u64>),
    /// Block entities where no block is.
    EmptyBlockEntities(usize),
    /// Block entities without an `id`.
    UnnamedBlockEntities(usize),
    EntitiesOutside(usize),
    NoDataVersion,
}

impl Grid {
    /// What is odd about this build.
    pub fn oddities(&self) -> Vec<Oddity> {
        let states: Vec<&BlockState> = self.counts().into_iter().map(|(state, _)| state).collect();
        let entities = &self.metadata.entities;
        let outside = entities.iter().filter(|entity| !self.bounds().contains(entity.home()));
        let unnamed =
            self.block_entities.values().filter(|data| !matches!(data.get("id"), Some(Tag::String(_))));
        let empty =
            self.block_entities.keys().filter(|place| self.get(Cell::from_array(**place)).is_nothing());
        let found = [
            Some(Oddity::UnknownBlocks(unknown(&states))),
            Some(Oddity::BadStates(self.bad_states(&states))),
            Some(Oddity::Halves(self.lone_halves())),
            Some(Oddity::EmptyBlockEntities(empty.count())),
            Some(Oddity::UnnamedBlockEntities(unnamed.count())),
            Some(Oddity::EntitiesOutside(outside.count())),
            self.metadata.data_version.is_none().then_some(Oddity::NoDataVersion),
        ];
        found.into_iter().flatten().filter(|oddity| !oddity.is_none()).collect()
    }

    /// What blocks cannot be in the version of the build; in any where it does not say its version. Nothing is known
    /// of states before 1.13.
    fn bad_states(&self, states: &[&BlockState]) -> BTreeSet<String> {
        match self.metadata.data_version.map(Version::of_data) {
            Some(None) => BTreeSet::new(),
            Some(Some(version)) => states.iter().filter_map(|state| bad_in(state, version)).collect(),
            None => states.iter().filter_map(|state| bad(state)).collect(),
        }
    }

    fn lone_halves(&self) -> BTreeMap<String, u64> {
        let states = self.palette.states();
        let steps = states.iter().map(|state| Some(block::other_half(state)?.0));
        let steps: Vec<Option<Cell>> = steps.collect();
        let mut lone = BTreeMap::new();
        for ((y, z, x), id) in self.cells.indexed_iter() {
            let Some(step) = steps[usize::from(*id)] else { continue };
            let other = Cell::new(x as i32, y as i32, z as i32) + step;
            let state = &states[usize::from(*id)];
            let is_there = self.bounds().contains(other) && block::is_other_half(state, self.get(other));
            if !is_there {
                *lone.entry(state.short_name().to_owned()).or_insert(0) += 1;
            }
        }
        lone
    }
}

fn unknown(states: &[&BlockState]) -> BTreeSet<String> {
    let of_game = states.iter().filter(|state| state.name().starts_with("minecraft:"));
    let unknown = of_game.filter(|state| block::known(state.name()).is_none());
    unknown.map(|state| state.short_name().to_owned()).collect()
}

fn bad(state: &BlockState) -> Option<String> {
    block::check(state).err().map(|problem| problem.to_string())
}

/// Why `version` does not have `state`.
fn bad_in(state: &BlockState, version: Version) -> Option<String> {
    let new = block::translated(state, version, Version::newest()).unwrap_or_else(|_| state.clone());
    if let Some(problem) = bad(&new) {
        return Some(problem);
    }
    let newer = || block::translated(state, version, version).err().map(|newer| newer.to_string());
    let unknown = || format!("`{}` is not of Minecraft {version}", state.short());
    (!block::legal_in(state, version)).then(|| newer().unwrap_or_else(unknown))
}

impl Oddity {
    /// Whether there is nothing of the kind.
    fn is_none(&self) -> bool {
        match self {
            Oddity::UnknownBlocks(names) | Oddity::BadStates(names) => names.is_empty(),
            Oddity::Halves(counts) => counts.is_empty(),
            Oddity::EmptyBlockEntities(count)
            | Oddity::UnnamedBlockEntities(count)
            | Oddity::EntitiesOutside(count) => *count == 0,
            Oddity::NoDataVersion => false,
        }
    }
}

impl fmt::Display for Oddity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Oddity::UnknownBlocks(names) => write!(f, "unknown blocks: {}", listed(names, ", ")),
            Oddity::BadStates(problems) => write!(f, "{}", listed(problems, "; ")),
            Oddity::Halves(counts) => {
                let each: BTreeSet<String> =
                    counts.iter().map(|(name, count)| format!("{count} {name}")).collect();
                write!(f, "without their other half: {}", listed(&each, ", "))
            }
            Oddity::EmptyBlockEntities(count) => write!(f, "block entities where no block is: {count}"),
            Oddity::UnnamedBlockEntities(count) => write!(f, "block entities without an `id`: {count}"),
            Oddity::EntitiesOutside(count) => write!(f, "entities outside of the building: {count}"),
            Oddity::NoDataVersion => write!(f, "the file does not say which game version it is of"),
        }
    }
}

fn listed(texts: &BTreeSet<String>, between: &str) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<&str> = texts.iter().take(SHOWN).map(String::as_str).collect();
    let more = texts.len().saturating_sub(SHOWN);
    let more = if more > 0 { format!("{between}and {more} more") } else { String::new() };
    format!("{}{more}", shown.join(between))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Entity;
    use crate::nbt::Compound;

    fn told(grid: &Grid) -> Vec<String> {
        grid.oddities().iter().map(Oddity::to_string).collect()
    }

    #[test]
    fn a_sound_build_has_none() {
        let mut grid =
            Grid::row(&["red_bed[facing=east,part=foot]", "red_bed[facing=east,part=head]", "mod:x[a=b]"]);
        grid.metadata.data_version = Some(3465);
        assert_eq!(grid.oddities(), []);
    }

    #[test]
    fn each_is_told() {
        let mut grid = Grid::row(&["oak_door[half=lower]", "stone[lit=true]", "glowing_rock", "air"]);
        grid.block_entities.insert([3, 0, 0], Compound::new());
        grid.metadata.entities.push(Entity { place: [9.0, 0.0, 0.0], block: None, data: Compound::new() });
        let expected = [
            "unknown blocks: glowing_rock",
            "`stone` has no property `lit`: it takes none",
            "without their other half: 1 oak_door",
            "block entities where no block is: 1",
            "block entities without an `id`: 1",
            "entities outside of the building: 1",
            "the file does not say which game version it is of",
        ];
        assert_eq!(told(&grid), expected);
    }

    #[test]
    fn states_are_held_against_the_version_of_the_build() {
        let mut grid =
            Grid::row(&["cobblestone_wall[east=true]", "chain[axis=x]", "cherry_planks", "grass_path"]);
        let mut told_of = |data_version| {
            grid.metadata.data_version = Some(data_version);
            told(&grid)
        };
        let wall = "`cobblestone_wall` cannot have east=true: east is one of none, low, tall";
        let cherry = "`cherry_planks` needs Minecraft 1.19.4";
        let chain = "`chain[axis=x]` needs Minecraft 1.16.2";
        assert_eq!(told_of(2230), [format!("{chain}; {cherry}")]);
        assert_eq!(told_of(2586), [format!("{cherry}; {wall}")]);
        assert_eq!(told_of(3465), [format!("{wall}; `grass_path` is not of Minecraft 1.20.1")]);
        assert_eq!(told_of(1343), [""; 0]);
    }
}
