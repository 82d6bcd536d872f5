//! The blocks of a region as a file holds them.

use super::bits;
use crate::block::BlockState;
use crate::io::states::{self, Complete};
use crate::nbt::Tag;
use ndarray::ArrayView3;

pub(super) struct Blocks {
    pub palette: Tag,
    pub indices: Tag,
    /// Those that are something.
    pub count: usize,
}

/// `cells` as numbers of states, which `complete` completes. Indices count from air on, which readers take
/// for granted, then in order of first use.
pub(super) fn encode(cells: &ArrayView3<u16>, complete: &Complete) -> Blocks {
    let cells = cells.as_standard_layout();
    let cells = cells.as_slice().expect("the standard layout is contiguous");
    let (index, used) = number(cells, complete);
    let nothing: Vec<bool> = complete.states.iter().map(BlockState::is_nothing).collect();
    let is_something: Vec<bool> = complete.numbers.iter().map(|&n| !nothing[usize::from(n)]).collect();
    let indices: Vec<u16> = cells.iter().map(|&id| index[usize::from(id)]).collect();
    Blocks {
        palette: Tag::List(used.iter().map(|&n| states::write(&complete.states[usize::from(n)])).collect()),
        indices: Tag::LongArray(bits::pack(&indices, bits::width(used.len()))),
        count: cells.iter().filter(|&&id| is_something[usize::from(id)]).count(),
    }
}

/// The indices by the numbers that cells hold, and the numbers of complete states by index.
fn number(cells: &[u16], complete: &Complete) -> (Vec<u16>, Vec<u16>) {
    const AIR: u16 = 0;
    let mut indices = vec![None; complete.states.len()];
    indices[usize::from(AIR)] = Some(0);
    let mut used = vec![AIR];
    let mut seen = vec![false; complete.numbers.len()];
    for &id in cells {
        if std::mem::replace(&mut seen[usize::from(id)], true) {
            continue;
        }
        let number = complete.numbers[usize::from(id)];
        indices[usize::from(number)].get_or_insert_with(|| {
            used.push(number);
            (used.len() - 1) as u16
        });
    }
    let index = |&number: &u16| indices[usize::from(number)].unwrap_or_default();
    (complete.numbers.iter().map(index).collect(), used)
}
