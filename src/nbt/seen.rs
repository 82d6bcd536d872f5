use super::{Compound, Tag};
use rustc_hash::FxHasher;
use std::hash::Hasher;

/// Short compounds that were read lately. Chests full of one item are most of some builds, and clones of equal compounds
/// share their memory.
pub(super) struct Seen(Vec<Compound>);

/// One place for each remainder of a hash: what came last stands there, so looking is one comparison for any file.
const PLACES: usize = 1024;

impl Seen {
    pub fn new() -> Seen {
        Seen(vec![Compound::new(); PLACES])
    }

    /// A clone of the same compound, where one is still there.
    pub fn share(&mut self, compound: Compound) -> Compound {
        let Some(hash) = hash(&compound) else { return compound };
        let last = &mut self.0[hash as usize % PLACES];
        if *last != compound {
            *last = compound;
        }
        last.clone()
    }
}

/// `None` where a tag may be long: such compounds rarely find their like.
fn hash(compound: &Compound) -> Option<u64> {
    let mut hasher = FxHasher::default();
    for (name, tag) in compound {
        hasher.write(name.as_bytes());
        match tag {
            Tag::Byte(n) => hasher.write_i8(*n),
            Tag::Short(n) => hasher.write_i16(*n),
            Tag::Int(n) => hasher.write_i32(*n),
            Tag::Long(n) => hasher.write_i64(*n),
            Tag::Float(n) => hasher.write_u32(n.to_bits()),
            Tag::Double(n) => hasher.write_u64(n.to_bits()),
            Tag::String(text) => hasher.write(text.as_bytes()),
            _ => return None,
        }
    }
    Some(hasher.finish())
}
