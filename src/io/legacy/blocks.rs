//! Blocks by their numbers, and the states that they stand for.

use super::ids::{Ids, Unknown};
use crate::block::{Palette, PaletteFull};
use crate::io::Warning;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// An id of 12 bits and data of 4.
type Number = (u16, u8);

/// What `numbers` stand for, in their order: numbers of the states in the palette beside.
pub fn states(
    numbers: impl Iterator<Item = Number>,
    ids: &Ids,
    strangers: &mut Strangers,
) -> Result<(Vec<u16>, Palette), PaletteFull> {
    let mut palette = Palette::default();
    let mut met: FxHashMap<Number, u16> = FxHashMap::default();
    let mut cells = Vec::with_capacity(numbers.size_hint().0);
    for number in numbers {
        let cell = match met.get(&number) {
            Some(&cell) => cell,
            None => {
                let (state, unknown) = ids.state(number.0, number.1);
                strangers.meet(number, unknown);
                let cell = palette.intern(&state)?;
                met.insert(number, cell);
                cell
            }
        };
        strangers.count(number);
        cells.push(cell);
    }
    Ok((cells, palette))
}

/// Blocks of what a file cannot mean, by id and data, and how many there are.
#[derive(Default)]
pub struct Strangers(BTreeMap<Number, (Unknown, usize)>);

impl Strangers {
    fn meet(&mut self, number: Number, unknown: Option<Unknown>) {
        if let Some(unknown) = unknown {
            self.0.entry(number).or_insert((unknown, 0));
        }
    }

    fn count(&mut self, number: Number) {
        if let Some((_, count)) = self.0.get_mut(&number) {
            *count += 1;
        }
    }

    pub fn warnings(&self) -> impl Iterator<Item = Warning> {
        let data = self.listed(Unknown::Data).map(|(blocks, ids)| Warning::UnknownData { blocks, ids });
        let ids = self.listed(Unknown::Id).map(|(blocks, ids)| Warning::UnknownIds { blocks, ids });
        data.into_iter().chain(ids)
    }

    /// How many blocks there are of an unknown kind, and which.
    fn listed(&self, kind: Unknown) -> Option<(usize, String)> {
        const SHOWN: usize = 6;
        let of_kind = || self.0.iter().filter(|(_, (unknown, _))| *unknown == kind);
        let blocks = of_kind().map(|(_, (_, count))| count).sum();
        let names = of_kind().take(SHOWN).map(|((id, data), _)| format!("{id}:{data}"));
        let names: Vec<String> = names.collect();
        let more = if of_kind().count() > SHOWN { ", ..." } else { "" };
        (blocks > 0).then(|| (blocks, format!("{}{more}", names.join(", "))))
    }
}
