//! Sixteen by sixteen texels of light and shade for each kind of material, drawn by rule.

use super::side::Side;
use crate::block::BlockState;
use crate::space::Axis;
use std::sync::OnceLock;

/// Brightness by `[v][u]`; `PLAIN` leaves the color as it is.
pub(super) type Texture = [[u8; 16]; 16];

/// The brightness that changes nothing.
pub(super) const PLAIN: u8 = 128;

/// Texels of this brightness and above are the frame of a pane of glass.
pub(super) const FRAME: u8 = 200;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Pattern {
    Plain,
    Grain,
    Boards,
    Stripes,
    Rows,
    Rings,
    Bricks,
    Tiles,
    Cobble,
    Leaves,
    Weave,
    Books,
    Slab,
    Frame,
}

const PATTERNS: [Pattern; 14] = [
    Pattern::Plain,
    Pattern::Grain,
    Pattern::Boards,
    Pattern::Stripes,
    Pattern::Rows,
    Pattern::Rings,
    Pattern::Bricks,
    Pattern::Tiles,
    Pattern::Cobble,
    Pattern::Leaves,
    Pattern::Weave,
    Pattern::Books,
    Pattern::Slab,
    Pattern::Frame,
];

/// What parts of names say of the material, first match first.
const WORDS: [(&str, Pattern); 32] = [
    ("glass", Pattern::Frame),
    ("planks", Pattern::Boards),
    ("chest", Pattern::Boards),
    ("barrel", Pattern::Boards),
    ("crafting", Pattern::Boards),
    ("composter", Pattern::Boards),
    ("mosaic", Pattern::Tiles),
    ("leaves", Pattern::Leaves),
    ("azalea", Pattern::Leaves),
    ("bookshelf", Pattern::Books),
    ("cobble", Pattern::Cobble),
    ("gravel", Pattern::Cobble),
    ("brick", Pattern::Bricks),
    ("tile", Pattern::Tiles),
    ("prismarine", Pattern::Tiles),
    ("purpur", Pattern::Tiles),
    ("polished", Pattern::Slab),
    ("hay", Pattern::Stripes),
    ("bamboo", Pattern::Stripes),
    ("wool", Pattern::Weave),
    ("carpet", Pattern::Weave),
    ("_bed", Pattern::Weave),
    ("banner", Pattern::Weave),
    ("dirt", Pattern::Grain),
    ("grass", Pattern::Grain),
    ("stone", Pattern::Grain),
    ("sand", Pattern::Grain),
    ("diorite", Pattern::Grain),
    ("granite", Pattern::Grain),
    ("andesite", Pattern::Grain),
    ("tuff", Pattern::Grain),
    ("_ore", Pattern::Cobble),
];

/// The textures of the three sides of a block that is cut from the block called `material`.
pub(super) fn textures(state: &BlockState, material: &str) -> [&'static Texture; 3] {
    let pattern = pattern(material);
    Side::ALL.map(|side| &drawn()[trunk(state, side).unwrap_or(pattern) as usize])
}

pub(super) fn plain() -> &'static Texture {
    &drawn()[Pattern::Plain as usize]
}

fn pattern(name: &str) -> Pattern {
    WORDS.iter().find(|(word, _)| name.contains(word)).map_or(Pattern::Plain, |&(_, pattern)| pattern)
}

/// Bark runs along the axis of a trunk, rings show at its ends.
fn trunk(state: &BlockState, side: Side) -> Option<Pattern> {
    let name = state.short_name();
    let ends = ["_log", "_stem", "_pillar", "basalt"].iter().any(|word| name.ends_with(word));
    let bark = ends || name.ends_with("_wood") || name.ends_with("_hyphae");
    let axis = match state.get("axis") {
        Some("x") => Axis::X,
        Some("z") => Axis::Z,
        _ => Axis::Y,
    };
    let [u, _] = side.axes();
    match axis.of(side.normal()) {
        _ if !bark => None,
        1 if ends => Some(Pattern::Rings),
        _ if axis.of(u) == 0 => Some(Pattern::Stripes),
        _ => Some(Pattern::Rows),
    }
}

/// Whether this side of a block is the cut end of a trunk.
pub(super) fn is_cut_end(state: &BlockState, side: Side) -> bool {
    trunk(state, side) == Some(Pattern::Rings)
}

fn drawn() -> &'static [Texture] {
    static TEXTURES: OnceLock<Vec<Texture>> = OnceLock::new();
    TEXTURES.get_or_init(|| PATTERNS.iter().map(|&pattern| draw(pattern)).collect())
}

fn draw(pattern: Pattern) -> Texture {
    std::array::from_fn(|v| std::array::from_fn(|u| texel(pattern, u as i32, v as i32)))
}

fn texel(pattern: Pattern, u: i32, v: i32) -> u8 {
    let light = match pattern {
        Pattern::Plain => noise(u, v, 3),
        Pattern::Grain => noise(u / 2, v / 2, 9) + noise(u, v, 5),
        Pattern::Boards => boards(u, v),
        Pattern::Stripes => noise(u, 0, 14) + noise(u, v / 4, 6),
        Pattern::Rows => noise(v, 0, 14) + noise(v, u / 4, 6),
        Pattern::Rings => rings(u, v),
        Pattern::Bricks => bricks(u, v),
        Pattern::Tiles => {
            if u % 8 == 0 || v % 8 == 0 {
                -16
            } else {
                4
            }
        }
        Pattern::Cobble => cobble(u, v),
        Pattern::Leaves => noise(u / 2, v / 2, 22) + noise(u, v, 10),
        Pattern::Weave => noise(u, v, 5),
        Pattern::Books => books(u, v),
        Pattern::Slab => {
            if border(u, v) {
                -12
            } else {
                noise(u, v, 4)
            }
        }
        Pattern::Frame => {
            if border(u, v) {
                i32::from(FRAME)
            } else {
                0
            }
        }
    };
    (i32::from(PLAIN) + light).clamp(0, 255) as u8
}

fn border(u: i32, v: i32) -> bool {
    u == 0 || v == 0 || u == 15 || v == 15
}

/// Four boards, each with a seam below it and a joint that moves from board to board.
fn boards(u: i32, v: i32) -> i32 {
    let board = v / 4;
    let joint = u == (board * 7 + 3) % 16;
    if v % 4 == 3 || joint { -18 } else { noise(u / 4, board, 5) + noise(board, 9, 5) }
}

fn bricks(u: i32, v: i32) -> i32 {
    let row = v / 4;
    let along = u + 4 * (row % 2);
    if v % 4 == 3 || along % 8 == 7 { -20 } else { noise(along / 8, row, 7) }
}

fn rings(u: i32, v: i32) -> i32 {
    let out = (2 * u - 15).abs().max((2 * v - 15).abs());
    match out {
        14.. => -34,
        _ if out % 4 >= 2 => 6,
        _ => -8,
    }
}

/// Each texel belongs to the nearest of sixteen scattered stones; those between two are joints.
fn cobble(u: i32, v: i32) -> i32 {
    let mut near: Vec<(i32, i32)> = (-1..5)
        .flat_map(|row: i32| (-1..5_i32).map(move |column| (row, column)))
        .map(|(row, column)| {
            let (r, c) = (row.rem_euclid(4), column.rem_euclid(4));
            let du = 4 * column + 2 + noise(r, c, 2) - u;
            let dv = 4 * row + 2 + noise(c + 7, r, 2) - v;
            (du * du + dv * dv, noise(r, c + 3, 12))
        })
        .collect();
    near.sort_unstable();
    if near[1].0 - near[0].0 < 3 { -20 } else { near[0].1 }
}

fn books(u: i32, v: i32) -> i32 {
    match v % 8 {
        0 | 7 => 12,
        _ => noise(u / 2, v / 8, 36),
    }
}

/// A number from `-most` to `most` that depends on the place alone.
pub(super) fn noise(x: i32, y: i32, most: i32) -> i32 {
    (scatter(x, y) % (2 * most as u32 + 1)) as i32 - most
}

/// Mixes two numbers into one that looks random.
fn scatter(x: i32, y: i32) -> u32 {
    let mut hash = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    hash = (hash ^ (hash >> 15)).wrapping_mul(0x2c1b_3c6d);
    hash = (hash ^ (hash >> 12)).wrapping_mul(0x297a_2d39);
    hash ^ (hash >> 15)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pattern_has_its_texture() {
        for (at, pattern) in PATTERNS.into_iter().enumerate() {
            assert_eq!(pattern as usize, at);
        }
    }

    #[test]
    fn bark_runs_along_the_trunk() {
        let of = |text: &str, side: Side| trunk(&text.parse().unwrap(), side);
        assert_eq!(of("oak_log", Side::Top), Some(Pattern::Rings));
        assert_eq!(of("oak_log", Side::Left), Some(Pattern::Stripes));
        assert_eq!(of("oak_log[axis=x]", Side::Right), Some(Pattern::Rings));
        assert_eq!(of("oak_log[axis=x]", Side::Left), Some(Pattern::Rows));
        assert_eq!(of("oak_log[axis=z]", Side::Top), Some(Pattern::Stripes));
    }
}
