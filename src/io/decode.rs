use super::{
    About, Format, Limits, Options, ReadError, Scale, Warning, axiom, blueprint, gzip, litematic, magica,
    mcedit, mcstructure, obj, region, schem, structure,
};
use crate::grid::{Grid, LabelledBoxes};
use crate::nbt::{self, Compound, NbtError, NbtProblem};

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
    pub content: Content,
    pub warnings: Vec<Warning>,
}

/// The content of a file, by what its bytes say it is. OBJ coordinates count in blocks.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Decoded, ReadError> {
    decode_with(bytes, limits, &Options::default())
}

/// As [`decode`], where OBJ coordinates count in units of `scale`.
pub fn decode_scaled(bytes: &[u8], limits: &Limits, scale: Scale) -> Result<Decoded, ReadError> {
    decode_with(bytes, limits, &Options { scale, ..Options::default() })
}

/// As [`decode`], with a choice where there is one.
pub fn decode_with(bytes: &[u8], limits: &Limits, options: &Options) -> Result<Decoded, ReadError> {
    let plain = gzip::unpack(bytes, limits.max_bytes)?;
    let parsed = parse(&plain, limits)?;
    match (&options.region, parsed.format()) {
        (None, _) | (_, Format::Litematic) => {}
        (Some(name), _) => return Err(ReadError::NoRegion { name: name.clone(), names: Vec::new() }),
    }
    match parsed {
        Parsed::Tags(Format::Schem, root) => schem::decode(&root, limits).map(of_grid),
        Parsed::Tags(Format::Litematic, root) => {
            litematic::decode(&root, limits, options.region.as_deref()).map(of_grid)
        }
        Parsed::Tags(Format::Structure, root) => {
            structure::decode(&root, limits, options.jigsaws).map(of_grid)
        }
        Parsed::Tags(Format::Mcedit, root) => mcedit::decode(&root, limits).map(of_grid),
        Parsed::Tags(Format::Blueprint, root) => blueprint::decode(&root, limits).map(of_grid),
        Parsed::Bytes(Format::MagicaVoxel) => magica::decode(&plain, limits).map(of_grid),
        Parsed::Bytes(Format::Region) => region::decode(&plain, limits).map(of_grid),
        Parsed::Bytes(Format::Mcstructure) => mcstructure::decode(&plain, limits).map(of_grid),
        Parsed::Bytes(Format::Axiom) => axiom::decode(&plain, limits).map(of_grid),
        Parsed::Bytes(Format::Obj) => {
            let boxes = obj::decode_obj_boxes(&plain, options.scale)?;
            Ok(Decoded { content: Content::Boxes(boxes), warnings: Vec::new() })
        }
        Parsed::Tags(format, _) | Parsed::Bytes(format) => Err(ReadError::Unreadable(format)),
    }
}

fn of_grid((grid, warnings): (Grid, Vec<Warning>)) -> Decoded {
    Decoded { content: Content::Grid(grid), warnings }
}

/// What format the bytes of a file are in.
pub fn sniff(bytes: &[u8], limits: &Limits) -> Result<Format, ReadError> {
    about(bytes, limits).map(|about| about.format)
}

/// What the bytes of a file say of how they are written.
pub fn about(bytes: &[u8], limits: &Limits) -> Result<About, ReadError> {
    let plain = gzip::unpack(bytes, limits.max_bytes)?;
    parse(&plain, limits).map(|parsed| match parsed {
        Parsed::Tags(format, root) => About::of_tags(format, &root),
        Parsed::Bytes(format) => About { format, version: None },
    })
}

enum Parsed {
    Tags(Format, Compound),
    Bytes(Format),
}

impl Parsed {
    fn format(&self) -> Format {
        match self {
            Parsed::Tags(format, _) | Parsed::Bytes(format) => *format,
        }
    }
}

fn parse(plain: &[u8], limits: &Limits) -> Result<Parsed, ReadError> {
    if plain.is_empty() {
        return Err(ReadError::Empty);
    }
    if let Some(format) = Format::of_bytes(plain) {
        return Ok(Parsed::Bytes(format));
    }
    // The type of a compound.
    if plain[0] != 10 {
        return Err(ReadError::Unknown(first_bytes(plain)));
    }
    let root = tags(plain, limits)?;
    match Format::of_tags(&root) {
        Some(format) => Ok(Parsed::Tags(format, root)),
        None => Err(ReadError::NoSchematic(names(&root))),
    }
}

/// Files that were appended to themselves hold nothing new, so they are read as one; anything else
/// after the end is a sign of damage.
fn tags(plain: &[u8], limits: &Limits) -> Result<Compound, NbtError> {
    let (_, root, end) = nbt::read_first(plain, &limits.nbt())?;
    let (first, rest) = plain.split_at(end);
    match rest.chunks(end).all(|copy| copy == first) {
        true => Ok(root),
        false => Err(NbtError::new(end, NbtProblem::Trailing(rest.len()))),
    }
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
