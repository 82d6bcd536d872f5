//! Texts in block entities: JSON since Minecraft 1.13, plain before and in Bedrock Edition. Signs have two sides since
//! Minecraft 1.20.

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

/// A line of a sign, which is JSON in files since Minecraft 1.8, and plain before.
pub(super) fn line(text: &str) -> String {
    match text {
        "null" => quoted(""),
        text if is_json_text(text) => text.to_owned(),
        text => quoted(text),
    }
}

fn is_json_text(text: &str) -> bool {
    text.starts_with(['{', '[', '"']) && serde_json::from_str::<serde_json::Value>(text).is_ok()
}

/// The lines of a plain text; a sign has four.
pub(super) fn plain_lines(text: &str) -> [String; 4] {
    let mut lines = text.lines();
    [(); 4].map(|()| quoted(lines.next().unwrap_or_default()))
}

/// One side of a sign.
pub(super) struct Side {
    /// Each in JSON.
    pub lines: [String; 4],
    /// The dye of the text.
    pub color: &'static str,
    pub glows: bool,
}

impl Default for Side {
    fn default() -> Side {
        Side::plain(plain_lines(""))
    }
}

impl Side {
    fn plain(lines: [String; 4]) -> Side {
        Side { lines, color: "black", glows: false }
    }
}

/// Writes a sign of the given lines, each in JSON.
pub(super) fn set_sign(data: &mut Compound, front: [String; 4], back: [String; 4]) {
    set_sides(data, Side::plain(front), Side::plain(back));
    data.insert("is_waxed".to_owned(), Tag::Byte(0));
}

/// Writes what stands on both sides of a sign.
pub(super) fn set_sides(data: &mut Compound, front: Side, back: Side) {
    data.insert("front_text".to_owned(), side(front));
    data.insert("back_text".to_owned(), side(back));
}

fn side(side: Side) -> Tag {
    let tags = [
        ("messages", Tag::List(side.lines.map(Tag::String).to_vec())),
        ("color", Tag::String(side.color.to_owned())),
        ("has_glowing_text", Tag::Byte(i8::from(side.glows))),
    ];
    Tag::Compound(tags.map(|(name, tag)| (name.to_owned(), tag)).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_json() {
        for (old, new) in [
            ("{\"text\":\"Inn\"}", "{\"text\":\"Inn\"}"),
            ("\"Inn\"", "\"Inn\""),
            ("The \"Inn\"", "\"The \\\"Inn\\\"\""),
            ("[Private]", "\"[Private]\""),
            ("null", "\"\""),
            ("", "\"\""),
        ] {
            assert_eq!(line(old), new, "{old}");
        }
        assert_eq!(plain_lines("The\n\"Inn\""), ["\"The\"", "\"\\\"Inn\\\"\"", "\"\"", "\"\""]);
    }
}
