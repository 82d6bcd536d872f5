use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};
use ndarray::{Array2, Array3};

/// The least game version that is written for grids that do not say theirs: 1.20.1.
pub const DEFAULT_DATA_VERSION: i32 = 3465;

/// What a schematic file says of itself beside its blocks.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Metadata {
    /// The game version that the block states belong to; `None` where the file did not say.
    pub data_version: Option<i32>,
    /// Where the low corner lies from the point of copying.
    pub offset: Cell,
    /// The file's own metadata as found. `Name`, `Author`, `Description` and `Date` mean the same in all formats.
    pub tags: Compound,
    /// What only the format that the file came in has a place for.
    pub own: Option<Own>,
    pub entities: Vec<Entity>,
    pub biomes: Option<Biomes>,
    /// The named parts that a file came in, within the grid; empty where it is one whole.
    pub regions: Vec<Region>,
}

impl Metadata {
    /// The entities that say what they are. Readers have no use for the others.
    pub fn named_entities(&self) -> impl Iterator<Item = &Entity> {
        self.entities.iter().filter(|entity| is_named(&entity.data))
    }
}

/// Tags beyond those that vox knows, kept for files of the same format.
#[derive(Clone, PartialEq, Debug)]
pub struct Own {
    pub dialect: Dialect,
    /// Beside the format's known tags, at the root of the file.
    pub tags: Compound,
}

/// Whose tags these are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dialect {
    Sponge,
    Litematica,
    Structure,
    Mcedit,
    Blueprint,
    Bedrock,
    Axiom,
}

/// A named part of a build.
#[derive(Clone, PartialEq, Debug)]
pub struct Region {
    pub name: String,
    /// Within the grid.
    pub bounds: Bounds,
    /// Beyond those that vox knows.
    pub tags: Compound,
}

/// Tags of a region that hold places: water that is about to flow, sand that is about to fall.
const PENDING: [&str; 2] = ["PendingBlockTicks", "PendingFluidTicks"];

impl Region {
    /// The region with its blocks moved or cut. What was about to happen does not move with them: it was of one
    /// moment of one world, the places would be wrong, and the game finds out anew what flows and falls.
    pub(super) fn moved(&self, bounds: Bounds) -> Region {
        let tags = self.tags.iter().filter(|(name, _)| !PENDING.contains(&name.as_str()));
        Region {
            name: self.name.clone(),
            bounds,
            tags: tags.map(|(name, tag)| (name.clone(), tag.clone())).collect(),
        }
    }
}

/// An animal, a painting, an item frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Entity {
    /// From the low corner of the grid, in blocks.
    pub place: [f64; 3],
    /// The cell that it hangs in, for paintings and the like: from the low corner too.
    pub block: Option<Cell>,
    /// As the game keeps it, with `id`, without `Pos` and without the tags that say the block.
    pub data: Compound,
}

/// Whether the data of an entity or a block entity say what it is.
pub fn is_named(data: &Compound) -> bool {
    matches!(data.get("id"), Some(Tag::String(_)))
}

/// The biomes of a grid, by numbers of their names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Biomes {
    /// Each once, in order of first use.
    pub names: Vec<String>,
    pub map: BiomeMap,
}

/// Where each biome is. The size is that of the grid.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum BiomeMap {
    /// One for every column, indexed `[z, x]`.
    Columns(Array2<u16>),
    /// One for every cell, indexed `[y, z, x]`.
    Cells(Array3<u16>),
}
