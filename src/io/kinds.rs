//! Block states as block entities decided them once, and do in Bedrock Edition: the colours of beds and banners, the
//! kinds of skulls, the plants in pots, the notes of note blocks. States of other blocks stay as they are.

use crate::block::{BlockState, DYES, known};

/// `state` with the block called `name` in its place; as it is where there is no such block.
fn renamed(state: &BlockState, name: &str) -> BlockState {
    let Some(known) = known(name) else { return state.clone() };
    let new = BlockState::new(name).unwrap_or_else(|_| state.clone());
    let kept = state.properties().filter(|(key, _)| known.property(key).is_some());
    kept.fold(new, |new, (key, value)| new.with(key, value))
}

/// A bed of the colour that wool has with data `color`.
pub(super) fn bed(state: &BlockState, color: usize) -> BlockState {
    match DYES.get(color) {
        Some(dye) if state.short_name() == "red_bed" => renamed(state, &format!("{dye}_bed")),
        _ => state.clone(),
    }
}

/// A banner of a colour. Banners count colours from black to white.
pub(super) fn banner(state: &BlockState, color: usize) -> BlockState {
    let dye = DYES.iter().rev().nth(color).unwrap_or(&"black");
    match state.short_name() {
        "white_banner" => renamed(state, &format!("{dye}_banner")),
        "white_wall_banner" => renamed(state, &format!("{dye}_wall_banner")),
        _ => state.clone(),
    }
}

/// By number: the block on the floor, and on the wall.
const SKULLS: [(&str, &str); 7] = [
    ("skeleton_skull", "skeleton_wall_skull"),
    ("wither_skeleton_skull", "wither_skeleton_wall_skull"),
    ("zombie_head", "zombie_wall_head"),
    ("player_head", "player_wall_head"),
    ("creeper_head", "creeper_wall_head"),
    ("dragon_head", "dragon_wall_head"),
    ("piglin_head", "piglin_wall_head"),
];

/// A skull of a kind, on the floor turned by sixteenths of a full turn.
pub(super) fn skull(state: &BlockState, kind: usize, sixteenths: usize) -> BlockState {
    let &(floor, wall) = SKULLS.get(kind).unwrap_or(&SKULLS[0]);
    match state.short_name() {
        "skeleton_skull" => turned_skull(&renamed(state, floor), sixteenths),
        "skeleton_wall_skull" => renamed(state, wall),
        _ => turned_skull(state, sixteenths),
    }
}

fn turned_skull(state: &BlockState, sixteenths: usize) -> BlockState {
    match SKULLS.iter().any(|(floor, _)| *floor == state.short_name()) {
        true => state.clone().with("rotation", &(sixteenths % 16).to_string()),
        false => state.clone(),
    }
}

/// A pot with the plant called `plant`.
pub(super) fn pot(state: &BlockState, plant: &str) -> BlockState {
    match state.short_name() {
        "flower_pot" => renamed(state, &format!("potted_{plant}")),
        _ => state.clone(),
    }
}

/// A note block tuned to `note`.
pub(super) fn note_block(state: &BlockState, note: usize) -> BlockState {
    match state.short_name() {
        "note_block" => state.clone().with("note", &note.min(24).to_string()),
        _ => state.clone(),
    }
}
