use super::entities;
use super::joint::Joint;
use crate::block::BlockState;
use crate::grid::{Dialect, Grid};
use crate::io::error::Size;
use crate::io::{Encoded, Lost, WriteError, gzip, states};
use crate::nbt::{self, Compound, Compounds, Endian, Part, Source, Tag, View};
use crate::space::Cell;
use rustc_hash::{FxHashMap, FxHashSet};
use std::io::{self, Write};

/// The file of `grid` as a structure of the game, with a palette for each variant. The same grid always gives
/// the same bytes.
///
/// Structure blocks load at most 48 blocks along each axis; commands, jigsaws and mods take any size.
pub fn encode_structure(grid: &Grid) -> Result<Encoded, WriteError> {
    if grid.bounds().is_empty() {
        return Err(WriteError::Empty(Size(grid.size())));
    }
    let others: Vec<&Grid> = same_size(grid).collect();
    let joint = Joint::of(grid, &others);
    let used = used(grid, &joint);
    let indices: FxHashMap<u32, i32> = used.iter().copied().zip(0..).collect();
    let palettes = (0..joint.looks()).map(|look| {
        Tag::List(used.iter().map(|&number| states::write(&placed(&joint, number, look))).collect())
    });
    let mut root = root(grid);
    root.insert("blocks".to_owned(), Tag::List(Vec::new()));
    root.extend(palette_tag(palettes.collect()));
    let blocks = Blocks { grid, joint: &joint, indices };
    let bytes = gzip::pack(|out| nbt::write_to(out, Endian::Big, "", &root, &blocks))?;
    Ok(Encoded { bytes, lost: lost(grid, &joint) })
}

/// The list of the blocks, which is made as it is written: each is a compound of its own.
struct Blocks<'a> {
    grid: &'a Grid,
    joint: &'a Joint<'a>,
    /// Those in the file's palettes, by their numbers.
    indices: FxHashMap<u32, i32>,
}

impl Source for Blocks<'_> {
    fn len(&self, _: &str) -> Option<usize> {
        None
    }

    fn write(&self, _: &str, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }

    fn compounds(&self, path: &str) -> Option<Compounds<'_>> {
        let each = || written(self.grid, self.joint);
        let block = |(place, number)| block(self.grid, place, self.indices[&number]);
        (path == "blocks").then(|| Compounds { len: each().count(), each: Box::new(each().map(block)) })
    }
}

/// The variants that can stand in the place of `grid`.
fn same_size(grid: &Grid) -> impl Iterator<Item = &Grid> {
    grid.variants.iter().filter(|variant| variant.size() == grid.size())
}

fn lost(grid: &Grid, joint: &Joint) -> Vec<Lost> {
    let other_size = grid.variants.len() - same_size(grid).count();
    // A file has data once for all looks.
    let own_data = |variant: &Grid| {
        let data = variant.block_entities.iter();
        data.filter(|&(place, data)| grid.block_entities.get(place) != Some(data)).count()
    };
    let own_data: usize = same_size(grid).map(own_data).sum();
    let lost = [
        (own_data > 0).then_some(Lost::BlockEntities(own_data)),
        Lost::unnamed_entities(grid),
        left_alone(grid, joint),
        Lost::biomes(grid),
        Lost::offset(grid),
        Lost::metadata_but(grid, author(grid).map_or(&[], |_| &["Author"])),
        Lost::own(grid, Some(Dialect::Structure)),
        Lost::regions(grid),
        (other_size > 0).then_some(Lost::Variants(other_size)),
    ];
    lost.into_iter().flatten().collect()
}

/// A file leaves the world alone where it has no block, in all looks alike. A written `structure_void` is a block.
fn left_alone(grid: &Grid, joint: &Joint) -> Option<Lost> {
    let left_alone = joint.left_alone();
    let count = written(grid, joint).filter(|(_, number)| left_alone[*number as usize] > 0).count();
    (count > 0).then_some(Lost::LeftAlone(count))
}

/// The state that is written for `number` in the look `look`.
fn placed(joint: &Joint, number: u32, look: usize) -> BlockState {
    let state = joint.state(number, look);
    if *state == BlockState::structure_void() { BlockState::air() } else { state.clone() }
}

fn author(grid: &Grid) -> Option<&String> {
    match grid.metadata.tags.get("Author") {
        Some(Tag::String(author)) => Some(author),
        _ => None,
    }
}

/// The cells that are written, with their numbers.
fn written<'a>(grid: &'a Grid, joint: &'a Joint) -> impl Iterator<Item = (Cell, u32)> + 'a {
    let left_alone = joint.left_alone();
    let size = Size(grid.size());
    let cells = joint.numbers().enumerate().map(move |(at, number)| (size.cell(at), number));
    cells.filter(move |(place, number)| {
        left_alone[*number as usize] < joint.looks() || grid.block_entities.contains_key(&place.to_array())
    })
}

/// The numbers that are written, in order of first use.
fn used(grid: &Grid, joint: &Joint) -> Vec<u32> {
    let mut seen = FxHashSet::default();
    written(grid, joint).map(|(_, number)| number).filter(|&number| seen.insert(number)).collect()
}

fn block(grid: &Grid, place: Cell, index: i32) -> View<'_> {
    let place = place.to_array();
    let mut block = vec![("pos", Part::New(ints(place))), ("state", Part::New(Tag::Int(index)))];
    let nbt = grid.block_entities.get(&place);
    let tags = nbt.map(|nbt| nbt.iter().map(|(name, tag)| (name.as_str(), Part::Tag(tag))).collect());
    block.extend(tags.map(|tags| ("nbt", Part::Compound(tags))));
    block
}

fn palette_tag(mut palettes: Vec<Tag>) -> Option<(String, Tag)> {
    match palettes.len() {
        0 | 1 => palettes.pop().map(|palette| ("palette".to_owned(), palette)),
        _ => Some(("palettes".to_owned(), Tag::List(palettes))),
    }
}

/// Everything but the blocks.
fn root(grid: &Grid) -> Compound {
    let own = grid.metadata.own.as_ref().filter(|own| own.dialect == Dialect::Structure);
    let mut root = own.map(|own| own.tags.clone()).unwrap_or_default();
    root.insert("DataVersion".to_owned(), Tag::Int(grid.data_version()));
    root.insert("size".to_owned(), ints(grid.size().to_array()));
    root.insert("entities".to_owned(), entities::write(grid));
    root.extend(author(grid).map(|author| ("author".to_owned(), Tag::String(author.clone()))));
    root
}

fn ints(numbers: [i32; 3]) -> Tag {
    Tag::List(numbers.map(Tag::Int).to_vec())
}
