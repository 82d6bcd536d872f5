use crate::nbt::Compound;
use crate::space::Cell;

/// What a schematic file says of itself beside its blocks.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Metadata {
    /// The game version that the block states belong to; `None` where the file did not say.
    pub data_version: Option<i32>,
    /// Where the low corner lies from the point of copying.
    pub offset: Cell,
    /// The file's own metadata (name, author, date), as found.
    pub tags: Compound,
    pub entities: Vec<Entity>,
    pub biomes: Option<Biomes>,
}

/// An animal, a painting, an item frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Entity {
    /// From the low corner of the grid, in blocks.
    pub place: [f64; 3],
    /// As the game keeps it, with `id` and without `Pos`.
    pub data: Compound,
}

/// The biomes of a file, kept as found: they mean nothing to vox and fit only the size they came with.
#[derive(Clone, PartialEq, Debug)]
pub struct Biomes {
    pub extent: BiomeExtent,
    /// Numbers by biome name.
    pub palette: Compound,
    /// Varints of those numbers.
    pub data: Vec<i8>,
}

/// What one biome entry stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BiomeExtent {
    Column,
    Cell,
}
