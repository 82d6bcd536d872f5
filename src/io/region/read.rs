use super::biomes::Gathered;
use super::chunk::{Blocks, Chunk, Column, blocks};
use super::leftovers::Leftovers;
use super::section::Section;
use super::world::World;
use super::{CHUNK, EDGE, versions};
use crate::block::{BlockState, PaletteFull, Version};
use crate::grid::Grid;
use crate::io::entities::{Found, Frame};
use crate::io::error::Size;
use crate::io::fields::Fields;
use crate::io::legacy::{self, Strangers};
use crate::io::{About, Content, Decoded, Format, Limits, ReadError, Warning};
use crate::nbt::Compound;
use crate::neighbours;
use crate::space::{Bounds, Cell};
use std::collections::BTreeMap;
use std::path::Path;

/// The blocks of a world within `part`, or all there are. `path` is a region file, a folder of them, or the folder of
/// a world that has one. Where the game has made no blocks yet the grid holds `structure_void`.
pub fn read_world(path: &Path, part: Option<Bounds>, limits: &Limits) -> Result<Decoded, ReadError> {
    decode(&World::at(path)?, part, limits)
}

/// All blocks of a region file.
pub fn decode_region(bytes: &[u8], limits: &Limits) -> Result<Decoded, ReadError> {
    decode(&World::of_bytes(bytes), None, limits)
}

fn decode(world: &World, wanted: Option<Bounds>, limits: &Limits) -> Result<Decoded, ReadError> {
    let part = wanted.map_or_else(|| extent(world, limits), Ok)?;
    let (grid, warnings) = read(world, part, wanted, limits)?;
    let about = About { format: Format::Region, version: None, place: Some(part.min) };
    Ok(Decoded { about, content: Content::Grid(grid), warnings })
}

fn read(
    world: &World,
    part: Bounds,
    wanted: Option<Bounds>,
    limits: &Limits,
) -> Result<(Grid, Vec<Warning>), ReadError> {
    let Bounds { min, max } = part;
    if min.cmpge(max).any() || min.min_element() < -EDGE || max.max_element() > EDGE {
        return Err(ReadError::NoPart { from: min, to: max });
    }
    let cells = part.volume();
    if cells > limits.max_cells {
        return Err(ReadError::TooManyCells { size: Size(part.size()), cells, limit: limits.max_cells });
    }
    let mut reading = Reading::new(part);
    let mut misplaced = 0;
    // What hangs in the part may have its middle in the next chunk.
    let around = wanted.map(|part| Bounds::new(part.min - 1, part.max + 1));
    for region in &world.blocks {
        misplaced += region.visit(around, limits, &mut |chunk| reading.add(chunk))?;
    }
    for region in &world.entities {
        misplaced += region.visit(around, limits, &mut |chunk| reading.add_entity_chunk(chunk))?;
    }
    if wanted.is_some() {
        reading.leave_outsiders();
    }
    let (grid, mut warnings) = reading.finish()?;
    warnings.extend((misplaced > 0).then_some(Warning::ChunksMisplaced(misplaced)));
    Ok((grid, warnings))
}

/// The smallest box around all blocks but air.
fn extent(world: &World, limits: &Limits) -> Result<Bounds, ReadError> {
    let mut extent: Option<Bounds> = None;
    for region in &world.blocks {
        region.visit(None, limits, &mut |chunk| {
            let Some(column) = chunk.column()? else { return Ok(()) };
            for found in &chunk.sections()? {
                let section = blocks(column, found, &mut Strangers::default())?;
                let filled = section.and_then(|(at, section)| filled(at, &section));
                extent = extent.into_iter().chain(filled).reduce(|all, next| all.union(&next));
            }
            Ok(())
        })?;
        if let Some(Bounds { min, max }) = extent.filter(|extent| extent.volume() > limits.max_cells) {
            return Err(ReadError::WorldTooLarge { from: min, to: max - 1, limit: limits.max_cells });
        }
    }
    extent.ok_or(ReadError::EmptyWorld)
}

/// The smallest box around the blocks of a section that are not air.
fn filled(at: Bounds, section: &Section) -> Option<Bounds> {
    let solid: Vec<bool> = section.states.iter().map(|state| !is_air(state)).collect();
    if section.ids.is_empty() {
        return solid.first().copied().unwrap_or_default().then_some(at);
    }
    let cells = at.cells().zip(&section.ids).filter(|&(_, &id)| solid[id as usize]);
    cells.map(|(cell, _)| Bounds::new(cell, cell + 1)).reduce(|all, next| all.union(&next))
}

fn is_air(state: &BlockState) -> bool {
    matches!(state.short_name(), "air" | "cave_air" | "void_air")
}

/// A part of the world while its chunks are read.
struct Reading {
    part: Bounds,
    grid: Grid,
    biomes: Gathered,
    /// Where the game has made blocks, and the version of their states.
    made: BTreeMap<Column, Option<Version>>,
    data_versions: Option<[i32; 2]>,
    numbered: Numbered,
    numbered_biomes: usize,
    found: Found,
    leftovers: Leftovers,
}

/// What chunks from before Minecraft 1.13 hold.
#[derive(Default)]
struct Numbered {
    chunks: usize,
    strangers: Strangers,
    with_items: usize,
    entities: usize,
}

impl Reading {
    fn new(part: Bounds) -> Reading {
        Reading {
            part,
            grid: Grid::new(part.size()),
            biomes: Gathered::new(part),
            made: BTreeMap::new(),
            data_versions: None,
            numbered: Numbered::default(),
            numbered_biomes: 0,
            found: Found::default(),
            leftovers: Leftovers::default(),
        }
    }

    fn add(&mut self, chunk: &Chunk) -> Result<(), ReadError> {
        let Some(column) = chunk.column()? else { return Ok(()) };
        if column.within(self.part).is_empty() {
            return self.add_entities(chunk);
        }
        let sections = chunk.sections()?;
        let told_by = chunk.told_by(&sections);
        self.add_version(column, chunk.states_version(told_by));
        self.numbered.chunks += usize::from(told_by == Blocks::Numbers);
        self.numbered_biomes += usize::from(chunk.has_numbered_biomes());
        self.leftovers.add(chunk, self.part);
        for (height, fields) in &sections {
            self.leftovers.add_section(fields);
            self.biomes.add(column.section(*height), fields)?;
        }
        for found in &sections {
            let Some((at, section)) = blocks(column, found, &mut self.numbered.strangers)? else { continue };
            self.fill(at, &section)?;
        }
        for fields in chunk.block_entities()? {
            self.add_block_entity(&fields, told_by)?;
        }
        let others = self.found.entities.len();
        self.add_entities(chunk)?;
        if told_by == Blocks::Numbers {
            self.numbered.entities += self.found.entities.len() - others;
        }
        Ok(())
    }

    fn add_version(&mut self, column: Column, data_version: Option<i32>) {
        self.made.insert(column, data_version.and_then(Version::of_data));
        let Some(version) = data_version else { return };
        let [lowest, highest] = self.data_versions.unwrap_or([version; 2]);
        self.data_versions = Some([lowest.min(version), highest.max(version)]);
    }

    fn fill(&mut self, at: Bounds, section: &Section) -> Result<(), ReadError> {
        let ids = section.states.iter().map(|state| self.grid.intern(state).map_err(full));
        let ids = ids.collect::<Result<Vec<u16>, ReadError>>()?;
        let inside = at.intersect(&self.part);
        if section.ids.is_empty() && !inside.is_empty() {
            let here = Bounds::new(inside.min - self.part.min, inside.max - self.part.min);
            self.grid.fill(here, ids[0]);
            return Ok(());
        }
        for cell in inside.cells() {
            let local = cell - at.min;
            let place = (local.y * CHUNK + local.z) * CHUNK + local.x;
            self.grid.set(cell - self.part.min, ids[section.ids[place as usize] as usize]);
        }
        Ok(())
    }

    fn add_block_entity(&mut self, fields: &Fields, blocks: Blocks) -> Result<(), ReadError> {
        let place = Cell::new(fields.get("x")?, fields.get("y")?, fields.get("z")?);
        if !self.part.contains(place) {
            return Ok(());
        }
        let place = place - self.part.min;
        let data = match blocks {
            Blocks::States => Some(fields.tags.clone()),
            Blocks::Numbers => self.modernised(place, fields)?,
        };
        if let Some(mut data) = data {
            // `keepPacked` is a note of the chunk to itself.
            for name in ["x", "y", "z", "keepPacked"] {
                data.remove(name);
            }
            self.grid.block_entities.insert(place.to_array(), data);
        }
        Ok(())
    }

    /// A block entity from before Minecraft 1.13. What it says of its block goes there.
    fn modernised(&mut self, place: Cell, fields: &Fields) -> Result<Option<Compound>, ReadError> {
        let (state, data) = legacy::modern(self.grid.get(place), fields)?;
        let id = self.grid.intern(&state).map_err(full)?;
        self.grid.set(place, id);
        self.numbered.with_items += usize::from(data.as_ref().is_some_and(legacy::holds_items));
        Ok(data)
    }

    /// A chunk of those that hold entities alone.
    fn add_entity_chunk(&mut self, chunk: &Chunk) -> Result<(), ReadError> {
        let column = Column::at(chunk.place).filter(|column| !column.within(self.part).is_empty());
        if column.is_some() {
            self.leftovers.add(chunk, self.part);
        }
        self.add_entities(chunk)
    }

    fn add_entities(&mut self, chunk: &Chunk) -> Result<(), ReadError> {
        self.found.add_list(&chunk.entities()?, Frame::at(self.part.min))
    }

    /// Leaves out what does not belong to the part.
    fn leave_outsiders(&mut self) {
        let inside = self.grid.bounds();
        self.found.entities.retain(|entity| inside.contains(entity.home()));
    }

    fn finish(mut self) -> Result<(Grid, Vec<Warning>), ReadError> {
        let unmade = self.leave_unmade_alone()?;
        self.grid.metadata.data_version = self.data_versions.map(|[_, highest]| highest);
        let unnamed = self.found.warning();
        self.grid.metadata.entities = self.found.entities;
        self.grid.metadata.biomes = self.biomes.finish();
        versions::bring_to_highest(&mut self.grid, self.part, &self.made).map_err(full)?;
        if self.numbered.chunks > 0 {
            legacy::name_upper_halves(&mut self.grid).map_err(full)?;
            neighbours::settle(&mut self.grid).map_err(full)?;
        }
        let mixed = self.data_versions.filter(|[lowest, highest]| lowest < highest);
        let warnings = [
            (unmade > 0).then_some(Warning::ChunksNotMade(unmade)),
            (self.numbered_biomes > 0).then_some(Warning::BiomesByNumber),
            unnamed,
            mixed.map(|[first, last]| Warning::MixedVersions { first, last }),
        ];
        let warnings = warnings.into_iter().flatten().chain(self.numbered.warnings());
        Ok((self.grid, warnings.chain(self.leftovers.warnings()).collect()))
    }

    /// Fills the chunks that the game has not made with `structure_void`. Gives their number.
    fn leave_unmade_alone(&mut self) -> Result<usize, ReadError> {
        let mut unmade = 0;
        for column in columns(self.part).filter(|column| !self.made.contains_key(column)) {
            let id = self.grid.intern(&BlockState::structure_void()).map_err(full)?;
            let within = column.within(self.part);
            self.grid.fill(Bounds::new(within.min - self.part.min, within.max - self.part.min), id);
            unmade += 1;
        }
        Ok(unmade)
    }
}

impl Numbered {
    fn warnings(&self) -> impl Iterator<Item = Warning> {
        let items = (self.with_items > 0).then_some(Warning::OldItems(self.with_items));
        let entities = (self.entities > 0).then_some(Warning::OldEntities(self.entities));
        self.strangers.warnings().chain(items).chain(entities)
    }
}

fn full(problem: PaletteFull) -> ReadError {
    ReadError::PaletteFull { path: "palette".to_owned(), problem }
}

/// The columns of the chunks that touch `part`.
pub(super) fn columns(part: Bounds) -> impl Iterator<Item = Column> {
    let chunks = |min: i32, max: i32| min.div_euclid(CHUNK)..=(max - 1).div_euclid(CHUNK);
    chunks(part.min.z, part.max.z)
        .flat_map(move |z| chunks(part.min.x, part.max.x).map(move |x| Column { x: x * CHUNK, z: z * CHUNK }))
}
