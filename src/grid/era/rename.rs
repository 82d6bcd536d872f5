//! What only got another name.

use super::Way;
use super::tags::{self, compounds};
use crate::block::Version;
use crate::nbt::Compound;

/// Since which version, of which kind, what before, what since then.
const RENAMED: [(&str, &str, &str, &str); 14] = [
    ("1.19", "painting", "Motive", "variant"),
    ("1.19", "painting", "Facing", "facing"),
    ("1.20.5", "beehive", "Bees", "bees"),
    ("1.20.5", "skull", "SkullOwner", "profile"),
    ("1.20.5", "banner", "Patterns", "patterns"),
    ("1.21.4", "furnace", "BurnTime", "lit_time_remaining"),
    ("1.21.4", "furnace", "CookTime", "cooking_time_spent"),
    ("1.21.4", "furnace", "CookTimeTotal", "cooking_total_time"),
    ("1.21.4", "smoker", "BurnTime", "lit_time_remaining"),
    ("1.21.4", "smoker", "CookTime", "cooking_time_spent"),
    ("1.21.4", "smoker", "CookTimeTotal", "cooking_total_time"),
    ("1.21.4", "blast_furnace", "BurnTime", "lit_time_remaining"),
    ("1.21.4", "blast_furnace", "CookTime", "cooking_time_spent"),
    ("1.21.4", "blast_furnace", "CookTimeTotal", "cooking_total_time"),
];

/// The same for each of the bees in a hive.
const BEES: [(&str, &str); 3] = [
    ("EntityData", "entity_data"),
    ("TicksInHive", "ticks_in_hive"),
    ("MinOccupationTicks", "min_ticks_in_hive"),
];

/// Renames what got another name in `at`.
pub fn change(data: &mut Compound, at: Version, way: Way) {
    let kind = tags::kind(data).to_owned();
    for (_, _, old, new) in RENAMED.iter().filter(|(since, of, ..)| (*since, *of) == (at.name(), &kind)) {
        let (from, to) = direction(way, old, new);
        tags::rename(data, from, to);
    }
    if (at.name(), kind.as_str()) == ("1.20.5", "beehive") {
        bees(data, way);
    }
}

fn bees(hive: &mut Compound, way: Way) {
    let list = direction(way, "Bees", "bees").1;
    for bee in compounds(hive, list) {
        for (old, new) in BEES {
            let (from, to) = direction(way, old, new);
            tags::rename(bee, from, to);
        }
    }
}

fn direction<'a>(way: Way, old: &'a str, new: &'a str) -> (&'a str, &'a str) {
    match way {
        Way::Up => (old, new),
        Way::Down => (new, old),
    }
}
