//! Which files a world is read from, and its chunks one after the other.

use super::chunk::Chunk;
use super::table::{self, Entry, Stored};
use super::{CHUNK, ChunkProblem, EDGE, REGION};
use crate::io::{Limits, ReadError, read_bytes};
use crate::nbt;
use crate::space::Bounds;
use std::borrow::Cow;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// Region files with blocks, and those with entities.
pub(super) struct World<'a> {
    pub blocks: Vec<Region<'a>>,
    pub entities: Vec<Region<'a>>,
}

/// A region file.
pub(super) enum Region<'a> {
    Bytes(&'a [u8]),
    File(PathBuf),
}

impl<'a> World<'a> {
    pub fn of_bytes(bytes: &'a [u8]) -> World<'a> {
        World { blocks: vec![Region::Bytes(bytes)], entities: Vec::new() }
    }

    /// A region file, a folder of them, or the folder of a world that has one.
    pub fn at(path: &Path) -> Result<World<'a>, ReadError> {
        if !path.is_dir() {
            let folder = path.parent().unwrap_or(Path::new(""));
            let entities = entities_beside(folder).map(|folder| folder.join(file_name(path)));
            let entities = entities.into_iter().filter(|path| path.is_file()).map(Region::File);
            return Ok(World { blocks: vec![Region::File(path.to_owned())], entities: entities.collect() });
        }
        let inner = path.join("region");
        let folder = if inner.is_dir() { inner } else { path.to_owned() };
        let blocks = regions(&folder)?;
        let entities = entities_beside(&folder).map_or(Ok(Vec::new()), |folder| regions(&folder))?;
        match blocks.is_empty() {
            true => Err(ReadError::NoRegions),
            false => Ok(World { blocks, entities }),
        }
    }
}

fn entities_beside(folder: &Path) -> Option<PathBuf> {
    Some(folder.join("..").join("entities")).filter(|entities| entities.is_dir())
}

fn file_name(path: &Path) -> &Path {
    path.file_name().map_or(path, Path::new)
}

/// The region files of a folder, in order of their places.
fn regions<'a>(folder: &Path) -> Result<Vec<Region<'a>>, ReadError> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        found.extend(place(&path).map(|place| (place, path)));
    }
    found.sort_unstable();
    Ok(found.into_iter().map(|(_, path)| Region::File(path)).collect())
}

/// Reads `r.-1.2.mca`: the place of a region, in regions. No world reaches beyond the edge.
fn place(path: &Path) -> Option<[i32; 2]> {
    const FAR: i32 = EDGE / CHUNK / REGION + 1;
    let name = path.file_name()?.to_str()?;
    let (x, z) = name.strip_prefix("r.")?.strip_suffix(".mca")?.split_once('.')?;
    let number = |text: &str| text.parse().ok().filter(|n| (-FAR..=FAR).contains(n));
    Some([number(x)?, number(z)?])
}

/// The place of a chunk in the world, where that of its region is known.
fn chunk_at(region: [i32; 2], entry: Entry) -> [i32; 2] {
    [0, 1].map(|i| region[i] * REGION + entry.slot[i])
}

/// Visits the chunk of the NBT `plain` if it fits. Gives whether it does.
fn visit_if(
    plain: &[u8],
    fits: impl Fn(&Chunk) -> bool,
    limits: &Limits,
    visit: &mut dyn FnMut(&Chunk) -> Result<(), ReadError>,
) -> Result<bool, ReadError> {
    let (_, root, _) = nbt::read_first(plain, &limits.nbt())?;
    let chunk = Chunk::of(&root)?;
    match fits(&chunk) {
        true => visit(&chunk).map(|()| true),
        false => Ok(false),
    }
}

impl Region<'_> {
    /// Calls `visit` with each chunk that may touch `part`, or with all of them. Gives the number of those that say
    /// they belong elsewhere, which are left out: the game itself does not trust them.
    pub fn visit(
        &self,
        part: Option<Bounds>,
        limits: &Limits,
        visit: &mut dyn FnMut(&Chunk) -> Result<(), ReadError>,
    ) -> Result<usize, ReadError> {
        let named = |error: ReadError| match self {
            Region::Bytes(_) => error,
            Region::File(path) => {
                ReadError::Named { name: file_name(path).display().to_string(), error: Box::new(error) }
            }
        };
        self.visit_wanted(part, limits, visit).map_err(named)
    }

    fn visit_wanted(
        &self,
        part: Option<Bounds>,
        limits: &Limits,
        visit: &mut dyn FnMut(&Chunk) -> Result<(), ReadError>,
    ) -> Result<usize, ReadError> {
        let touches = |span, low| part.is_none_or(|part| touches(part, span, low));
        let place = self.place();
        if place.is_some_and(|place| !touches(REGION, place.map(|n| n * REGION))) {
            return Ok(0);
        }
        let bytes = self.bytes(limits)?;
        let mut left = limits.max_bytes;
        let mut misplaced = 0;
        for entry in table::entries(&bytes)? {
            let at = place.map(|place| chunk_at(place, entry));
            if at.is_some_and(|at| !touches(1, at)) {
                continue;
            }
            let in_chunk = |problem| ReadError::Chunk { slot: entry.slot, problem };
            let plain = self.unpack(&bytes, entry, left, limits).map_err(in_chunk)?;
            left -= plain.len() as u64;
            let fits = |chunk: &Chunk| at.map_or(chunk.slot() == entry.slot, |at| chunk.place == at);
            let fitting = visit_if(&plain, fits, limits, visit)
                .map_err(|error| in_chunk(ChunkProblem::Content(Box::new(error))))?;
            misplaced += usize::from(!fitting);
        }
        Ok(misplaced)
    }

    /// In regions; a file alone may have any name.
    fn place(&self) -> Option<[i32; 2]> {
        match self {
            Region::Bytes(_) => None,
            Region::File(path) => place(path),
        }
    }

    fn bytes(&self, limits: &Limits) -> Result<Cow<'_, [u8]>, ReadError> {
        match self {
            Region::Bytes(bytes) => Ok(Cow::Borrowed(bytes)),
            Region::File(path) => Ok(Cow::Owned(read_bytes(File::open(path)?, limits.max_bytes)?)),
        }
    }

    /// The NBT of a chunk, of which `left` bytes are allowed.
    fn unpack<'b>(
        &self,
        bytes: &'b [u8],
        entry: Entry,
        left: u64,
        limits: &Limits,
    ) -> Result<Cow<'b, [u8]>, ChunkProblem> {
        match entry.stored(bytes)? {
            Stored::Here(packing, packed) => packing.unpack(packed, left),
            Stored::Beside(packing) => {
                let packed = self.beside(entry, limits).ok_or(ChunkProblem::Beside)?;
                packing.unpack(&packed, left).map(|plain| Cow::Owned(plain.into_owned()))
            }
        }
        .map_err(|problem| match problem {
            ChunkProblem::TooLarge(_) => ChunkProblem::TooLarge(limits.max_bytes),
            problem => problem,
        })
    }

    /// The content of the file of a chunk that is too long for the region.
    fn beside(&self, entry: Entry, limits: &Limits) -> Option<Vec<u8>> {
        let (Region::File(path), Some(place)) = (self, self.place()) else { return None };
        let file = File::open(path.with_file_name(beside_name(chunk_at(place, entry)))).ok()?;
        read_bytes(file, limits.max_bytes).ok()
    }
}

/// The name of the file of a chunk that is too long for its region.
pub(super) fn beside_name([x, z]: [i32; 2]) -> String {
    format!("c.{x}.{z}.mcc")
}

/// Whether a square of `span` chunks reaches into `part`.
fn touches(part: Bounds, span: i32, low: [i32; 2]) -> bool {
    let reach = |low: i32, min: i32, max: i32| {
        let (low, span) = (i64::from(low) * i64::from(CHUNK), i64::from(span * CHUNK));
        low < i64::from(max) && low + span > i64::from(min)
    };
    reach(low[0], part.min.x, part.max.x) && reach(low[1], part.min.z, part.max.z)
}
