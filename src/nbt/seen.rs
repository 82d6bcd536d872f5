use super::{Compound, Kept, Tag};
use rustc_hash::FxHasher;
use std::hash::Hasher;

/// Compounds that were read lately. Chests full of one item are most of some builds, and clones of equal compounds
/// share their memory.
pub struct Seen {
    /// One place for each remainder of a hash: what came last stands there, so looking is one comparison for any file.
    places: Vec<Compound>,
    longest: usize,
}

const PLACES: usize = 1024;

impl Seen {
    /// Of compounds that take about `longest` bytes at most. Longer ones are not looked for.
    pub fn of(longest: usize) -> Seen {
        Seen { places: Vec::new(), longest }
    }

    /// A clone of the same compound where one is still there, of which nothing more is kept.
    pub fn share(&mut self, compound: Compound) -> (Compound, Kept) {
        let mut hash = Hash { hasher: FxHasher::default(), left: self.longest };
        if hash.add(&compound).is_none() {
            return (compound, Kept::All);
        }
        // Most files that are read have few compounds in lists, or none.
        self.places.resize_with(PLACES, Compound::new);
        let last = &mut self.places[hash.hasher.finish() as usize % PLACES];
        if *last == compound {
            return (last.clone(), Kept::Nothing);
        }
        last.clone_from(&compound);
        (compound, Kept::All)
    }
}

struct Hash {
    hasher: FxHasher,
    /// The bytes that may still come.
    left: usize,
}

impl Hash {
    /// `None` where there are too many.
    fn add(&mut self, compound: &Compound) -> Option<()> {
        compound.iter().try_for_each(|(name, tag)| {
            self.bytes(name.as_bytes())?;
            self.tag(tag)
        })
    }

    fn tag(&mut self, tag: &Tag) -> Option<()> {
        self.left = self.left.checked_sub(size_of::<Tag>())?;
        match tag {
            Tag::Byte(n) => self.hasher.write_i8(*n),
            Tag::Short(n) => self.hasher.write_i16(*n),
            Tag::Int(n) => self.hasher.write_i32(*n),
            Tag::Long(n) => self.hasher.write_i64(*n),
            Tag::Float(n) => self.hasher.write_u32(n.to_bits()),
            Tag::Double(n) => self.hasher.write_u64(n.to_bits()),
            Tag::String(text) => self.bytes(text.as_bytes())?,
            Tag::List(entries) => entries.iter().try_for_each(|entry| self.tag(entry))?,
            Tag::Compound(compound) => self.add(compound)?,
            Tag::ByteArray(numbers) => self.length::<i8>(numbers)?,
            Tag::IntArray(numbers) => self.length::<i32>(numbers)?,
            Tag::LongArray(numbers) => self.length::<i64>(numbers)?,
        }
        Some(())
    }

    fn bytes(&mut self, bytes: &[u8]) -> Option<()> {
        self.left = self.left.checked_sub(bytes.len())?;
        self.hasher.write(bytes);
        Some(())
    }

    /// The numbers of arrays are left to the comparison.
    fn length<T>(&mut self, numbers: &[T]) -> Option<()> {
        self.left = self.left.checked_sub(size_of_val(numbers))?;
        self.hasher.write_usize(numbers.len());
        Some(())
    }
}
