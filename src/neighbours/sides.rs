//! Blocks that join to what is beside them: fences, panes and gates, and the sides of plants and snowy grass.

use super::site::{Answer, Block, Site};
use crate::block::{Facing, Shape};
use crate::space::Cell;

const TRUTH: [&str; 2] = ["false", "true"];

pub fn truth(value: bool) -> &'static str {
    TRUTH[usize::from(value)]
}

/// The answer that says for each of `sides` whether it is joined.
pub fn each_side(sides: &[Facing], is_joined: impl Fn(Facing) -> bool) -> Answer {
    sides.iter().map(|side| (side.name(), truth(is_joined(*side)))).collect()
}

pub fn fence(site: &Site<'_>, cell: Cell) -> Answer {
    let is_nether = |cell: Cell| site.state(cell).name().ends_with("nether_brick_fence");
    each_side(&Facing::HORIZONTAL, |side| {
        let beside = cell + side.step();
        let other = site.block(beside);
        let same = matches!(other.shape, Shape::Fence(_)) && is_nether(beside) == is_nether(cell);
        same || gate_ends_at(other, side) || other.joins.contains(side.opposite())
    })
}

/// Panes and bars.
pub fn pane(site: &Site<'_>, cell: Cell) -> Answer {
    each_side(&Facing::HORIZONTAL, |side| {
        let other = site.block(cell + side.step());
        let is_thin = matches!(other.shape, Shape::Pane(_) | Shape::Wall { .. });
        is_thin || other.joins.contains(side.opposite())
    })
}

/// Whether `other`, on the given side, is a gate that has one of its ends here.
pub fn gate_ends_at(other: &Block, side: Facing) -> bool {
    matches!(other.shape, Shape::Gate { facing, .. } if facing.axis() != side.axis())
}

/// A gate between walls hangs lower.
pub fn gate(site: &Site<'_>, cell: Cell) -> Answer {
    let Shape::Gate { facing, .. } = site.block(cell).shape else { return Answer::new() };
    let is_wall = |side: Facing| matches!(site.block(cell + side.step()).shape, Shape::Wall { .. });
    Answer::from_iter([("in_wall", truth(is_wall(facing.left()) || is_wall(facing.right())))])
}

pub fn chorus(site: &Site<'_>, cell: Cell) -> Answer {
    each_side(&Facing::ALL, |side| match site.state(cell + side.step()).name() {
        "minecraft:chorus_plant" | "minecraft:chorus_flower" => true,
        "minecraft:end_stone" => side == Facing::Down,
        _ => false,
    })
}

/// Vines also hang from what is over them.
pub fn vine(site: &Site<'_>, cell: Cell) -> Answer {
    each_side(&[Facing::Up], |side| site.block(cell + side.step()).sturdy.contains(side.opposite()))
}

/// Grass under snow.
pub fn snowy(site: &Site<'_>, cell: Cell) -> Answer {
    let above = site.state(cell + Cell::Y).short_name();
    Answer::from_iter([("snowy", truth(["snow", "snow_block", "powder_snow"].contains(&above)))])
}
