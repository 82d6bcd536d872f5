use std::collections::BTreeSet;

/// What reading a file had to put right or leave out.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum Warning {
    #[error("{0} block entities lie outside of the schematic and are left out")]
    BlockEntitiesOutside(usize),
    #[error("{0} entities without an `Id` are left out")]
    EntitiesUnnamed(usize),
    #[error("PaletteMax is {said}, but the palette holds {found} entries: the palette is believed")]
    PaletteMax { said: i32, found: usize },
    #[error("{blocks} blocks have data that their id never has ({ids}): they are read as if it was 0")]
    UnknownData { blocks: usize, ids: String },
    #[error("the file does not say what {blocks} blocks are ({ids}): they are called `legacy:` and their id")]
    UnknownIds { blocks: usize, ids: String },
    #[error("{0} blocks ask for the ground or the water of a world: they say to leave it alone here")]
    Ground(usize),
    #[error("ids above 255 are read in WorldEdit's order of `AddBlocks`; other programs have another")]
    HalvesOfIds,
    #[error(
        "the items in {0} block entities are kept in the form of Minecraft 1.12, which newer games may drop"
    )]
    OldItems(usize),
    #[error("{0} entities are kept in the form of Minecraft 1.12, which newer games may drop")]
    OldEntities(usize),
    #[error("{0} chunks are not made yet: their blocks are left alone (structure_void)")]
    ChunksNotMade(usize),
    #[error("{0} chunks say that they belong elsewhere and are left out")]
    ChunksMisplaced(usize),
    #[error("the chunks are of the data versions {first} to {last}: blocks take the states of the highest")]
    MixedVersions { first: i32, last: i32 },
    #[error("biomes are kept by number, as before Minecraft 1.18, and are left out")]
    BiomesByNumber,
    #[error("{blocks} blocks are unknown and kept under their names in Bedrock Edition ({names})")]
    UnknownBedrock { blocks: usize, names: String },
    #[error(
        "{0} block entities and entities are kept in the form of Bedrock Edition, which Java Edition drops"
    )]
    BedrockData(usize),
    #[error("the water of {0} blocks that cannot stand in it, or are not there, is left out")]
    WaterDropped(usize),
    #[error("{0} blocks share their cell with another, which Java Edition has no place for: it is left out")]
    SecondLayer(usize),
    #[error("{0} ticks that blocks wait for are left out")]
    TicksDropped(usize),
    #[error("the tags {0} are unknown and are left out")]
    TagsDropped(String),
    #[error("the tags {0} of chunks have no place in a build and are left out")]
    ChunkTags(String),
    #[error("Version is {found}, and vox knows those up to {known}: what is new is not understood")]
    NewVersion { found: i32, known: i32 },
    #[error("the block states are those of Minecraft 1.12 and are kept as they stand")]
    OldStates,
    #[error("the palette of the region `{0}` does not start with air, which Litematica takes for granted")]
    PaletteWithoutAir(String),
    #[error("{blocks} blocks of the region `{region}` replace those of other regions in the same place")]
    RegionsOverlap { region: String, blocks: usize },
    #[error("{0} parts of the scene are hidden and are left out")]
    ModelsHidden(usize),
    #[error("{0} later frames of an animation are left out")]
    FramesLater(usize),
    #[error("{0} voxels lie outside of their models and are left out")]
    VoxelsOutside(usize),
    #[error("{0} blocks lie outside of the size and are left out")]
    BlocksOutside(usize),
    #[error("{0} blocks stand where the file has put another before: the last one counts")]
    BlocksReplaced(usize),
    #[error("{0} jigsaw blocks are read as the blocks that they leave behind")]
    Jigsaws(usize),
    #[error("the biomes do not fit the schematic and are left out")]
    Biomes,
    #[error("{0} bytes follow after the end and are left out")]
    Trailing(u64),
}

impl Warning {
    /// `None` where no tag is dropped.
    pub(super) fn tags_dropped(names: &BTreeSet<String>) -> Option<Warning> {
        (!names.is_empty()).then(|| Warning::TagsDropped(listed(names)))
    }

    /// `None` where chunks hold nothing else.
    pub(super) fn chunk_tags(names: &BTreeSet<String>) -> Option<Warning> {
        (!names.is_empty()).then(|| Warning::ChunkTags(listed(names)))
    }
}

/// The first few of `names`, which a file may hold any number of.
fn listed(names: &BTreeSet<String>) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<&str> = names.iter().take(SHOWN).map(String::as_str).collect();
    shown.join(", ") + if names.len() > SHOWN { ", ..." } else { "" }
}
