//! Things of two blocks: doors, tall plants and beds.

use super::{BlockState, Facing, known, water};
use crate::space::Cell;

/// How the halves of one thing are told apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Halves {
    pub key: &'static str,
    pub first: &'static str,
    pub second: &'static str,
}

const UPRIGHT: Halves = Halves { key: "half", first: "lower", second: "upper" };
const LYING: Halves = Halves { key: "part", first: "foot", second: "head" };

impl Halves {
    /// `None` for blocks that are things of their own, and for those that are not of the game.
    pub fn of(state: &BlockState) -> Option<Halves> {
        let known = known(state.name())?;
        let tells = |halves: &Halves| {
            known.property(halves.key).is_some_and(|property| property.values.contains(&halves.second))
        };
        [UPRIGHT, LYING].into_iter().find(tells)
    }

    /// From the first half to the second: beds lie where they face.
    pub fn step(self, facing: Facing) -> Cell {
        if self == LYING { facing.step() } else { Cell::Y }
    }
}

/// The step to the other half of `state`, and what that one is as far as this one tells. `None` where a block has no
/// other half, or leaves open which one it is itself.
pub fn other_half(state: &BlockState) -> Option<(Cell, BlockState)> {
    let halves = Halves::of(state)?;
    if is_young(state) {
        return None;
    }
    let step = halves.step(state.get("facing").and_then(Facing::named).unwrap_or(Facing::North));
    match state.get(halves.key)? {
        half if half == halves.first => Some((step, state.clone().with(halves.key, halves.second))),
        half if half == halves.second => Some((-step, state.clone().with(halves.key, halves.first))),
        _ => None,
    }
}

/// Pitcher plants grow an upper half with time.
fn is_young(state: &BlockState) -> bool {
    let lower = state.short_name() == "pitcher_crop" && state.get("half") == Some(UPRIGHT.first);
    lower && matches!(state.get("age"), None | Some("0" | "1" | "2"))
}

/// Whether `other`, which stands where the other half of `state` belongs, is that half. The halves of a bed face
/// alike; those of a door that do not are one door that is out of order.
pub fn is_other_half(state: &BlockState, other: &BlockState) -> bool {
    let Some(halves) = Halves::of(state).filter(|_| state.name() == other.name()) else { return false };
    let is_opposite = match (state.get(halves.key), other.get(halves.key)) {
        (Some(half), Some(other)) => half != other,
        _ => false,
    };
    is_opposite && (halves == UPRIGHT || state.get("facing") == other.get("facing"))
}

/// The half `half` as it is put in the place of `old`; `None` where there is no room for it.
pub fn placed_half(half: BlockState, old: &BlockState) -> Option<BlockState> {
    let in_water = water::is_source(old);
    match half.get("waterlogged") {
        _ if !in_water && !old.is_nothing() => None,
        Some(_) => Some(half.with("waterlogged", if in_water { "true" } else { "false" })),
        None => (water::is_always_in_water(&half) == in_water).then_some(half),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(text: &str) -> BlockState {
        text.parse().unwrap()
    }

    #[test]
    fn each_half_points_to_the_other() {
        let cases = [
            ("oak_door[half=lower]", Some((Cell::Y, "oak_door[half=upper]"))),
            ("oak_door[half=upper]", Some((-Cell::Y, "oak_door[half=lower]"))),
            ("red_bed[facing=east,part=foot]", Some((Cell::X, "red_bed[facing=east,part=head]"))),
            ("red_bed[facing=east,part=head]", Some((-Cell::X, "red_bed[facing=east,part=foot]"))),
            ("oak_door", None),
            ("oak_stairs[half=bottom]", None),
            ("oak_trapdoor[half=top]", None),
            ("mod:fir_door[half=lower]", None),
        ];
        for (text, expected) in cases {
            let expected = expected.map(|(step, other)| (step, state(other)));
            assert_eq!(other_half(&state(text)), expected, "{text}");
            if let Some((_, other)) = expected {
                assert!(is_other_half(&state(text), &other));
                assert!(!is_other_half(&state(text), &state(text)));
            }
        }
    }

    #[test]
    fn pitcher_plants_have_an_upper_half_from_age_three_on() {
        for age in 0..=4 {
            let lower = state(&format!("pitcher_crop[age={age},half=lower]"));
            assert_eq!(other_half(&lower).is_some(), age >= 3, "{age}");
            assert!(other_half(&lower.with("half", "upper")).is_some());
        }
    }

    #[test]
    fn there_is_room_in_air_and_in_water_for_what_lives_in_it() {
        let cases = [
            ("oak_door", "air", Some("oak_door")),
            ("oak_door", "cave_air", Some("oak_door")),
            ("oak_door", "stone", None),
            ("oak_door", "water", None),
            ("tall_seagrass", "air", None),
            ("tall_seagrass", "water[level=0]", Some("tall_seagrass")),
            ("tall_seagrass", "water[level=3]", None),
            ("small_dripleaf[waterlogged=false]", "water", Some("small_dripleaf[waterlogged=true]")),
            ("small_dripleaf[waterlogged=true]", "air", Some("small_dripleaf[waterlogged=false]")),
            ("small_dripleaf[waterlogged=true]", "stone", None),
        ];
        for (half, old, expected) in cases {
            assert_eq!(placed_half(state(half), &state(old)), expected.map(state), "{half} at {old}");
        }
    }
}
