//! Texts in block entities, which are JSON since Minecraft 1.13.

use crate::nbt::{Compound, Tag};

/// Makes the plain text `name` a JSON one.
pub(super) fn make_json(data: &mut Compound, name: &str) {
    if let Some(Tag::String(text)) = data.get_mut(name) {
        *text = quoted(text);
    }
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

const LINES: [&str; 4] = ["Text1", "Text2", "Text3", "Text4"];

/// Brings the lines of a sign to its front, where Minecraft 1.20 keeps them.
pub(super) fn sign(data: &mut Compound) {
    let lines = LINES.map(|name| line(data.remove(name)));
    data.insert("front_text".to_owned(), side(lines));
    data.insert("back_text".to_owned(), side(LINES.map(|_| quoted(""))));
    data.insert("is_waxed".to_owned(), Tag::Byte(0));
}

/// A line is JSON since Minecraft 1.8, and plain before.
fn line(tag: Option<Tag>) -> String {
    match tag {
        Some(Tag::String(text)) if text == "null" => quoted(""),
        Some(Tag::String(text)) if is_json_text(&text) => text,
        Some(Tag::String(text)) => quoted(&text),
        _ => quoted(""),
    }
}

fn is_json_text(text: &str) -> bool {
    text.starts_with(['{', '[', '"']) && serde_json::from_str::<serde_json::Value>(text).is_ok()
}

fn side(lines: [String; 4]) -> Tag {
    let tags = [
        ("messages", Tag::List(lines.map(Tag::String).to_vec())),
        ("color", Tag::String("black".to_owned())),
        ("has_glowing_text", Tag::Byte(0)),
    ];
    Tag::Compound(tags.map(|(name, tag)| (name.to_owned(), tag)).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_json() {
        for (old, new) in [
            (Some("{\"text\":\"Inn\"}"), "{\"text\":\"Inn\"}"),
            (Some("\"Inn\""), "\"Inn\""),
            (Some("The \"Inn\""), "\"The \\\"Inn\\\"\""),
            (Some("[Private]"), "\"[Private]\""),
            (Some("null"), "\"\""),
            (Some(""), "\"\""),
            (None, "\"\""),
        ] {
            assert_eq!(line(old.map(|text| Tag::String(text.to_owned()))), new, "{old:?}");
        }
    }
}
