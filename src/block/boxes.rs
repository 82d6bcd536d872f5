use super::{
    Arm, Bend, BlockState, Facing, Half, Hung, Leaves, Plant, Post, Rgba, Shape, Sides, Slope, shape,
};
use crate::space::{Axis, Cell, Turn};

/// A box inside a cell, in sixteenths of it, from `low` to `high` along x, y and z.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cuboid {
    pub low: [u8; 3],
    pub high: [u8; 3],
    /// `None`: the color of the block.
    pub color: Option<Rgba>,
}

const WOOD: Rgba = Rgba::rgb(0x6a, 0x4b, 0x2c);
const IRON: Rgba = Rgba::rgb(0x45, 0x49, 0x52);
const LEAF: Rgba = Rgba::rgb(0x4f, 0x8a, 0x34);
const LINEN: Rgba = Rgba::rgb(0xee, 0xee, 0xea);

impl Cuboid {
    pub const FULL: Cuboid = cuboid([0, 0, 0], [16, 16, 16]);

    fn painted(self, color: Rgba) -> Cuboid {
        Cuboid { color: Some(color), ..self }
    }

    /// Turned about the middle of the cell.
    pub fn turned(self, turn: Turn) -> Cuboid {
        let place = |corner: [u8; 3]| turn.apply(2 * Cell::from(corner.map(i32::from)) - 16);
        let (a, b) = (place(self.low), place(self.high));
        let back = |v: Cell| ((v + 16) / 2).to_array().map(|n| n as u8);
        Cuboid { low: back(a.min(b)), high: back(a.max(b)), ..self }
    }
}

const fn cuboid(low: [u8; 3], high: [u8; 3]) -> Cuboid {
    Cuboid { low, high, color: None }
}

/// The boxes that a block is made of: what there is to see of it, fine detail aside.
pub fn boxes(state: &BlockState) -> Vec<Cuboid> {
    match shape(state) {
        Shape::Air => Vec::new(),
        Shape::Full => vec![Cuboid::FULL],
        Shape::Slab(half) => vec![half_block(half)],
        Shape::Stairs { facing, half, bend } => stairs(facing, half, bend),
        Shape::Fence(sides) => fence(sides),
        Shape::Pane(sides) => pane(sides),
        Shape::Wall { post, arms } => wall(post, arms),
        Shape::Gate { facing, leaves } => gate(facing, leaves),
        Shape::Door(side) | Shape::Trapdoor(side) => vec![at_side(side, 3)],
        Shape::Ladder(side) => vec![at_side(side, 1)],
        Shape::WallSign(side) => vec![to_side(side, cuboid([0, 4, 0], [16, 12, 2]))],
        Shape::Faces(sides) => sides.iter().map(|side| at_side(side, 1)).collect(),
        Shape::Torch(side) => torch(side).to_vec(),
        Shape::Button(side) => vec![button(side)],
        Shape::Lantern(hung) => lantern(hung),
        Shape::Chain(axis) | Shape::Rod(axis) => vec![along(axis)],
        Shape::Rail(slope) => rail(slope),
        Shape::Bed(pillow) => bed(pillow),
        Shape::Layer(height) | Shape::Fluid(height) => vec![cuboid([0, 0, 0], [16, height, 16])],
        Shape::Plant(Plant::Flower) => flower().to_vec(),
        Shape::Plant(Plant::Blades) => BLADES.to_vec(),
        Shape::Partial { boxes, front } => boxes.iter().map(|&b| to_side(front, b)).collect(),
    }
}

/// Turns what was made for the north side to `side`; up and down leave it where it is.
fn to_side(side: Facing, north: Cuboid) -> Cuboid {
    let turn = Turn::ALL.into_iter().find(|&turn| Facing::North.turned(turn) == side);
    north.turned(turn.unwrap_or_default())
}

/// A plate of the given thickness at one side of the cell.
fn at_side(side: Facing, thickness: u8) -> Cuboid {
    match side {
        Facing::Down => cuboid([0, 0, 0], [16, thickness, 16]),
        Facing::Up => cuboid([0, 16 - thickness, 0], [16, 16, 16]),
        _ => to_side(side, cuboid([0, 0, 0], [16, 16, thickness])),
    }
}

fn half_block(half: Half) -> Cuboid {
    match half {
        Half::Bottom => at_side(Facing::Down, 8),
        Half::Top => at_side(Facing::Up, 8),
    }
}

fn stairs(facing: Facing, half: Half, bend: Bend) -> Vec<Cuboid> {
    let (low, high) = match half {
        Half::Bottom => (8, 16),
        Half::Top => (0, 8),
    };
    let part = |west: u8, east: u8, z: u8| to_side(facing, cuboid([west, low, z], [east, high, z + 8]));
    // Seen with the tall side to the north: left is west.
    let steps = match bend {
        Bend::Straight => vec![part(0, 16, 0)],
        Bend::OuterLeft => vec![part(0, 8, 0)],
        Bend::OuterRight => vec![part(8, 16, 0)],
        Bend::InnerLeft => vec![part(0, 16, 0), part(0, 8, 8)],
        Bend::InnerRight => vec![part(0, 16, 0), part(8, 16, 8)],
    };
    std::iter::once(half_block(half)).chain(steps).collect()
}

fn fence(sides: Sides) -> Vec<Cuboid> {
    let bars = [cuboid([7, 6, 0], [9, 9, 6]), cuboid([7, 12, 0], [9, 15, 6])];
    let arms = sides.iter().flat_map(|side| bars.map(|bar| to_side(side, bar)));
    std::iter::once(cuboid([6, 0, 6], [10, 16, 10])).chain(arms).collect()
}

fn pane(sides: Sides) -> Vec<Cuboid> {
    let arms = sides.iter().map(|side| to_side(side, cuboid([7, 0, 0], [9, 16, 7])));
    std::iter::once(cuboid([7, 0, 7], [9, 16, 9])).chain(arms).collect()
}

fn wall(post: Post, arms: [Arm; 4]) -> Vec<Cuboid> {
    let post = (post == Post::Present).then_some(cuboid([4, 0, 4], [12, 16, 12]));
    let reach = if post.is_some() { 4 } else { 8 };
    let arm = |(side, arm): (Facing, Arm)| {
        let height = match arm {
            Arm::None => return None,
            Arm::Low => 14,
            Arm::Tall => 16,
        };
        Some(to_side(side, cuboid([5, 0, 0], [11, height, reach])))
    };
    post.into_iter().chain(Facing::HORIZONTAL.into_iter().zip(arms).filter_map(arm)).collect()
}

fn gate(facing: Facing, leaves: Leaves) -> Vec<Cuboid> {
    let posts = [cuboid([0, 5, 7], [2, 16, 9]), cuboid([14, 5, 7], [16, 16, 9])];
    let leaves = match leaves {
        Leaves::Shut => vec![
            cuboid([2, 6, 7], [14, 9, 9]),
            cuboid([2, 12, 7], [14, 15, 9]),
            cuboid([6, 9, 7], [10, 12, 9]),
        ],
        Leaves::Open => vec![cuboid([0, 6, 1], [2, 15, 7]), cuboid([14, 6, 1], [16, 15, 7])],
    };
    posts.into_iter().chain(leaves).map(|part| to_side(facing, part)).collect()
}

/// The color of the block is that of the flame.
fn torch(side: Facing) -> [Cuboid; 2] {
    match side {
        Facing::Up | Facing::Down => {
            [cuboid([7, 0, 7], [9, 8, 9]).painted(WOOD), cuboid([7, 8, 7], [9, 11, 9])]
        }
        _ => [
            to_side(side, cuboid([7, 3, 1], [9, 11, 3])).painted(WOOD),
            to_side(side, cuboid([7, 11, 1], [9, 14, 3])),
        ],
    }
}

fn button(side: Facing) -> Cuboid {
    match side {
        Facing::Down => cuboid([5, 0, 6], [11, 2, 10]),
        Facing::Up => cuboid([5, 14, 6], [11, 16, 10]),
        _ => to_side(side, cuboid([5, 6, 0], [11, 10, 2])),
    }
}

fn lantern(hung: Hung) -> Vec<Cuboid> {
    match hung {
        Hung::Standing => {
            vec![cuboid([5, 0, 5], [11, 7, 11]), cuboid([6, 7, 6], [10, 9, 10]).painted(IRON)]
        }
        Hung::Hanging => vec![
            cuboid([5, 1, 5], [11, 8, 11]),
            cuboid([6, 8, 6], [10, 10, 10]).painted(IRON),
            cuboid([7, 10, 7], [9, 16, 9]).painted(IRON),
        ],
    }
}

fn along(axis: Axis) -> Cuboid {
    let (mut low, mut high) = ([7; 3], [9; 3]);
    low[axis.index()] = 0;
    high[axis.index()] = 16;
    cuboid(low, high)
}

fn rail(slope: Slope) -> Vec<Cuboid> {
    match slope {
        Slope::Flat => vec![cuboid([1, 0, 1], [15, 1, 15])],
        Slope::Up(side) => (0..4)
            .map(|step| (4 * step, 16 - 4 * step))
            .map(|(z, height)| to_side(side, cuboid([1, height - 4, z], [15, height, z + 4])))
            .collect(),
    }
}

fn bed(pillow: Option<Facing>) -> Vec<Cuboid> {
    let frame = cuboid([0, 2, 0], [16, 5, 16]).painted(WOOD);
    let mattress = cuboid([0, 5, 0], [16, 9, 16]);
    let pillow = pillow.map(|side| to_side(side, cuboid([2, 9, 1], [14, 10, 7])).painted(LINEN));
    [frame, mattress].into_iter().chain(pillow).collect()
}

fn flower() -> [Cuboid; 3] {
    [
        cuboid([7, 0, 7], [9, 8, 9]).painted(LEAF),
        cuboid([9, 0, 8], [11, 4, 10]).painted(LEAF),
        cuboid([5, 8, 5], [11, 12, 11]),
    ]
}

const BLADES: [Cuboid; 5] = [
    cuboid([3, 0, 3], [5, 7, 5]),
    cuboid([10, 0, 2], [12, 9, 4]),
    cuboid([7, 0, 7], [9, 11, 9]),
    cuboid([3, 0, 11], [5, 9, 13]),
    cuboid([11, 0, 10], [13, 6, 12]),
];

/// Reads `x y z X Y Z [#color] ; ...`; leaves out what is not so.
pub(super) fn parse_boxes(text: &str) -> Vec<Cuboid> {
    text.split(';').filter_map(parse_box).collect()
}

fn parse_box(text: &str) -> Option<Cuboid> {
    let mut words = text.split_whitespace();
    let mut number = || words.next()?.parse::<u8>().ok().filter(|&n| n <= 16);
    let low = [number()?, number()?, number()?];
    let high = [number()?, number()?, number()?];
    Some(Cuboid { low, high, color: words.next().and_then(Rgba::parse) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::all;

    #[test]
    fn all_boxes_lie_in_their_cell_and_have_a_volume() {
        for known in all() {
            for b in boxes(&known.default_state()) {
                let fits = (0..3).all(|i| b.low[i] < b.high[i] && b.high[i] <= 16);
                assert!(fits, "{}: {b:?}", known.name());
            }
        }
    }

    #[test]
    fn the_tall_side_of_stairs_is_where_they_face() {
        let parts = boxes(&"oak_stairs[facing=east]".parse().unwrap());
        assert_eq!(parts, [cuboid([0, 0, 0], [16, 8, 16]), cuboid([8, 8, 0], [16, 16, 16])]);
        let parts = boxes(&"oak_stairs[facing=east,half=top,shape=outer_right]".parse().unwrap());
        assert_eq!(parts, [cuboid([0, 8, 0], [16, 16, 16]), cuboid([8, 0, 8], [16, 8, 16])]);
    }

    #[test]
    fn turning_a_block_turns_its_boxes() {
        let sorted = |mut boxes: Vec<Cuboid>| {
            boxes.sort_by_key(|b| (b.low, b.high));
            boxes
        };
        for name in ["oak_stairs", "oak_door", "oak_fence_gate", "anvil", "ladder", "chest", "lever"] {
            let state = crate::block::known(name).unwrap().default_state();
            let turned = boxes(&state).into_iter().map(|b| b.turned(Turn::quarters(1))).collect();
            assert_eq!(sorted(boxes(&state.turned(Turn::quarters(1)))), sorted(turned), "{name}");
        }
    }
}
