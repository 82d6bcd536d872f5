//! Short words for what is done with tags all the time.

use crate::nbt::{Compound, Tag};

/// The id without the game's namespace; empty where there is none.
pub fn kind(data: &Compound) -> &str {
    match data.get("id") {
        Some(Tag::String(id)) => id.strip_prefix("minecraft:").unwrap_or(id),
        _ => "",
    }
}

pub fn put(data: &mut Compound, name: &str, tag: Tag) {
    data.insert(name.to_owned(), tag);
}

pub fn text(text: &str) -> Tag {
    Tag::String(text.to_owned())
}

/// A compound of these tags.
pub fn compound<const N: usize>(tags: [(&str, Tag); N]) -> Tag {
    Tag::Compound(tags.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect())
}

/// Moves what is called `old` to `new`.
pub fn rename(data: &mut Compound, old: &str, new: &str) {
    if let Some(tag) = data.remove(old) {
        put(data, new, tag);
    }
}

/// The compound of that name.
pub fn inner<'a>(data: &'a mut Compound, name: &str) -> Option<&'a mut Compound> {
    match data.get_mut(name) {
        Some(Tag::Compound(inner)) => Some(inner),
        _ => None,
    }
}

/// The list of that name.
pub fn list<'a>(data: &'a mut Compound, name: &str) -> Option<&'a mut Vec<Tag>> {
    match data.get_mut(name) {
        Some(Tag::List(list)) => Some(list),
        _ => None,
    }
}

/// The compounds among the entries of the list of that name.
pub fn compounds<'a>(data: &'a mut Compound, name: &str) -> impl Iterator<Item = &'a mut Compound> {
    let entries = list(data, name).into_iter().flatten();
    entries.filter_map(|entry| if let Tag::Compound(inner) = entry { Some(inner) } else { None })
}

/// A whole number of any width.
pub fn int(tag: &Tag) -> Option<i32> {
    match *tag {
        Tag::Byte(n) => Some(n.into()),
        Tag::Short(n) => Some(n.into()),
        Tag::Int(n) => Some(n),
        _ => None,
    }
}

/// Replaces the tag of that name by what `change` makes of it, where it makes something.
pub fn change(data: &mut Compound, name: &str, change: impl FnOnce(&Tag) -> Option<Tag>) {
    if let Some(tag) = data.get_mut(name)
        && let Some(new) = change(tag)
    {
        *tag = new;
    }
}
