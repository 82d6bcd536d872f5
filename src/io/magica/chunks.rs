//! The bytes of a file: chunks, numbers with the low byte first, texts and dictionaries.

use super::{MOST, MagicaError};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// What a file holds, chunks that vox has no use for aside.
#[derive(Default)]
pub(super) struct File<'a> {
    pub models: Vec<Model<'a>>,
    /// By their numbers.
    pub nodes: BTreeMap<u32, Node<'a>>,
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
pub(super) enum Node<'a> {
    Transform(Transform<'a>),
    Group(Vec<u32>),
    Shape(Shape),
}

pub(super) struct Shape {
    /// The model of the first frame.
    pub model: Option<u32>,
    pub later_frames: usize,
}

pub(super) struct Transform<'a> {
    pub child: u32,
    pub layer: u32,
    pub hidden: bool,
    /// Those of the first frame.
    pub rotation: Option<Cow<'a, str>>,
    pub translation: Option<Cow<'a, str>>,
    pub later_frames: usize,
}

impl Node<'_> {
    pub fn later_frames(&self) -> usize {
        match self {
            Node::Transform(Transform { later_frames, .. }) | Node::Shape(Shape { later_frames, .. }) => {
                *later_frames
            }
            Node::Group(_) => 0,
        }
    }
}

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
                file.hidden_layers.extend(chunk.is_hidden()?.then_some(layer));
            }
            "nTRN" | "nGRP" | "nSHP" => file.nodes.extend([chunk.node()?]),
            _ => {}
        }
    }
    Ok(file)
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

    fn text(&mut self) -> Result<Cow<'a, str>, MagicaError> {
        let len = self.number()?;
        Ok(String::from_utf8_lossy(self.take(len.into())?))
    }

    /// The values of a dictionary for `keys`; the last one of several. Nothing else of it is kept, as an entry of a few
    /// bytes would take many times that.
    fn dictionary<const N: usize>(
        &mut self,
        keys: [&str; N],
    ) -> Result<[Option<Cow<'a, str>>; N], MagicaError> {
        let mut values = [const { None }; N];
        for _ in 0..self.number()? {
            let (key, value) = (self.text()?, self.text()?);
            if let Some(at) = keys.iter().position(|&wanted| wanted == key) {
                values[at] = Some(value);
            }
        }
        Ok(values)
    }

    /// What a dictionary of attributes says.
    fn is_hidden(&mut self) -> Result<bool, MagicaError> {
        let [hidden] = self.dictionary(["_hidden"])?;
        Ok(hidden.is_some_and(|value| value == "1"))
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

    fn node(&mut self) -> Result<(u32, Node<'a>), MagicaError> {
        let (number, hidden) = (self.number()?, self.is_hidden()?);
        Ok((
            number,
            match &self.chunk[..] {
                "nTRN" => Node::Transform(self.transform(hidden)?),
                "nGRP" => {
                    let count = self.number()?;
                    Node::Group((0..count).map(|_| self.number()).collect::<Result<_, _>>()?)
                }
                _ => Node::Shape(self.shape()?),
            },
        ))
    }

    fn transform(&mut self, hidden: bool) -> Result<Transform<'a>, MagicaError> {
        let child = self.number()?;
        let _reserved = self.number()?;
        let layer = self.number()?;
        let frames = self.number()?;
        let [rotation, translation] = if frames > 0 { self.dictionary(["_r", "_t"])? } else { [None, None] };
        let later_frames = self.later_frames(frames, |frame| frame.dictionary([]).map(|[]| ()));
        Ok(Transform { child, layer, hidden, rotation, translation, later_frames })
    }

    fn shape(&mut self) -> Result<Shape, MagicaError> {
        let frames = self.number()?;
        let model = (frames > 0).then(|| self.number()).transpose()?;
        let later_frames = self.later_frames(frames, |frame| {
            // The attributes of the model before come first.
            let [] = frame.dictionary([])?;
            frame.number().map(|_| ())
        });
        Ok(Shape { model, later_frames })
    }

    /// How many of `frames` are there after the first: a count alone says nothing.
    fn later_frames(
        &mut self,
        frames: u32,
        mut skip: impl FnMut(&mut Self) -> Result<(), MagicaError>,
    ) -> usize {
        (1..frames).map_while(|_| skip(self).ok()).count()
    }
}
