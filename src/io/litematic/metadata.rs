//! What a file says of itself. Times are carried, never taken from a clock.

use super::{LitematicVersion, XYZ};
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::io::ReadError;
use crate::io::fields::Fields;
use crate::nbt::{Compound, Tag};
use crate::space::Cell;

/// At the root, beside what only Litematica knows.
const ROOT_TAGS: [&str; 5] = ["MinecraftDataVersion", "Version", "SubVersion", "Metadata", "Regions"];

/// Follow from the regions.
const COUNTED: [&str; 4] = ["EnclosingSize", "RegionCount", "TotalBlocks", "TotalVolume"];

/// Readers want them, so they are written where there is nothing to say.
const TEXTS: [&str; 3] = ["Name", "Author", "Description"];

/// Everything but what the regions tell.
pub(super) fn read(root: &Fields) -> Result<Metadata, ReadError> {
    let mut tags = root.find::<&Compound>("Metadata")?.cloned().unwrap_or_default();
    tags.retain(|name, tag| {
        let is_empty = TEXTS.contains(&name.as_str()) && *tag == Tag::String(String::new());
        !is_empty && !COUNTED.contains(&name.as_str())
    });
    date(&mut tags);
    let own = root.tags.iter().filter(|(name, _)| !ROOT_TAGS.contains(&name.as_str()));
    let own: Compound = own.map(|(name, tag)| (name.clone(), tag.clone())).collect();
    Ok(Metadata {
        // The first versions for Minecraft 1.13 wrote none.
        data_version: root.find("MinecraftDataVersion")?.filter(|&version: &i32| version > 0),
        tags,
        own: (!own.is_empty()).then_some(Own { dialect: Dialect::Litematica, tags: own }),
        ..Metadata::default()
    })
}

/// `TimeCreated` becomes `Date`; 0 stands for no time, and nothing is modified at the time of its creation.
fn date(tags: &mut Compound) {
    let created = tags.get("TimeCreated").cloned();
    if let Some(created @ Tag::Long(time)) = created {
        tags.remove("TimeCreated");
        if tags.get("TimeModified") == Some(&created) {
            tags.remove("TimeModified");
        }
        if time != 0 {
            tags.insert("Date".to_owned(), created);
        }
    }
}

/// What follows from the regions that are written.
#[derive(Default)]
pub(super) struct Totals {
    pub size: Cell,
    pub regions: usize,
    pub blocks: usize,
    pub volume: usize,
}

pub(super) fn write(grid: &Grid, totals: &Totals) -> Compound {
    let mut tags = grid.metadata.tags.clone();
    for name in TEXTS {
        tags.insert_missing(name, || Tag::String(String::new()));
    }
    let created = match tags.remove("Date") {
        Some(date @ Tag::Long(_)) => date,
        other => {
            tags.extend(other.map(|date| ("Date".to_owned(), date)));
            Tag::Long(0)
        }
    };
    tags.insert_missing("TimeModified", || created.clone());
    tags.insert("TimeCreated".to_owned(), created);
    let count = |count: usize| Tag::Int(count.try_into().unwrap_or(i32::MAX));
    tags.extend(COUNTED.map(str::to_owned).into_iter().zip([
        xyz(totals.size),
        count(totals.regions),
        count(totals.blocks),
        count(totals.volume),
    ]));
    tags
}

/// The root around what is written of the regions.
pub(super) fn root(grid: &Grid, version: LitematicVersion) -> Compound {
    let version = match version {
        LitematicVersion::V6 => 6,
        LitematicVersion::V7 => 7,
    };
    let own = grid.metadata.own.as_ref().filter(|own| own.dialect == Dialect::Litematica);
    let mut root = own.map(|own| own.tags.clone()).unwrap_or_default();
    let numbers = [("Version", version), ("SubVersion", 1), ("MinecraftDataVersion", grid.data_version())];
    root.extend(numbers.map(|(name, n)| (name.to_owned(), Tag::Int(n))));
    root
}

pub(super) fn xyz(cell: Cell) -> Tag {
    let numbers = XYZ.into_iter().zip(cell.to_array());
    Tag::Compound(numbers.map(|(axis, n)| (axis.to_owned(), Tag::Int(n))).collect())
}
