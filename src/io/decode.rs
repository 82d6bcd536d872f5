use super::{
    About, Format, Limits, Options, ReadError, Warning, axiom, blueprint, gzip, litematic, magica, mcedit,
    mcstructure, obj, region, schem, structure,
};
use crate::grid::{Grid, LabelledBoxes};
use crate::nbt::{self, Compound, Endian, Kept, Sink};
use std::borrow::Cow;
use std::io::{self, BufRead, BufReader, Read};

/// What a file holds.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "one is made per file")]
pub enum Content {
    Grid(Grid),
    Boxes(LabelledBoxes),
}

/// What a file holds, and what reading it had to put right.
#[derive(Clone, Debug)]
pub struct Decoded {
    pub about: About,
    pub content: Content,
    pub warnings: Vec<Warning>,
}

/// The content of a file, by what its bytes say it is.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded, ReadError> {
    decode_with(bytes, limits, &Options::default())
}

/// As [`decode`], with a choice where there is one.
pub fn decode_with(bytes: &[u8], limits: &Limits, options: &Options) -> Result<Decoded, ReadError> {
    let opened = open(bytes, limits)?;
    match (&options.region, opened.format()) {
        (None, _) | (_, Format::Litematic) => {}
        (Some(name), _) => return Err(ReadError::NoRegion { name: name.clone(), names: Vec::new() }),
    }
    match opened {
        Opened::Tags(format, tags) => decode_tags(format, tags, limits, options),
        Opened::Bytes(format, plain) => decode_bytes(format, &plain, limits, options),
    }
}

/// The content of a format that is big-endian NBT.
fn decode_tags(format: Format, tags: Tags, limits: &Limits, options: &Options) -> Result<Decoded, ReadError> {
    let (about, root) = (About::of_tags(format, &tags.root), &tags.root);
    let (grid, mut warnings) = match format {
        Format::Schem => schem::decode(tags.root, tags.long.schem, limits)?,
        Format::Litematic => litematic::decode(root, limits, options.region.as_deref())?,
        Format::Structure => structure::decode(root, tags.long.structure, limits, options.jigsaws)?,
        Format::Mcedit => mcedit::decode(root, limits)?,
        Format::Blueprint => blueprint::decode(root, limits)?,
        _ => return Err(ReadError::Unreadable(format)),
    };
    warnings.extend((tags.trailing > 0).then_some(Warning::Trailing(tags.trailing)));
    Ok(Decoded { about, content: Content::Grid(grid), warnings })
}

fn decode_bytes(
    format: Format,
    plain: &[u8],
    limits: &Limits,
    options: &Options,
) -> Result<Decoded, ReadError> {
    let about = About { format, version: None, place: None };
    let (grid, warnings) = match format {
        Format::Mcstructure => mcstructure::decode(plain, limits)?,
        Format::Axiom => axiom::decode(plain, limits)?,
        Format::MagicaVoxel => magica::decode(plain, limits)?,
        Format::Region => return region::decode_region(plain, limits),
        Format::Obj => {
            let boxes = obj::decode_obj_boxes(plain, options.scale)?;
            return Ok(Decoded { about, content: Content::Boxes(boxes), warnings: Vec::new() });
        }
        _ => return Err(ReadError::Unreadable(format)),
    };
    Ok(Decoded { about, content: Content::Grid(grid), warnings })
}

/// What format the bytes of a file are in.
pub fn sniff(bytes: &[u8], limits: &Limits) -> Result<Format, ReadError> {
    open(bytes, limits).map(|opened| opened.format())
}

/// A file as far as all formats are alike.
#[expect(clippy::large_enum_variant, reason = "one is made per file")]
enum Opened<'a> {
    /// Big-endian NBT, read as a stream.
    Tags(Format, Tags),
    /// Anything else, unpacked.
    Bytes(Format, Cow<'a, [u8]>),
}

impl Opened<'_> {
    fn format(&self) -> Format {
        match self {
            Opened::Tags(format, _) | Opened::Bytes(format, _) => *format,
        }
    }
}

struct Tags {
    root: Compound,
    long: Long,
    /// The bytes after the root's end.
    trailing: u64,
}

/// What is too long for a tree of tags, of formats that are told apart only when all tags are there.
struct Long {
    schem: schem::Incoming,
    structure: structure::Incoming,
    /// Whose list is coming in.
    list: Format,
}

impl Sink for Long {
    fn wants(&mut self, path: &str, len: usize) -> bool {
        self.schem.wants(path, len)
    }

    fn take(&mut self, bytes: &[u8]) {
        self.schem.take(bytes);
    }

    fn wants_list(&mut self, path: &str) -> bool {
        let takers: [(Format, &mut dyn Sink); 2] =
            [(Format::Schem, &mut self.schem), (Format::Structure, &mut self.structure)];
        let taker = takers.into_iter().find_map(|(format, sink)| sink.wants_list(path).then_some(format));
        self.list = taker.unwrap_or(self.list);
        taker.is_some()
    }

    fn entry(&mut self, index: usize, compound: Compound) -> Kept {
        match self.list {
            Format::Structure => self.structure.entry(index, compound),
            _ => self.schem.entry(index, compound),
        }
    }
}

/// As many bytes as tell NBT from anything else.
const HEAD: u64 = 1024;

fn open<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Opened<'a>, ReadError> {
    let (head, content) = gzip::peek(gzip::open(bytes, limits.max_bytes)?, HEAD)?;
    if head.is_empty() {
        return Err(ReadError::Empty);
    }
    // The type of a compound; it is a line break, too.
    if head[0] == 10 && Format::of_bytes(&head).is_none() {
        let tags = tags(content, gzip::most_unpacked(bytes.len()), limits)?;
        return match Format::of_tags(&tags.root) {
            Some(format) => Ok(Opened::Tags(format, tags)),
            None => Err(ReadError::NoSchematic(names(&tags.root))),
        };
    }
    let plain = if gzip::is_gzip(bytes) { Cow::Owned(all(content)?) } else { Cow::Borrowed(bytes) };
    match Format::of_bytes(&plain) {
        Some(format) => Ok(Opened::Bytes(format, plain)),
        None => Err(ReadError::Unknown(first_bytes(&plain))),
    }
}

fn tags(content: Box<dyn BufRead + '_>, most: usize, limits: &Limits) -> Result<Tags, ReadError> {
    // The layers below are too deep to be asked for every number.
    let mut content = BufReader::with_capacity(gzip::CHUNK, content);
    let mut long = Long {
        schem: schem::Incoming::new(most, limits),
        structure: structure::Incoming::default(),
        list: Format::Schem,
    };
    let (_, root, _) = nbt::read_from(&mut content, Endian::Big, &limits.nbt(), &mut long)?;
    // To the very end, where gzip keeps its checksum.
    let trailing = io::copy(&mut content, &mut io::sink())?;
    Ok(Tags { root, long, trailing })
}

fn all(mut content: Box<dyn BufRead + '_>) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    content.read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn first_bytes(bytes: &[u8]) -> String {
    let head: Vec<String> = bytes.iter().take(8).map(|b| format!("{b:02x}")).collect();
    head.join(" ")
}

fn names(root: &Compound) -> String {
    const SHOWN: usize = 8;
    match root.len() {
        0 => "nothing".to_owned(),
        len => {
            let shown: Vec<String> = root.keys().take(SHOWN).map(|name| format!("`{name}`")).collect();
            format!("{}{}", shown.join(", "), if len > SHOWN { ", ..." } else { "" })
        }
    }
}
