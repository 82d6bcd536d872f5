//! What chunks hold beside blocks, entities and biomes. A grid is no chunk, so has no place for it.

use super::chunk::Chunk;
use crate::io::Warning;
use crate::io::fields::Fields;
use crate::nbt::Tag;
use crate::space::{Bounds, Cell};
use std::collections::BTreeSet;

/// Where the blocks, entities and biomes of a chunk are, and what says which chunk it is.
const READ: [&str; 15] = [
    "DataVersion",
    "Level",
    "xPos",
    "yPos",
    "zPos",
    "Position",
    "Status",
    "sections",
    "Sections",
    "block_entities",
    "TileEntities",
    "entities",
    "Entities",
    // Those of before 1.18 have a warning of their own.
    "Biomes",
    "V",
];

/// What the game makes anew: light and heights, and how far it has come with them. And its clocks.
const MADE_ANEW: [&str; 9] = [
    "Heightmaps",
    "HeightMap",
    "Lights",
    "isLightOn",
    "LightPopulated",
    "TerrainPopulated",
    "starlight.light_version",
    "LastUpdate",
    "InhabitedTime",
];

/// What blocks wait for, each with its place.
const TICKS: [&str; 4] = ["block_ticks", "fluid_ticks", "TileTicks", "LiquidTicks"];

/// What a section has that is read or made anew.
const OF_SECTIONS: [&str; 11] = [
    "Y",
    "block_states",
    "biomes",
    "Palette",
    "BlockStates",
    "Blocks",
    "Data",
    "Add",
    "BlockLight",
    "SkyLight",
    "starlight.blocklight_state",
];

/// What the chunks that were read have left behind.
#[derive(Default)]
pub(super) struct Leftovers {
    /// The paths of tags that hold something.
    tags: BTreeSet<String>,
    ticks: usize,
}

impl Leftovers {
    pub fn add(&mut self, chunk: &Chunk, part: Bounds) {
        for fields in chunk.compounds() {
            self.add_tags(fields, |name| {
                READ.contains(&name) || MADE_ANEW.contains(&name) || TICKS.contains(&name)
            });
            let ticks = TICKS.iter().filter_map(|name| fields.list(name).ok()).flatten();
            self.ticks += ticks.filter(|tick| place(tick).is_none_or(|place| part.contains(place))).count();
        }
    }

    pub fn add_section(&mut self, section: &Fields) {
        self.add_tags(section, |name| OF_SECTIONS.contains(&name) || name.starts_with("starlight."));
    }

    fn add_tags(&mut self, fields: &Fields, is_known: impl Fn(&str) -> bool) {
        let unknown = fields.tags.iter().filter(|(name, tag)| !is_known(name) && !is_empty(tag));
        self.tags.extend(unknown.map(|(name, _)| path(fields, name)));
    }

    pub fn warnings(&self) -> impl Iterator<Item = Warning> {
        let ticks = (self.ticks > 0).then_some(Warning::TicksDropped(self.ticks));
        ticks.into_iter().chain(Warning::chunk_tags(&self.tags))
    }
}

/// The path of a tag. Sections are told by their list alone: what one has, most have.
fn path(fields: &Fields, name: &str) -> String {
    match fields.path.split_once('[') {
        Some((list, _)) => Fields::new(format!("{list}[]"), fields.tags).path(name),
        None => fields.path(name),
    }
}

/// `None` where a tick does not say.
fn place(tick: &Fields) -> Option<Cell> {
    let [x, y, z] = ["x", "y", "z"].map(|name| tick.get(name).ok());
    Some(Cell::new(x?, y?, z?))
}

/// Whether nothing is in a tag: the game writes many lists of empty lists.
fn is_empty(tag: &Tag) -> bool {
    match tag {
        Tag::Compound(tags) => tags.values().all(is_empty),
        Tag::List(entries) => entries.iter().all(is_empty),
        Tag::ByteArray(bytes) => bytes.is_empty(),
        Tag::IntArray(numbers) => numbers.is_empty(),
        Tag::LongArray(numbers) => numbers.is_empty(),
        _ => false,
    }
}
