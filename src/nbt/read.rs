use super::again::{Again, Ahead};
use super::input::Input;
use super::path::Path;
use super::seen::Seen;
use super::tag::id;
use super::{Compound, Endian, Kept, Limits, Name, NbtError, NbtProblem, Sink, Tag};
use std::borrow::Cow;
use std::io::BufRead;

/// The root name and tree of big-endian NBT, which must fill `bytes`.
///
/// No length is believed before its bytes are there, so memory is bounded by `bytes` and `limits`.
/// Of equal names in a compound the last one counts, as in the game.
pub fn read(bytes: &[u8], limits: &Limits) -> Result<(String, Compound), NbtError> {
    read_as(Endian::Big, bytes, limits)
}

/// As [`read`], in either order of bytes.
pub fn read_as(endian: Endian, bytes: &[u8], limits: &Limits) -> Result<(String, Compound), NbtError> {
    let (name, root, end) = read_from(bytes, endian, limits, &mut ())?;
    match bytes.len() as u64 - end {
        0 => Ok((name, root)),
        left => Err(NbtError::new(end, "", NbtProblem::Trailing(left))),
    }
}

/// The root name and tree of the big-endian NBT that `bytes` start with, and the number of bytes that it takes.
pub fn read_first(bytes: &[u8], limits: &Limits) -> Result<(String, Compound, usize), NbtError> {
    let (name, root, end) = read_from(bytes, Endian::Big, limits, &mut ())?;
    Ok((name, root, end as usize))
}

/// The root name and tree of the NBT that `input` starts with, and the number of bytes that it took.
/// Byte arrays in compounds go to `sink` where it wants them. The path of one within a list does not tell its entry:
/// `Chests[].Data`.
pub fn read_from(
    input: impl BufRead,
    endian: Endian,
    limits: &Limits,
    sink: &mut dyn Sink,
) -> Result<(String, Compound, u64), NbtError> {
    let (input, path) = (Input::new(input), Path::default());
    let (memory, text, open) = (limits.max_memory, Vec::new(), Vec::new());
    let mut reader = Reader {
        input,
        endian,
        path,
        memory,
        limits,
        sink,
        text,
        open,
        seen: Seen::of(SHORT),
        again: Again::new(),
        buffer: Vec::new(),
    };
    let root = reader.byte("the type of the root tag")?;
    if root != id::COMPOUND {
        return Err(NbtError::new(0, "", NbtProblem::Root(root)));
    }
    let name = reader.text()?.to_owned();
    let compound = reader.compound(1)?;
    Ok((name, compound, reader.input.at))
}

/// What a compound costs beside its entries: counts of clones and of room, what the allocator keeps.
const COMPOUND: u64 = 32;
const ENTRY: u64 = size_of::<(Name, Tag)>() as u64;

/// As long as entries of lists may be to be looked up: in lists of lists it is done at every depth.
const SHORT: usize = 512;

/// The few numbers that may be kept of a compound that was handed on.
const HANDED_ON: u64 = 64;

struct Reader<'a, R> {
    input: Input<R>,
    endian: Endian,
    path: Path,
    /// What the tree may still cost.
    memory: u64,
    limits: &'a Limits,
    sink: &'a mut dyn Sink,
    /// The text that was read last.
    text: Vec<u8>,
    /// What was read so far of the compounds that stand in each other.
    open: Vec<(Name, Tag)>,
    /// Of the compounds that are entries of lists.
    seen: Seen,
    again: Again,
    /// The bytes of an array that are becoming numbers.
    buffer: Vec<u8>,
}

impl<R: BufRead> Reader<'_, R> {
    fn error(&self, problem: NbtProblem) -> NbtError {
        NbtError::new(self.input.at, self.path.as_str(), problem)
    }

    fn fail<T>(&self, problem: NbtProblem) -> Result<T, NbtError> {
        Err(self.error(problem))
    }

    /// The error of a value of which only the last `left` bytes were there.
    fn cut_off(&self, what: &'static str, needed: usize, left: usize) -> NbtError {
        let problem = NbtProblem::CutOff { what, needed: needed as u64, left: left as u64 };
        NbtError::new(self.input.at - left as u64, self.path.as_str(), problem)
    }

    fn fill(&mut self, what: &'static str, target: &mut [u8]) -> Result<(), NbtError> {
        let filled = self.input.fill(target).map_err(|error| self.error(NbtProblem::Input(error)))?;
        match filled < target.len() {
            true => Err(self.cut_off(what, target.len(), filled)),
            false => Ok(()),
        }
    }

    /// The bytes of a number, high byte first.
    fn array<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], NbtError> {
        let mut array = [0; N];
        self.fill(what, &mut array)?;
        Ok(self.endian.arrange(array))
    }

    fn byte(&mut self, what: &'static str) -> Result<u8, NbtError> {
        Ok(self.array::<1>(what)?[0])
    }

    fn length(&mut self, what: &'static str) -> Result<usize, NbtError> {
        let len = i32::from_be_bytes(self.array(what)?);
        usize::try_from(len).map_err(|_| self.error(NbtProblem::NegativeLength { what, len }))
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

    /// Makes room for `more` of the at most `most` entries of `entries`: at a time no more than as many as came.
    fn reserve<T>(&mut self, entries: &mut Vec<T>, more: usize, most: usize) -> Result<(), NbtError> {
        let (len, room) = (entries.len(), entries.capacity());
        if room - len < more {
            let wanted = (len + more).max(2 * room).min(most);
            self.charge(((wanted - room) * size_of::<T>()) as u64)?;
            entries.reserve_exact(wanted - len);
        }
        Ok(())
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
            id::STRING => Tag::String(self.string()?),
            id::BYTE_ARRAY => Tag::ByteArray(self.numbers("a Byte Array", i8::from_be_bytes)?),
            id::INT_ARRAY => Tag::IntArray(self.numbers("an Int Array", i32::from_be_bytes)?),
            id::LONG_ARRAY => Tag::LongArray(self.numbers("a Long Array", i64::from_be_bytes)?),
            id::LIST => Tag::List(self.list(depth)?),
            id::COMPOUND => Tag::Compound(self.compound(depth)?),
            _ => return self.fail(NbtProblem::TagType(kind)),
        })
    }

    /// The value of a compound's tag, which `sink` may take.
    fn tag(&mut self, kind: u8, depth: usize) -> Result<Tag, NbtError> {
        match kind {
            id::BYTE_ARRAY => self.byte_array(),
            id::LIST => self.list_tag(depth).map(Tag::List),
            _ => self.payload(kind, depth),
        }
    }

    fn byte_array(&mut self) -> Result<Tag, NbtError> {
        let what = "a Byte Array";
        let len = self.length(what)?;
        if !self.sink.wants(self.path.as_str(), len) {
            return Ok(Tag::ByteArray(self.entries(what, len, i8::from_be_bytes)?));
        }
        let passed = self.input.pass(len, |piece| self.sink.take(piece));
        match passed.map_err(|error| self.error(NbtProblem::Input(error)))? {
            passed if passed < len => Err(self.cut_off(what, len, passed)),
            _ => Ok(Tag::ByteArray(Vec::new())),
        }
    }

    fn numbers<T, const N: usize>(
        &mut self,
        what: &'static str,
        number: impl Fn([u8; N]) -> T,
    ) -> Result<Vec<T>, NbtError> {
        let len = self.length(what)?;
        self.entries(what, len, number)
    }

    /// The `len` numbers of an array.
    fn entries<T, const N: usize>(
        &mut self,
        what: &'static str,
        len: usize,
        number: impl Fn([u8; N]) -> T,
    ) -> Result<Vec<T>, NbtError> {
        const MOST: usize = 8192;
        let mut numbers = Vec::new();
        while numbers.len() < len {
            let step = (len - numbers.len()).min(MOST / N);
            let before = numbers.len() * N;
            let mut buffer = std::mem::take(&mut self.buffer);
            buffer.resize(step * N, 0);
            self.fill(what, &mut buffer).map_err(|error| error.in_array(before, len * N))?;
            self.reserve(&mut numbers, step, len)?;
            let (chunks, _) = buffer.as_chunks::<N>();
            numbers.extend(chunks.iter().map(|chunk| number(self.endian.arrange(*chunk))));
            self.buffer = buffer;
        }
        Ok(numbers)
    }

    /// The next text, until another is read.
    fn text(&mut self) -> Result<&str, NbtError> {
        let start = self.input.at;
        let len = u16::from_be_bytes(self.array("the length of a text")?);
        let mut bytes = std::mem::take(&mut self.text);
        bytes.resize(usize::from(len), 0);
        self.fill("a text", &mut bytes)?;
        // Plain UTF-8 comes first: many tools write it, and the two forms rarely differ.
        if std::str::from_utf8(&bytes).is_err() {
            let text = cesu8::from_java_cesu8(&bytes).map(Cow::into_owned);
            let broken = |_| NbtError::new(start, self.path.as_str(), NbtProblem::Text);
            bytes = text.map_err(broken)?.into_bytes();
        }
        self.text = bytes;
        Ok(std::str::from_utf8(&self.text).unwrap_or_default())
    }

    fn string(&mut self) -> Result<String, NbtError> {
        let string = self.text()?.to_owned();
        self.charge(string.len() as u64)?;
        Ok(string)
    }

    fn name(&mut self) -> Result<Name, NbtError> {
        let name = Name::from(self.text()?);
        // Long ones twice: they stand in the path, too.
        self.charge(if name.len() > Name::INLINE_LIMIT { 2 * name.len() as u64 } else { 0 })?;
        Ok(name)
    }

    /// The list of a compound, which `sink` may take.
    fn list_tag(&mut self, depth: usize) -> Result<Vec<Tag>, NbtError> {
        match self.list_head(depth)? {
            // An empty list is one of no compounds, whatever type it gives.
            (id::COMPOUND, len) | (_, len @ 0) if self.sink.wants_list(self.path.as_str()) => {
                self.streamed_list(len, depth)?;
                Ok(Vec::new())
            }
            (kind, len) => self.list_entries(kind, len, depth),
        }
    }

    fn list(&mut self, depth: usize) -> Result<Vec<Tag>, NbtError> {
        let (kind, len) = self.list_head(depth)?;
        self.list_entries(kind, len, depth)
    }

    /// The type and number of the entries.
    fn list_head(&mut self, depth: usize) -> Result<(u8, usize), NbtError> {
        self.check_depth(depth)?;
        let kind = self.byte("the entry type of a List")?;
        if kind > id::LONG_ARRAY {
            return self.fail(NbtProblem::TagType(kind));
        }
        let len = self.length("a List")?;
        if kind == id::END && len > 0 {
            return self.fail(NbtProblem::UntypedList(len as i32));
        }
        Ok((kind, len))
    }

    fn list_entries(&mut self, kind: u8, len: usize, depth: usize) -> Result<Vec<Tag>, NbtError> {
        let mark = self.path.enter_list();
        let mut entries = Vec::new();
        for index in 0..len {
            self.reserve(&mut entries, 1, len)?;
            let entry = match kind {
                id::COMPOUND => self.entry(index, depth + 1).map(Tag::Compound),
                _ => self.payload(kind, depth + 1),
            };
            let entry = entry.map_err(|error| error.in_entry(&mark, index))?;
            entries.push(entry);
        }
        self.path.leave(&mark);
        Ok(entries)
    }

    /// The compound number `index` of a list that stays in the tree.
    fn entry(&mut self, index: usize, depth: usize) -> Result<Compound, NbtError> {
        self.check_depth(depth)?;
        let ahead = self.input.ahead();
        if let Some((compound, len)) = self.again.find(index, ahead) {
            let compound = compound.clone();
            self.input.skip(len);
            self.charge(COMPOUND + ENTRY * compound.len() as u64 + len as u64)?;
            return Ok(compound);
        }
        let (ahead, start) = (Ahead::of(ahead), self.input.at);
        let compound = self.compound(depth)?;
        let (compound, _) = self.seen.share(compound);
        self.again.keep(index, &ahead, (self.input.at - start) as usize, &compound);
        Ok(compound)
    }

    /// Hands on the compounds of a list, one after the other. Only those that are kept cost memory.
    fn streamed_list(&mut self, len: usize, depth: usize) -> Result<(), NbtError> {
        let mark = self.path.enter_list();
        for index in 0..len {
            let before = self.memory;
            let entry = self.compound(depth + 1).map_err(|error| error.in_entry(&mark, index))?;
            if self.sink.entry(index, entry) == Kept::Nothing {
                self.memory = before;
                self.charge(HANDED_ON)?;
            }
        }
        self.path.leave(&mark);
        Ok(())
    }

    fn compound(&mut self, depth: usize) -> Result<Compound, NbtError> {
        self.check_depth(depth)?;
        let start = self.open.len();
        loop {
            let kind = self.byte("a Compound")?;
            if kind == id::END {
                return Ok(Compound::split_off(&mut self.open, start));
            }
            let name = self.name()?;
            self.charge(if self.open.len() == start { COMPOUND + ENTRY } else { ENTRY })?;
            let mark = self.path.enter_tag(&name);
            let tag = self.tag(kind, depth + 1)?;
            self.path.leave(&mark);
            self.make_open()?;
            self.open.push((name, tag));
        }
    }

    /// Makes room for one more tag of an open compound.
    fn make_open(&mut self) -> Result<(), NbtError> {
        let (len, room) = (self.open.len(), self.open.capacity());
        if len == room {
            let more = room.max(16);
            self.charge(more as u64 * ENTRY)?;
            self.open.reserve_exact(more);
        }
        Ok(())
    }
}
