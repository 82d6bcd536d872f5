use super::{BlockState, Facing};
use crate::space::{Axis, Turn};
use std::borrow::Cow;
use std::ops::Neg;

/// A reflection that leaves up and down in their places.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Mirror {
    /// East and west change places: x is negated.
    X,
    /// North and south change places: z is negated.
    Z,
}

impl Mirror {
    pub const ALL: [Mirror; 2] = [Mirror::X, Mirror::Z];

    pub fn axis(self) -> Axis {
        match self {
            Mirror::X => Axis::X,
            Mirror::Z => Axis::Z,
        }
    }

    pub fn apply(self, facing: Facing) -> Facing {
        if facing.axis() == self.axis() { facing.opposite() } else { facing }
    }
}

/// How a building may be put elsewhere: by any of the four turns, or a reflection.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Motion {
    Turn(Turn),
    Mirror(Mirror),
}

impl BlockState {
    /// This state on a building that is turned: what faced east faces `turn` of east.
    pub fn turned(&self, turn: Turn) -> BlockState {
        self.moved(Motion::Turn(turn))
    }

    /// This state on a building that is mirrored.
    pub fn mirrored(&self, mirror: Mirror) -> BlockState {
        self.moved(Motion::Mirror(mirror))
    }

    /// This state on a building that is moved.
    pub fn moved(&self, motion: Motion) -> BlockState {
        self.map(|key, value| match key {
            "north" | "east" | "south" | "west" => (motion.word(key), value.into()),
            _ => (key, motion.value(key, value)),
        })
    }
}

impl Motion {
    /// Moves a vector about the origin.
    pub fn apply<T: Copy + Neg<Output = T>>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        match self {
            Motion::Turn(turn) => match turn.count() {
                0 => [x, y, z],
                1 => [z, y, -x],
                2 => [-x, y, -z],
                _ => [-z, y, x],
            },
            Motion::Mirror(Mirror::X) => [-x, y, z],
            Motion::Mirror(Mirror::Z) => [x, y, -z],
        }
    }

    /// Moves an angle in degrees, clockwise from south.
    pub fn angle(self, degrees: f64) -> f64 {
        match self {
            Motion::Turn(turn) => degrees - 90.0 * f64::from(turn.count()),
            Motion::Mirror(Mirror::X) => -degrees,
            Motion::Mirror(Mirror::Z) => 180.0 - degrees,
        }
    }

    /// Moves a sixteenth of a circle, clockwise from south.
    pub fn sixteenth(self, sixteenth: i32) -> i32 {
        const DEGREES: f64 = 22.5;
        (self.angle(f64::from(sixteenth) * DEGREES) / DEGREES).rem_euclid(16.0) as i32
    }

    pub fn facing(self, facing: Facing) -> Facing {
        match self {
            Motion::Turn(turn) => facing.turned(turn),
            Motion::Mirror(mirror) => mirror.apply(facing),
        }
    }

    /// The name of a side, moved; any other word stays.
    fn word(self, word: &str) -> &str {
        Facing::named(word).map_or(word, |facing| self.facing(facing).name())
    }

    fn value<'a>(self, key: &str, value: &'a str) -> Cow<'a, str> {
        match key {
            "facing" => self.word(value).into(),
            "axis" => self.axis(value).into(),
            "rotation" => self.rotation(value),
            "orientation" => self.words(value).into(),
            "shape" if is_rail(value) => rail(self.words(value)),
            "shape" | "hinge" | "type" | "side_chain" => self.hand(value),
            _ => value.into(),
        }
    }

    fn words(self, value: &str) -> String {
        value.split('_').map(|word| self.word(word)).collect::<Vec<_>>().join("_")
    }

    fn axis(self, value: &str) -> &str {
        match (self, value) {
            (Motion::Turn(turn), "x") if turn.count() % 2 == 1 => "z",
            (Motion::Turn(turn), "z") if turn.count() % 2 == 1 => "x",
            _ => value,
        }
    }

    fn rotation(self, value: &str) -> Cow<'_, str> {
        match value.parse() {
            Ok(rotation) => self.sixteenth(rotation).to_string().into(),
            Err(_) => value.to_owned().into(),
        }
    }

    /// Left and right hand change places in a mirror: stair corners, door hinges, halves of chests.
    fn hand(self, value: &str) -> Cow<'_, str> {
        match self {
            Motion::Turn(_) => value.into(),
            Motion::Mirror(_) if value.contains("left") => value.replace("left", "right").into(),
            Motion::Mirror(_) => value.replace("right", "left").into(),
        }
    }
}

fn is_rail(shape: &str) -> bool {
    shape.split('_').any(|word| Facing::named(word).is_some())
}

/// A rail joins two sides in either order, but only one order is a legal value.
fn rail(shape: String) -> Cow<'static, str> {
    match shape.split_once('_') {
        Some((first @ ("east" | "west"), second @ ("north" | "south"))) => format!("{second}_{first}").into(),
        Some(("south", "north")) => "north_south".into(),
        Some(("west", "east")) => "east_west".into(),
        _ => shape.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::{Known, all, check};
    use proptest::prelude::*;

    /// Any known block in any legal state.
    fn any_state() -> impl Strategy<Value = BlockState> {
        prop::sample::select(all().iter().collect::<Vec<_>>()).prop_flat_map(|known: &'static Known| {
            let values: Vec<_> = known
                .properties()
                .iter()
                .map(|p| prop::sample::select(p.values.clone()).prop_map(|value| (p.key, value)))
                .collect();
            values.prop_map(|values| {
                let bare = BlockState::new(known.name()).unwrap();
                values.into_iter().fold(bare, |state, (key, value)| state.with(key, value))
            })
        })
    }

    fn any_turn() -> impl Strategy<Value = Turn> {
        prop::sample::select(Turn::ALL.to_vec())
    }

    /// Every value of every property, the others at their defaults.
    fn each_value() -> impl Iterator<Item = BlockState> {
        all().iter().flat_map(|known| {
            let values = known.properties().iter().flat_map(|p| p.values.iter().map(|v| (p.key, *v)));
            values.map(|(key, value)| known.default_state().with(key, value))
        })
    }

    #[test]
    fn every_value_of_every_block_moves_to_a_legal_one_and_back() {
        for state in each_value() {
            for turn in Turn::ALL {
                assert_eq!(check(&state.turned(turn)), Ok(()));
                assert_eq!(state.turned(turn).turned(turn.inverse()), state);
            }
            for mirror in Mirror::ALL {
                assert_eq!(check(&state.mirrored(mirror)), Ok(()));
                assert_eq!(state.mirrored(mirror).mirrored(mirror), state);
            }
        }
    }

    proptest! {
        #[test]
        fn turns_add_up(state in any_state(), a in any_turn(), b in any_turn()) {
            prop_assert_eq!(state.turned(a).turned(b), state.turned(a + b));
        }

        #[test]
        fn a_mirror_reverses_turns(state in any_state(), turn in any_turn()) {
            for mirror in Mirror::ALL {
                prop_assert_eq!(
                    state.turned(turn).mirrored(mirror),
                    state.mirrored(mirror).turned(turn.inverse())
                );
            }
        }

        #[test]
        fn both_mirrors_are_a_half_turn(state in any_state()) {
            let both = state.mirrored(Mirror::X).mirrored(Mirror::Z);
            prop_assert_eq!(both, state.turned(Turn::quarters(2)));
        }
    }

    #[test]
    fn one_turn_takes_east_to_north() {
        let cases = [
            ("oak_stairs[facing=east,shape=inner_left]", "oak_stairs[facing=north,shape=inner_left]"),
            ("oak_fence[east=true,north=false]", "oak_fence[north=true,west=false]"),
            ("oak_log[axis=x]", "oak_log[axis=z]"),
            ("oak_sign[rotation=0]", "oak_sign[rotation=12]"),
            ("rail[shape=south_east]", "rail[shape=north_east]"),
            ("rail[shape=ascending_east]", "rail[shape=ascending_north]"),
            ("jigsaw[orientation=east_up]", "jigsaw[orientation=north_up]"),
            ("crafter[orientation=up_south]", "crafter[orientation=up_east]"),
            ("mod:box[color=east,facing=west]", "mod:box[color=east,facing=south]"),
        ];
        for (from, to) in cases {
            assert_eq!(from.parse::<BlockState>().unwrap().turned(Turn::quarters(1)).short(), to);
        }
    }

    #[test]
    fn a_mirror_swaps_hands() {
        let cases = [
            ("oak_stairs[facing=east,shape=inner_left]", "oak_stairs[facing=west,shape=inner_right]"),
            ("oak_door[facing=north,hinge=right]", "oak_door[facing=north,hinge=left]"),
            ("chest[facing=south,type=left]", "chest[facing=south,type=right]"),
            ("oak_sign[rotation=4]", "oak_sign[rotation=12]"),
            ("oak_slab[type=top]", "oak_slab[type=top]"),
        ];
        for (from, to) in cases {
            assert_eq!(from.parse::<BlockState>().unwrap().mirrored(Mirror::X).short(), to);
        }
    }
}
