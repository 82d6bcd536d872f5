//! The tags of a compound by name and type, with errors that give the path of the tag.

use super::ReadError;
use crate::nbt::{Compound, Tag};
use std::borrow::Cow;

/// A compound and where it stands in its file.
#[derive(Clone)]
pub(super) struct Fields<'a> {
    pub path: String,
    pub tags: &'a Compound,
}

/// As much of a name as a path holds: every entry of a list has a path of its own, so a long name would count as often.
fn shown(name: &str) -> Cow<'_, str> {
    const MOST: usize = 64;
    match name.char_indices().nth(MOST) {
        Some((at, _)) => Cow::Owned(format!("{}...", &name[..at])),
        None => Cow::Borrowed(name),
    }
}

/// A value that a tag can hold.
pub(super) trait FromTag<'a>: Sized {
    /// In the words of messages.
    const EXPECTED: &'static str;

    fn from_tag(tag: &'a Tag) -> Option<Self>;
}

impl<'a> Fields<'a> {
    pub fn new(path: impl Into<String>, tags: &'a Compound) -> Fields<'a> {
        Fields { path: path.into(), tags }
    }

    pub fn path(&self, name: &str) -> String {
        let name = shown(name);
        match self.path.is_empty() {
            true => name.into_owned(),
            false => format!("{}.{name}", self.path),
        }
    }

    /// `None` where the tag is absent.
    pub fn find<T: FromTag<'a>>(&self, name: &str) -> Result<Option<T>, ReadError> {
        let Some(tag) = self.tags.get(name) else { return Ok(None) };
        match T::from_tag(tag) {
            None => Err(wrong_type::<T>(self.path(name), tag)),
            found => Ok(found),
        }
    }

    pub fn get<T: FromTag<'a>>(&self, name: &str) -> Result<T, ReadError> {
        self.find(name)?.ok_or_else(|| ReadError::Missing { path: self.path(name), expected: T::EXPECTED })
    }

    /// The compound `name` within this one.
    pub fn inner(&self, name: &str) -> Result<Option<Fields<'a>>, ReadError> {
        let tags = self.find::<&Compound>(name)?;
        Ok(tags.map(|tags| Fields::new(self.path(name), tags)))
    }

    /// The compounds of the list `name`; none where it is absent.
    pub fn list(&self, name: &str) -> Result<Vec<Fields<'a>>, ReadError> {
        let entries = self.find::<&[Tag]>(name)?.unwrap_or_default();
        values(&self.path(name), entries)
            .map(|entry| entry.map(|(path, tags)| Fields::new(path, tags)))
            .collect()
    }
}

/// The values of a list at `path`, each with its own path.
pub(super) fn values<'a, T: FromTag<'a>>(
    path: &str,
    entries: &'a [Tag],
) -> impl Iterator<Item = Result<(String, T), ReadError>> {
    entries.iter().enumerate().map(move |(index, tag)| {
        let path = format!("{path}[{index}]");
        match T::from_tag(tag) {
            Some(value) => Ok((path, value)),
            None => Err(wrong_type::<T>(path, tag)),
        }
    })
}

pub(super) fn wrong_type<'a, T: FromTag<'a>>(path: String, tag: &Tag) -> ReadError {
    ReadError::WrongType { path, expected: T::EXPECTED, found: describe(tag) }
}

/// Numbers with their value, anything longer by its type and length.
fn describe(tag: &Tag) -> String {
    let kind = tag.kind();
    match tag {
        Tag::Byte(n) => format!("{kind} ({n})"),
        Tag::Short(n) => format!("{kind} ({n})"),
        Tag::Int(n) => format!("{kind} ({n})"),
        Tag::Long(n) => format!("{kind} ({n})"),
        Tag::Float(n) => format!("{kind} ({n})"),
        Tag::Double(n) => format!("{kind} ({n})"),
        Tag::List(entries) => format!("{kind} of {}", entries.len()),
        Tag::IntArray(numbers) => format!("{kind} of {}", numbers.len()),
        Tag::LongArray(numbers) => format!("{kind} of {}", numbers.len()),
        _ => kind.to_owned(),
    }
}

impl FromTag<'_> for i32 {
    const EXPECTED: &'static str = "an Int";

    fn from_tag(tag: &Tag) -> Option<i32> {
        match *tag {
            Tag::Byte(n) => Some(n.into()),
            Tag::Short(n) => Some(n.into()),
            Tag::Int(n) => Some(n),
            _ => None,
        }
    }
}

/// A width, height or length: a Short that counts as unsigned.
pub(super) struct Extent(pub u16);

impl FromTag<'_> for Extent {
    const EXPECTED: &'static str = "a Short (unsigned: 0 to 65,535)";

    fn from_tag(tag: &Tag) -> Option<Extent> {
        match *tag {
            Tag::Byte(n) => n.try_into().ok().map(Extent),
            Tag::Short(n) => Some(Extent(n.cast_unsigned())),
            Tag::Int(n) => n.try_into().ok().map(Extent),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a str {
    const EXPECTED: &'static str = "a String";

    fn from_tag(tag: &'a Tag) -> Option<&'a str> {
        match tag {
            Tag::String(text) => Some(text),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a [i8] {
    const EXPECTED: &'static str = "a Byte Array";

    fn from_tag(tag: &'a Tag) -> Option<&'a [i8]> {
        match tag {
            Tag::ByteArray(bytes) => Some(bytes),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a [i32] {
    const EXPECTED: &'static str = "an Int Array";

    fn from_tag(tag: &'a Tag) -> Option<&'a [i32]> {
        match tag {
            Tag::IntArray(numbers) => Some(numbers),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a [i64] {
    const EXPECTED: &'static str = "a Long Array";

    fn from_tag(tag: &'a Tag) -> Option<&'a [i64]> {
        match tag {
            Tag::LongArray(numbers) => Some(numbers),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a [Tag] {
    const EXPECTED: &'static str = "a List";

    fn from_tag(tag: &'a Tag) -> Option<&'a [Tag]> {
        match tag {
            Tag::List(entries) => Some(entries),
            _ => None,
        }
    }
}

impl<'a> FromTag<'a> for &'a Compound {
    const EXPECTED: &'static str = "a Compound";

    fn from_tag(tag: &'a Tag) -> Option<&'a Compound> {
        match tag {
            Tag::Compound(tags) => Some(tags),
            _ => None,
        }
    }
}

impl FromTag<'_> for [i32; 3] {
    const EXPECTED: &'static str = "an Int Array of 3";

    fn from_tag(tag: &Tag) -> Option<[i32; 3]> {
        match tag {
            Tag::IntArray(numbers) => numbers.as_slice().try_into().ok(),
            Tag::List(entries) => three(entries, |tag| i32::from_tag(tag)),
            _ => None,
        }
    }
}

impl FromTag<'_> for [f64; 3] {
    const EXPECTED: &'static str = "a List of 3 Doubles";

    fn from_tag(tag: &Tag) -> Option<[f64; 3]> {
        let number = |tag: &Tag| match *tag {
            Tag::Float(n) => Some(n.into()),
            Tag::Double(n) => Some(n),
            _ => i32::from_tag(tag).map(f64::from),
        };
        match tag {
            Tag::List(entries) => three(entries, number),
            _ => None,
        }
    }
}

fn three<T>(entries: &[Tag], number: impl Fn(&Tag) -> Option<T>) -> Option<[T; 3]> {
    let numbers = entries.iter().map(number).collect::<Option<Vec<T>>>()?;
    numbers.try_into().ok()
}
