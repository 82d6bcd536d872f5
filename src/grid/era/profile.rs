//! Whose head it is: since Minecraft 1.20.5 a profile with its properties in a list.

use super::tags::{self, compound, put, text};
use super::{Kept, Way};
use crate::nbt::{Compound, Tag};

/// By the names before and since. The tag itself is renamed with all others.
const NAMES: [(&str, &str); 2] = [("Id", "id"), ("Name", "name")];

/// By the names before and since, in each property.
const PROPERTY: [(&str, &str); 2] = [("Value", "value"), ("Signature", "signature")];

pub fn change(data: &mut Compound, way: Way, _: &mut Kept) {
    if tags::kind(data) != "skull" {
        return;
    }
    match way {
        Way::Up => tags::change(data, "SkullOwner", raised),
        Way::Down => tags::change(data, "profile", lowered),
    }
}

/// A profile of the name or the owner that was.
pub fn raised(owner: &Tag) -> Option<Tag> {
    let mut owner = match owner {
        Tag::String(name) => return Some(compound([("name", text(name))])),
        Tag::Compound(owner) => owner.clone(),
        _ => return None,
    };
    NAMES.iter().for_each(|(old, new)| tags::rename(&mut owner, old, new));
    if let Some(Tag::Compound(properties)) = owner.remove("Properties") {
        let each = properties.into_iter().flat_map(|(name, values)| {
            let values = if let Tag::List(values) = values { values } else { Vec::new() };
            values.into_iter().filter_map(move |value| property(&name, value))
        });
        put(&mut owner, "properties", Tag::List(each.collect()));
    }
    Some(Tag::Compound(owner))
}

fn property(name: &str, value: Tag) -> Option<Tag> {
    let Tag::Compound(mut value) = value else { return None };
    PROPERTY.iter().for_each(|(old, new)| tags::rename(&mut value, old, new));
    put(&mut value, "name", text(name));
    Some(Tag::Compound(value))
}

/// The owner of a profile.
pub fn lowered(profile: &Tag) -> Option<Tag> {
    let mut profile = match profile {
        Tag::String(name) => return Some(compound([("Name", text(name))])),
        Tag::Compound(profile) => profile.clone(),
        _ => return None,
    };
    NAMES.iter().for_each(|(old, new)| tags::rename(&mut profile, new, old));
    if let Some(Tag::List(entries)) = profile.remove("properties") {
        put(&mut profile, "Properties", Tag::Compound(by_name(entries)));
    }
    Some(Tag::Compound(profile))
}

fn by_name(entries: Vec<Tag>) -> Compound {
    let mut properties = Compound::new();
    for entry in entries {
        let Tag::Compound(mut entry) = entry else { continue };
        let Some(Tag::String(name)) = entry.remove("name") else { continue };
        PROPERTY.iter().for_each(|(old, new)| tags::rename(&mut entry, new, old));
        if !properties.contains_key(name.as_str()) {
            put(&mut properties, &name, Tag::List(Vec::new()));
        }
        if let Some(values) = tags::list(&mut properties, &name) {
            values.push(Tag::Compound(entry));
        }
    }
    properties
}
