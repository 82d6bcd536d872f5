//! Water, and the blocks that stand in it.

use super::{BlockState, known};

/// Blocks that are only ever in water, and do not say so.
const ALWAYS: [&str; 5] = ["seagrass", "tall_seagrass", "kelp", "kelp_plant", "bubble_column"];

pub fn is_water(state: &BlockState) -> bool {
    state.name() == "minecraft:water"
}

/// Whether this is water that does not flow.
pub fn is_source(state: &BlockState) -> bool {
    is_water(state) && matches!(state.get("level"), None | Some("0"))
}

/// Whether the block is only ever in water, and has no property that says so.
pub fn is_always_in_water(state: &BlockState) -> bool {
    ALWAYS.contains(&state.short_name())
}

/// Whether the block can be in water, as a property of it says.
pub fn takes_water(state: &BlockState) -> bool {
    known(state.name()).is_some_and(|known| known.property("waterlogged").is_some())
}

/// What is left of a block that goes: the water that it stood in, or air.
pub fn left_behind(state: &BlockState) -> BlockState {
    match is_always_in_water(state) || state.get("waterlogged") == Some("true") {
        true => BlockState::known("water").with("level", "0"),
        false => BlockState::air(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_in_water_leave_it_behind() {
        let cases = [
            ("tall_seagrass[half=upper]", "water[level=0]"),
            ("small_dripleaf[waterlogged=true]", "water[level=0]"),
            ("small_dripleaf[waterlogged=false]", "air"),
            ("oak_door", "air"),
        ];
        for (text, expected) in cases {
            assert_eq!(left_behind(&text.parse().unwrap()).short(), expected);
        }
    }

    #[test]
    fn blocks_always_in_water_have_no_property_for_it() {
        for name in ALWAYS {
            assert!(known(name).is_some_and(|known| known.property("waterlogged").is_none()), "{name}");
        }
    }
}
