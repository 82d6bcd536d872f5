use super::sides::{gate_ends_at, truth};
use super::site::{Answer, Site};
use crate::block::{Facing, Post, Shape};
use crate::space::Cell;

/// The arms of a wall, which reach up to what stands over them, and its post. Walls are asked from the top down:
/// a post goes down through all walls under it.
pub fn arms_and_post(site: &Site<'_>, cell: Cell) -> Answer {
    let above = site.block(cell + Cell::Y).bottom;
    let arm = |side: Facing| match (joins(site, cell, side), above.strips.contains(side)) {
        (false, _) => "none",
        (true, false) => "low",
        (true, true) => "tall",
    };
    let arms = Facing::HORIZONTAL.map(arm);
    let mut answer: Answer = Facing::HORIZONTAL.iter().map(|side| side.name()).zip(arms).collect();
    answer.push(("up", truth(has_post(site, cell, arms))));
    answer
}

fn joins(site: &Site<'_>, cell: Cell, side: Facing) -> bool {
    let other = site.block(cell + side.step());
    let is_thin = matches!(other.shape, Shape::Wall { .. } | Shape::Pane(_));
    is_thin || gate_ends_at(other, side) || other.joins.contains(side.opposite())
}

/// A wall that runs straight on, or crosses another, has a post only where something stands on it.
fn has_post(site: &Site<'_>, cell: Cell, [north, east, south, west]: [&str; 4]) -> bool {
    let above = site.block(cell + Cell::Y);
    let is_arm = |arm: &str| arm != "none";
    let is_bare = ![north, east, south, west].into_iter().any(is_arm);
    let runs_on = is_arm(north) == is_arm(south) && is_arm(east) == is_arm(west);
    let is_tall = |one: &str, other: &str| one == "tall" && other == "tall";
    match above.shape {
        Shape::Wall { post: Post::Present, .. } => true,
        _ if is_bare || !runs_on => true,
        _ if is_tall(north, south) || is_tall(east, west) => false,
        _ => above.bottom.middle || holds_post(site.state(cell + Cell::Y).short_name()),
    }
}

/// Things too small to be felt from below that still stand on a post: the game's tag `wall_post_override`.
fn holds_post(name: &str) -> bool {
    const NAMES: [&str; 6] =
        ["torch", "soul_torch", "redstone_torch", "copper_torch", "tripwire", "cactus_flower"];
    const ENDINGS: [&str; 3] = ["_sign", "_banner", "_pressure_plate"];
    let ends = ENDINGS.iter().any(|ending| name.ends_with(ending)) && !name.ends_with("_hanging_sign");
    NAMES.contains(&name) || ends
}
