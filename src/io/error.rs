use super::{ChunkProblem, Format, GzipError, MagicaError, ObjError, VarintProblem};
use crate::block::{BadBlockState, PaletteFull};
use crate::nbt::{self, NbtError, NbtProblem};
use crate::space::Cell;
use std::io;

/// Why a file cannot be read. The name of the file is for the caller to add.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    #[error(transparent)]
    File(io::Error),
    #[error("the file is larger than {0} bytes, the limit")]
    LargeFile(u64),
    #[error("the file is empty")]
    Empty,
    #[error(transparent)]
    Gzip(GzipError),
    #[error(transparent)]
    Nbt(NbtError),
    #[error(
        "this is {0}, which vox cannot read: expected a schematic, a structure, a model, a world or a labelled OBJ"
    )]
    Unreadable(Format),
    #[error(
        "this is NBT, but no schematic: expected `Palette` and `BlockData`, or a compound `Blocks`, \
         but the root holds {0}"
    )]
    NoSchematic(String),
    #[error("this is no format that vox knows: it starts with the bytes {0}")]
    Unknown(String),

    #[error("the tag `{path}` is missing: expected {expected}")]
    Missing { path: String, expected: &'static str },
    #[error("the tag `{path}` is {found}: expected {expected}")]
    WrongType { path: String, expected: &'static str, found: String },
    #[error("the tag `{path}` is {found}: vox knows the versions 1 to 3 of Sponge schematics")]
    Version { path: String, found: i32 },
    #[error("the tag `{path}` is {found}: vox knows version {known} of this format")]
    OnlyVersion { path: String, found: i32, known: i32 },
    #[error("the tag `{path}` is 0: a schematic is at least one block wide, high and long")]
    ZeroSize { path: String },
    #[error("the tag `{path}` is {found}: expected 1 to 65,535")]
    Side { path: String, found: i32 },
    #[error("the size {size} makes {cells} blocks, more than {limit}, the limit")]
    TooManyCells { size: Size, cells: u64, limit: u64 },
    #[error("the tag `{path}` is {found}: vox knows Litematica schematics from version 2 on")]
    OldLitematic { path: String, found: i32 },
    #[error("the file has no region `{name}`: {}", having(names))]
    NoRegion { name: String, names: Vec<String> },
    #[error(
        "the regions `{first}` and `{last}` lie {apart} blocks apart along {axis}: the box around all \
         regions, {size}, makes {cells} blocks, more than {limit}, the limit; read the regions one by one"
    )]
    FarApart {
        first: String,
        last: String,
        apart: i64,
        axis: &'static str,
        size: Size,
        cells: u64,
        limit: u64,
    },
    #[error("`{path}` is {} and the size {size}: no number reaches so far", place(.position))]
    FarOut { path: String, position: Cell, size: Size },
    #[error("`{path}` holds {found} words: expected {expected} for the size {size} and {bits} bits a block")]
    WordCount { path: String, found: usize, expected: u64, size: Size, bits: u32 },
    #[error(
        "the size {size} makes {cells} blocks in each of {variants} palettes, more than {limit} in all, \
         the limit"
    )]
    TooManyVariants { size: Size, cells: u64, variants: usize, limit: u64 },
    #[error(
        "the data of blocks take {bytes} bytes in each of {variants} palettes, more than {limit} in all, the limit"
    )]
    LargeVariants { bytes: u64, variants: usize, limit: u64 },
    #[error("the size {size} makes {cells} blocks, but `{path}` holds only {bytes} bytes")]
    TooFewBytes { size: Size, cells: u64, path: String, bytes: usize },

    #[error("the size {size} makes {cells} blocks, but `{path}` holds only {found}")]
    TooFewEntries { size: Size, cells: u64, path: String, found: usize },
    #[error("the tag `{path}` is {found}: expected -2,097,152 to 2,097,151")]
    FarAway { path: String, found: i32 },
    #[error("the file holds {sections} sections of blocks, more than {limit}, the limit")]
    TooManySections { sections: usize, limit: u64 },
    #[error("`{path}` holds only {found} of {needed} Longs")]
    TooFewLongs { path: String, needed: usize, found: usize },
    #[error("the file ends within its {part}: only {left} bytes are left for it and its length")]
    PartCutOff { part: &'static str, left: usize },
    #[error("`{path}` holds only {found} bytes, too few for all blocks")]
    ShortArray { path: String, found: usize },
    #[error(
        "the tag `Materials` is `{0}`: vox knows only `Alpha`, the blocks of Java Edition; \
         Classic and Pocket Edition number theirs otherwise"
    )]
    Materials(String),

    #[error("the entry `{entry}` of `{path}` is no block state: {problem}")]
    PaletteEntry { path: String, entry: String, problem: BadBlockState },
    #[error("the entry `{entry}` of `{path}` has the index {index}: expected 0 to {}", PALETTE_INDEX_MAX)]
    PaletteIndex { path: String, entry: String, index: i32 },
    #[error("the entries `{first}` and `{second}` of `{path}` have the same index {index}")]
    PaletteTwice { path: String, first: String, second: String, index: i32 },
    #[error("`{path}`: {problem}")]
    PaletteFull { path: String, problem: PaletteFull },

    #[error("`{path}`, byte {offset}, block {}: {problem}", place(.cell))]
    Varint { path: String, offset: usize, cell: Cell, problem: VarintProblem },
    #[error("`{path}`, block {}: index {index} is not in the palette of {entries} entries", place(.cell))]
    NotInPalette { path: String, cell: Cell, index: u32, entries: usize },
    #[error("`{path}` ends after {found} of {cells} blocks")]
    TooFewBlocks { path: String, found: u64, cells: u64 },
    #[error("`{path}` goes on after all {cells} blocks")]
    TooManyBlocks { path: String, cells: u64 },

    #[error("{name}: {error}")]
    Named { name: String, error: Box<ReadError> },
    #[error("the region is {0} bytes long: its table alone takes 8,192")]
    RegionHead(usize),
    #[error("the chunk ({}, {}) of the region: {problem}", .slot[0], .slot[1])]
    Chunk { slot: [i32; 2], problem: ChunkProblem },
    #[error("the folder holds no region: expected files `r.<x>.<z>.mca`, or a folder `region` with such")]
    NoRegions,
    #[error("there is no block but air")]
    EmptyWorld,
    #[error(
        "the blocks reach from {} to {}, or further: more than {limit} cells, the limit; give a box to read",
        place(.from),
        place(.to)
    )]
    WorldTooLarge { from: Cell, to: Cell, limit: u64 },
    #[error(
        "no part of a world reaches from {} to {}: expected the low corner first, within 30,000,000 blocks of the middle",
        place(.from),
        place(.to)
    )]
    NoPart { from: Cell, to: Cell },
    #[error("`{path}` is empty: expected a block state at least")]
    NoStates { path: String },
    #[error("`{path}` holds {longs} longs, into which {count} indices of {entries} entries are never packed")]
    PackedLength { path: String, longs: usize, count: usize, entries: usize },
    #[error("`{path}`, number {at}: index {index} is not in the palette of {entries} entries")]
    PackedIndex { path: String, at: usize, index: u32, entries: usize },

    #[error(transparent)]
    Magica(#[from] MagicaError),
    #[error(transparent)]
    Obj(#[from] ObjError),
}

/// What goes wrong while unpacking comes out of the stream as an error of it.
impl From<io::Error> for ReadError {
    fn from(error: io::Error) -> ReadError {
        error.downcast::<GzipError>().map_or_else(ReadError::File, ReadError::Gzip)
    }
}

impl From<NbtError> for ReadError {
    fn from(error: NbtError) -> ReadError {
        match error.problem {
            NbtProblem::Input(error) => error.into(),
            _ => ReadError::Nbt(error),
        }
    }
}

/// Cells hold 16 bits.
pub(super) const PALETTE_INDEX_MAX: i32 = (1 << 16) - 1;

/// A size as messages show it: `17 x 12 x 12`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Size(pub Cell);

impl Size {
    /// How many cells this is, of any size that a file says.
    pub(super) fn cells(self) -> u64 {
        let extents = self.0.to_array().map(|n| u64::try_from(n).unwrap_or(0));
        extents.into_iter().fold(1, u64::saturating_mul)
    }

    /// The place of the cell `at` in the order of schematic files: x fastest, then z, then y.
    pub(super) fn cell(self, at: usize) -> Cell {
        let [width, _, length] = self.0.to_array().map(|n| n as usize);
        Cell::new((at % width) as i32, (at / width / length) as i32, (at / width % length) as i32)
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} x {} x {}", self.0.x, self.0.y, self.0.z)
    }
}

fn having(names: &[String]) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<String> = names.iter().take(SHOWN).map(|name| format!("`{name}`")).collect();
    match names.len() {
        0 => "it has no regions".to_owned(),
        len => format!("it has {}{}", shown.join(", "), if len > SHOWN { ", ..." } else { "" }),
    }
}

fn place(cell: &Cell) -> String {
    format!("({}, {}, {})", cell.x, cell.y, cell.z)
}

/// Why something cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    #[error(transparent)]
    File(#[from] std::io::Error),
    #[error("the size {0} cannot be written: a .schem holds 1 to 65,535 blocks along each axis")]
    Size(Size),
    #[error(
        "the blocks are of the data version {0}, but chunks are written as since Minecraft 1.18 (2860): \
         bring the blocks there first, as with `--mc-version 1.20.1`"
    )]
    OldBlocks(i32),
    #[error("the build would reach from {} to {}: worlds go to 30,000,000 sideways and 2,032 up and down",
        place(.from), place(.to))]
    OutsideWorlds { from: Cell, to: Cell },
    #[error("the model takes more than 4 GiB, the most that the format can say")]
    LongModel,
    #[error("the region ({}, {}) takes more than 64 GiB", .0[0], .0[1])]
    LongRegion([i32; 2]),
    #[error("the size {0} cannot be written: there is no block in it")]
    Empty(Size),
    #[error("the offset {} cannot be written: no number reaches so far", place(.0))]
    Offset(Cell),
    #[error(transparent)]
    Nbt(#[from] nbt::WriteError),
}
