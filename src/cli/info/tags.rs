//! Tags of files as text and as JSON.

use crate::nbt::{Compound, Tag};
use serde_json::{Value, json};

/// A tag in a few words.
pub(super) fn short(name: &str, tag: &Tag) -> String {
    match tag {
        Tag::Long(moment) if name == "Date" => date(*moment),
        Tag::Byte(n) => n.to_string(),
        Tag::Short(n) => n.to_string(),
        Tag::Int(n) => n.to_string(),
        Tag::Long(n) => n.to_string(),
        Tag::Float(n) => n.to_string(),
        Tag::Double(n) => n.to_string(),
        Tag::String(text) => text.escape_debug().to_string(),
        Tag::List(entries) => format!("a list of {}", entries.len()),
        Tag::Compound(tags) => tags.keys().cloned().collect::<Vec<_>>().join(", "),
        Tag::ByteArray(numbers) => format!("{} bytes", numbers.len()),
        Tag::IntArray(numbers) => format!("{} numbers", numbers.len()),
        Tag::LongArray(numbers) => format!("{} numbers", numbers.len()),
    }
}

pub(super) fn compound(tags: &Compound) -> Value {
    tags.iter().map(|(name, tag)| (name.clone(), value(tag))).collect()
}

fn value(tag: &Tag) -> Value {
    match tag {
        Tag::Byte(n) => json!(n),
        Tag::Short(n) => json!(n),
        Tag::Int(n) => json!(n),
        Tag::Long(n) => json!(n),
        Tag::Float(n) => json!(n),
        Tag::Double(n) => json!(n),
        Tag::String(text) => json!(text),
        Tag::ByteArray(numbers) => json!(numbers),
        Tag::IntArray(numbers) => json!(numbers),
        Tag::LongArray(numbers) => json!(numbers),
        Tag::List(entries) => entries.iter().map(value).collect(),
        Tag::Compound(tags) => compound(tags),
    }
}

/// The day of a moment in milliseconds since 1970, in the proleptic Gregorian calendar.
fn date(moment: i64) -> String {
    const DAY: i64 = 24 * 60 * 60 * 1000;
    // Years that begin in March end with the day that may be missing.
    let days = moment.div_euclid(DAY) + 719_468;
    let (era, day) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let (year, month) = if month < 10 { (year, month + 3) } else { (year + 1, month - 9) };
    format!("{:04}-{month:02}-{day:02}", year + 400 * era)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_those_of_the_calendar() {
        let cases = [
            (0, "1970-01-01"),
            (-1, "1969-12-31"),
            (951_782_400_000, "2000-02-29"),
            (1_700_000_000_000, "2023-11-14"),
        ];
        for (moment, expected) in cases {
            assert_eq!(date(moment), expected);
        }
        assert!(date(i64::MIN).starts_with('-') && !date(i64::MAX).is_empty());
    }
}
