//! Block entities, in the form that they have beside the states of today. What became part of the state moves there.

use super::{owner, text};
use crate::block::{BlockState, DYES, known, legacy_id, legacy_state};
use crate::grid::Grid;
use crate::io::fields::{Fields, FromTag};
use crate::io::{ReadError, Warning, volume};
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

/// Ids before Minecraft 1.11.
const OLD_IDS: [(&str, &str); 23] = [
    ("Airportal", "end_portal"),
    ("Banner", "banner"),
    ("Beacon", "beacon"),
    ("Cauldron", "brewing_stand"),
    ("Chest", "chest"),
    ("Comparator", "comparator"),
    ("Control", "command_block"),
    ("DLDetector", "daylight_detector"),
    ("Dropper", "dropper"),
    ("EnchantTable", "enchanting_table"),
    ("EndGateway", "end_gateway"),
    ("EnderChest", "ender_chest"),
    ("FlowerPot", "flower_pot"),
    ("Furnace", "furnace"),
    ("Hopper", "hopper"),
    ("MobSpawner", "mob_spawner"),
    ("Music", "noteblock"),
    ("Piston", "piston"),
    ("RecordPlayer", "jukebox"),
    ("Sign", "sign"),
    ("Skull", "skull"),
    ("Structure", "structure_block"),
    ("Trap", "dispenser"),
];

/// Puts the block entities of a schematic into `grid`.
pub(super) fn read(root: &Fields, grid: &mut Grid) -> Result<Vec<Warning>, ReadError> {
    let (mut outside, mut with_items) = (0, 0);
    for fields in root.list("TileEntities")? {
        let place = Cell::new(fields.get("x")?, fields.get("y")?, fields.get("z")?);
        if !grid.bounds().contains(place) {
            outside += 1;
            continue;
        }
        let (state, data) = modern(grid.get(place), &fields)?;
        let id = grid.intern(&state).map_err(volume::full("TileEntities"))?;
        grid.set(place, id);
        with_items += usize::from(data.as_ref().is_some_and(holds_items));
        grid.block_entities.extend(data.map(|data| (place.to_array(), data)));
    }
    let warnings = [
        (outside > 0).then_some(Warning::BlockEntitiesOutside(outside)),
        (with_items > 0).then_some(Warning::OldItems(with_items)),
    ];
    Ok(warnings.into_iter().flatten().collect())
}

fn holds_items(data: &Compound) -> bool {
    matches!(data.get("Items"), Some(Tag::List(items)) if !items.is_empty())
        || data.contains_key("RecordItem")
}

/// The state of a block and its block entity as they are today; `None` where it needs none any more.
fn modern(state: &BlockState, fields: &Fields) -> Result<(BlockState, Option<Compound>), ReadError> {
    let id = modern_id(fields.find::<&str>("id")?.unwrap_or_default(), state);
    let mut data = fields.tags.clone();
    data.retain(|name, _| !["x", "y", "z"].contains(&name.as_str()));
    if !id.is_empty() {
        data.insert("id".to_owned(), Tag::String(id.clone()));
    }
    text::make_json(&mut data, "CustomName");
    let kind = id.strip_prefix("minecraft:").unwrap_or(&id);
    Ok(match kind {
        "bed" => (bed(state, &mut data), Some(data)),
        "banner" => (banner(state, &mut data), Some(data)),
        "skull" => (skull(state, &mut data), Some(data)),
        "flower_pot" => (pot(state, &data), None),
        "noteblock" => (note_block(state, &data), None),
        "sign" => {
            text::sign(&mut data);
            (state.clone(), Some(data))
        }
        _ => (state.clone(), Some(data)),
    })
}

/// The id of a block entity since Minecraft 1.13, which tells trapped chests apart. Those of mods stay as they are.
fn modern_id(id: &str, state: &BlockState) -> String {
    let name = OLD_IDS.iter().find(|(old, _)| *old == id).map(|(_, new)| format!("minecraft:{new}"));
    match name.as_deref().unwrap_or(id) {
        "minecraft:chest" if state.short_name() == "trapped_chest" => "minecraft:trapped_chest".to_owned(),
        id => id.to_owned(),
    }
}

/// `state` with the block called `name` in its place; as it is where there is no such block.
fn renamed(state: &BlockState, name: &str) -> BlockState {
    let Some(known) = known(name) else { return state.clone() };
    let new = BlockState::new(name).unwrap_or_else(|_| state.clone());
    let kept = state.properties().filter(|(key, _)| known.property(key).is_some());
    kept.fold(new, |new, (key, value)| new.with(key, value))
}

/// The number that `name` holds, which is then gone.
fn take(data: &mut Compound, name: &str) -> Option<usize> {
    data.remove(name).and_then(|tag| number(&tag))
}

fn number(tag: &Tag) -> Option<usize> {
    i32::from_tag(tag).and_then(|number| usize::try_from(number).ok())
}

fn bed(state: &BlockState, data: &mut Compound) -> BlockState {
    let dye = take(data, "color").and_then(|color| DYES.get(color)).unwrap_or(&"red");
    if state.short_name() == "red_bed" { renamed(state, &format!("{dye}_bed")) } else { state.clone() }
}

/// Banners counted their colours from black to white.
fn banner_dye(color: usize) -> Option<&'static str> {
    DYES.iter().rev().nth(color).copied()
}

fn banner(state: &BlockState, data: &mut Compound) -> BlockState {
    let dye = banner_dye(take(data, "Base").unwrap_or(0)).unwrap_or("black");
    if let Some(Tag::List(patterns)) = data.get_mut("Patterns") {
        patterns.iter_mut().for_each(turn_colour);
    }
    match state.short_name() {
        "white_banner" => renamed(state, &format!("{dye}_banner")),
        "white_wall_banner" => renamed(state, &format!("{dye}_wall_banner")),
        _ => state.clone(),
    }
}

fn turn_colour(pattern: &mut Tag) {
    let Tag::Compound(pattern) = pattern else { return };
    if let Some(color) = pattern.get_mut("Color")
        && let Some(old @ 0..=15) = i32::from_tag(color)
    {
        *color = Tag::Int(15 - old);
    }
}

/// By `SkullType`: the block on the floor, and on the wall.
const SKULLS: [(&str, &str); 6] = [
    ("skeleton_skull", "skeleton_wall_skull"),
    ("wither_skeleton_skull", "wither_skeleton_wall_skull"),
    ("zombie_head", "zombie_wall_head"),
    ("player_head", "player_wall_head"),
    ("creeper_head", "creeper_wall_head"),
    ("dragon_head", "dragon_wall_head"),
];

fn skull(state: &BlockState, data: &mut Compound) -> BlockState {
    let kind = take(data, "SkullType").unwrap_or(0);
    let rotation = take(data, "Rot").unwrap_or(0) % 16;
    owner::modernise(data);
    let &(floor, wall) = SKULLS.get(kind).unwrap_or(&SKULLS[0]);
    match state.short_name() {
        "skeleton_skull" => renamed(state, floor).with("rotation", &rotation.to_string()),
        "skeleton_wall_skull" => renamed(state, wall),
        _ => state.clone(),
    }
}

/// The plant is an item, by its name or, in old files, by its number.
fn pot(state: &BlockState, data: &Compound) -> BlockState {
    let id = match data.get("Item") {
        Some(Tag::String(name)) => legacy_id(name),
        Some(tag) => number(tag).and_then(|id| u8::try_from(id).ok()),
        None => None,
    };
    let item_data = data.get("Data").and_then(number).and_then(|data| u8::try_from(data).ok()).unwrap_or(0);
    let plant = id.and_then(|id| legacy_state(id, item_data));
    match plant.filter(|_| state.short_name() == "flower_pot") {
        Some(plant) => renamed(state, &format!("potted_{}", plant.short_name())),
        None => state.clone(),
    }
}

fn note_block(state: &BlockState, data: &Compound) -> BlockState {
    if state.short_name() != "note_block" {
        return state.clone();
    }
    let number = |name| data.get(name).and_then(number).unwrap_or(0);
    let powered = if number("powered") == 0 { "false" } else { "true" };
    state.clone().with("note", &number("note").min(24).to_string()).with("powered", powered)
}
