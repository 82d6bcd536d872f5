use crate::block::{self, BlockState, Known, Shape};

/// How a block of the game depends on its neighbours.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Joint {
    Fence,
    Pane,
    Wall,
    Gate,
    Stairs,
    /// Of two blocks, one above the other.
    Door,
    /// Of two blocks, one above the other.
    Plant,
    /// Of two blocks, one behind the other.
    Bed,
    /// Alone, or two side by side.
    Chest,
    Wire,
    Tripwire,
    Vine,
    Chorus,
    Snowy,
}

impl Joint {
    /// `None` for what depends on no neighbour, and for blocks that are not of the game.
    pub fn of(state: &BlockState) -> Option<Joint> {
        let known = block::known(state.name())?;
        match block::shape(state) {
            Shape::Fence(_) => Some(Joint::Fence),
            Shape::Pane(_) => Some(Joint::Pane),
            Shape::Wall { .. } => Some(Joint::Wall),
            Shape::Gate { .. } => Some(Joint::Gate),
            Shape::Stairs { .. } => Some(Joint::Stairs),
            Shape::Door(_) => Some(Joint::Door),
            Shape::Bed(_) => Some(Joint::Bed),
            _ => Joint::by_properties(known),
        }
    }

    fn by_properties(known: &Known) -> Option<Joint> {
        let takes = |key: &str, value: &str| known.property(key).is_some_and(|p| p.values.contains(&value));
        match known.name() {
            "redstone_wire" => Some(Joint::Wire),
            "tripwire" => Some(Joint::Tripwire),
            "vine" => Some(Joint::Vine),
            "chorus_plant" => Some(Joint::Chorus),
            _ if takes("type", "single") => Some(Joint::Chest),
            _ if takes("half", "upper") => Some(Joint::Plant),
            _ if takes("snowy", "true") => Some(Joint::Snowy),
            _ => None,
        }
    }

    /// The properties that the neighbours decide.
    pub fn keys(self) -> &'static [&'static str] {
        match self {
            Joint::Fence | Joint::Pane | Joint::Wire | Joint::Tripwire => &["east", "north", "south", "west"],
            Joint::Wall => &["east", "north", "south", "up", "west"],
            Joint::Chorus => &["down", "east", "north", "south", "up", "west"],
            Joint::Gate => &["in_wall"],
            Joint::Stairs => &["shape"],
            Joint::Door | Joint::Plant => &["half"],
            Joint::Bed => &["part"],
            Joint::Chest => &["type"],
            Joint::Vine => &["up"],
            Joint::Snowy => &["snowy"],
        }
    }

    /// The properties that both halves have alike, and take from each other where they are absent.
    pub fn shared(self) -> &'static [&'static str] {
        match self {
            Joint::Door => &["facing", "hinge", "open", "powered"],
            Joint::Bed => &["facing", "occupied"],
            Joint::Plant => &["age", "facing"],
            _ => &[],
        }
    }
}

/// Whether the neighbours have to say what a state leaves out.
pub fn is_open(state: &BlockState) -> bool {
    let Some(known) = block::known(state.name()) else { return false };
    // Most states say everything, which is quickly seen.
    !block::is_complete(state) && Joint::of(state).is_some_and(|joint| leaves_open(state, known, joint))
}

/// The properties of a block that its neighbours decide.
pub fn decided(state: &BlockState) -> &'static [&'static str] {
    Joint::of(state).map_or(&[], Joint::keys)
}

fn leaves_open(state: &BlockState, known: &Known, joint: Joint) -> bool {
    let absent = |key: &&&str| state.get(key).is_none();
    let mut shared = joint.shared().iter().filter(|key| known.property(key).is_some());
    joint.keys().iter().filter(absent).count() == joint.keys().len() || shared.any(|key| absent(&key))
}

/// `state` with its absent properties at their defaults, but for those that its neighbours decide.
pub fn opened(state: &BlockState) -> BlockState {
    let full = block::complete(state);
    let Some(joint) = Joint::of(state) else { return full };
    match joint.keys().iter().all(|key| state.get(key).is_none()) {
        true => joint.keys().iter().fold(full, |open, key| open.without(key)),
        false => full,
    }
}

/// `state` without what its neighbours decide. What tells two halves from each other stays: only the first half
/// of a door and a single chest go without.
pub fn bare(state: &BlockState) -> BlockState {
    let Some(joint) = Joint::of(state) else { return state.clone() };
    let of_two = matches!(joint, Joint::Door | Joint::Plant | Joint::Bed | Joint::Chest);
    let goes = |key: &&&str| !of_two || is_default(state, key);
    joint.keys().iter().filter(goes).fold(state.clone(), |bare, key| bare.without(key))
}

fn is_default(state: &BlockState, key: &str) -> bool {
    let property = block::known(state.name()).and_then(|known| known.property(key));
    property.is_some_and(|property| state.get(key) == Some(property.default))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(text: &str) -> BlockState {
        text.parse().unwrap()
    }

    #[test]
    fn the_properties_of_joints_are_those_of_their_blocks() {
        for known in block::all() {
            let Some(joint) = Joint::of(&known.default_state()) else { continue };
            for key in joint.keys() {
                assert!(known.property(key).is_some(), "{} has no {key}", known.name());
            }
        }
    }

    #[test]
    fn every_side_is_that_of_a_joint_or_of_a_block_that_has_it_for_itself() {
        const OWN: [&str; 11] = [
            "brown_mushroom_block",
            "red_mushroom_block",
            "mushroom_stem",
            "glow_lichen",
            "sculk_vein",
            "resin_clump",
            "fire",
            "pale_moss_carpet",
            "vine",
            "bell",
            "lever",
        ];
        for known in block::all().iter().filter(|known| known.property("north").is_some()) {
            let is_joint = Joint::of(&known.default_state()).is_some();
            assert!(is_joint || OWN.contains(&known.name()), "{}", known.name());
        }
    }

    #[test]
    fn what_neighbours_decide_stays_open() {
        let cases = [
            ("oak_fence", "oak_fence[waterlogged=false]"),
            (
                "oak_fence[east=true]",
                "oak_fence[east=true,north=false,south=false,waterlogged=false,west=false]",
            ),
            ("oak_stairs[half=top]", "oak_stairs[facing=north,half=top,waterlogged=false]"),
            ("oak_door[facing=east]", "oak_door[facing=east,hinge=left,open=false,powered=false]"),
            ("grass_block", "grass_block"),
            ("stone", "stone"),
            ("mod:fir_fence[a=b]", "mod:fir_fence[a=b]"),
        ];
        for (text, expected) in cases {
            assert_eq!(opened(&state(text)).short(), expected);
            assert_eq!(opened(&opened(&state(text))), opened(&state(text)));
        }
    }

    #[test]
    fn second_halves_stay_second() {
        let cases = [
            ("oak_stairs[facing=east,shape=inner_left]", "oak_stairs[facing=east]"),
            ("oak_door[half=lower,hinge=right]", "oak_door[hinge=right]"),
            ("oak_door[half=upper]", "oak_door[half=upper]"),
            ("chest[facing=east,type=single]", "chest[facing=east]"),
            ("chest[facing=east,type=left]", "chest[facing=east,type=left]"),
            ("cobblestone_wall[up=true,waterlogged=true]", "cobblestone_wall[waterlogged=true]"),
        ];
        for (text, expected) in cases {
            assert_eq!(bare(&state(text)).short(), expected);
        }
    }
}
