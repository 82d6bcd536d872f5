use super::joint::Joint;
use super::site::Site;
use crate::block::{BlockState, Facing, PaletteFull};
use crate::space::Cell;

const CHEST: [Joint; 1] = [Joint::Chest];

/// Joins chests that stand side by side and look the same way, two by two.
pub fn settle(site: &mut Site<'_>) -> Result<(), PaletteFull> {
    for y in site.layers(&CHEST) {
        for cell in site.open_in(y, &CHEST) {
            pair(site, cell)?;
        }
    }
    Ok(())
}

fn pair(site: &mut Site<'_>, cell: Cell) -> Result<(), PaletteFull> {
    let own = site.state(cell).clone();
    if own.get("type").is_some() {
        return Ok(());
    }
    let facing = facing(&own);
    let like = |other: &BlockState| other.name() == own.name() && self::facing(other) == facing;
    let step = facing.right().step();
    let run = site.run(cell, step, |other| like(other) && other.get("type").is_none());
    let (first, last) = (run[0], run[run.len() - 1]);
    // A chest waits for its other half where that has been told already.
    let waits = |cell: Cell, half: &str| like(site.state(cell)) && site.state(cell).get("type") == Some(half);
    let (start, end) = (waits(first - step, "left"), waits(last + step, "right"));
    let types = types(run.len(), start, end);
    for (cell, half) in run.into_iter().zip(types) {
        let state = site.state(cell).clone().with("type", half);
        site.put(cell, &state)?;
    }
    Ok(())
}

fn facing(state: &BlockState) -> Facing {
    state.get("facing").and_then(Facing::named).unwrap_or(Facing::North)
}

/// The halves in a row of chests, as they stand from their left half to their right half. Pairs are made from both
/// ends, so that a mirrored row is paired alike; what is left in the middle of an odd row stays single.
fn types(count: usize, starts_with_right: bool, ends_with_left: bool) -> Vec<&'static str> {
    let mut types = vec!["single"; count];
    let (mut low, mut high) = (0, count);
    if starts_with_right && low < high {
        types[low] = "right";
        low += 1;
    }
    if ends_with_left && low < high {
        high -= 1;
        types[high] = "left";
    }
    while high - low == 2 || high - low >= 4 {
        (types[low], types[low + 1]) = ("left", "right");
        (types[high - 2], types[high - 1]) = ("left", "right");
        (low, high) = (low + 2, (high - 2).max(low + 2));
    }
    types
}

#[cfg(test)]
mod tests {
    use super::types;

    #[test]
    fn rows_are_paired_from_both_ends() {
        let letters =
            |count, start, end| types(count, start, end).iter().map(|t| &t[..1]).collect::<String>();
        let rows: Vec<String> = (0..=8).map(|count| letters(count, false, false)).collect();
        assert_eq!(rows, ["", "s", "lr", "sss", "lrlr", "lrslr", "lrlrlr", "lrssslr", "lrlrlrlr"]);
        assert_eq!(letters(1, true, true), "r");
        assert_eq!(letters(2, true, false), "rs");
        assert_eq!(letters(4, true, true), "rlrl");
    }
}
