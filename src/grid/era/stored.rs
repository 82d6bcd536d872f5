//! Where items are kept.

use super::tags::inner;
use crate::nbt::{Compound, Tag};

/// Lists of items, and single items, in block entities and entities of any version.
const LISTS: [&str; 5] = ["Items", "Inventory", "ArmorItems", "HandItems", "items"];
const SINGLE: [&str; 7] = ["Item", "item", "Book", "RecordItem", "ArmorItem", "SaddleItem", "DecorItem"];

/// Goes through the items of a block entity or entity, and those in them, the inner ones first.
pub fn each(holder: &mut Compound, work: &mut impl FnMut(&mut Compound)) {
    for name in LISTS {
        if let Some(Tag::List(entries)) = holder.get_mut(name) {
            entries.iter_mut().for_each(|entry| item(entry, work));
        }
    }
    for name in SINGLE {
        if let Some(entry) = holder.get_mut(name) {
            item(entry, work);
        }
    }
    if let Some(Tag::Compound(worn)) = holder.get_mut("equipment") {
        worn.values_mut().for_each(|entry| item(entry, work));
    }
}

fn item(tag: &mut Tag, work: &mut impl FnMut(&mut Compound)) {
    let Tag::Compound(item) = tag else { return };
    if !matches!(item.get("id"), Some(Tag::String(_))) {
        return;
    }
    contents(item, work);
    work(item);
}

/// What is in a shulker box or a bundle.
fn contents(item: &mut Compound, work: &mut impl FnMut(&mut Compound)) {
    if let Some(tag) = inner(item, "tag") {
        each(tag, work);
        inner(tag, "BlockEntityTag").into_iter().for_each(|block| each(block, work));
    }
    let Some(components) = inner(item, "components") else { return };
    for name in ["minecraft:container", "minecraft:bundle_contents"] {
        let Some(Tag::List(slots)) = components.get_mut(name) else { continue };
        for slot in slots {
            match slot {
                Tag::Compound(place) if place.contains_key("item") => {
                    place.get_mut("item").into_iter().for_each(|entry| self::item(entry, work));
                }
                entry => self::item(entry, work),
            }
        }
    }
}
