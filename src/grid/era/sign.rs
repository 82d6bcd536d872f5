//! Signs have two sides since Minecraft 1.20.

use super::tags::{self, compound, put, text};
use super::{Kept, Way};
use crate::nbt::{Compound, Tag};

const LINES: [&str; 4] = ["Text1", "Text2", "Text3", "Text4"];
const FILTERED: [&str; 4] = ["FilteredText1", "FilteredText2", "FilteredText3", "FilteredText4"];

/// An empty line.
const EMPTY: &str = "\"\"";

pub fn change(data: &mut Compound, way: Way, kept: &mut Kept) {
    match (tags::kind(data), way) {
        ("sign" | "hanging_sign", Way::Up) => raise(data),
        ("sign" | "hanging_sign", Way::Down) => lower(data, kept),
        _ => {}
    }
}

fn raise(data: &mut Compound) {
    if data.contains_key("front_text") {
        return;
    }
    let color = data.remove("Color").unwrap_or_else(|| text("black"));
    let glows = data.remove("GlowingText").unwrap_or(Tag::Byte(0));
    let mut front = vec![("messages", lines(data, LINES)), ("color", color), ("has_glowing_text", glows)];
    if FILTERED.iter().any(|name| data.contains_key(name)) {
        front.push(("filtered_messages", lines(data, FILTERED)));
    }
    let front = front.into_iter().map(|(name, tag)| (name.to_owned(), tag)).collect();
    put(data, "front_text", Tag::Compound(front));
    let back = [
        ("messages", Tag::List(LINES.map(|_| text(EMPTY)).to_vec())),
        ("color", text("black")),
        ("has_glowing_text", Tag::Byte(0)),
    ];
    put(data, "back_text", compound(back));
    put(data, "is_waxed", Tag::Byte(0));
}

/// Takes the lines of these names.
fn lines(data: &mut Compound, names: [&str; 4]) -> Tag {
    Tag::List(names.map(|name| data.remove(name).unwrap_or_else(|| text(EMPTY))).to_vec())
}

/// The back has no place: where something is written there it stays, and is told.
fn lower(data: &mut Compound, kept: &mut Kept) {
    if let Some(Tag::Compound(mut front)) = data.remove("front_text") {
        for (list, names) in [("messages", LINES), ("filtered_messages", FILTERED)] {
            if let Some(Tag::List(lines)) = front.remove(list) {
                lines.into_iter().zip(names).for_each(|(line, name)| put(data, name, line));
            }
        }
        for (new, old) in [("color", "Color"), ("has_glowing_text", "GlowingText")] {
            if let Some(tag) = front.remove(new) {
                put(data, old, tag);
            }
        }
    }
    match tags::inner(data, "back_text").is_some_and(is_written) {
        true => kept.add("written back of a sign"),
        false => drop(data.remove("back_text")),
    }
    if data.remove("is_waxed").is_some_and(|waxed| waxed != Tag::Byte(0)) {
        kept.add("wax on a sign");
    }
}

fn is_written(side: &mut Compound) -> bool {
    let is_empty = |line: &Tag| matches!(line, Tag::String(text) if ["", EMPTY, "{\"text\":\"\"}"].contains(&text.as_str()));
    tags::list(side, "messages").is_some_and(|lines| !lines.iter().all(is_empty))
}
