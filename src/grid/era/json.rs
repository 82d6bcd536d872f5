//! Texts as the game keeps them: JSON in a string before Minecraft 1.21.5, tags since.

use super::tags::{compound, put, text};
use crate::nbt::{Compound, Tag};
use serde_json::{Map, Number, Value};

/// Properties of a text that are true or false.
const FLAGS: [&str; 6] = ["bold", "italic", "underlined", "strikethrough", "obfuscated", "interpret"];

/// By the kind of a click: what holds its value since 1.21.5.
const CLICKS: [(&str, &str); 4] = [
    ("open_url", "url"),
    ("run_command", "command"),
    ("suggest_command", "command"),
    ("change_page", "page"),
];

/// The tags of a text in JSON; `None` where it is none, or holds what is not known to mean the same.
pub fn parse(text: &str) -> Option<Tag> {
    serde_json::from_str::<Value>(text).ok().and_then(|value| tag(&value))
}

/// The text in JSON; `None` where it holds what is not known to mean the same.
pub fn print(text: &Tag) -> Option<String> {
    value("", text).map(|value| value.to_string())
}

fn tag(value: &Value) -> Option<Tag> {
    Some(match value {
        Value::Null => return None,
        Value::Bool(flag) => Tag::Byte(i8::from(*flag)),
        Value::Number(number) => numeral(number),
        Value::String(words) => text(words),
        Value::Array(entries) => Tag::List(alike(entries.iter().map(tag).collect::<Option<_>>()?)),
        Value::Object(fields) => {
            let mut tags = Compound::new();
            for (name, field) in fields {
                match name.as_str() {
                    "clickEvent" => put(&mut tags, "click_event", click(field)?),
                    "hoverEvent" => put(&mut tags, "hover_event", hover(field)?),
                    name => put(&mut tags, name, tag(field)?),
                }
            }
            Tag::Compound(tags)
        }
    })
}

fn numeral(number: &Number) -> Tag {
    match number.as_i64() {
        Some(whole) => i32::try_from(whole).map_or(Tag::Long(whole), Tag::Int),
        None => Tag::Double(number.as_f64().unwrap_or_default()),
    }
}

/// The entries of a list in one type, as lists of tags need them: words among others become texts of their own.
pub fn alike(entries: Vec<Tag>) -> Vec<Tag> {
    let mixed = entries.windows(2).any(|pair| pair[0].kind() != pair[1].kind());
    if !mixed {
        return entries;
    }
    let whole = |entry: Tag| match entry {
        Tag::Compound(_) => entry,
        Tag::List(parts) => {
            let parts = alike(parts);
            compound([("text", text("")), ("extra", Tag::List(parts))])
        }
        entry => compound([("text", entry)]),
    };
    entries.into_iter().map(whole).collect()
}

fn click(event: &Value) -> Option<Tag> {
    let (action, value) = (event.get("action")?.as_str()?, event.get("value")?);
    let field = CLICKS.iter().find(|(kind, _)| *kind == action).map_or("value", |(_, field)| field);
    let value = match (action, value) {
        ("change_page", Value::String(page)) => Tag::Int(page.parse().ok()?),
        (_, value) => tag(value)?,
    };
    Some(compound([("action", text(action)), (field, value)]))
}

/// Of what is shown over a text, only texts are the same by another name.
fn hover(event: &Value) -> Option<Tag> {
    let shown = event.get("contents").or(event.get("value"))?;
    let is_text = event.get("action")?.as_str()? == "show_text";
    is_text.then(|| Some(compound([("action", text("show_text")), ("value", tag(shown)?)])))?
}

fn value(name: &str, tag: &Tag) -> Option<Value> {
    Some(match tag {
        Tag::Byte(flag) if FLAGS.contains(&name) => Value::Bool(*flag != 0),
        Tag::Byte(n) => Value::from(*n),
        Tag::Short(n) => Value::from(*n),
        Tag::Int(n) => Value::from(*n),
        Tag::Long(n) => Value::from(*n),
        Tag::Float(n) => Value::from(*n),
        Tag::Double(n) => Value::from(*n),
        Tag::String(words) => Value::from(words.as_str()),
        Tag::List(entries) => entries.iter().map(|entry| value("", entry)).collect::<Option<Value>>()?,
        Tag::Compound(tags) => Value::Object(object(tags)?),
        Tag::ByteArray(_) | Tag::IntArray(_) | Tag::LongArray(_) => return None,
    })
}

fn object(tags: &Compound) -> Option<Map<String, Value>> {
    let mut fields = Map::new();
    for (name, tag) in tags.iter() {
        let (name, value) = match (name.as_ref() as &str, tag) {
            ("click_event", Tag::Compound(event)) => ("clickEvent", old_click(event)?),
            ("hover_event", Tag::Compound(event)) => ("hoverEvent", old_hover(event)?),
            (name, tag) => (name, value(name, tag)?),
        };
        fields.insert(name.to_owned(), value);
    }
    Some(fields)
}

fn old_click(event: &Compound) -> Option<Value> {
    let Some(Tag::String(action)) = event.get("action") else { return None };
    let field = CLICKS.iter().find(|(kind, _)| kind == action).map_or("value", |(_, field)| field);
    let value = match event.get(field)? {
        Tag::Int(page) => page.to_string(),
        Tag::String(words) => words.clone(),
        _ => return None,
    };
    Some(serde_json::json!({ "action": action, "value": value }))
}

fn old_hover(event: &Compound) -> Option<Value> {
    match (event.get("action"), event.get("value")) {
        (Some(Tag::String(action)), Some(shown)) if action == "show_text" => {
            Some(serde_json::json!({ "action": "show_text", "contents": value("", shown)? }))
        }
        _ => None,
    }
}
