//! Items: `Count` and `tag` before Minecraft 1.20.5, `count` and `components` since.

use super::tags::{self, compound, put, text};
use super::{Kept, Way, profile, stored};
use crate::nbt::{Compound, Tag};

/// How a tag and a component say the same.
#[derive(Clone, Copy)]
struct Form {
    raise: fn(&Tag) -> Option<Tag>,
    lower: fn(&Tag) -> Option<Tag>,
}

const SAME: Form = Form { raise: |tag| Some(tag.clone()), lower: |tag| Some(tag.clone()) };
const FLAG: Form = Form { raise: flag, lower: |_| Some(Tag::Byte(1)) };
const POTION: Form =
    Form { raise: |tag| Some(compound([("potion", tag.clone())])), lower: |tag| only(tag, "potion") };
const COLOR: Form =
    Form { raise: |tag| Some(compound([("rgb", tag.clone())])), lower: |tag| only(tag, "rgb") };
const LEVELS: Form = Form { raise: levels, lower: enchantments };
const OWNER: Form = Form { raise: profile::raised, lower: profile::lowered };
const SLOTS: Form = Form { raise: slots, lower: items };
const PAGES: Form = Form { raise: |tag| Some(compound([("pages", pages(tag)?)])), lower: raw_pages };

/// Where in `tag`, which component, in what form.
const TAGS: [(&[&str], &str, Form); 12] = [
    (&["Damage"], "damage", SAME),
    (&["RepairCost"], "repair_cost", SAME),
    (&["CustomModelData"], "custom_model_data", SAME),
    (&["Unbreakable"], "unbreakable", FLAG),
    (&["Potion"], "potion_contents", POTION),
    (&["Enchantments"], "enchantments", LEVELS),
    (&["StoredEnchantments"], "stored_enchantments", LEVELS),
    (&["SkullOwner"], "profile", OWNER),
    (&["display", "Name"], "custom_name", SAME),
    (&["display", "Lore"], "lore", SAME),
    (&["display", "color"], "dyed_color", COLOR),
    (&["BlockEntityTag", "Items"], "container", SLOTS),
];

/// Written books keep their pages beside title and author, and have a way of their own.
const WRITABLE: (&[&str], &str, Form) = (&["pages"], "writable_book_content", PAGES);

pub fn change(data: &mut Compound, way: Way, kept: &mut Kept) {
    stored::each(data, &mut |item| match way {
        Way::Up => raise(item, kept),
        Way::Down => lower(item, kept),
    });
}

fn raise(item: &mut Compound, kept: &mut Kept) {
    if let Some(count) = item.remove("Count") {
        put(item, "count", Tag::Int(tags::int(&count).unwrap_or(1)));
    }
    let Some(Tag::Compound(mut tag)) = item.remove("tag") else { return };
    let mut components = Compound::new();
    for (path, name, form) in rules(item) {
        let Some(new) = found(&tag, path).and_then(form.raise) else { continue };
        put(&mut components, &format!("minecraft:{name}"), new);
        remove(&mut tag, path);
    }
    if tags::kind(item) == "written_book" {
        raise_book(&mut tag, &mut components);
    }
    // The game keeps what it does not know in the same place.
    if !tag.is_empty() {
        tag.keys().for_each(|name| kept.add(format!("item tag `{name}`")));
        put(&mut components, "minecraft:custom_data", Tag::Compound(tag));
    }
    if !components.is_empty() {
        put(item, "components", Tag::Compound(components));
    }
}

fn lower(item: &mut Compound, kept: &mut Kept) {
    let count = item.remove("count").and_then(|count| tags::int(&count)).unwrap_or(1);
    put(item, "Count", Tag::Byte(i8::try_from(count).unwrap_or(i8::MAX)));
    let Some(Tag::Compound(mut components)) = item.remove("components") else { return };
    let mut tag = match components.remove("minecraft:custom_data") {
        Some(Tag::Compound(custom)) => custom,
        _ => Compound::new(),
    };
    for (path, name, form) in rules(item) {
        let name = format!("minecraft:{name}");
        let Some(old) = components.get(name.as_str()).and_then(form.lower) else { continue };
        components.remove(name.as_str());
        insert(&mut tag, path, old);
    }
    if tags::kind(item) == "written_book" {
        lower_book(&mut tag, &mut components);
    }
    if !tag.is_empty() {
        put(item, "tag", Tag::Compound(tag));
    }
    if !components.is_empty() {
        components.keys().for_each(|name| kept.add(format!("item component `{name}`")));
        put(item, "components", Tag::Compound(components));
    }
}

/// The rules for an item.
fn rules(item: &Compound) -> impl Iterator<Item = (&'static [&'static str], &'static str, Form)> + use<> {
    let is_writable = tags::kind(item) == "writable_book";
    TAGS.into_iter().chain(is_writable.then_some(WRITABLE))
}

fn found<'a>(tag: &'a Compound, path: &[&str]) -> Option<&'a Tag> {
    match path {
        [name] => tag.get(name),
        [name, rest @ ..] => match tag.get(name)? {
            Tag::Compound(inner) => found(inner, rest),
            _ => None,
        },
        [] => None,
    }
}

/// Removes what is at `path`, and the compounds on the way that hold nothing more. An id says nothing more: the item
/// says what block it is.
fn remove(tag: &mut Compound, path: &[&str]) {
    match path {
        [name] => drop(tag.remove(name)),
        [name, rest @ ..] => {
            if let Some(inner) = tags::inner(tag, name) {
                remove(inner, rest);
                if inner.keys().all(|name| name == "id") {
                    tag.remove(name);
                }
            }
        }
        [] => {}
    }
}

fn insert(tag: &mut Compound, path: &[&str], new: Tag) {
    match path {
        [name] => put(tag, name, new),
        [name, rest @ ..] => {
            if tags::inner(tag, name).is_none() {
                put(tag, name, Tag::Compound(Compound::new()));
            }
            tags::inner(tag, name).into_iter().for_each(|inner| insert(inner, rest, new.clone()));
        }
        [] => {}
    }
}

fn flag(tag: &Tag) -> Option<Tag> {
    tags::int(tag).filter(|number| *number != 0).map(|_| Tag::Compound(Compound::new()))
}

/// What a compound holds under `name`, if that is all that it holds.
fn only(tag: &Tag, name: &str) -> Option<Tag> {
    match tag {
        Tag::Compound(inner) if inner.len() == 1 => inner.get(name).cloned(),
        _ => None,
    }
}

fn levels(tag: &Tag) -> Option<Tag> {
    let Tag::List(entries) = tag else { return None };
    let mut levels = Compound::new();
    for entry in entries {
        let Tag::Compound(entry) = entry else { return None };
        let Some(Tag::String(id)) = entry.get("id") else { return None };
        let id = if id.contains(':') { id.clone() } else { format!("minecraft:{id}") };
        put(&mut levels, &id, Tag::Int(tags::int(entry.get("lvl")?)?));
    }
    Some(compound([("levels", Tag::Compound(levels))]))
}

fn enchantments(tag: &Tag) -> Option<Tag> {
    let Tag::Compound(levels) = only(tag, "levels")? else { return None };
    let each = levels.iter().map(|(id, level)| {
        let level = i16::try_from(tags::int(level)?).ok()?;
        Some(compound([("id", text(id)), ("lvl", Tag::Short(level))]))
    });
    each.collect::<Option<Vec<Tag>>>().map(Tag::List)
}

/// Items with their slots beside them, as containers hold them since.
fn slots(tag: &Tag) -> Option<Tag> {
    let Tag::List(items) = tag else { return None };
    let each = items.iter().map(|item| {
        let Tag::Compound(mut item) = item.clone() else { return None };
        let slot = tags::int(&item.remove("Slot")?)?;
        Some(compound([("slot", Tag::Int(slot)), ("item", Tag::Compound(item))]))
    });
    each.collect::<Option<Vec<Tag>>>().map(Tag::List)
}

fn items(tag: &Tag) -> Option<Tag> {
    let Tag::List(slots) = tag else { return None };
    let each = slots.iter().map(|slot| {
        let Tag::Compound(slot) = slot else { return None };
        let Some(Tag::Compound(item)) = slot.get("item") else { return None };
        let mut item = item.clone();
        put(&mut item, "Slot", Tag::Byte(i8::try_from(tags::int(slot.get("slot")?)?).ok()?));
        Some(Tag::Compound(item))
    });
    each.collect::<Option<Vec<Tag>>>().map(Tag::List)
}

/// Texts that may have a filtered form beside them.
fn pages(tag: &Tag) -> Option<Tag> {
    let Tag::List(pages) = tag else { return None };
    Some(Tag::List(pages.iter().map(|page| compound([("raw", page.clone())])).collect()))
}

fn raw_pages(tag: &Tag) -> Option<Tag> {
    let Tag::List(pages) = only(tag, "pages")? else { return None };
    pages.iter().map(raw).collect::<Option<Vec<Tag>>>().map(Tag::List)
}

/// A text that has no filtered form.
fn raw(page: &Tag) -> Option<Tag> {
    match page {
        Tag::String(_) => Some(page.clone()),
        page => only(page, "raw"),
    }
}

const BOOK: &str = "minecraft:written_book_content";

fn raise_book(tag: &mut Compound, components: &mut Compound) {
    let (Some(pages), Some(author)) = (tag.get("pages").and_then(pages), tag.remove("author")) else {
        return;
    };
    let mut book = Compound::new();
    put(&mut book, "pages", pages);
    put(&mut book, "author", author);
    put(&mut book, "title", compound([("raw", tag.remove("title").unwrap_or_else(|| text("")))]));
    for name in ["generation", "resolved"] {
        tag.remove(name).into_iter().for_each(|old| put(&mut book, name, old));
    }
    tag.remove("pages");
    put(components, BOOK, Tag::Compound(book));
}

fn lower_book(tag: &mut Compound, components: &mut Compound) {
    let Some(book) = tags::inner(components, BOOK) else { return };
    let pages = match book.get("pages") {
        Some(Tag::List(pages)) => pages.iter().map(raw).collect::<Option<Vec<Tag>>>(),
        _ => None,
    };
    let (Some(pages), Some(title)) = (pages, book.get("title").and_then(raw)) else { return };
    put(tag, "pages", Tag::List(pages));
    put(tag, "title", title);
    for name in ["author", "generation", "resolved"] {
        book.remove(name).into_iter().for_each(|new| put(tag, name, new));
    }
    components.remove(BOOK);
}

/// Since Minecraft 1.21.4 models are chosen by several numbers, of which the first is the old one.
pub fn change_model(data: &mut Compound, way: Way, kept: &mut Kept) {
    const MODEL: &str = "minecraft:custom_model_data";
    stored::each(data, &mut |item| {
        let Some(components) = tags::inner(item, "components") else { return };
        let Some(old) = components.get(MODEL) else { return };
        let new = match way {
            Way::Up => tags::int(old)
                .map(|number| compound([("floats", Tag::List(vec![Tag::Float(number as f32)]))])),
            Way::Down => whole(old),
        };
        match new {
            Some(new) => put(components, MODEL, new),
            None => kept.add(format!("item component `{MODEL}`")),
        }
    });
}

fn whole(model: &Tag) -> Option<Tag> {
    match only(model, "floats")? {
        Tag::List(floats) => match floats.as_slice() {
            [Tag::Float(number)] if number.fract() == 0.0 => Some(Tag::Int(*number as i32)),
            _ => None,
        },
        _ => None,
    }
}
