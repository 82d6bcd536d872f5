//! The two layers of blocks, as one.

use super::palette::Entry;
use crate::block::{BlockState, Palette, is_always_in_water, is_water, takes_water};
use crate::io::error::Size;
use crate::io::fields::{Fields, FromTag};
use crate::io::{Limits, ReadError, Warning, volume};
use crate::nbt::Tag;
use crate::space::Cell;
use std::collections::BTreeMap;

/// Palette numbers in the order y, z, x.
pub(super) struct Cells {
    pub numbers: Vec<u16>,
    pub palette: Palette,
}

/// An index into the palette of the file, or none.
type Index = Option<usize>;

pub(super) fn read(
    structure: &Fields,
    size: Cell,
    entries: &[Entry],
    limits: &Limits,
) -> Result<(Cells, Vec<Warning>), ReadError> {
    let layers = structure.get::<&[Tag]>("block_indices")?;
    let path = |layer: usize| format!("{}[{layer}]", structure.path("block_indices"));
    let first = Layer::read(path(0), layers.first(), size, entries.len(), limits)?;
    let second = match layers.get(1) {
        None => None,
        Some(tag) => Some(Layer::read(path(1), Some(tag), size, entries.len(), limits)?),
    };
    let mut mix = Mix { entries, palette: Palette::default(), known: BTreeMap::new() };
    let mut numbers = Vec::with_capacity(first.entries.len());
    for at in 0..first.entries.len() {
        let cell = Size(size).cell(at);
        let over = second.as_ref().map_or(Ok(None), |layer| layer.index(cell))?;
        numbers.push(mix.number(first.index(cell)?, over).map_err(volume::full("block_palette"))?);
    }
    let warnings = mix.warnings();
    Ok((Cells { numbers, palette: mix.palette }, warnings))
}

/// One of the lists of indices: as many as there are cells.
struct Layer<'a> {
    path: String,
    entries: &'a [Tag],
    size: Cell,
    palette: usize,
}

impl<'a> Layer<'a> {
    fn read(
        path: String,
        tag: Option<&'a Tag>,
        size: Cell,
        palette: usize,
        limits: &Limits,
    ) -> Result<Layer<'a>, ReadError> {
        let missing = || ReadError::Missing { path: path.clone(), expected: "a List" };
        let entries = <&[Tag]>::from_tag(tag.ok_or_else(missing)?).ok_or_else(missing)?;
        let cells = volume::cells(size, path.clone(), entries.len(), limits)?;
        Ok(Layer { path, entries: &entries[..cells], size, palette })
    }

    /// What stands at `cell`: z runs fastest, then y.
    fn index(&self, cell: Cell) -> Result<Index, ReadError> {
        let [x, y, z] = cell.to_array().map(|n| n as usize);
        let [_, height, length] = self.size.to_array().map(|n| n as usize);
        match i32::from_tag(&self.entries[z + length * (y + height * x)]) {
            Some(-1) => Ok(None),
            Some(index) if usize::try_from(index).is_ok_and(|index| index < self.palette) => {
                Ok(Some(index as usize))
            }
            other => Err(ReadError::NotInPalette {
                path: self.path.clone(),
                cell,
                index: other.unwrap_or(i32::MIN).cast_unsigned(),
                entries: self.palette,
            }),
        }
    }
}

/// The blocks of both layers as states of the grid.
struct Mix<'a> {
    entries: &'a [Entry],
    palette: Palette,
    /// The palette number of each pair that was met, and how often it was.
    known: BTreeMap<(Index, Index), (u16, usize)>,
}

impl Mix<'_> {
    fn number(&mut self, block: Index, over: Index) -> Result<u16, crate::block::PaletteFull> {
        if let Some((number, count)) = self.known.get_mut(&(block, over)) {
            *count += 1;
            return Ok(*number);
        }
        let number = self.palette.intern(&self.state(block, over))?;
        self.known.insert((block, over), (number, 1));
        Ok(number)
    }

    /// Nothing in the first layer leaves the world alone, whatever is in the second.
    fn state(&self, block: Index, over: Index) -> BlockState {
        let Some(block) = block else { return BlockState::structure_void() };
        let state = &self.entries[block].state;
        match over {
            Some(over) if self.is_water(over) && state.is_air() => self.entries[over].state.clone(),
            Some(over) if self.is_water(over) && takes_water(state) => {
                state.clone().with("waterlogged", "true")
            }
            _ => state.clone(),
        }
    }

    fn is_water(&self, index: usize) -> bool {
        is_water(&self.entries[index].state)
    }

    fn warnings(&self) -> Vec<Warning> {
        let (water, other) = self.dropped();
        let water = (water > 0).then_some(Warning::WaterDropped(water));
        let other = (other > 0).then_some(Warning::SecondLayer(other));
        water.into_iter().chain(other).chain(self.unknown()).collect()
    }

    /// How many blocks of the second layer are left out: water, and others.
    fn dropped(&self) -> (usize, usize) {
        let (mut water, mut other) = (0, 0);
        for ((block, over), (_, count)) in &self.known {
            let Some(over) = over.filter(|over| !self.entries[*over].state.is_air()) else { continue };
            let under = block.map(|block| &self.entries[block].state);
            match self.is_water(over) {
                true if under.is_some_and(|state| state.is_air() || holds_water(state)) => {}
                true => water += count,
                false => other += count,
            }
        }
        (water, other)
    }

    fn unknown(&self) -> Option<Warning> {
        const SHOWN: usize = 6;
        let mut counts = BTreeMap::new();
        for ((block, _), (_, count)) in &self.known {
            if let Some(entry) = block.map(|block| &self.entries[block]).filter(|entry| entry.unknown) {
                *counts.entry(entry.state.short_name()).or_insert(0) += count;
            }
        }
        let names: Vec<&str> = counts.keys().take(SHOWN).copied().collect();
        let names = names.join(", ") + if counts.len() > SHOWN { ", ..." } else { "" };
        (!counts.is_empty()).then(|| Warning::UnknownBedrock { blocks: counts.values().sum(), names })
    }
}

/// Whether the block is in water, or can be.
fn holds_water(state: &BlockState) -> bool {
    takes_water(state) || is_water(state) || is_always_in_water(state)
}
