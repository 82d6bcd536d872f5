use super::tag::id;
use super::{Compound, Endian, Limits, NbtError, NbtProblem, Tag};

/// The root name and tree of big-endian NBT, which must fill `bytes`.
///
/// No length is believed before its bytes are there, so memory is bounded by `bytes` and `limits`.
/// Of equal names in a compound the last one counts, as in the game.
pub fn read(bytes: &[u8], limits: &Limits) -> Result<(String, Compound), NbtError> {
    read_as(Endian::Big, bytes, limits)
}

/// As [`read`], of NBT in either order of bytes.
pub fn read_as(endian: Endian, bytes: &[u8], limits: &Limits) -> Result<(String, Compound), NbtError> {
    let (name, root, end) = first(endian, bytes, limits)?;
    match bytes.len() - end {
        0 => Ok((name, root)),
        left => Err(NbtError::new(end, NbtProblem::Trailing(left))),
    }
}

/// The root name and tree of the NBT that `bytes` start with, and the number of bytes that it takes.
pub fn read_first(bytes: &[u8], limits: &Limits) -> Result<(String, Compound, usize), NbtError> {
    first(Endian::Big, bytes, limits)
}

fn first(endian: Endian, bytes: &[u8], limits: &Limits) -> Result<(String, Compound, usize), NbtError> {
    let mut reader = Reader { endian, bytes, at: 0, memory: limits.max_memory, limits };
    let root = reader.byte("the type of the root tag")?;
    if root != id::COMPOUND {
        return Err(NbtError::new(0, NbtProblem::Root(root)));
    }
    let name = reader.text()?;
    let compound = reader.compound(1)?;
    Ok((name, compound, reader.at))
}

struct Reader<'a> {
    endian: Endian,
    bytes: &'a [u8],
    at: usize,
    /// What the tree may still cost.
    memory: u64,
    limits: &'a Limits,
}

impl<'a> Reader<'a> {
    fn fail<T>(&self, problem: NbtProblem) -> Result<T, NbtError> {
        Err(NbtError::new(self.at, problem))
    }

    fn take(&mut self, what: &'static str, needed: u64) -> Result<&'a [u8], NbtError> {
        let rest = &self.bytes[self.at..];
        match usize::try_from(needed).ok().and_then(|needed| rest.get(..needed)) {
            None => self.fail(NbtProblem::CutOff { what, needed, left: rest.len() }),
            Some(taken) => {
                self.at += taken.len();
                Ok(taken)
            }
        }
    }

    fn array<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], NbtError> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(what, N as u64)?);
        Ok(self.endian.arrange(array))
    }

    fn byte(&mut self, what: &'static str) -> Result<u8, NbtError> {
        Ok(self.array::<1>(what)?[0])
    }

    /// A length of entries that take at least `width` bytes each, all of which are there.
    fn length(&mut self, what: &'static str, width: u64) -> Result<u64, NbtError> {
        let len = i32::from_be_bytes(self.array(what)?);
        let Ok(count) = u64::try_from(len) else {
            return self.fail(NbtProblem::NegativeLength { what, len });
        };
        let left = self.bytes.len() - self.at;
        match count * width {
            needed if needed > left as u64 => self.fail(NbtProblem::CutOff { what, needed, left }),
            _ => Ok(count),
        }
    }

    fn charge(&mut self, cost: u64) -> Result<(), NbtError> {
        match self.memory.checked_sub(cost) {
            None => self.fail(NbtProblem::TooLarge(self.limits.max_memory)),
            Some(left) => {
                self.memory = left;
                Ok(())
            }
        }
    }

    fn check_depth(&self, depth: usize) -> Result<(), NbtError> {
        match depth > self.limits.max_depth {
            true => self.fail(NbtProblem::TooDeep(self.limits.max_depth)),
            false => Ok(()),
        }
    }

    fn payload(&mut self, kind: u8, depth: usize) -> Result<Tag, NbtError> {
        Ok(match kind {
            id::BYTE => Tag::Byte(i8::from_be_bytes(self.array("a Byte")?)),
            id::SHORT => Tag::Short(i16::from_be_bytes(self.array("a Short")?)),
            id::INT => Tag::Int(i32::from_be_bytes(self.array("an Int")?)),
            id::LONG => Tag::Long(i64::from_be_bytes(self.array("a Long")?)),
            id::FLOAT => Tag::Float(f32::from_be_bytes(self.array("a Float")?)),
            id::DOUBLE => Tag::Double(f64::from_be_bytes(self.array("a Double")?)),
            id::STRING => Tag::String(self.text()?),
            id::BYTE_ARRAY => Tag::ByteArray(self.numbers("a Byte Array", i8::from_be_bytes)?),
            id::INT_ARRAY => Tag::IntArray(self.numbers("an Int Array", i32::from_be_bytes)?),
            id::LONG_ARRAY => Tag::LongArray(self.numbers("a Long Array", i64::from_be_bytes)?),
            id::LIST => Tag::List(self.list(depth)?),
            id::COMPOUND => Tag::Compound(self.compound(depth)?),
            _ => return self.fail(NbtProblem::TagType(kind)),
        })
    }

    fn numbers<T, const N: usize>(
        &mut self,
        what: &'static str,
        number: impl Fn([u8; N]) -> T,
    ) -> Result<Vec<T>, NbtError> {
        let len = self.length(what, N as u64)?;
        self.charge(len * N as u64)?;
        let (chunks, _) = self.take(what, len * N as u64)?.as_chunks::<N>();
        Ok(chunks.iter().map(|chunk| number(self.endian.arrange(*chunk))).collect())
    }

    fn text(&mut self) -> Result<String, NbtError> {
        let start = self.at;
        let len = u16::from_be_bytes(self.array("the length of a text")?);
        self.charge(u64::from(len))?;
        let bytes = self.take("a text", u64::from(len))?;
        // Plain UTF-8 comes first: many tools write it, and the two forms rarely differ.
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(text.to_owned()),
            Err(_) => cesu8::from_java_cesu8(bytes)
                .map(|text| text.into_owned())
                .map_err(|_| NbtError::new(start, NbtProblem::Text)),
        }
    }

    fn list(&mut self, depth: usize) -> Result<Vec<Tag>, NbtError> {
        self.check_depth(depth)?;
        let kind = self.byte("the entry type of a List")?;
        let Some(width) = least_width(kind) else { return self.fail(NbtProblem::TagType(kind)) };
        let len = self.length("a List", width)?;
        if kind == id::END && len > 0 {
            return self.fail(NbtProblem::UntypedList(len as i32));
        }
        self.charge(len * size_of::<Tag>() as u64)?;
        (0..len as usize)
            .map(|index| self.payload(kind, depth + 1).map_err(|error| error.in_entry(index)))
            .collect()
    }

    fn compound(&mut self, depth: usize) -> Result<Compound, NbtError> {
        self.check_depth(depth)?;
        let mut compound = Compound::new();
        loop {
            let kind = self.byte("a Compound")?;
            if kind == id::END {
                return Ok(compound);
            }
            let name = self.text()?;
            self.charge(size_of::<(String, Tag)>() as u64)?;
            let tag = self.payload(kind, depth + 1).map_err(|error| error.in_tag(&name))?;
            compound.insert(name, tag);
        }
    }
}

/// The fewest bytes that a value of type `kind` takes; `None` where there is no such type.
fn least_width(kind: u8) -> Option<u64> {
    match kind {
        id::END => Some(0),
        id::BYTE | id::COMPOUND => Some(1),
        id::SHORT | id::STRING => Some(2),
        id::INT | id::FLOAT | id::BYTE_ARRAY | id::INT_ARRAY | id::LONG_ARRAY => Some(4),
        id::LIST => Some(5),
        id::LONG | id::DOUBLE => Some(8),
        _ => None,
    }
}
