use super::{Compound, Tag};

/// The last short compound at each of the first places of lists, by its bytes. Items of chests come again in the next
/// chest, and comparing bytes takes a tenth of reading tags.
pub(super) struct Again(Vec<Entry>);

#[derive(Clone, Default)]
struct Entry {
    bytes: Vec<u8>,
    compound: Compound,
}

/// As many items as a double chest holds, and some.
const PLACES: usize = 64;

/// As long as most items are.
const LONGEST: usize = 128;

/// The bytes before a compound is read, as far as it may be long.
pub(super) struct Ahead {
    bytes: [u8; LONGEST],
    len: usize,
}

impl Ahead {
    pub fn of(ahead: &[u8]) -> Ahead {
        let (mut bytes, len) = ([0; LONGEST], ahead.len().min(LONGEST));
        bytes[..len].copy_from_slice(&ahead[..len]);
        Ahead { bytes, len }
    }
}

impl Again {
    pub fn new() -> Again {
        Again(vec![Entry::default(); PLACES])
    }

    /// The compound that `ahead` starts with, where it was the last at place `index`, and its length in bytes.
    pub fn find(&self, index: usize, ahead: &[u8]) -> Option<(&Compound, usize)> {
        let Entry { bytes, compound } = &self.0[index % PLACES];
        (!bytes.is_empty() && ahead.starts_with(bytes)).then_some((compound, bytes.len()))
    }

    /// Keeps the compound of `len` bytes that was read from `ahead` at place `index`. One that holds others stays away: what
    /// becomes of those depends on their path and depth.
    pub fn keep(&mut self, index: usize, ahead: &Ahead, len: usize, compound: &Compound) {
        if len <= ahead.len && compound.values().all(is_plain) {
            let entry = &mut self.0[index % PLACES];
            entry.bytes.clear();
            entry.bytes.extend_from_slice(&ahead.bytes[..len]);
            entry.compound.clone_from(compound);
        }
    }
}

fn is_plain(tag: &Tag) -> bool {
    use Tag::{Byte, Double, Float, Int, Long, Short, String};
    matches!(tag, Byte(_) | Short(_) | Int(_) | Long(_) | Float(_) | Double(_) | String(_))
}
