//! Data of block entities and entities from one version of the game to another: signs, texts, items, heads, banners and
//! what has only got another name. What is not known to mean the same stays as it is, and is told.

mod banner;
mod equipment;
mod item;
mod json;
mod profile;
mod rename;
mod sign;
mod stored;
mod tags;
mod text;

use crate::block::Version;
use crate::nbt::{Compound, Tag};
use std::collections::BTreeMap;
use std::fmt;

/// Which way data are translated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Way {
    Up,
    Down,
}

/// What keeps the form of its version: names and kinds, with how often each was found.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Kept(BTreeMap<String, usize>);

impl Kept {
    fn add(&mut self, what: impl Into<String>) {
        *self.0.entry(what.into()).or_insert(0) += 1;
    }

    pub fn is_none(&self) -> bool {
        self.0.is_empty()
    }
}

impl fmt::Display for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 8;
        let mut each: Vec<String> =
            self.0.iter().take(SHOWN).map(|(what, count)| format!("{count} {what}")).collect();
        each.extend((self.0.len() > SHOWN).then(|| format!("and {} more", self.0.len() - SHOWN)));
        f.write_str(&each.join(", "))
    }
}

/// What came with a version: how the data of one block entity or entity change.
type Change = fn(&mut Compound, Way, &mut Kept);

/// The oldest first. Renames have a table of their own, and come after the changes of their version.
const CHANGES: [(&str, Change); 7] = [
    ("1.20", sign::change),
    ("1.20.5", item::change),
    ("1.20.5", profile::change),
    ("1.20.5", banner::change),
    ("1.21.4", item::change_model),
    ("1.21.5", text::change),
    ("1.21.5", equipment::change),
];

/// Kinds that hold nothing but what is translated here, or that never changed.
const UNDERSTOOD: [&str; 33] = [
    "armor_stand",
    "banner",
    "barrel",
    "bed",
    "beehive",
    "bell",
    "blast_furnace",
    "brewing_stand",
    "campfire",
    "chest",
    "chiseled_bookshelf",
    "comparator",
    "conduit",
    "daylight_detector",
    "decorated_pot",
    "dispenser",
    "dropper",
    "enchanting_table",
    "end_portal",
    "ender_chest",
    "furnace",
    "glow_item_frame",
    "hanging_sign",
    "hopper",
    "item_frame",
    "jukebox",
    "lectern",
    "painting",
    "shulker_box",
    "sign",
    "skull",
    "smoker",
    "trapped_chest",
];

/// Brings the data of a block entity or entity, which are of `from`, to `to`.
pub(super) fn translate(data: &mut Compound, from: Version, to: Version, kept: &mut Kept) {
    if from == to {
        return;
    }
    let kind = tags::kind(data).to_owned();
    if !UNDERSTOOD.contains(&kind.as_str()) {
        kept.add(if kind.is_empty() { "without an id" } else { &kind });
    }
    let way = if from < to { Way::Up } else { Way::Down };
    let (low, high) = (from.min(to), from.max(to));
    let mut passed: Vec<Version> = Version::all().filter(|at| low < *at && *at <= high).collect();
    if way == Way::Down {
        passed.reverse();
    }
    passed.into_iter().for_each(|at| pass(data, at, way, kept));
}

/// Brings data over the border between `at` and the version before.
fn pass(data: &mut Compound, at: Version, way: Way, kept: &mut Kept) {
    let changes = CHANGES.iter().filter(|(since, _)| *since == at.name());
    changes.for_each(|(_, change)| each(data, &mut |one| change(one, way, kept)));
    each(data, &mut |one| rename::change(one, at, way));
}

/// An entity and those that ride on it.
fn each(data: &mut Compound, work: &mut impl FnMut(&mut Compound)) {
    work(data);
    let Some(Tag::List(riders)) = data.get_mut("Passengers") else { return };
    for rider in riders {
        if let Tag::Compound(rider) = rider {
            each(rider, work);
        }
    }
}

#[cfg(test)]
mod tests;
