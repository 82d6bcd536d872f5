//! What entities wear and hold: two lists before Minecraft 1.21.5, since then by the names of the slots.

use super::tags::{self, put};
use super::{Kept, Way};
use crate::nbt::{Compound, Tag};

/// The lists, and the slots in their order.
const WORN: [(&str, &[&str]); 2] =
    [("ArmorItems", &["feet", "legs", "chest", "head"]), ("HandItems", &["mainhand", "offhand"])];
const CHANCES: [(&str, &[&str]); 2] = [("ArmorDropChances", WORN[0].1), ("HandDropChances", WORN[1].1)];

/// How likely a slot drops what is in it, unless it says so itself.
const USUAL: f32 = 0.085;

pub fn change(data: &mut Compound, way: Way, kept: &mut Kept) {
    match way {
        Way::Up => {
            raise(
                data,
                "equipment",
                WORN,
                |tag| matches!(tag, Tag::Compound(item) if item.contains_key("id")),
            );
            raise(data, "drop_chances", CHANCES, |tag| *tag != Tag::Float(USUAL));
        }
        Way::Down => {
            lower(data, "equipment", WORN, &Tag::Compound(Compound::new()), kept);
            lower(data, "drop_chances", CHANCES, &Tag::Float(USUAL), kept);
        }
    }
}

/// Names those entries of the lists that say something.
fn raise(data: &mut Compound, new: &str, lists: [(&str, &[&str]); 2], says: impl Fn(&Tag) -> bool) {
    let mut slots = Compound::new();
    for (old, names) in lists {
        let Some(Tag::List(entries)) = data.remove(old) else { continue };
        let said = names.iter().zip(entries).filter(|(_, entry)| says(entry));
        said.for_each(|(name, entry)| put(&mut slots, name, entry));
    }
    if !slots.is_empty() {
        put(data, new, Tag::Compound(slots));
    }
}

fn lower(data: &mut Compound, new: &str, lists: [(&str, &[&str]); 2], empty: &Tag, kept: &mut Kept) {
    let Some(Tag::Compound(mut slots)) = data.remove(new) else { return };
    for (old, names) in lists {
        if names.iter().any(|name| slots.contains_key(name)) {
            let entries = names.iter().map(|name| slots.remove(name).unwrap_or_else(|| empty.clone()));
            tags::put(data, old, Tag::List(entries.collect()));
        }
    }
    if !slots.is_empty() {
        slots.keys().for_each(|name| kept.add(format!("`{name}` in `{new}`")));
        put(data, new, Tag::Compound(slots));
    }
}
