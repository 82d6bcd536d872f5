use super::chunk::Column;
use super::packing::{bits, pack};
use super::read::columns;
use super::section::{CELLS, LEAST_BITS};
use super::table::{HEAD, SECTOR};
use super::world::beside_name;
use super::{CHUNK, REGION, biomes};
use crate::block::{Palette, complete_in};
use crate::grid::{Grid, is_named};
use crate::io::entities::Frame;
use crate::io::{self, Lost, WriteError, states};
use crate::nbt::{self, Compound, Tag};
use crate::space::{Bounds, Cell};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

/// The first version of the game that keeps chunks as they are written: 1.18.
const OLDEST: i32 = 2860;

/// The heights of the usual world.
const HEIGHTS: std::ops::Range<i32> = -64..320;

/// The region files of a build, and what of it they have no place for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EncodedRegions {
    /// By their names within the folder of a world, as in `region/r.0.-1.mca`, in order.
    pub files: Vec<(String, Vec<u8>)>,
    pub lost: Vec<Lost>,
}

/// The region files of `grid` with its low corner at `at`. They hold whole chunks: what a world has there already
/// gives way. Chunks of nothing but `structure_void` are left out. The same grid always gives the same bytes.
pub fn encode_regions(grid: &Grid, at: Cell) -> Result<EncodedRegions, WriteError> {
    let part = part(grid, at)?;
    let data_version = grid.data_version();
    if data_version < OLDEST {
        return Err(WriteError::OldBlocks(data_version));
    }
    let build = Build { grid, at, part, data_version, states: States::of(grid) };
    let mut files = Vec::new();
    for (place, chunks) in by_region(columns(part).map(|column| column.chunk())) {
        region_files(&mut files, "region", place, chunks, |chunk| build.chunk(chunk))?;
    }
    let entities = build.entities();
    for (place, chunks) in by_region(entities.keys().copied()) {
        region_files(&mut files, "entities", place, chunks, |chunk| {
            Some(build.entity_chunk(chunk, entities.get(&chunk)?))
        })?;
    }
    Ok(EncodedRegions { files, lost: build.lost() })
}

/// Where the build stands in the world.
fn part(grid: &Grid, at: Cell) -> Result<Bounds, WriteError> {
    const EDGE: Cell = Cell::new(30_000_000, 2_032, 30_000_000);
    let high = at.saturating_add(grid.size());
    match at.cmpge(-EDGE).all() && high.cmple(EDGE).all() {
        true => Ok(Bounds::new(at, high)),
        false => Err(WriteError::OutsideWorlds { from: at, to: high }),
    }
}

/// Chunks by their regions, both in the order of their files.
fn by_region(chunks: impl Iterator<Item = [i32; 2]>) -> BTreeMap<[i32; 2], Vec<[i32; 2]>> {
    let mut regions: BTreeMap<[i32; 2], Vec<[i32; 2]>> = BTreeMap::new();
    for chunk in chunks {
        regions.entry(chunk.map(|n| n.div_euclid(REGION))).or_default().push(chunk);
    }
    regions
}

/// Adds the file of a region to `files`, and those of chunks too long for it. `content` gives the tags of a chunk;
/// `None` for one that is left out.
fn region_files(
    files: &mut Vec<(String, Vec<u8>)>,
    folder: &str,
    place: [i32; 2],
    chunks: Vec<[i32; 2]>,
    content: impl Fn([i32; 2]) -> Option<Compound>,
) -> Result<(), WriteError> {
    let mut region = vec![0; HEAD];
    let mut beside = Vec::new();
    for chunk in chunks {
        let Some(tags) = content(chunk) else { continue };
        let packed = deflate(&nbt::write("", &tags)?)?;
        if let Some(packed) = append(&mut region, chunk, packed).ok_or(WriteError::LongRegion(place))? {
            beside.push((format!("{folder}/{}", beside_name(chunk)), packed));
        }
    }
    if region.len() > HEAD {
        let [x, z] = place;
        files.push((format!("{folder}/r.{x}.{z}.mca"), region));
        files.extend(beside);
    }
    Ok(())
}

/// Puts a chunk at the end of `region` and into its table. Gives the chunk back where it is too long and stands in a
/// file of its own instead; `None` where the region is.
fn append(region: &mut Vec<u8>, chunk: [i32; 2], packed: Vec<u8>) -> Option<Option<Vec<u8>>> {
    const ZLIB: u8 = 2;
    const ZLIB_BESIDE: u8 = 128 + ZLIB;
    const MOST_SECTORS: usize = 255;
    let fits = 5 + packed.len() <= MOST_SECTORS * SECTOR;
    let (kind, content) = if fits { (ZLIB, &packed[..]) } else { (ZLIB_BESIDE, &[][..]) };
    let sector = u32::try_from(region.len() / SECTOR).ok().filter(|&sector| sector < 1 << 24)?;
    region.extend((content.len() as u32 + 1).to_be_bytes());
    region.push(kind);
    region.extend(content);
    region.resize(region.len().next_multiple_of(SECTOR), 0);
    let sectors = (region.len() / SECTOR) as u32 - sector;
    let [x, z] = chunk.map(|n| n.rem_euclid(REGION) as usize);
    let entry = 4 * (z * REGION as usize + x);
    region[entry..entry + 4].copy_from_slice(&(sector << 8 | sectors).to_be_bytes());
    Some((!fits).then_some(packed))
}

fn deflate(plain: &[u8]) -> std::io::Result<Vec<u8>> {
    const LEVEL: Compression = Compression::new(4);
    let mut encoder = ZlibEncoder::new(Vec::new(), LEVEL);
    encoder.write_all(plain)?;
    encoder.finish()
}

/// A grid at its place in the world.
struct Build<'a> {
    grid: &'a Grid,
    at: Cell,
    part: Bounds,
    data_version: i32,
    states: States,
}

/// The states of a grid by their numbers.
struct States {
    entries: Vec<Tag>,
    /// Of the cells to be left alone.
    void: Option<u16>,
}

impl States {
    fn of(grid: &Grid) -> States {
        let states = grid.palette().states();
        let version = grid.version();
        let void = states.iter().position(|state| state.short_name() == "structure_void");
        States {
            entries: states.iter().map(|state| states::write(&complete_in(state, version))).collect(),
            void: void.map(|id| id as u16),
        }
    }

    /// What stands in the world for a cell of the grid: in a new one, what is left alone is air.
    fn written(&self, id: u16) -> u16 {
        if Some(id) == self.void { Palette::AIR } else { id }
    }
}

impl Build<'_> {
    fn id(&self, cell: Cell) -> u16 {
        match self.part.contains(cell) {
            true => self.grid.id(cell - self.at),
            false => Palette::AIR,
        }
    }

    /// `None` for a chunk that is left alone.
    fn chunk(&self, chunk: [i32; 2]) -> Option<Compound> {
        let [x, z] = chunk;
        let column = Column { x: x * CHUNK, z: z * CHUNK };
        let within = column.within(self.part);
        if self.is_left_alone(within) {
            return None;
        }
        let heights = within.min.y.div_euclid(CHUNK)..=(within.max.y - 1).div_euclid(CHUNK);
        let sections = heights.clone().map(|height| self.section(height, column.section(height)));
        let empty = || Tag::Compound(Compound::new());
        let structures = compound([("References", empty()), ("starts", empty())]);
        Some(compound([
            ("DataVersion", Tag::Int(self.data_version)),
            ("xPos", Tag::Int(x)),
            ("yPos", Tag::Int((*heights.start()).min(HEIGHTS.start / CHUNK))),
            ("zPos", Tag::Int(z)),
            ("Status", Tag::String("minecraft:full".to_owned())),
            ("LastUpdate", Tag::Long(0)),
            ("InhabitedTime", Tag::Long(0)),
            ("isLightOn", Tag::Byte(0)),
            ("Heightmaps", empty()),
            ("structures", Tag::Compound(structures)),
            ("block_ticks", Tag::List(Vec::new())),
            ("fluid_ticks", Tag::List(Vec::new())),
            ("block_entities", self.block_entities(within)),
            ("sections", Tag::List(sections.map(Tag::Compound).collect())),
        ]))
    }

    fn is_left_alone(&self, within: Bounds) -> bool {
        self.states.void.is_some_and(|void| within.cells().all(|cell| self.id(cell) == void))
    }

    fn section(&self, height: i32, at: Bounds) -> Compound {
        // Which entry of the section's palette each number of the grid's has.
        let mut numbers = vec![None; self.states.entries.len()];
        let mut palette = Vec::new();
        let number = |cell| {
            let id = usize::from(self.states.written(self.id(cell)));
            *numbers[id].get_or_insert_with(|| {
                palette.push(self.states.entries[id].clone());
                (palette.len() - 1) as u16
            })
        };
        let ids: Vec<u16> = at.cells().map(number).collect();
        debug_assert_eq!(ids.len(), CELLS);
        let mut states = Compound::new();
        if palette.len() > 1 {
            let bits = bits(palette.len()).max(LEAST_BITS);
            states.insert("data".to_owned(), Tag::LongArray(pack(&ids, bits)));
        }
        states.insert("palette".to_owned(), Tag::List(palette));
        compound([
            ("Y", Tag::Byte(height as i8)),
            ("block_states", Tag::Compound(states)),
            ("biomes", Tag::Compound(biomes::write(self.grid, self.at, at))),
        ])
    }

    /// Those without an `id` stay away: the game cannot tell what they are of.
    fn block_entities(&self, within: Bounds) -> Tag {
        let places = self.grid.block_entities.iter().filter_map(|(&place, data)| {
            let place = self.at.checked_add(Cell::from_array(place))?;
            (within.contains(place) && is_named(data)).then(|| {
                let mut data = data.clone();
                let place = ["x", "y", "z"].into_iter().zip(place.to_array());
                data.extend(place.map(|(name, n)| (name.to_owned(), Tag::Int(n))));
                Tag::Compound(data)
            })
        });
        Tag::List(places.collect())
    }

    /// The entities by the chunks that they are in.
    fn entities(&self) -> BTreeMap<[i32; 2], Vec<Tag>> {
        let mut chunks: BTreeMap<[i32; 2], Vec<Tag>> = BTreeMap::new();
        for entity in self.grid.metadata.named_entities() {
            // Here the game goes by the place and not by the block.
            let cell = (glam::DVec3::from_array(entity.place) + self.at.as_dvec3()).floor().as_ivec3();
            let chunk = [cell.x, cell.z].map(|n| n.div_euclid(CHUNK));
            let data = io::entities::write(entity, Frame::at(self.at), self.data_version);
            chunks.entry(chunk).or_default().push(data);
        }
        chunks
    }

    fn entity_chunk(&self, [x, z]: [i32; 2], entities: &[Tag]) -> Compound {
        compound([
            ("DataVersion", Tag::Int(self.data_version)),
            ("Position", Tag::IntArray(vec![x, z])),
            ("Entities", Tag::List(entities.to_vec())),
        ])
    }

    fn lost(&self) -> Vec<Lost> {
        let outside = self.part.min.y < HEIGHTS.start || self.part.max.y > HEIGHTS.end;
        let lost = [
            self.left_alone(),
            outside.then_some(Lost::OutsideHeights),
            self.block_entities_left_alone(),
            Lost::unnamed_block_entities(self.grid),
            Lost::unnamed_entities(self.grid),
            biomes::are_finer_than_cubes(self.grid, self.at).then_some(Lost::Biomes),
            Lost::offset(self.grid),
            Lost::metadata(self.grid),
            Lost::own(self.grid, None),
            Lost::regions(self.grid),
            Lost::variants(self.grid),
        ];
        lost.into_iter().flatten().collect()
    }

    /// Those in chunks that are left alone: there is no block that they could be of.
    fn block_entities_left_alone(&self) -> Option<Lost> {
        self.states.void?;
        let alone: BTreeSet<[i32; 2]> = columns(self.part)
            .filter(|column| self.is_left_alone(column.within(self.part)))
            .map(Column::chunk)
            .collect();
        let places = self.grid.block_entities.iter().filter(|(_, data)| is_named(data));
        let chunk = |[x, _, z]: [i32; 3]| [self.at.x + x, self.at.z + z].map(|n| n.div_euclid(CHUNK));
        let count = places.filter(|(place, _)| alone.contains(&chunk(**place))).count();
        (count > 0).then_some(Lost::BlockEntities(count))
    }

    /// Cells to be left alone in chunks that are written.
    fn left_alone(&self) -> Option<Lost> {
        let void = self.states.void?;
        let in_chunk = |column: Column| {
            let count = column.within(self.part).cells().filter(|&cell| self.id(cell) == void).count();
            if self.is_left_alone(column.within(self.part)) { 0 } else { count }
        };
        let count: usize = columns(self.part).map(in_chunk).sum();
        (count > 0).then_some(Lost::LeftAlone(count))
    }
}

fn compound<const N: usize>(tags: [(&str, Tag); N]) -> Compound {
    tags.map(|(name, tag)| (name.to_owned(), tag)).into()
}
