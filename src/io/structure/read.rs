use super::blocks::{self, Incoming, Placed};
use super::{ROOT_TAGS, entities, jigsaw};
use crate::block::BlockState;
use crate::grid::{Dialect, Grid, Metadata, Own};
use crate::io::error::Size;
use crate::io::fields::{self, Fields};
use crate::io::{Jigsaws, Limits, ReadError, Warning, states};
use crate::nbt::{Compound, Tag};
use crate::space::{Bounds, Cell};

/// The grid of a structure, with one of its palettes; the others make its variants.
pub fn decode(
    root: &Compound,
    blocks: Incoming,
    limits: &Limits,
    jigsaws: Jigsaws,
) -> Result<(Grid, Vec<Warning>), ReadError> {
    let root = Fields::new("", root);
    let size = size(&root)?;
    let palettes = palettes(&root)?;
    check_cells(size, palettes.len(), limits)?;
    let blocks = blocks.finish(&root)?;
    let outside = blocks.iter().filter(|block| !is_inside(size, block)).count();
    check_data(&blocks, palettes.len(), limits)?;
    let looks = palettes.iter().map(|states| look(size, &blocks, states, jigsaws));
    let mut looks = looks.collect::<Result<Vec<Look>, ReadError>>()?.into_iter();
    let Look { mut grid, replaced, jigsaws } = looks.next().expect("there is a palette");
    grid.variants = looks.map(|look| look.grid).collect();
    grid.metadata = metadata(&root)?;
    let found = entities::read(&root)?;

    let counted = [
        (outside, Warning::BlocksOutside as fn(usize) -> Warning),
        (replaced, Warning::BlocksReplaced),
        (jigsaws, Warning::Jigsaws),
        (found.unnamed, Warning::EntitiesUnnamed),
    ];
    grid.metadata.entities = found.entities;
    let warnings = counted.into_iter().filter(|&(count, _)| count > 0).map(|(count, of)| of(count));
    Ok((grid, warnings.collect()))
}

fn size(root: &Fields) -> Result<Size, ReadError> {
    let size = Cell::from_array(root.get("size")?);
    let expected = "at least one block along each axis";
    match size.min_element() {
        1.. => Ok(Size(size)),
        _ => Err(ReadError::WrongType { path: root.path("size"), expected, found: Size(size).to_string() }),
    }
}

/// The bytes of a structure do not bound its size, so the limit does. Every variant is a whole grid.
fn check_cells(size: Size, variants: usize, limits: &Limits) -> Result<(), ReadError> {
    let cells = size.cells();
    match cells.saturating_mul(variants as u64) > limits.max_cells {
        true if variants > 1 => {
            Err(ReadError::TooManyVariants { size, variants, cells, limit: limits.max_cells })
        }
        true => Err(ReadError::TooManyCells { size, cells, limit: limits.max_cells }),
        false => Ok(()),
    }
}

/// Every variant has block entities of its own, which stand in the file but once.
fn check_data(blocks: &[Placed], variants: usize, limits: &Limits) -> Result<(), ReadError> {
    let limit = limits.max_bytes;
    let bytes = blocks.iter().filter_map(|block| block.nbt.as_deref()).map(weight).sum::<u64>();
    match bytes.saturating_mul(variants as u64 - 1) > limit {
        true => Err(ReadError::LargeVariants { bytes, variants, limit }),
        false => Ok(()),
    }
}

/// What tags take in memory, or some more.
fn weight(tags: &Compound) -> u64 {
    const LEAST: u64 = 600;
    const ENTRY: u64 = 120;
    let entries = tags.iter().map(|(name, tag)| ENTRY + name.len() as u64 + weight_beside(tag));
    LEAST + entries.sum::<u64>()
}

/// What a value takes beside its place in a list or compound.
fn weight_beside(tag: &Tag) -> u64 {
    match tag {
        Tag::Compound(tags) => weight(tags),
        Tag::List(entries) => {
            entries.iter().map(|entry| size_of::<Tag>() as u64 + weight_beside(entry)).sum()
        }
        Tag::String(text) => text.len() as u64,
        Tag::ByteArray(numbers) => size_of_val(&numbers[..]) as u64,
        Tag::IntArray(numbers) => size_of_val(&numbers[..]) as u64,
        Tag::LongArray(numbers) => size_of_val(&numbers[..]) as u64,
        _ => 0,
    }
}

/// A palette, and its path.
struct States {
    path: String,
    states: Vec<BlockState>,
}

fn palettes(root: &Fields) -> Result<Vec<States>, ReadError> {
    let states = |path: String, entries| Ok(States { states: states::read_palette(&path, entries)?, path });
    match root.find::<&[Tag]>("palettes")?.filter(|lists| !lists.is_empty()) {
        None => Ok(vec![states(root.path("palette"), root.get("palette")?)?]),
        Some(lists) => {
            let path = root.path("palettes");
            let lists = fields::values(&path, lists);
            lists.map(|list| list.and_then(|(path, entries)| states(path, entries))).collect()
        }
    }
}

/// A structure with one of its palettes.
struct Look {
    grid: Grid,
    /// Blocks that stand where another one stood.
    replaced: usize,
    /// Jigsaws that became what they leave behind.
    jigsaws: usize,
}

fn look(size: Size, blocks: &[Placed], states: &States, jigsaws: Jigsaws) -> Result<Look, ReadError> {
    let full = |problem| ReadError::PaletteFull { path: states.path.clone(), problem };
    let mut grid = Grid::new(size.0);
    let nobodys = grid.intern(&BlockState::structure_void()).map_err(full)?;
    grid.fill(grid.bounds(), nobodys);
    let ids = states.states.iter().map(|state| grid.intern(state)).collect::<Result<Vec<u16>, _>>();
    let ids = ids.map_err(full)?;
    let mut look = Look { grid, replaced: 0, jigsaws: 0 };
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| is_inside(size, block)) {
        let number = block.state as usize;
        let Some(state) = states.states.get(number) else { return Err(not_in_palette(index, block, states)) };
        let nbt = block.nbt.as_deref();
        look.replaced += usize::from(look.grid.id(block.place) != nobodys);
        let left_behind = match jigsaws {
            Jigsaws::Final => jigsaw::final_state(state, nbt, || format!("{}.nbt", blocks::path(index)))?,
            Jigsaws::Keep => None,
        };
        let id = left_behind.as_ref().map_or(Ok(ids[number]), |state| look.grid.intern(state));
        look.grid.set(block.place, id.map_err(full)?);
        look.jigsaws += usize::from(left_behind.is_some());
        set_data(&mut look.grid, block.place, nbt.filter(|_| left_behind.is_none()));
    }
    Ok(look)
}

fn is_inside(size: Size, block: &Placed) -> bool {
    Bounds::of_size(size.0).contains(block.place)
}

fn not_in_palette(index: usize, block: &Placed, states: &States) -> ReadError {
    ReadError::NotInPalette {
        path: format!("{}.state", blocks::path(index)),
        cell: block.place,
        index: block.state,
        entries: states.states.len(),
    }
}

/// The block entity at `place` is that of the last block there.
fn set_data(grid: &mut Grid, place: Cell, nbt: Option<&Compound>) {
    grid.block_entities.remove(&place.to_array());
    if let Some(nbt) = nbt {
        let mut data = nbt.clone();
        data.retain(|name, _| !["x", "y", "z"].contains(&name.as_str()));
        grid.block_entities.insert(place.to_array(), data);
    }
}

fn metadata(root: &Fields) -> Result<Metadata, ReadError> {
    let author = root.find::<&str>("author")?.filter(|author| !author.is_empty());
    let author = author.map(|author| ("Author".to_owned(), Tag::String(author.to_owned())));
    let own = root.tags.iter().filter(|(name, _)| !ROOT_TAGS.contains(&name.as_str()));
    let own: Compound = own.map(|(name, tag)| (name.clone(), tag.clone())).collect();
    Ok(Metadata {
        data_version: root.find("DataVersion")?,
        tags: author.into_iter().collect(),
        own: (!own.is_empty()).then_some(Own { dialect: Dialect::Structure, tags: own }),
        ..Metadata::default()
    })
}
