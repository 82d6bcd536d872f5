//! Block entities, in the form that they have beside the states of today. What became part of the state moves there.

use super::owner;
use crate::block::{BlockState, legacy_id, legacy_state};
use crate::io::fields::{Fields, FromTag};
use crate::io::{ReadError, kinds, text};
use crate::nbt::{Compound, Tag};

/// The colour of beds that do not say theirs.
const RED: usize = 14;

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

/// Whether there are items in it, whose form is that of their time.
pub fn holds_items(data: &Compound) -> bool {
    matches!(data.get("Items"), Some(Tag::List(items)) if !items.is_empty())
        || data.contains_key("RecordItem")
}

/// The state of a block and its block entity as they are today; `None` where it needs none any more.
pub fn modern(state: &BlockState, fields: &Fields) -> Result<(BlockState, Option<Compound>), ReadError> {
    let id = modern_id(fields.find::<&str>("id")?.unwrap_or_default(), state);
    let mut data = fields.tags.clone();
    data.retain(|name, _| !["x", "y", "z"].contains(&name.as_str()));
    if !id.is_empty() {
        data.insert("id".to_owned(), Tag::String(id.clone()));
    }
    text::make_json(&mut data, "CustomName");
    let kind = id.strip_prefix("minecraft:").unwrap_or(&id);
    Ok(match kind {
        "bed" => (kinds::bed(state, take(&mut data, "color").unwrap_or(RED)), Some(data)),
        "banner" => (banner(state, &mut data), Some(data)),
        "skull" => (skull(state, &mut data), Some(data)),
        "flower_pot" => (pot(state, &data), None),
        "noteblock" => (note_block(state, &data), None),
        "sign" => {
            sign(&mut data);
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

/// The number that `name` holds, which is then gone.
fn take(data: &mut Compound, name: &str) -> Option<usize> {
    data.remove(name).and_then(|tag| number(&tag))
}

fn number(tag: &Tag) -> Option<usize> {
    i32::from_tag(tag).and_then(|number| usize::try_from(number).ok())
}

fn banner(state: &BlockState, data: &mut Compound) -> BlockState {
    if let Some(Tag::List(patterns)) = data.get_mut("Patterns") {
        patterns.iter_mut().for_each(turn_colour);
    }
    kinds::banner(state, take(data, "Base").unwrap_or(0))
}

/// Patterns count colours as wool does since Minecraft 1.13, and the other way before.
fn turn_colour(pattern: &mut Tag) {
    let Tag::Compound(pattern) = pattern else { return };
    if let Some(color) = pattern.get_mut("Color")
        && let Some(old @ 0..=15) = i32::from_tag(color)
    {
        *color = Tag::Int(15 - old);
    }
}

fn skull(state: &BlockState, data: &mut Compound) -> BlockState {
    owner::modernise(data);
    let kind = take(data, "SkullType").unwrap_or(0);
    kinds::skull(state, kind, take(data, "Rot").unwrap_or(0))
}

/// The plant is an item, by its name or, in old files, by its number.
fn pot(state: &BlockState, data: &Compound) -> BlockState {
    let id = match data.get("Item") {
        Some(Tag::String(name)) => legacy_id(name),
        Some(tag) => number(tag).and_then(|id| u8::try_from(id).ok()),
        None => None,
    };
    let item_data = data.get("Data").and_then(number).and_then(|data| u8::try_from(data).ok()).unwrap_or(0);
    match id.and_then(|id| legacy_state(id, item_data)) {
        Some(plant) => kinds::pot(state, plant.short_name()),
        None => state.clone(),
    }
}

fn note_block(state: &BlockState, data: &Compound) -> BlockState {
    let number = |name| data.get(name).and_then(number).unwrap_or(0);
    let tuned = kinds::note_block(state, number("note"));
    let powered = number("powered") != 0 && tuned.get("note").is_some();
    if powered { tuned.with("powered", "true") } else { tuned }
}

const LINES: [&str; 4] = ["Text1", "Text2", "Text3", "Text4"];

/// Brings the lines of a sign to its front.
fn sign(data: &mut Compound) {
    let front = LINES.map(|name| match data.remove(name) {
        Some(Tag::String(text)) => text::line(&text),
        _ => text::line(""),
    });
    text::set_sign(data, front, LINES.map(|_| text::line("")));
}
