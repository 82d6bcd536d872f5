use super::era::{self, Kept};
use super::{DEFAULT_DATA_VERSION, Grid};
use crate::block::{BlockState, Newer, PaletteFull, Version, legal_in, translated};
use std::collections::BTreeSet;

/// Why a build cannot be brought to a version of the game.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NotIn {
    /// With what each of the blocks needs, in words.
    #[error("Minecraft {to} does not have {}", listed(blocks))]
    Blocks { to: Version, blocks: BTreeSet<String> },
    #[error(
        "its block states are those before Minecraft 1.13 (data version {0}), and are not translated to later ones"
    )]
    OldStates(i32),
    #[error(transparent)]
    Full(#[from] PaletteFull),
}

fn listed(blocks: &BTreeSet<String>) -> String {
    blocks.iter().map(String::as_str).collect::<Vec<_>>().join(", ")
}

impl Grid {
    /// The data version that the build says, or else that of the first version from the default one on that has all
    /// of its blocks.
    pub fn data_version(&self) -> i32 {
        let default = || Version::of_data(DEFAULT_DATA_VERSION).unwrap_or(Version::newest());
        self.metadata.data_version.unwrap_or_else(|| self.least_version(default()).data_version())
    }

    /// The version of the game whose properties block states have. Before 1.13 they had names of their own, which
    /// nothing is known of.
    pub fn version(&self) -> Version {
        Version::of_data(self.data_version()).unwrap_or(Version::oldest())
    }

    /// The first version from `least` on that has all of its blocks.
    pub fn least_version(&self, least: Version) -> Version {
        // The palette may hold states that no cell has any more, but cells need no look where it asks for nothing.
        let mut palettes = std::iter::once(self).chain(&self.variants).map(|grid| grid.palette().states());
        match palettes.any(|states| states.iter().any(|state| first_with(state, least) != least)) {
            true => self.states().fold(least, |least, state| first_with(state, least)),
            false => least,
        }
    }

    /// Brings blocks and what is in them to another version. What keeps its form is given back.
    pub fn bring_to(&mut self, to: Version) -> Result<Kept, NotIn> {
        let from = match Version::of_data(self.data_version()) {
            Some(from) => from,
            None => return Err(NotIn::OldStates(self.data_version())),
        };
        let newer = self.states().filter_map(|state| translated(state, from, to).err());
        let blocks: BTreeSet<String> =
            newer.map(|Newer { state, needs }| format!("{} ({needs})", newer_part(&state, to))).collect();
        if !blocks.is_empty() {
            return Err(NotIn::Blocks { to, blocks });
        }
        self.map_states(|old| translated(old, from, to).unwrap_or_else(|_| old.clone()))?;
        let mut kept = Kept::default();
        self.translate_data(from, to, &mut kept);
        self.metadata.data_version = Some(to.data_version());
        Ok(kept)
    }

    fn translate_data(&mut self, from: Version, to: Version, kept: &mut Kept) {
        let entities = self.metadata.entities.iter_mut().map(|entity| &mut entity.data);
        entities
            .chain(self.block_entities.values_mut())
            .for_each(|data| era::translate(data, from, to, kept));
        self.variants.iter_mut().for_each(|variant| variant.translate_data(from, to, kept));
    }

    /// The states that stand here and in the variants, some more than once.
    fn states(&self) -> impl Iterator<Item = &BlockState> {
        let builds = std::iter::once(self).chain(&self.variants);
        builds.flat_map(Grid::counts).map(|(state, _)| state)
    }
}

/// The first version from `least` on that has `state`; `least` where none has it.
fn first_with(state: &BlockState, least: Version) -> Version {
    let mut later = Version::all().filter(|version| *version >= least);
    later.find(|version| legal_in(state, *version)).unwrap_or(least)
}

/// The block, or its state where `version` has the block in others.
fn newer_part(state: &BlockState, version: Version) -> String {
    let bare = state.properties().fold(state.clone(), |bare, (key, _)| bare.without(key));
    if legal_in(&bare, version) { state.short() } else { bare.short() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Cell;

    #[test]
    fn a_build_that_says_no_version_is_of_the_first_with_all_its_blocks() {
        let cases = [
            (&["stone", "oak_stairs[facing=east]", "mod:x[a=b]"][..], DEFAULT_DATA_VERSION),
            (&["short_grass"], 3698),
            (&["short_grass", "pale_oak_planks"], 4080),
            // Of before, and never there.
            (&["grass_path"], DEFAULT_DATA_VERSION),
            (&["nonsense", "short_grass"], 3698),
        ];
        for (names, expected) in cases {
            assert_eq!(Grid::row(names).data_version(), expected, "{names:?}");
        }
        let mut unused = Grid::row(&["stone"]);
        unused.intern(&"short_grass".parse().unwrap()).unwrap();
        assert_eq!(unused.data_version(), DEFAULT_DATA_VERSION, "what stands nowhere does not count");
        unused.metadata.data_version = Some(1343);
        assert_eq!(unused.data_version(), 1343);
    }

    #[test]
    fn variants_count_as_well() {
        let mut grid = Grid::row(&["stone"]);
        grid.variants.push(Grid::row(&["short_grass"]));
        assert_eq!(grid.data_version(), 3698);
    }

    #[test]
    fn states_of_before_names_are_not_taken_for_later_ones() {
        let mut grid = Grid::row(&["planks[variant=oak]"]);
        grid.metadata.data_version = Some(1343);
        let to = Version::newest();
        assert_eq!(grid.bring_to(to), Err(NotIn::OldStates(1343)));
        assert_eq!(grid.metadata.data_version, Some(1343));
    }

    #[test]
    fn states_and_data_are_brought_along() {
        let mut grid = Grid::row(&["grass", "oak_sign"]);
        grid.metadata.data_version = Some(3337);
        let tags = [("id", "minecraft:sign"), ("Text1", "\"Inn\"")];
        let data = tags.map(|(name, text)| (name.to_owned(), crate::nbt::Tag::String(text.to_owned())));
        grid.block_entities.insert([1, 0, 0], data.into_iter().collect());
        let kept = grid.bring_to(Version::named("1.20.4").unwrap()).unwrap();
        assert!(kept.is_none(), "{kept}");
        assert_eq!(grid.get(Cell::ZERO).short(), "short_grass");
        assert!(grid.block_entities[&[1, 0, 0]].contains_key("front_text"));
        assert_eq!(grid.metadata.data_version, Some(3700));
        let newer = Grid::row(&["cherry_planks"]).bring_to(Version::oldest()).unwrap_err().to_string();
        assert!(newer.starts_with("Minecraft 1.13 does not have "), "{newer}");
    }
}
