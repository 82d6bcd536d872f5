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
}
