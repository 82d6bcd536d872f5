use super::*;

fn version(name: &str) -> Version {
    Version::named(name).unwrap()
}

/// Tags from JSON, where numbers are Ints, `"3b"` is a Byte, `"3s"` a Short and `"3f"` a Float.
fn tag(value: &serde_json::Value) -> Tag {
    use serde_json::Value;
    match value {
        Value::Number(n) => Tag::Int(n.as_i64().unwrap() as i32),
        Value::String(text) => number(text).unwrap_or_else(|| Tag::String(text.clone())),
        Value::Array(entries) => Tag::List(entries.iter().map(tag).collect()),
        Value::Object(fields) => {
            Tag::Compound(fields.iter().map(|(name, field)| (name.clone(), tag(field))).collect())
        }
        other => panic!("{other}"),
    }
}

fn number(text: &str) -> Option<Tag> {
    let (digits, last) = text.split_at_checked(text.len().checked_sub(1)?)?;
    match last {
        "b" => digits.parse().ok().map(Tag::Byte),
        "s" => digits.parse().ok().map(Tag::Short),
        "f" => digits.parse().ok().map(Tag::Float),
        _ => None,
    }
}

fn data(text: &str) -> Compound {
    match tag(&serde_json::from_str(text).unwrap()) {
        Tag::Compound(data) => data,
        other => panic!("{other:?}"),
    }
}

fn moved(text: &str, from: &str, to: &str) -> (Compound, String) {
    let (mut data, mut kept) = (data(text), Kept::default());
    translate(&mut data, version(from), version(to), &mut kept);
    (data, kept.to_string())
}

/// Old and new form of the same, told by a line with both versions before. Nothing is lost either way.
#[test]
fn what_is_known_is_translated_both_ways() {
    let mut cases = 0;
    for case in include_str!("cases.txt").split("\n\n").filter(|case| !case.starts_with('#')) {
        let [versions, old, new] = case.trim().lines().collect::<Vec<_>>()[..] else { panic!("{case}") };
        let (from, to) = versions.split_once(' ').unwrap();
        let nothing = String::new();
        assert_eq!(moved(old, from, to), (data(new), nothing.clone()), "up: {old}");
        assert_eq!(moved(new, to, from), (data(old), nothing), "down: {new}");
        cases += 1;
    }
    assert!(cases > 9, "{cases}");
}

#[test]
fn what_is_not_known_stays_and_is_told() {
    let cases = [
        (
            "1.20.5",
            "1.20.1",
            r#"{"id":"minecraft:chest","Items":[{"id":"a:b","count":1,"components":{"minecraft:food":3}}]}"#,
            "1 item component `minecraft:food`",
        ),
        (
            "1.20.1",
            "1.20.5",
            r#"{"id":"minecraft:chest","Items":[{"id":"a:b","Count":"1b","tag":{"HideFlags":3}}]}"#,
            "1 item tag `HideFlags`",
        ),
        (
            "1.20.1",
            "1.20.5",
            r#"{"id":"minecraft:banner","Patterns":[{"Pattern":"mod","Color":3}]}"#,
            "1 banner pattern",
        ),
        (
            "1.20.1",
            "1.19.4",
            r#"{"id":"minecraft:sign","back_text":{"messages":["\"Hi\""]},"is_waxed":"1b"}"#,
            "1 wax on a sign, 1 written back of a sign",
        ),
        ("1.21.4", "1.21.5", r#"{"id":"minecraft:chest","CustomName":"{nonsense"}"#, "1 text"),
        ("1.20.1", "1.21.5", r#"{"id":"minecraft:cow"}"#, "1 cow"),
        ("1.21.5", "1.21.5", r#"{"id":"minecraft:cow"}"#, ""),
    ];
    for (from, to, text, told) in cases {
        let (found, kept) = moved(text, from, to);
        assert_eq!(kept, told, "{text}");
        assert!(found.contains_key("id"));
    }
}

#[test]
fn what_is_left_over_goes_where_the_game_keeps_it() {
    let old = r#"{"id":"minecraft:chest","Items":[{"id":"a:b","Count":"1b","tag":{"Damage":2,"mine":3}}]}"#;
    let new = r#"{"id":"minecraft:chest","Items":[{"id":"a:b","count":1,
        "components":{"minecraft:damage":2,"minecraft:custom_data":{"mine":3}}}]}"#;
    assert_eq!(moved(old, "1.20.1", "1.20.5").0, data(new));
    assert_eq!(moved(new, "1.20.5", "1.20.1").0, data(old));
}
