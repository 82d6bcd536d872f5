use crate::nbt::{Compound, Tag};
use std::fmt;

/// What a file is. Some of these are only named, so that an error can say what was found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    Schem,
    Obj,
    Litematic,
    Structure,
    Mcedit,
    Blueprint,
    Mcstructure,
    Axiom,
    MagicaVoxel,
    Region,
    Png,
    Jpeg,
    Zip,
    Xml,
    Json,
    Text,
}

impl Format {
    fn description(self) -> &'static str {
        match self {
            Format::Schem => "a Sponge schematic (.schem)",
            Format::Obj => "a Wavefront OBJ file",
            Format::Litematic => "a Litematica schematic (.litematic)",
            Format::Structure => "a vanilla structure (.nbt)",
            Format::Mcedit => "an MCEdit schematic (.schematic)",
            Format::Blueprint => "a Structurize blueprint (.blueprint)",
            Format::Mcstructure => "a Bedrock structure (.mcstructure)",
            Format::Axiom => "an Axiom blueprint (.bp)",
            Format::MagicaVoxel => "a MagicaVoxel model (.vox)",
            Format::Region => "a region of a world (.mca)",
            Format::Png => "a PNG picture",
            Format::Jpeg => "a JPEG picture",
            Format::Zip => "a ZIP archive",
            Format::Xml => "an XML text",
            Format::Json => "a JSON text",
            Format::Text => "a text without the vertices and faces of an OBJ",
        }
    }

    /// How the names of such files end.
    pub fn ending(self) -> &'static str {
        match self {
            Format::Schem => "schem",
            Format::Obj => "obj",
            Format::Litematic => "litematic",
            Format::Structure => "nbt",
            Format::Mcedit => "schematic",
            Format::Blueprint => "blueprint",
            Format::Mcstructure => "mcstructure",
            Format::Axiom => "bp",
            Format::MagicaVoxel => "vox",
            Format::Region => "mca",
            Format::Png => "png",
            Format::Jpeg => "jpg",
            Format::Zip => "zip",
            Format::Xml => "xml",
            Format::Json => "json",
            Format::Text => "txt",
        }
    }

    /// What unpacked `bytes` are by their first bytes; `None` for NBT, which its tags tell apart,
    /// and for the unknown.
    pub(super) fn of_bytes(bytes: &[u8]) -> Option<Format> {
        let magic = MAGIC.iter().find(|(magic, _)| bytes.starts_with(magic));
        magic
            .map(|(_, format)| *format)
            .or_else(|| is_mcstructure(bytes).then_some(Format::Mcstructure))
            .or_else(|| text_format(bytes))
            .or_else(|| is_region(bytes).then_some(Format::Region))
    }

    /// What NBT is by the tags of its root.
    pub(super) fn of_tags(root: &Compound) -> Option<Format> {
        let has = |name| root.contains_key(name);
        let nested = root.get("Schematic").is_some_and(|tag| matches!(tag, Tag::Compound(_)));
        let blocks = root.get("Blocks");
        match blocks {
            _ if nested || has("BlockData") => Some(Format::Schem),
            Some(Tag::Compound(_)) => Some(Format::Schem),
            Some(Tag::ByteArray(_)) => Some(Format::Mcedit),
            _ if matches!(root.get("Regions"), Some(Tag::Compound(_))) => Some(Format::Litematic),
            _ if has("size_x") => Some(Format::Blueprint),
            _ if has("size") && (has("palette") || has("palettes")) => Some(Format::Structure),
            _ if has("Palette") && has("Width") => Some(Format::Schem),
            _ => None,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.description())
    }
}

const MAGIC: [(&[u8], Format); 6] = [
    (&[0x0a, 0xe5, 0xbb, 0x36], Format::Axiom),
    (b"VOX ", Format::MagicaVoxel),
    (b"\x89PNG", Format::Png),
    (&[0xff, 0xd8, 0xff], Format::Jpeg),
    (b"PK\x03\x04", Format::Zip),
    (b"PK\x05\x06", Format::Zip),
];

/// Bedrock writes NBT with the low byte first, and these names early.
fn is_mcstructure(bytes: &[u8]) -> bool {
    let name = b"format_version";
    let head = &bytes[..bytes.len().min(32)];
    bytes.starts_with(&[0x0a, 0, 0, 3, 14, 0]) && head.windows(name.len()).any(|window| window == name)
}

const SECTOR: usize = 4096;

/// A region has no magic number: its table of chunks must point to places behind the table.
pub fn is_region(bytes: &[u8]) -> bool {
    let Some(table) = bytes.get(..SECTOR) else { return false };
    let (entries, _) = table.as_chunks::<4>();
    let mut chunks =
        entries.iter().map(|entry| u32::from_be_bytes(*entry)).filter(|&entry| entry != 0).peekable();
    let fits = |entry: u32| entry >> 8 >= 2 && ((entry >> 8) as usize) * SECTOR < bytes.len();
    bytes.len() > 2 * SECTOR && chunks.peek().is_some() && chunks.all(fits)
}

/// Text holds no control characters but white space; binary formats soon do.
fn text_format(bytes: &[u8]) -> Option<Format> {
    let head = &bytes[..bytes.len().min(1024)];
    let control = |b: &u8| b.is_ascii_control() && !b.is_ascii_whitespace();
    if head.is_empty() || head.iter().any(control) {
        return None;
    }
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    match text.chars().next() {
        Some('<') => Some(Format::Xml),
        Some('{' | '[') => Some(Format::Json),
        _ if text.lines().any(is_obj_line) => Some(Format::Obj),
        _ => Some(Format::Text),
    }
}

fn is_obj_line(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let keyword = words.next().is_some_and(|word| ["v", "vn", "vt", "f"].contains(&word));
    keyword
        && words
            .next()
            .is_some_and(|word| word.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)))
        && !line.contains("-->")
}
