use super::boxes::boxes;
use super::pattern::{fits, table};
use super::{Arm, Bend, BlockState, Cuboid, Facing, Half, Leaves, Post, Shape, Sides, shape};
use crate::space::Turn;
use std::sync::OnceLock;

/// What of the bottom of a block is there, as far as walls under it ask.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Bottom {
    /// The middle, over the post of a wall.
    pub middle: bool,
    /// The strips from these sides to the middle, over the arms of a wall.
    pub strips: Sides,
}

impl Bottom {
    fn all() -> Bottom {
        Bottom { middle: true, strips: Facing::HORIZONTAL.into_iter().collect() }
    }

    fn middle() -> Bottom {
        Bottom { middle: true, strips: Sides::default() }
    }
}

/// The sides of a block that are whole squares, which others can be fixed to.
pub fn sturdy(state: &BlockState) -> Sides {
    match exception(state) {
        Some(exception) => exception.sides.iter().map(|side| side.turned(turn(state))).collect(),
        None => sturdy_form(&shape(state)),
    }
}

fn sturdy_form(shape: &Shape) -> Sides {
    match *shape {
        Shape::Full | Shape::Layer(16..) => Facing::ALL.into_iter().collect(),
        Shape::Slab(half) => Sides::from_iter([end(half)]),
        Shape::Stairs { facing, half, bend } => {
            stairs_sides(facing, bend).into_iter().flatten().chain([end(half)]).collect()
        }
        Shape::Door(side) | Shape::Trapdoor(side) => Sides::from_iter([side]),
        _ => Sides::default(),
    }
}

fn end(half: Half) -> Facing {
    match half {
        Half::Bottom => Facing::Down,
        Half::Top => Facing::Up,
    }
}

/// The sides where stairs reach from bottom to top.
fn stairs_sides(facing: Facing, bend: Bend) -> [Option<Facing>; 2] {
    match bend {
        Bend::Straight => [Some(facing), None],
        Bend::InnerLeft => [Some(facing), Some(facing.left())],
        Bend::InnerRight => [Some(facing), Some(facing.right())],
        Bend::OuterLeft | Bend::OuterRight => [None, None],
    }
}

/// What of the bottom of a block is there.
pub fn bottom(state: &BlockState) -> Bottom {
    exception(state).map_or_else(|| bottom_form(state), |exception| exception.bottom)
}

fn bottom_form(state: &BlockState) -> Bottom {
    match shape(state) {
        Shape::Plant(_) | Shape::Layer(..=2) => Bottom::default(),
        Shape::Full => Bottom::all(),
        Shape::Fence(strips) | Shape::Pane(strips) => Bottom { middle: true, strips },
        Shape::Gate { leaves: Leaves::Open, .. } => Bottom::default(),
        Shape::Gate { facing, leaves: Leaves::Shut } => {
            Bottom { middle: true, strips: [facing.left(), facing.right()].into_iter().collect() }
        }
        Shape::Wall { post, arms } => wall_bottom(post, arms),
        _ => bottom_of(&boxes(state)),
    }
}

fn wall_bottom(post: Post, arms: [Arm; 4]) -> Bottom {
    let strips = Facing::HORIZONTAL.into_iter().zip(arms).filter(|(_, arm)| *arm != Arm::None);
    let strips: Sides = strips.map(|(side, _)| side).collect();
    let middle = post == Post::Present || strips != Sides::default();
    Bottom { middle, strips }
}

/// One box must cover each part: that of several together is not asked for by any block of the game.
fn bottom_of(boxes: &[Cuboid]) -> Bottom {
    let covers = |west: u8, north: u8, east: u8, south: u8| {
        let on_floor = boxes.iter().filter(|part| part.low[1] == 0);
        on_floor.into_iter().any(|part| {
            part.low[0] <= west && part.low[2] <= north && part.high[0] >= east && part.high[2] >= south
        })
    };
    let strips = [
        (Facing::North, covers(7, 0, 9, 9)),
        (Facing::East, covers(7, 7, 16, 9)),
        (Facing::South, covers(7, 7, 9, 16)),
        (Facing::West, covers(0, 7, 9, 9)),
    ];
    let strips = strips.into_iter().filter(|(_, covered)| *covered).map(|(side, _)| side).collect();
    Bottom { middle: covers(7, 7, 9, 9), strips }
}

/// From north to where the block faces.
fn turn(state: &BlockState) -> Turn {
    let facing = state.get("facing").and_then(Facing::named);
    let turned = |turn: &Turn| Some(Facing::North.turned(*turn)) == facing;
    Turn::ALL.into_iter().find(turned).unwrap_or_default()
}

struct Exception {
    sides: Sides,
    bottom: Bottom,
}

fn exception(state: &BlockState) -> Option<&'static Exception> {
    let (_, name) = state.name().split_once(':').unwrap_or(("", state.name()));
    exceptions().iter().find(|(pattern, _)| fits(pattern, name)).map(|(_, exception)| exception)
}

fn exceptions() -> &'static [(&'static str, Exception)] {
    static EXCEPTIONS: OnceLock<Vec<(&str, Exception)>> = OnceLock::new();
    EXCEPTIONS.get_or_init(|| {
        let table = table(include_str!("sturdy.txt"));
        table.filter_map(|(pattern, value)| Some((pattern, parse(value)?))).collect()
    })
}

/// Reads `neswd / all`.
fn parse(value: &str) -> Option<Exception> {
    let (sides, bottom) = value.split_once('/')?;
    let named = |letter: char| Facing::ALL.into_iter().find(|side| side.name().starts_with(letter));
    let sides = match sides.trim() {
        "-" => Sides::default(),
        "all" => Facing::ALL.into_iter().collect(),
        letters => letters.chars().map(named).collect::<Option<Sides>>()?,
    };
    let bottom = match bottom.trim() {
        "-" => Bottom::default(),
        "all" => Bottom::all(),
        "middle" => Bottom::middle(),
        _ => return None,
    };
    Some(Exception { sides, bottom })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    #[test]
    fn every_exception_is_read_and_fits_a_block() {
        let lines = table(include_str!("sturdy.txt"));
        assert_eq!(lines.count(), exceptions().len());
        for (at, (pattern, _)) in exceptions().iter().enumerate() {
            let first = |name: &str| exceptions().iter().position(|(pattern, _)| fits(pattern, name));
            assert!(all().iter().any(|known| first(known.name()) == Some(at)), "{pattern}");
        }
    }

    fn sides(text: &str) -> String {
        let state = text.parse().unwrap();
        sturdy(&state).iter().map(|side| &side.name()[..1]).collect()
    }

    #[test]
    fn whole_squares_are_sturdy() {
        let cases = [
            ("stone", "neswud"),
            ("oak_slab[type=top]", "u"),
            ("oak_slab[type=double]", "neswud"),
            ("oak_stairs[facing=east,half=bottom]", "ed"),
            ("oak_stairs[facing=east,half=top,shape=inner_left]", "neu"),
            ("oak_stairs[facing=east,half=top,shape=outer_left]", "u"),
            ("oak_door[facing=east]", "w"),
            ("oak_trapdoor[half=top]", "u"),
            ("ladder[facing=east]", "w"),
            ("snow[layers=8]", "neswud"),
            ("snow[layers=3]", ""),
            ("oak_leaves", ""),
            ("oak_fence[north=true]", ""),
            ("chest", ""),
        ];
        for (text, expected) in cases {
            assert_eq!(sides(text), expected, "{text}");
        }
    }

    #[test]
    fn walls_feel_what_stands_on_them() {
        let of = |text: &str| {
            let Bottom { middle, strips } = bottom(&text.parse().unwrap());
            let strips: String = strips.iter().map(|side| &side.name()[..1]).collect();
            format!("{}{strips}", if middle { "m" } else { "" })
        };
        let cases = [
            ("stone", "mnesw"),
            ("oak_slab[type=top]", ""),
            ("oak_slab", "mnesw"),
            ("white_carpet", "mnesw"),
            ("torch", ""),
            ("lantern", "m"),
            ("oak_fence[east=true]", "me"),
            ("oak_fence_gate[facing=north]", "mew"),
            ("oak_fence_gate[open=true]", ""),
            ("stone_brick_wall[up=false,north=low,south=tall]", "mns"),
            ("oak_trapdoor", "mnesw"),
            ("chest", "m"),
            ("poppy", ""),
        ];
        for (text, expected) in cases {
            assert_eq!(of(text), expected, "{text}");
        }
    }
}
