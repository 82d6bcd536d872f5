//! Things of two blocks: doors, double plants and beds.

use super::joint::Joint;
use super::site::Site;
use crate::block::{self, BlockState, Facing, Halves, PaletteFull};
use crate::space::Cell;

const OF_TWO: [Joint; 3] = [Joint::Door, Joint::Plant, Joint::Bed];

/// Says which half each block is, and gives each half what only the other one says.
pub fn settle(site: &mut Site<'_>) -> Result<(), PaletteFull> {
    for y in site.layers(&OF_TWO) {
        for cell in site.open_in(y, &OF_TWO) {
            name_halves(site, cell)?;
        }
    }
    for y in site.layers(&OF_TWO) {
        for cell in site.open_in(y, &OF_TWO) {
            share(site, cell)?;
        }
    }
    Ok(())
}

/// Where nothing says which half is which, they take turns from the first one on.
fn name_halves(site: &mut Site<'_>, cell: Cell) -> Result<(), PaletteFull> {
    let own = with_facing(site, cell)?;
    let Some(halves) = Halves::of(&own) else { return Ok(()) };
    let step = step(halves, &own);
    if own.get(halves.key).is_some() {
        return Ok(());
    }
    let is_same = |other: &BlockState| {
        other.name() == own.name() && (step == Cell::Y || other.get("facing") == own.get("facing"))
    };
    let run = site.run(cell, step, |other| is_same(other) && other.get(halves.key).is_none());
    let before = site.state(run[0] - step);
    let starts_with_second = is_same(before) && before.get(halves.key) == Some(halves.first);
    for (number, cell) in run.into_iter().enumerate() {
        let is_second = (number % 2 == 1) != starts_with_second;
        let half = if is_second { halves.second } else { halves.first };
        let state = site.state(cell).clone().with(halves.key, half);
        site.put(cell, &state)?;
    }
    Ok(())
}

/// From the first half to the second.
fn step(halves: Halves, state: &BlockState) -> Cell {
    halves.step(facing(state).unwrap_or(Facing::North))
}

fn facing(state: &BlockState) -> Option<Facing> {
    state.get("facing").and_then(Facing::named)
}

/// The state at `cell`; the halves of a bed lie where it faces, so that comes first.
fn with_facing(site: &mut Site<'_>, cell: Cell) -> Result<BlockState, PaletteFull> {
    let own = site.state(cell).clone();
    if site.block(cell).joint != Some(Joint::Bed) || own.get("facing").is_some() {
        return Ok(own);
    }
    let own = own.with("facing", bed_facing(site, cell).name());
    site.put(cell, &own)?;
    Ok(own)
}

/// Where a bed looks that does not say so: as the half that it belongs to.
fn bed_facing(site: &Site<'_>, cell: Cell) -> Facing {
    let own = site.state(cell);
    let of_neighbour = |side: &Facing| {
        let other = site.state(cell + side.step());
        let towards = match other.get("part") {
            Some("foot") => side.opposite(),
            _ => *side,
        };
        other.name() == own.name() && other.get("part").is_some() && facing(other) == Some(towards)
    };
    let neighbour = || Facing::HORIZONTAL.into_iter().find(of_neighbour);
    let of = |side: Facing| facing(site.state(cell + side.step()));
    facing(own).or_else(|| neighbour().and_then(of)).unwrap_or(Facing::North)
}

fn share(site: &mut Site<'_>, cell: Cell) -> Result<(), PaletteFull> {
    let Some(joint) = site.block(cell).joint else { return Ok(()) };
    let own = site.state(cell).clone();
    let other = block::other_half(&own).map(|(step, _)| site.state(cell + step));
    let other = other.filter(|other| block::is_other_half(&own, other));
    let known = block::known(own.name());
    let mut full = own.clone();
    for key in joint.shared().iter().filter(|key| own.get(key).is_none()) {
        let Some(property) = known.and_then(|known| known.property(key)) else { continue };
        let given = other.and_then(|other| other.get(key));
        full = full.with(key, given.unwrap_or(property.default));
    }
    site.put(cell, &full)
}
