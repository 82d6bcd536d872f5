use super::{BlockState, Known, Version, complete, known, translated};

/// `state`, which is of `version`, with its absent properties at their defaults there. What is newer than that
/// version gets those of the newest one. Blocks that are not of the game stay as they are.
pub fn complete_in(state: &BlockState, version: Version) -> BlockState {
    // Most states say everything, which is quickly seen. Those that say nothing may have had properties once.
    match state.properties().len() > 0 && is_complete(state) {
        true => state.clone(),
        false => filled_in(state, version, complete),
    }
}

/// Whether no property is absent that the newest version has.
pub fn is_complete(state: &BlockState) -> bool {
    let properties = known(state.name()).map_or(&[][..], Known::properties);
    properties.iter().all(|property| state.get(property.key).is_some())
}

/// `state`, which is of `version`, with what `fill` adds to it in the words of the newest version. What `version`
/// does not know of that is left out.
pub fn filled_in(
    state: &BlockState,
    version: Version,
    fill: impl Fn(&BlockState) -> BlockState,
) -> BlockState {
    let newest = Version::newest();
    let full = translated(state, version, newest).and_then(|new| translated(&fill(&new), newest, version));
    let Ok(full) = full else { return fill(state) };
    let absent = full.properties().filter(|(key, _)| state.get(key).is_none());
    absent.fold(state.clone(), |state, (key, value)| state.with(key, value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{all, legal_in};

    fn completed(text: &str, version: &str) -> String {
        complete_in(&text.parse().unwrap(), Version::named(version).unwrap()).short()
    }

    #[test]
    fn states_get_the_properties_of_their_version() {
        let cases = [
            ("oak_leaves", "1.18.2", "oak_leaves[distance=7,persistent=false]"),
            ("oak_leaves", "1.19", "oak_leaves[distance=7,persistent=false,waterlogged=false]"),
            ("skeleton_skull[rotation=3]", "1.20.1", "skeleton_skull[rotation=3]"),
            ("skeleton_skull[rotation=3]", "1.20.2", "skeleton_skull[powered=false,rotation=3]"),
            ("rail", "1.16.5", "rail[shape=north_south]"),
            ("chain", "1.16", "chain[waterlogged=false]"),
            ("chain", "1.20.1", "chain[axis=y,waterlogged=false]"),
            ("iron_chain", "1.20.1", "iron_chain[axis=y,waterlogged=false]"),
            ("cauldron", "1.16.5", "cauldron[level=0]"),
            ("cauldron", "1.17", "cauldron"),
            (
                "cobblestone_wall[east=true]",
                "1.15.2",
                "cobblestone_wall[east=true,north=false,south=false,up=true,waterlogged=false,west=false]",
            ),
            ("stone_slab[type=top]", "1.13.2", "stone_slab[type=top,waterlogged=false]"),
        ];
        for (text, version, expected) in cases {
            assert_eq!(completed(text, version), expected, "{text} in {version}");
        }
    }

    #[test]
    fn what_the_version_does_not_have_is_completed_as_it_is_today() {
        assert_eq!(completed("pale_oak_log", "1.16.5"), "pale_oak_log[axis=y]");
        assert_eq!(completed("mod:fence[a=b]", "1.16.5"), "mod:fence[a=b]");
    }

    /// Every block with one property at most, as far as `version` has it.
    fn states(version: Version) -> impl Iterator<Item = BlockState> {
        let named = all().iter().flat_map(|known| {
            let bare = BlockState::known(known.name());
            let values = known.properties().iter().flat_map(|p| p.values.iter().map(|v| (p.key, *v)));
            let one: Vec<BlockState> = values.map(|(key, value)| bare.clone().with(key, value)).collect();
            one.into_iter().chain([bare])
        });
        // Without its level, nothing tells that water in cauldrons came later.
        let is_clear = |state: &BlockState| state.short() != "water_cauldron";
        named.filter(is_clear).filter(move |state| legal_in(state, version))
    }

    #[test]
    fn completion_keeps_what_is_given_is_legal_and_done_once() {
        for version in ["1.13", "1.14.4", "1.15.2", "1.16.5", "1.20.1", "26.3"] {
            let version = Version::named(version).unwrap();
            for state in states(version) {
                let full = complete_in(&state, version);
                assert!(legal_in(&full, version), "{full} in {version}");
                assert!(state.properties().all(|(key, value)| full.get(key) == Some(value)), "{full}");
                assert_eq!(full.name(), state.name());
                assert_eq!(complete_in(&full, version), full);
            }
        }
    }
}
