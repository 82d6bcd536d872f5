//! The numbers of the blocks, and the states they stand for.

use super::ids::{Ids, Unknown};
use crate::block::{BlockState, Palette, PaletteFull};
use crate::grid::Grid;
use crate::io::fields::Fields;
use crate::io::{Limits, ReadError, Warning, volume};
use crate::space::Cell;
use std::collections::BTreeMap;

/// Palette numbers in the order y, z, x, their palette, and what had to be put right.
type Read = (Vec<u16>, Palette, Vec<Warning>);

pub(super) fn read(root: &Fields, size: Cell, limits: &Limits) -> Result<Read, ReadError> {
    let blocks = root.get::<&[i8]>("Blocks")?;
    let data = root.get::<&[i8]>("Data")?;
    let volume = volume::cells(size, root.path("Blocks"), blocks.len(), limits)?;
    volume::cells(size, root.path("Data"), data.len(), limits)?;
    let ids = Ids::read(root)?;
    let high = High::read(root, volume, &ids)?;

    let mut states = States::default();
    let mut cells = Vec::with_capacity(volume);
    for (at, (&block, &data)) in blocks.iter().zip(data).enumerate().take(volume) {
        let id = u16::from(block.cast_unsigned()) | high.of(at) << 8;
        let number = states.number(id, data.cast_unsigned() & 15, &ids);
        cells.push(number.map_err(volume::full("Blocks"))?);
    }
    let warnings = states.warnings().chain(high.warning()).collect();
    Ok((cells, states.palette, warnings))
}

/// The bits of the ids beyond the eighth.
enum High<'a> {
    None,
    /// A byte for each block.
    Bytes(&'a [i8]),
    /// Half a byte for each block, the low half first.
    WorldEdit(&'a [i8]),
    /// The high half first.
    Schematica(&'a [i8]),
}

impl High<'_> {
    /// Nothing in a file tells the two orders of halves apart; but only Schematica writes names of its ids.
    fn read<'a>(root: &Fields<'a>, volume: usize, ids: &Ids) -> Result<High<'a>, ReadError> {
        if let Some(halves) = root.find::<&[i8]>("AddBlocks")? {
            let enough = halves.get(..volume.div_ceil(2)).ok_or_else(|| short(root, "AddBlocks", halves))?;
            return Ok(if ids.named() { High::Schematica(enough) } else { High::WorldEdit(enough) });
        }
        match root.find::<&[i8]>("Add")? {
            None => Ok(High::None),
            Some(bytes) => bytes.get(..volume).map(High::Bytes).ok_or_else(|| short(root, "Add", bytes)),
        }
    }

    fn of(&self, at: usize) -> u16 {
        let half = |bytes: &[i8], low: bool| {
            let byte = u16::from(bytes[at / 2].cast_unsigned());
            if low { byte & 15 } else { byte >> 4 }
        };
        match self {
            High::None => 0,
            High::Bytes(bytes) => u16::from(bytes[at].cast_unsigned()) & 15,
            High::WorldEdit(bytes) => half(bytes, at.is_multiple_of(2)),
            High::Schematica(bytes) => half(bytes, !at.is_multiple_of(2)),
        }
    }

    fn warning(&self) -> Option<Warning> {
        match self {
            High::WorldEdit(bytes) => bytes.iter().any(|&byte| byte != 0).then_some(Warning::HalvesOfIds),
            _ => None,
        }
    }
}

fn short(root: &Fields, name: &str, bytes: &[i8]) -> ReadError {
    ReadError::ShortArray { path: root.path(name), found: bytes.len() }
}

/// The palette, as it grows while cells are read.
struct States {
    palette: Palette,
    /// Palette numbers by id times 16 plus data.
    numbers: Vec<Option<u16>>,
    /// Blocks of what the file cannot mean, by id and data.
    unknown: BTreeMap<(u16, u8), (Unknown, usize)>,
}

impl Default for States {
    fn default() -> States {
        let numbers = vec![None; 4096 * 16];
        States { palette: Palette::default(), numbers, unknown: BTreeMap::new() }
    }
}

impl States {
    fn number(&mut self, id: u16, data: u8, ids: &Ids) -> Result<u16, PaletteFull> {
        let at = usize::from(id) * 16 + usize::from(data);
        let number = match self.numbers[at] {
            Some(number) => number,
            None => self.new_number(id, data, ids)?,
        };
        self.numbers[at] = Some(number);
        if let Some((_, count)) = self.unknown.get_mut(&(id, data)) {
            *count += 1;
        }
        Ok(number)
    }

    fn new_number(&mut self, id: u16, data: u8, ids: &Ids) -> Result<u16, PaletteFull> {
        let (state, unknown) = ids.state(id, data);
        self.unknown.extend(unknown.map(|unknown| ((id, data), (unknown, 0))));
        self.palette.intern(&state)
    }

    fn warnings(&self) -> impl Iterator<Item = Warning> {
        let data = self.listed(Unknown::Data).map(|(blocks, ids)| Warning::UnknownData { blocks, ids });
        let ids = self.listed(Unknown::Id).map(|(blocks, ids)| Warning::UnknownIds { blocks, ids });
        data.into_iter().chain(ids)
    }

    /// How many blocks there are of an unknown kind, and which.
    fn listed(&self, kind: Unknown) -> Option<(usize, String)> {
        const SHOWN: usize = 6;
        let of_kind = || self.unknown.iter().filter(|(_, (unknown, _))| *unknown == kind);
        let blocks = of_kind().map(|(_, (_, count))| count).sum();
        let names = of_kind().take(SHOWN).map(|((id, data), _)| format!("{id}:{data}"));
        let names: Vec<String> = names.collect();
        let more = if of_kind().count() > SHOWN { ", ..." } else { "" };
        (blocks > 0).then(|| (blocks, format!("{}{more}", names.join(", "))))
    }
}

const TALL_PLANTS: [&str; 6] = ["sunflower", "lilac", "tall_grass", "large_fern", "rose_bush", "peony"];

fn is_tall_plant(state: &BlockState, half: &str) -> bool {
    state.get("half") == Some(half) && TALL_PLANTS.contains(&state.short_name())
}

/// The upper half of a tall plant has no kind of its own: it is the kind of the lower half.
pub(super) fn name_upper_halves(grid: &mut Grid) -> Result<(), PaletteFull> {
    let is_upper: Vec<bool> =
        grid.palette().states().iter().map(|state| is_tall_plant(state, "upper")).collect();
    let upper = grid.bounds().cells().filter(|&cell| cell.y > 0 && is_upper[usize::from(grid.id(cell))]);
    for cell in upper.collect::<Vec<Cell>>() {
        let below = grid.get(cell - Cell::Y);
        if is_tall_plant(below, "lower") {
            let state = below.clone().with("half", "upper");
            let id = grid.intern(&state)?;
            grid.set(cell, id);
        }
    }
    Ok(())
}
