use crate::nbt;

/// How much a file may unfold to. Small files can ask for any amount of memory, so what is too much
/// must be said; people with huge builds raise it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Of the file once unpacked, and of its tags in memory.
    pub max_bytes: u64,
    pub max_cells: u64,
}

impl Default for Limits {
    /// 1 GiB, which holds 256 Mi cells of any palette; those make a grid of 512 MiB.
    fn default() -> Limits {
        Limits { max_bytes: 1 << 30, max_cells: 256 << 20 }
    }
}

impl Limits {
    pub(super) fn nbt(&self) -> nbt::Limits {
        nbt::Limits { max_memory: self.max_bytes, ..nbt::Limits::default() }
    }
}
