//! What a terminal is in a house, and what it is called.

use crate::block::{self, BlockState, Shape};
use crate::graph::{Expr, NodeIndex, Op, OpGraph, Thing};

/// What a terminal is in a house.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    Nothing,
    Solid,
    /// Stairs and slabs.
    Sloped,
    Window,
    Door,
    Fence,
    Ground,
    /// Furniture, plants, lights and the like.
    Other,
}

/// Full blocks that lie under houses and not in them.
pub const GROUND: [&str; 11] = [
    "grass_block",
    "dirt",
    "coarse_dirt",
    "rooted_dirt",
    "podzol",
    "mycelium",
    "gravel",
    "sand",
    "red_sand",
    "dirt_path",
    "farmland",
];

/// A terminal of a graph.
#[derive(Clone, Debug)]
pub struct Leaf {
    pub kind: Kind,
    /// Its material, or its own name where it is of none.
    pub word: String,
}

impl Leaf {
    /// What a primitive, turned or not, or nil is; `None` for other operations.
    pub fn of(graph: &OpGraph, node: NodeIndex) -> Option<Leaf> {
        match graph.op(node) {
            Op::Nil => Some(Leaf { kind: Kind::Nothing, word: "empty".to_owned() }),
            Op::Primitive { name, .. } => Some(Leaf::named(graph, name)),
            Op::Rotate { .. } if graph.is_leaf(node) => {
                graph.children(node).next().and_then(|(_, child)| Leaf::of(graph, child))
            }
            _ => None,
        }
    }

    fn named(graph: &OpGraph, name: &Expr) -> Leaf {
        let text = match name {
            Expr::Constant(at) => graph.constants.get(*at).map_or("", |known| &known.name),
            Expr::Thing(thing) => thing.text(),
            _ => "",
        };
        let block = match name {
            Expr::Thing(thing @ (Thing::Name(_) | Thing::Block(_))) => thing.block(),
            _ => None,
        };
        match block {
            Some(state) => Leaf { kind: kind(&state), word: material(state.short_name()) },
            None => Leaf { kind: Kind::Solid, word: text.to_owned() },
        }
    }
}

fn kind(state: &BlockState) -> Kind {
    let name = state.short_name();
    match block::shape(state) {
        Shape::Air => Kind::Nothing,
        _ if GROUND.contains(&name) => Kind::Ground,
        _ if name.contains("glass") => Kind::Window,
        Shape::Full => Kind::Solid,
        Shape::Stairs { .. } | Shape::Slab(_) => Kind::Sloped,
        Shape::Pane(_) => Kind::Window,
        Shape::Door(_) => Kind::Door,
        Shape::Fence(_) | Shape::Wall { .. } | Shape::Gate { .. } => Kind::Fence,
        _ => Kind::Other,
    }
}

/// What a block's name adds to its material.
const MEMBERS: [&str; 11] = [
    "_fence_gate",
    "_trapdoor",
    "_planks",
    "_stairs",
    "_fence",
    "_slab",
    "_wall",
    "_door",
    "_wood",
    "_log",
    "_block",
];

/// The material of a block in two words at the most: `oak` of `oak_planks`, `stone_brick` of `mossy_stone_bricks`.
pub fn material(name: &str) -> String {
    let name = name.rsplit(':').next().unwrap_or(name);
    let name = ["wall_", "potted_"].iter().find_map(|before| name.strip_prefix(before)).unwrap_or(name);
    let bare = MEMBERS.iter().find_map(|member| name.strip_suffix(member)).unwrap_or(name);
    let bare = match bare {
        "bricks" => "brick",
        _ => bare.strip_suffix("_bricks").map_or(bare, |_| &bare[..bare.len() - 1]),
    };
    let words: Vec<&str> = bare.split('_').collect();
    words[words.len().saturating_sub(2)..].join("_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_are_two_words_at_the_most() {
        let cases = [
            ("oak_planks", "oak"),
            ("stripped_dark_oak_log", "dark_oak"),
            ("stone_bricks", "stone_brick"),
            ("mossy_stone_brick_stairs", "stone_brick"),
            ("bricks", "brick"),
            ("wall_torch", "torch"),
            ("mod:red_rock_slab", "red_rock"),
            ("glass", "glass"),
            ("", ""),
        ];
        for (name, expected) in cases {
            assert_eq!(material(name), expected, "{name}");
        }
    }
}
