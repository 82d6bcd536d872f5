use super::boxes::{Cuboid, parse_boxes};
use super::pattern::{fits, table};
use super::{BlockState, Facing};
use crate::space::{Axis, Turn};
use std::sync::OnceLock;

/// The form of a block, as far as it matters for how it looks and what it goes with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    Air,
    /// Fills its cell.
    Full,
    Slab(Half),
    /// The tall side is on `facing`.
    Stairs {
        facing: Facing,
        half: Half,
        bend: Bend,
    },
    /// Joined to the neighbours on these sides.
    Fence(Sides),
    Pane(Sides),
    Wall {
        post: Post,
        arms: [Arm; 4],
    },
    /// A fence gate: the leaves lie across `facing`, or along it where it is open.
    Gate {
        facing: Facing,
        leaves: Leaves,
    },
    /// The leaf stands at this side of the cell.
    Door(Facing),
    /// The leaf lies or stands at this side of the cell.
    Trapdoor(Facing),
    /// Hangs flat at this side of the cell: ladders, banners.
    Ladder(Facing),
    /// A sign at this side of the cell.
    WallSign(Facing),
    /// Covers these sides of the cell: vines.
    Faces(Sides),
    /// Fixed to this side of the cell.
    Torch(Facing),
    Button(Facing),
    Lantern(Hung),
    Chain(Axis),
    Rod(Axis),
    Rail(Slope),
    /// The pillow is at this side, if this half of the bed has one.
    Bed(Option<Facing>),
    /// Snow, this many sixteenths high.
    Layer(u8),
    /// This many sixteenths high.
    Fluid(u8),
    Plant(Plant),
    /// Anything else that is smaller than its cell, turned to `front`.
    Partial {
        boxes: &'static [Cuboid],
        front: Facing,
    },
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Half {
    Bottom,
    Top,
}

/// How stairs go round a corner.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Bend {
    Straight,
    InnerLeft,
    InnerRight,
    OuterLeft,
    OuterRight,
}

/// How high a wall reaches towards one side.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Arm {
    None,
    Low,
    Tall,
}

/// Whether a wall has a post in its middle.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Post {
    Absent,
    Present,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Leaves {
    Shut,
    Open,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Plant {
    /// A stem with a head in the color of the block.
    Flower,
    /// Blades in the color of the block.
    Blades,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Hung {
    Standing,
    Hanging,
}

/// Whether a rail climbs, and to which side.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Slope {
    Flat,
    Up(Facing),
}

/// A set of sides of a block.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct Sides(u8);

impl Sides {
    pub fn contains(self, side: Facing) -> bool {
        self.0 & (1 << side as u8) != 0
    }

    pub fn iter(self) -> impl Iterator<Item = Facing> {
        Facing::ALL.into_iter().filter(move |&side| self.contains(side))
    }
}

impl FromIterator<Facing> for Sides {
    fn from_iter<I: IntoIterator<Item = Facing>>(sides: I) -> Sides {
        Sides(sides.into_iter().fold(0, |bits, side| bits | 1 << side as u8))
    }
}

/// The form of `state`, by the rules of the game for its name. Absent properties count as their usual values.
pub fn shape(state: &BlockState) -> Shape {
    let (_, name) = state.name().split_once(':').unwrap_or(("", state.name()));
    match rules().iter().find(|(pattern, _)| fits(pattern, name)) {
        Some((_, Rule::Class(read))) => read(state),
        Some((_, Rule::Boxes(boxes))) => Shape::Partial { boxes, front: front(state) },
        None => Shape::Full,
    }
}

/// What a line of the table says of the names that fit it.
enum Rule {
    Class(Reader),
    Boxes(Vec<Cuboid>),
}

type Reader = fn(&BlockState) -> Shape;

const CLASSES: [(&str, Reader); 25] = [
    ("air", |_| Shape::Air),
    ("full", |_| Shape::Full),
    ("flower", |_| Shape::Plant(Plant::Flower)),
    ("blades", |_| Shape::Plant(Plant::Blades)),
    ("slab", slab),
    ("stairs", stairs),
    ("fence", |state| Shape::Fence(sides(state))),
    ("pane", |state| Shape::Pane(sides(state))),
    ("faces", |state| Shape::Faces(sides(state))),
    ("wall", wall),
    ("gate", gate),
    ("door", door),
    ("trapdoor", trapdoor),
    ("ladder", |state| Shape::Ladder(facing(state).opposite())),
    ("wall_sign", |state| Shape::WallSign(facing(state).opposite())),
    ("torch", |_| Shape::Torch(Facing::Down)),
    ("wall_torch", |state| Shape::Torch(facing(state).opposite())),
    ("button", button),
    ("lantern", lantern),
    ("chain", |state| Shape::Chain(axis(state))),
    ("rod", |state| Shape::Rod(facing_or(state, Facing::Up).axis())),
    ("rail", rail),
    ("bed", bed),
    ("snow", snow),
    ("fluid", fluid),
];

fn rules() -> &'static [(&'static str, Rule)] {
    static RULES: OnceLock<Vec<(&str, Rule)>> = OnceLock::new();
    RULES.get_or_init(|| table(include_str!("shapes.txt")).map(|(p, value)| (p, rule(value))).collect())
}

fn rule(value: &str) -> Rule {
    let class = CLASSES.iter().find(|(word, _)| *word == value);
    class.map_or_else(|| Rule::Boxes(parse_boxes(value)), |(_, read)| Rule::Class(*read))
}

fn is(state: &BlockState, key: &str, value: &str) -> bool {
    state.get(key) == Some(value)
}

fn facing_or(state: &BlockState, absent: Facing) -> Facing {
    state.get("facing").and_then(Facing::named).unwrap_or(absent)
}

fn facing(state: &BlockState) -> Facing {
    facing_or(state, Facing::North)
}

/// Where a block looks that stands free: signs, banners and skulls count sixteenths clockwise from south.
fn front(state: &BlockState) -> Facing {
    let from_south = state.get("rotation").and_then(|value| value.parse::<i32>().ok());
    let quarters = |sixteenths: i32| Turn::quarters(-(sixteenths + 2).div_euclid(4));
    from_south.map_or_else(|| facing(state), |sixteenths| Facing::South.turned(quarters(sixteenths)))
}

fn axis(state: &BlockState) -> Axis {
    match state.get("axis") {
        Some("x") => Axis::X,
        Some("z") => Axis::Z,
        _ => Axis::Y,
    }
}

fn sides(state: &BlockState) -> Sides {
    Facing::ALL.into_iter().filter(|side| is(state, side.name(), "true")).collect()
}

fn half(state: &BlockState) -> Half {
    if is(state, "half", "top") { Half::Top } else { Half::Bottom }
}

fn slab(state: &BlockState) -> Shape {
    match state.get("type") {
        Some("double") => Shape::Full,
        Some("top") => Shape::Slab(Half::Top),
        _ => Shape::Slab(Half::Bottom),
    }
}

fn stairs(state: &BlockState) -> Shape {
    let bend = match state.get("shape") {
        Some("inner_left") => Bend::InnerLeft,
        Some("inner_right") => Bend::InnerRight,
        Some("outer_left") => Bend::OuterLeft,
        Some("outer_right") => Bend::OuterRight,
        _ => Bend::Straight,
    };
    Shape::Stairs { facing: facing(state), half: half(state), bend }
}

fn wall(state: &BlockState) -> Shape {
    let arm = |side: Facing| match state.get(side.name()) {
        Some("low" | "true") => Arm::Low,
        Some("tall") => Arm::Tall,
        _ => Arm::None,
    };
    let post = if is(state, "up", "false") { Post::Absent } else { Post::Present };
    Shape::Wall { post, arms: Facing::HORIZONTAL.map(arm) }
}

fn gate(state: &BlockState) -> Shape {
    let leaves = if is(state, "open", "true") { Leaves::Open } else { Leaves::Shut };
    Shape::Gate { facing: facing(state), leaves }
}

/// A shut door stands at the side that it is entered from; an open one at the side of its hinge.
fn door(state: &BlockState) -> Shape {
    let facing = facing(state);
    Shape::Door(match (is(state, "open", "true"), is(state, "hinge", "right")) {
        (false, _) => facing.opposite(),
        (true, false) => facing.left(),
        (true, true) => facing.right(),
    })
}

fn trapdoor(state: &BlockState) -> Shape {
    Shape::Trapdoor(match (is(state, "open", "true"), half(state)) {
        (true, _) => facing(state).opposite(),
        (false, Half::Bottom) => Facing::Down,
        (false, Half::Top) => Facing::Up,
    })
}

fn button(state: &BlockState) -> Shape {
    Shape::Button(match state.get("face") {
        Some("floor") => Facing::Down,
        Some("ceiling") => Facing::Up,
        _ => facing(state).opposite(),
    })
}

fn lantern(state: &BlockState) -> Shape {
    Shape::Lantern(if is(state, "hanging", "true") { Hung::Hanging } else { Hung::Standing })
}

fn rail(state: &BlockState) -> Shape {
    let climbs = state.get("shape").and_then(|shape| shape.strip_prefix("ascending_"));
    Shape::Rail(climbs.and_then(Facing::named).map_or(Slope::Flat, Slope::Up))
}

fn bed(state: &BlockState) -> Shape {
    Shape::Bed(is(state, "part", "head").then(|| facing(state)))
}

fn number(state: &BlockState, key: &str, absent: u8) -> u8 {
    state.get(key).and_then(|value| value.parse().ok()).unwrap_or(absent)
}

fn snow(state: &BlockState) -> Shape {
    match number(state, "layers", 1) {
        layers @ 0..8 => Shape::Layer(2 * layers.max(1)),
        _ => Shape::Full,
    }
}

/// A source is a little lower than its cell, flowing fluid sinks with its level, falling fluid fills the cell.
fn fluid(state: &BlockState) -> Shape {
    Shape::Fluid(match number(state, "level", 0) {
        level @ 0..8 => 14 - level * 12 / 8,
        _ => 16,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    fn shape_of(text: &str) -> Shape {
        shape(&text.parse().unwrap())
    }

    #[test]
    fn every_rule_is_a_class_or_has_boxes() {
        for (pattern, rule) in rules() {
            assert!(!matches!(rule, Rule::Boxes(boxes) if boxes.is_empty()), "{pattern}");
        }
    }

    #[test]
    fn every_rule_fits_a_block_that_no_earlier_rule_takes() {
        for (at, (pattern, _)) in rules().iter().enumerate() {
            let first = |name: &str| rules().iter().position(|(pattern, _)| fits(pattern, name));
            assert!(all().iter().any(|known| first(known.name()) == Some(at)), "{pattern}");
        }
    }

    #[test]
    fn names_and_properties_give_the_shape() {
        let stairs = Shape::Stairs { facing: Facing::East, half: Half::Top, bend: Bend::InnerLeft };
        let arms = [Arm::None, Arm::Tall, Arm::None, Arm::Low];
        let cases = [
            ("stone", Shape::Full),
            ("air", Shape::Air),
            ("oak_stairs[facing=east,half=top,shape=inner_left]", stairs),
            ("mod:fir_slab[type=top]", Shape::Slab(Half::Top)),
            ("oak_slab[type=double]", Shape::Full),
            ("oak_fence[east=true]", Shape::Fence(Sides::from_iter([Facing::East]))),
            ("cobblestone_wall[east=tall,west=low,up=false]", Shape::Wall { post: Post::Absent, arms }),
            ("oak_door[facing=east]", Shape::Door(Facing::West)),
            ("oak_door[facing=east,open=true,hinge=right]", Shape::Door(Facing::South)),
            ("oak_trapdoor[facing=north,open=true]", Shape::Trapdoor(Facing::South)),
            ("ladder[facing=north]", Shape::Ladder(Facing::South)),
            ("snow[layers=3]", Shape::Layer(6)),
            ("water", Shape::Fluid(14)),
            ("lantern[hanging=true]", Shape::Lantern(Hung::Hanging)),
        ];
        for (text, expected) in cases {
            assert_eq!(shape_of(text), expected, "{text}");
        }
    }

    #[test]
    fn a_sign_turns_to_the_nearest_quarter() {
        for (rotation, expected) in [(0, "south"), (4, "west"), (7, "north"), (11, "east"), (15, "south")] {
            let state = BlockState::known("oak_sign").with("rotation", &rotation.to_string());
            assert_eq!(front(&state).name(), expected);
        }
    }
}
