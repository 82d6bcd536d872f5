//! Wires: redstone dust and string.

use super::sides::each_side;
use super::site::{Answer, Site};
use crate::block::{Facing, Shape};
use crate::space::Cell;

/// Dust runs to what carries or takes power, up and down single blocks as well. Dust that leads nowhere is a
/// cross, and dust that has one end only runs straight on.
pub fn wire(site: &Site<'_>, cell: Cell) -> Answer {
    let ends = Facing::HORIZONTAL.map(|side| end(site, cell, side));
    let is_end = |at: usize| ends[at].is_some();
    let line = |at: usize| !is_end((at + 1) % 4) && !is_end((at + 3) % 4);
    let value = |at: usize| ends[at].unwrap_or(if line(at) { "side" } else { "none" });
    Facing::HORIZONTAL.iter().enumerate().map(|(at, side)| (side.name(), value(at))).collect()
}

fn end(site: &Site<'_>, cell: Cell, side: Facing) -> Option<&'static str> {
    let beside = cell + side.step();
    let climbs =
        !conducts(site, cell + Cell::Y) && carries_dust(site, beside) && is_dust(site, beside + Cell::Y);
    let falls = !conducts(site, beside) && is_dust(site, beside - Cell::Y);
    match climbs && site.block(beside).sturdy.contains(side.opposite()) {
        true => Some("up"),
        false if climbs || falls || takes_power(site, beside, side) => Some("side"),
        false => None,
    }
}

fn is_dust(site: &Site<'_>, cell: Cell) -> bool {
    site.state(cell).name() == "minecraft:redstone_wire"
}

fn carries_dust(site: &Site<'_>, cell: Cell) -> bool {
    let block = site.block(cell);
    let is_trapdoor = matches!(block.shape, Shape::Trapdoor(_));
    is_trapdoor || block.sturdy.contains(Facing::Up) || site.state(cell).name() == "minecraft:hopper"
}

/// Blocks that fill their cell, or nearly, and that power does not go through. Snow lies lower than it looks.
const INSULATORS: [&str; 14] = [
    "glass",
    "glowstone",
    "sea_lantern",
    "beacon",
    "ice",
    "frosted_ice",
    "tnt",
    "redstone_block",
    "observer",
    "piston",
    "sticky_piston",
    "chorus_flower",
    "powder_snow",
    "snow",
];

/// Power goes through blocks that are solid on all sides, which leaves and the like are not.
fn conducts(site: &Site<'_>, cell: Cell) -> bool {
    let (name, block) = (site.state(cell).short_name(), site.block(cell));
    let insulates =
        INSULATORS.contains(&name) || ["_glass", "_grate", "copper_bulb"].iter().any(|e| name.ends_with(e));
    let is_solid = block.shape == Shape::Full && block.sturdy.contains(Facing::Up);
    (is_solid && !insulates) || name == "barrier"
}

/// Blocks that give out power to all sides, by the end of their name.
const SOURCES: [&str; 14] = [
    "redstone_wire",
    "redstone_torch",
    "redstone_wall_torch",
    "redstone_block",
    "lever",
    "_button",
    "_pressure_plate",
    "daylight_detector",
    "tripwire_hook",
    "trapped_chest",
    "detector_rail",
    "lectern",
    "target",
    "sculk_sensor",
];

/// Whether dust runs to the block at `cell`, which lies on that side of it.
fn takes_power(site: &Site<'_>, cell: Cell, side: Facing) -> bool {
    let state = site.state(cell);
    let facing = || state.get("facing").and_then(Facing::named).unwrap_or(Facing::North);
    match state.short_name() {
        "repeater" => facing().axis() == side.axis(),
        "observer" => facing() == side,
        "comparator" | "jukebox" => true,
        name => SOURCES.iter().any(|source| name.ends_with(source)) || name.ends_with("lightning_rod"),
    }
}

/// String runs to string and to the hooks that hold it.
pub fn tripwire(site: &Site<'_>, cell: Cell) -> Answer {
    each_side(&Facing::HORIZONTAL, |side| {
        let state = site.state(cell + side.step());
        match state.short_name() {
            "tripwire" => true,
            "tripwire_hook" => state.get("facing") == Some(side.opposite().name()),
            _ => false,
        }
    })
}
