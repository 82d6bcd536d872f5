use super::path::Path;
use super::tag::id;
use super::{Compound, Compounds, Endian, Part, Source, Tag, View};
use std::io::{self, Write};

/// Why a tree has no binary form.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    #[error("a text of {0} bytes is too long for NBT: at most 65,535")]
    LongText(usize),
    #[error("{0} entries are too many for NBT: at most 2,147,483,647")]
    LongArray(usize),
    #[error("a list holds both {0} and {1}: NBT lists hold one type")]
    MixedList(&'static str, &'static str),
    #[error("`{path}` was announced with {said} entries, but has {found}")]
    Announced { path: String, said: usize, found: usize },
    #[error(transparent)]
    Output(#[from] io::Error),
}

/// The big-endian binary form of a tree. The same tree always gives the same bytes.
pub fn write(root_name: &str, root: &Compound) -> Result<Vec<u8>, WriteError> {
    write_as(Endian::Big, root_name, root)
}

/// As [`write`], in either order of bytes.
pub fn write_as(endian: Endian, root_name: &str, root: &Compound) -> Result<Vec<u8>, WriteError> {
    let mut bytes = Vec::new();
    write_to(&mut bytes, endian, root_name, root, &())?;
    Ok(bytes)
}

/// Writes the binary form of a tree to `out`, in many small pieces. Arrays that `source` has come from there.
pub fn write_to(
    out: impl Write,
    endian: Endian,
    root_name: &str,
    root: &Compound,
    source: &dyn Source,
) -> Result<(), WriteError> {
    let mut writer = Writer { out, endian, path: Path::default(), source };
    writer.number([id::COMPOUND])?;
    writer.text(root_name)?;
    writer.compound(root)
}

struct Writer<'a, W> {
    out: W,
    endian: Endian,
    path: Path,
    source: &'a dyn Source,
}

impl<W: Write> Writer<'_, W> {
    /// Writes a number, given high byte first.
    fn number<const N: usize>(&mut self, bytes: [u8; N]) -> Result<(), WriteError> {
        Ok(self.out.write_all(&self.endian.arrange(bytes))?)
    }

    fn payload(&mut self, tag: &Tag) -> Result<(), WriteError> {
        match tag {
            Tag::Byte(n) => self.number(n.to_be_bytes()),
            Tag::Short(n) => self.number(n.to_be_bytes()),
            Tag::Int(n) => self.number(n.to_be_bytes()),
            Tag::Long(n) => self.number(n.to_be_bytes()),
            Tag::Float(n) => self.number(n.to_be_bytes()),
            Tag::Double(n) => self.number(n.to_be_bytes()),
            Tag::String(value) => self.text(value),
            Tag::ByteArray(numbers) => self.numbers(numbers, |n| n.to_be_bytes()),
            Tag::IntArray(numbers) => self.numbers(numbers, |n| n.to_be_bytes()),
            Tag::LongArray(numbers) => self.numbers(numbers, |n| n.to_be_bytes()),
            Tag::List(entries) => self.list(entries),
            Tag::Compound(tags) => self.compound(tags),
        }
    }

    /// The value of a compound's tag, which `source` may have.
    fn tag(&mut self, tag: &Tag) -> Result<(), WriteError> {
        let path = self.path.as_str();
        let (len, compounds) = match tag {
            Tag::ByteArray(_) => (self.source.len(path), None),
            Tag::List(_) => (None, self.source.compounds(path)),
            _ => (None, None),
        };
        match (len, compounds) {
            (Some(len), _) => self.streamed_array(len),
            (_, Some(compounds)) => self.streamed_list(compounds),
            (None, None) => self.payload(tag),
        }
    }

    fn streamed_array(&mut self, len: usize) -> Result<(), WriteError> {
        self.length(len)?;
        let mut counted = Counted { out: &mut self.out, written: 0 };
        self.source.write(self.path.as_str(), &mut counted)?;
        let found = counted.written;
        self.check_announced(len, found)
    }

    fn streamed_list(&mut self, compounds: Compounds) -> Result<(), WriteError> {
        self.number([if compounds.len == 0 { id::END } else { id::COMPOUND }])?;
        self.length(compounds.len)?;
        let mark = self.path.enter_list();
        let mut found = 0;
        for view in compounds.each {
            self.view(&view)?;
            found += 1;
        }
        self.path.leave(&mark);
        self.check_announced(compounds.len, found)
    }

    fn check_announced(&self, said: usize, found: usize) -> Result<(), WriteError> {
        match found == said {
            true => Ok(()),
            false => Err(WriteError::Announced { path: self.path.as_str().to_owned(), said, found }),
        }
    }

    fn view(&mut self, view: &View) -> Result<(), WriteError> {
        for (name, part) in view {
            let tag = match part {
                Part::Tag(tag) => *tag,
                Part::New(tag) => tag,
                Part::Compound(view) => {
                    self.head(id::COMPOUND, name)?;
                    self.view(view)?;
                    continue;
                }
            };
            self.head(tag.id(), name)?;
            self.payload(tag)?;
        }
        self.number([id::END])
    }

    fn head(&mut self, kind: u8, name: &str) -> Result<(), WriteError> {
        self.number([kind])?;
        self.text(name)
    }

    fn text(&mut self, text: &str) -> Result<(), WriteError> {
        // What is ASCII but for NUL, nearly everything, is the same in both forms.
        let plain = self.endian == Endian::Little || text.bytes().all(|byte| matches!(byte, 1..0x80));
        let bytes = if plain { text.as_bytes().into() } else { cesu8::to_java_cesu8(text) };
        let len = u16::try_from(bytes.len()).map_err(|_| WriteError::LongText(bytes.len()))?;
        self.number(len.to_be_bytes())?;
        Ok(self.out.write_all(&bytes)?)
    }

    fn length(&mut self, len: usize) -> Result<(), WriteError> {
        let short = i32::try_from(len).map_err(|_| WriteError::LongArray(len))?;
        self.number(short.to_be_bytes())
    }

    fn numbers<T, const N: usize>(
        &mut self,
        numbers: &[T],
        bytes: impl Fn(&T) -> [u8; N],
    ) -> Result<(), WriteError> {
        self.length(numbers.len())?;
        let mut buffer = Vec::with_capacity(8192);
        for step in numbers.chunks(buffer.capacity() / N) {
            buffer.clear();
            buffer.extend(step.iter().flat_map(|number| self.endian.arrange(bytes(number))));
            self.out.write_all(&buffer)?;
        }
        Ok(())
    }

    fn list(&mut self, entries: &[Tag]) -> Result<(), WriteError> {
        self.number([entries.first().map_or(id::END, Tag::id)])?;
        self.length(entries.len())?;
        let mark = self.path.enter_list();
        for entry in entries {
            if entry.id() != entries[0].id() {
                return Err(WriteError::MixedList(entries[0].kind(), entry.kind()));
            }
            self.payload(entry)?;
        }
        self.path.leave(&mark);
        Ok(())
    }

    fn compound(&mut self, tags: &Compound) -> Result<(), WriteError> {
        for (name, tag) in tags {
            self.head(tag.id(), name)?;
            let mark = self.path.enter_tag(name);
            self.tag(tag)?;
            self.path.leave(&mark);
        }
        self.number([id::END])
    }
}

struct Counted<W> {
    out: W,
    written: usize,
}

impl<W: Write> Write for Counted<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.out.write(bytes)?;
        self.written += written;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
