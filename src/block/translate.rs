//! Block states from one version of the game to another.

use super::pattern::fits;
use super::version::{Change, Pattern, Ways};
use super::{BlockState, Version, known};

/// Why a state cannot be translated down: a block, or a property of it, came later.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("`{}` needs Minecraft {needs}", state.short())]
pub struct Newer {
    pub state: BlockState,
    pub needs: Version,
}

/// Whether `version` has the block and knows all that `state` says of it. Blocks that are not of the game pass.
pub fn legal_in(state: &BlockState, version: Version) -> bool {
    let has_come = |at: Version| at <= version;
    is_foreign(state)
        || Version::all().all(|at| match has_come(at) {
            true => is_current(state, at),
            false => is_older(state, at),
        })
}

/// What `state` of version `from` is in version `to`, by way of the newest one: what `to` does not have is told
/// even where `from` does not have it either. Newer properties are left out where they say no more than their default;
/// walls and jigsaws take what comes nearest.
pub fn translated(state: &BlockState, from: Version, to: Version) -> Result<BlockState, Newer> {
    if is_foreign(state) {
        return Ok(state.clone());
    }
    let newest = Version::all().filter(|at| from < *at).fold(state.clone(), raised);
    let mut passed = Version::all().rev().filter(|at| to < *at);
    passed
        .try_fold(newest, |old, at| lowered(old, at).ok_or_else(|| Newer { state: state.clone(), needs: at }))
}

/// `state` in the words of `version`: without what came later and says no more than its default. What `version` does not
/// have stays as it is.
pub fn as_in(state: &BlockState, version: Version) -> BlockState {
    translated(state, version, version).unwrap_or_else(|_| state.clone())
}

fn is_foreign(state: &BlockState) -> bool {
    !state.name().starts_with("minecraft:")
}

/// The state in `at`, from the version before.
fn raised(state: BlockState, at: Version) -> BlockState {
    renames(at)
        .filter(|(_, _, ways)| *ways == Ways::Both)
        .fold(state, |state, (old, new, _)| exchanged(&state, old, new).unwrap_or(state))
}

/// The state in the version before `at`; `None` where there is no such.
fn lowered(state: BlockState, at: Version) -> Option<BlockState> {
    let named = |old: &Pattern, new: &Pattern| old.name != new.name;
    let mut of_other_name = renames(at).filter(|(old, new, _)| named(old, new));
    if let Some(old) = of_other_name.find_map(|(old, new, _)| exchanged(&state, new, old)) {
        return Some(old);
    }
    if comes_with(&state, at) {
        return None;
    }
    let same_name = renames(at).filter(|(old, new, _)| !named(old, new));
    let state = same_name.fold(state, |state, (old, new, _)| exchanged(&state, new, old).unwrap_or(state));
    without_new_properties(state, at)
}

/// Takes off the properties that came with `at`; `None` where they say something.
fn without_new_properties(mut state: BlockState, at: Version) -> Option<BlockState> {
    for (key, values) in new_properties(&state, at) {
        let Some(value) = state.get(key) else { continue };
        match values {
            Some(values) if values.contains(&value) => return None,
            Some(_) => {}
            None if is_default(&state, key) => state = state.without(key),
            None => return None,
        }
    }
    Some(state)
}

fn is_default(state: &BlockState, key: &str) -> bool {
    let property = known(state.name()).and_then(|known| known.property(key));
    property.is_some_and(|property| Some(property.default) == state.get(key))
}

/// Whether nothing of the state was given up in `at`.
fn is_current(state: &BlockState, at: Version) -> bool {
    let is_old = |(old, _, ways): (&Pattern, &Pattern, Ways)| ways == Ways::Both && holds(state, old);
    comes_with(state, at) || !renames(at).any(is_old)
}

/// Whether nothing of the state came with `at`.
fn is_older(state: &BlockState, at: Version) -> bool {
    let says_more = |old: &Pattern, new: &Pattern| new.name != old.name || !new.properties.is_empty();
    let is_new = |(old, new, _): (&Pattern, &Pattern, Ways)| says_more(old, new) && holds(state, new);
    let was = renames(at).any(|(old, _, _)| old.properties.is_empty() && holds(state, old));
    let has_new = |(key, values): (&str, Option<&[&str]>)| {
        let value = state.get(key);
        value.is_some_and(|value| values.is_none_or(|values| values.contains(&value)))
    };
    (was || !comes_with(state, at)) && !renames(at).any(is_new) && !new_properties(state, at).any(has_new)
}

fn renames(at: Version) -> impl Iterator<Item = (&'static Pattern, &'static Pattern, Ways)> {
    at.changes().iter().filter_map(|change| match change {
        Change::Renamed { old, new, ways } => Some((old, new, *ways)),
        _ => None,
    })
}

/// Whether a block of that name came with `at`.
fn comes_with(state: &BlockState, at: Version) -> bool {
    let is_new = |change: &Change| matches!(change, Change::Blocks(new) if new.contains(&state.short_name()));
    at.changes().iter().any(is_new)
}

/// The properties of the block that came with `at`; with values where only these are new.
fn new_properties(
    state: &BlockState,
    at: Version,
) -> impl Iterator<Item = (&'static str, Option<&'static [&'static str]>)> + use<> {
    let name = state.short_name().to_owned();
    at.changes().iter().filter_map(move |change| match change {
        Change::Property { key, values, blocks } if blocks.contains(&&*name) => {
            Some((*key, values.as_deref()))
        }
        _ => None,
    })
}

fn holds(state: &BlockState, pattern: &Pattern) -> bool {
    fits(pattern.name, state.short_name())
        && pattern.properties.iter().all(|(key, value)| state.get(key) == Some(value))
}

/// `state` as `into` has it, if it is as `from` has it.
fn exchanged(state: &BlockState, from: &Pattern, into: &Pattern) -> Option<BlockState> {
    holds(state, from).then(|| {
        let named = match into.name.contains('*') {
            true => state.clone(),
            false => state.renamed(into.name),
        };
        let kept = from.properties.iter().fold(named, |state, (key, _)| state.without(key));
        into.properties.iter().fold(kept, |state, (key, value)| state.with(key, value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    fn version(name: &str) -> Version {
        Version::named(name).unwrap()
    }

    fn moved(text: &str, from: &str, to: &str) -> String {
        match translated(&text.parse().unwrap(), version(from), version(to)) {
            Ok(state) => state.short(),
            Err(newer) => newer.to_string(),
        }
    }

    #[test]
    fn names_and_states_change_with_versions() {
        let cases = [
            ("1.16.5", "grass_path", "1.17", "dirt_path"),
            ("1.16.5", "cauldron[level=2]", "1.17", "water_cauldron[level=2]"),
            ("1.16.5", "cauldron[level=0]", "1.20.1", "cauldron"),
            ("1.20.2", "grass", "1.20.3", "short_grass"),
            (
                "1.13.2",
                "sign[rotation=4,waterlogged=false]",
                "1.14",
                "oak_sign[rotation=4,waterlogged=false]",
            ),
            ("1.13", "wall_sign[facing=east]", "1.21.11", "oak_wall_sign[facing=east]"),
            ("1.13", "stone_slab[type=top]", "1.14", "smooth_stone_slab[type=top]"),
            ("1.21.8", "chain[axis=x]", "1.21.9", "iron_chain[axis=x]"),
            (
                "1.15.2",
                "cobblestone_wall[east=true,north=false,up=true]",
                "1.16",
                "cobblestone_wall[east=low,north=none,up=true]",
            ),
            ("1.15.2", "jigsaw[facing=east]", "1.16", "jigsaw[orientation=east_up]"),
        ];
        for (from, old, to, new) in cases {
            assert_eq!(moved(old, from, to), new);
            assert_eq!(moved(new, to, from), old);
        }
    }

    #[test]
    fn what_comes_nearest_is_taken_on_the_way_down() {
        let cases = [
            ("cobblestone_wall[east=tall]", "1.15.2", "cobblestone_wall[east=true]"),
            ("jigsaw[orientation=up_east]", "1.15.2", "jigsaw[facing=up]"),
            ("rail[waterlogged=false]", "1.16.5", "rail"),
            ("iron_chain[axis=y,waterlogged=true]", "1.16.1", "chain[waterlogged=true]"),
        ];
        for (text, to, expected) in cases {
            assert_eq!(moved(text, "1.21.11", to), expected);
        }
    }

    #[test]
    fn what_is_newer_names_the_version_that_it_needs() {
        let cases = [
            ("lava_cauldron", "1.16.5", "`lava_cauldron` needs Minecraft 1.17"),
            ("cherry_planks", "1.19.2", "`cherry_planks` needs Minecraft 1.19.4"),
            ("stone_slab[type=top]", "1.13.2", "`stone_slab[type=top]` needs Minecraft 1.14"),
            ("blackstone_wall[east=low]", "1.15.2", "`blackstone_wall[east=low]` needs Minecraft 1.16"),
            ("rail[waterlogged=true]", "1.16.5", "`rail[waterlogged=true]` needs Minecraft 1.17"),
            ("note_block[instrument=bit]", "1.13.2", "`note_block[instrument=bit]` needs Minecraft 1.14"),
        ];
        for (text, to, expected) in cases {
            assert_eq!(moved(text, "1.21.11", to), expected);
            let state = text.parse().unwrap();
            assert!(is_reused(&state) || !legal_in(&state, version(to)), "{text}");
        }
    }

    #[test]
    fn other_blocks_pass() {
        assert_eq!(moved("mod:chain[axis=x]", "1.21.11", "1.13"), "mod:chain[axis=x]");
        assert!(legal_in(&"mod:fir_wall[east=true]".parse().unwrap(), Version::newest()));
    }

    /// Every value of every block, the others at their defaults.
    fn states() -> impl Iterator<Item = BlockState> {
        all().iter().flat_map(|known| {
            let values = known.properties().iter().flat_map(|p| p.values.iter().map(|v| (p.key, *v)));
            let changed = values.map(|(key, value)| known.default_state().with(key, value));
            std::iter::once(known.default_state()).chain(changed)
        })
    }

    /// Names that blocks had once and no other block has taken since.
    const PAST: [&str; 5] = ["chain", "grass", "grass_path", "sign", "wall_sign"];

    /// Names that meant something else once; they have cases of their own.
    const REUSED: [&str; 2] = ["cauldron", "stone_slab"];

    fn is_reused(state: &BlockState) -> bool {
        REUSED.contains(&state.short_name())
    }

    #[test]
    fn every_state_is_legal_in_the_newest_version() {
        let legal = |state: &BlockState| legal_in(state, Version::newest());
        let past = |state: &BlockState| PAST.contains(&state.short_name());
        for state in states() {
            assert_eq!(legal(&state), !past(&state), "{state}");
        }
    }

    /// The first version, and those that something came with.
    fn versions() -> impl Iterator<Item = Version> {
        Version::all().filter(|at| *at == version("1.13") || !at.changes().is_empty())
    }

    #[test]
    fn what_goes_down_is_legal_there_and_comes_back() {
        let newest = Version::newest();
        let current = || states().filter(|state| !PAST.contains(&state.short_name()));
        for at in versions() {
            for state in current() {
                let Ok(old) = translated(&state, newest, at) else {
                    assert!(is_reused(&state) || !legal_in(&state, at), "{state} is legal in {at}");
                    continue;
                };
                assert!(legal_in(&old, at), "{state} is {old} in {at}, which is not legal there");
                let new = translated(&old, at, newest).unwrap();
                assert!(legal_in(&new, newest), "{new}");
                assert_eq!(translated(&new, newest, at), Ok(old), "{state} in {at}");
            }
        }
    }

    #[test]
    fn what_goes_up_comes_back() {
        let newest = Version::newest();
        for at in versions() {
            for state in states().filter(|state| legal_in(state, at) && !is_reused(state)) {
                let new = translated(&state, at, newest).unwrap();
                assert!(legal_in(&new, newest), "{state} of {at} is {new}");
                assert_eq!(translated(&new, newest, at), Ok(state));
            }
        }
    }
}
