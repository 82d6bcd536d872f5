use super::tag::id;
use super::{Compound, Tag};

/// Why a tree has no binary form.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum WriteError {
    #[error("a text of {0} bytes is too long for NBT: at most 65,535")]
    LongText(usize),
    #[error("{0} entries are too many for NBT: at most 2,147,483,647")]
    LongArray(usize),
    #[error("a list holds both {0} and {1}: NBT lists hold one type")]
    MixedList(&'static str, &'static str),
}

/// The big-endian binary form of a tree. The same tree always gives the same bytes.
pub fn write(root_name: &str, root: &Compound) -> Result<Vec<u8>, WriteError> {
    let mut out = vec![id::COMPOUND];
    text(&mut out, root_name)?;
    compound(&mut out, root)?;
    Ok(out)
}

fn payload(out: &mut Vec<u8>, tag: &Tag) -> Result<(), WriteError> {
    match tag {
        Tag::Byte(n) => out.extend(n.to_be_bytes()),
        Tag::Short(n) => out.extend(n.to_be_bytes()),
        Tag::Int(n) => out.extend(n.to_be_bytes()),
        Tag::Long(n) => out.extend(n.to_be_bytes()),
        Tag::Float(n) => out.extend(n.to_be_bytes()),
        Tag::Double(n) => out.extend(n.to_be_bytes()),
        Tag::String(value) => text(out, value)?,
        Tag::ByteArray(numbers) => {
            length(out, numbers.len())?;
            out.extend(numbers.iter().map(|n| n.cast_unsigned()));
        }
        Tag::IntArray(numbers) => {
            length(out, numbers.len())?;
            out.extend(numbers.iter().flat_map(|n| n.to_be_bytes()));
        }
        Tag::LongArray(numbers) => {
            length(out, numbers.len())?;
            out.extend(numbers.iter().flat_map(|n| n.to_be_bytes()));
        }
        Tag::List(entries) => list(out, entries)?,
        Tag::Compound(tags) => compound(out, tags)?,
    }
    Ok(())
}

fn text(out: &mut Vec<u8>, text: &str) -> Result<(), WriteError> {
    let bytes = cesu8::to_java_cesu8(text);
    let len = u16::try_from(bytes.len()).map_err(|_| WriteError::LongText(bytes.len()))?;
    out.extend(len.to_be_bytes());
    out.extend_from_slice(&bytes);
    Ok(())
}

fn length(out: &mut Vec<u8>, len: usize) -> Result<(), WriteError> {
    let short = i32::try_from(len).map_err(|_| WriteError::LongArray(len))?;
    out.extend(short.to_be_bytes());
    Ok(())
}

fn list(out: &mut Vec<u8>, entries: &[Tag]) -> Result<(), WriteError> {
    out.push(entries.first().map_or(id::END, Tag::id));
    length(out, entries.len())?;
    for entry in entries {
        if entry.id() != entries[0].id() {
            return Err(WriteError::MixedList(entries[0].kind(), entry.kind()));
        }
        payload(out, entry)?;
    }
    Ok(())
}

fn compound(out: &mut Vec<u8>, tags: &Compound) -> Result<(), WriteError> {
    for (name, tag) in tags {
        out.push(tag.id());
        text(out, name)?;
        payload(out, tag)?;
    }
    out.push(id::END);
    Ok(())
}
