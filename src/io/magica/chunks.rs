//! The bytes of a file: chunks, numbers with the low byte first, texts and dictionaries.

use super::{MOST, MagicaError};
use std::collections::{BTreeMap, BTreeSet};

/// What a file holds, chunks that vox has no use for aside.
#[derive(Default)]
pub(super) struct File<'a> {
    pub models: Vec<Model<'a>>,
    /// By their numbers.
    pub nodes: BTreeMap<u32, Node>,
    pub hidden_layers: BTreeSet<u32>,
    /// Entry `i` is the colour of number `i` + 1.
    pub palette: Option<&'a [[u8; 4]]>,
}

pub(super) struct Model<'a> {
    /// Along x, y and z, of which z is up.
    pub size: [i32; 3],
    /// Place and colour.
    pub voxels: &'a [[u8; 4]],
}

/// A part of the scene.
pub(super) enum Node {
    Transform {
        child: u32,
        layer: u32,
        attributes: Dictionary,
        frame: Dictionary,
    },
    Group(Vec<u32>),
    /// The model of the first frame.
    Shape(Option<u32>),
}

pub(super) type Dictionary = BTreeMap<String, String>;

pub(super) fn parse(bytes: &[u8]) -> Result<File<'_>, MagicaError> {
    // "VOX " and the version.
    let mut reader = Reader { chunk: "VOX ".to_owned(), bytes };
    reader.take(8)?;
    let main = reader.next()?;
    if main.chunk != "MAIN" {
        return Err(MagicaError::NoMain(main.chunk));
    }
    let mut file = File::default();
    let mut size = None;
    while !reader.bytes.is_empty() {
        let mut chunk = reader.next()?;
        match &chunk.chunk[..] {
            "SIZE" => size = Some([chunk.number()?, chunk.number()?, chunk.number()?]),
            "XYZI" => file.models.extend(model(&mut chunk, size, file.models.len())?),
            "RGBA" => file.palette = Some(chunk.quadruples(chunk.bytes.len() / 4)?),
            "LAYR" => {
                let layer = chunk.number()?;
                file.hidden_layers.extend(is_hidden(&chunk.dictionary()?).then_some(layer));
            }
            "nTRN" | "nGRP" | "nSHP" => file.nodes.extend([chunk.node()?]),
            _ => {}
        }
    }
    Ok(file)
}

pub(super) fn is_hidden(attributes: &Dictionary) -> bool {
    attributes.get("_hidden").is_some_and(|value| value == "1")
}

fn model<'a>(
    chunk: &mut Reader<'a>,
    size: Option<[u32; 3]>,
    model: usize,
) -> Result<Option<Model<'a>>, MagicaError> {
    let Some(size) = size else { return Ok(None) };
    if size.iter().any(|n| !(1..=MOST as u32).contains(n)) {
        return Err(MagicaError::Size { model, size });
    }
    let count = chunk.number()? as usize;
    Ok(Some(Model { size: size.map(|n| n as i32), voxels: chunk.quadruples(count)? }))
}

/// What is left of the chunk called `chunk`.
struct Reader<'a> {
    chunk: String,
    bytes: &'a [u8],
}

impl<'a> Reader<'a> {
    fn take(&mut self, needed: u64) -> Result<&'a [u8], MagicaError> {
        let cut_off = || MagicaError::CutOff { chunk: self.chunk.clone(), needed, left: self.bytes.len() };
        let len = usize::try_from(needed).map_err(|_| cut_off())?;
        let (taken, rest) = self.bytes.split_at_checked(len).ok_or_else(cut_off)?;
        self.bytes = rest;
        Ok(taken)
    }

    fn number(&mut self) -> Result<u32, MagicaError> {
        let bytes = self.take(4)?;
        Ok(bytes.iter().rev().fold(0, |number, &byte| number << 8 | u32::from(byte)))
    }

    fn quadruples(&mut self, count: usize) -> Result<&'a [[u8; 4]], MagicaError> {
        Ok(self.take(count as u64 * 4)?.as_chunks::<4>().0)
    }

    fn text(&mut self) -> Result<String, MagicaError> {
        let len = self.number()?;
        Ok(String::from_utf8_lossy(self.take(len.into())?).into_owned())
    }

    fn dictionary(&mut self) -> Result<Dictionary, MagicaError> {
        let count = self.number()?;
        (0..count).map(|_| Ok((self.text()?, self.text()?))).collect()
    }

    /// The chunk that comes next. Chunks within it come after it: only `MAIN` has such.
    fn next(&mut self) -> Result<Reader<'a>, MagicaError> {
        let chunk = String::from_utf8_lossy(self.take(4)?).into_owned();
        let (len, _) = (self.number()?, self.number()?);
        let mut reader = Reader { chunk, bytes: self.bytes };
        let bytes = reader.take(len.into())?;
        self.bytes = reader.bytes;
        Ok(Reader { bytes, ..reader })
    }

    fn node(&mut self) -> Result<(u32, Node), MagicaError> {
        let (number, attributes) = (self.number()?, self.dictionary()?);
        Ok((
            number,
            match &self.chunk[..] {
                "nTRN" => self.transform(attributes)?,
                "nGRP" => {
                    let count = self.number()?;
                    Node::Group((0..count).map(|_| self.number()).collect::<Result<_, _>>()?)
                }
                _ => {
                    let count = self.number()?;
                    Node::Shape((count > 0).then(|| self.number()).transpose()?)
                }
            },
        ))
    }

    fn transform(&mut self, attributes: Dictionary) -> Result<Node, MagicaError> {
        let child = self.number()?;
        let _reserved = self.number()?;
        let layer = self.number()?;
        let frames = self.number()?;
        let frame = if frames > 0 { self.dictionary()? } else { Dictionary::new() };
        Ok(Node::Transform { child, layer, attributes, frame })
    }
}
