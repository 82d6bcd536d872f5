//! Where texts are, which Minecraft 1.21.5 keeps as tags and those before in JSON. With them components of items became
//! plainer.

use super::tags::{self, compound, compounds, put};
use super::{Kept, Way, json, stored};
use crate::nbt::{Compound, Tag};

/// Components of items that hold a text.
const TEXTS: [&str; 2] = ["minecraft:custom_name", "minecraft:item_name"];
const LORE: &str = "minecraft:lore";
const BOOK: &str = "minecraft:written_book_content";

/// Components that hold all they say in one field before.
const PLAINER: [(&str, &str); 3] = [
    ("minecraft:enchantments", "levels"),
    ("minecraft:stored_enchantments", "levels"),
    ("minecraft:dyed_color", "rgb"),
];

/// Components that changed beyond what is translated here.
const CHANGED: [&str; 7] = [
    "minecraft:attribute_modifiers",
    "minecraft:can_break",
    "minecraft:can_place_on",
    "minecraft:hide_additional_tooltip",
    "minecraft:hide_tooltip",
    "minecraft:tooltip_display",
    "minecraft:trim",
];

pub fn change(data: &mut Compound, way: Way, kept: &mut Kept) {
    one(data, "CustomName", way, kept);
    match tags::kind(data) {
        "sign" | "hanging_sign" => {
            for side in ["front_text", "back_text"] {
                let Some(side) = tags::inner(data, side) else { continue };
                ["messages", "filtered_messages"].iter().for_each(|name| each(side, name, way, kept));
            }
        }
        "text_display" => one(data, "text", way, kept),
        "command_block" | "command_block_minecart" => one(data, "LastOutput", way, kept),
        _ => {}
    }
    stored::each(data, &mut |item| {
        if let Some(components) = tags::inner(item, "components") {
            of_item(components, way, kept);
        }
    });
}

fn of_item(components: &mut Compound, way: Way, kept: &mut Kept) {
    TEXTS.iter().for_each(|name| one(components, name, way, kept));
    each(components, LORE, way, kept);
    if let Some(book) = tags::inner(components, BOOK) {
        for page in compounds(book, "pages") {
            ["raw", "filtered"].iter().for_each(|name| one(page, name, way, kept));
        }
    }
    for (name, field) in PLAINER {
        let Some(old) = components.get(name) else { continue };
        match plainer(old, field, way) {
            Some(new) => put(components, name, new),
            None => kept.add(format!("item component `{name}`")),
        }
    }
    let changed = CHANGED.iter().filter(|name| components.contains_key(name));
    changed.for_each(|name| kept.add(format!("item component `{name}`")));
}

fn plainer(old: &Tag, field: &str, way: Way) -> Option<Tag> {
    match (way, old) {
        (Way::Down, old) => Some(compound([(field, old.clone())])),
        (Way::Up, Tag::Compound(whole)) if whole.len() == 1 => whole.get(field).cloned(),
        (Way::Up, _) => None,
    }
}

/// The text of that name.
fn one(data: &mut Compound, name: &str, way: Way, kept: &mut Kept) {
    tags::change(data, name, |old| Some(translated(old, way, kept)));
}

/// The texts of the list of that name.
fn each(data: &mut Compound, name: &str, way: Way, kept: &mut Kept) {
    let Some(list) = tags::list(data, name) else { return };
    let texts = list.iter().map(|old| translated(old, way, kept)).collect();
    *list = json::alike(texts);
}

fn translated(old: &Tag, way: Way, kept: &mut Kept) -> Tag {
    let new = match (way, old) {
        (Way::Up, Tag::String(text)) if text.is_empty() => Some(old.clone()),
        (Way::Up, Tag::String(text)) => json::parse(text),
        (Way::Up, _) => None,
        (Way::Down, text) => json::print(text).map(Tag::String),
    };
    new.unwrap_or_else(|| {
        kept.add("text");
        old.clone()
    })
}
