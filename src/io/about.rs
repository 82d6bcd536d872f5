use super::Format;
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

/// What a file says of how it is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct About {
    pub format: Format,
    /// Of the format, where the file says one.
    pub version: Option<i32>,
    /// Where in its world the low corner lies, of what is a part of one.
    pub place: Option<Cell>,
}

impl About {
    pub(super) fn of_tags(format: Format, root: &Compound) -> About {
        let nested = match root.get("Schematic") {
            Some(Tag::Compound(body)) => body,
            _ => root,
        };
        let version = ["Version", "version"].into_iter().find_map(|name| match nested.get(name) {
            Some(Tag::Int(version)) => Some(*version),
            Some(Tag::Byte(version)) => Some((*version).into()),
            _ => None,
        });
        About { format, version, place: None }
    }
}
