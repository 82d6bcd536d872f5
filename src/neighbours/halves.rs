//! Things of two blocks: doors, double plants and beds.

use super::joint::Joint;
use super::site::Site;
use crate::block::{self, BlockState, Facing, PaletteFull};
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

/// How the halves of one thing are told apart.
struct Halves {
    key: &'static str,
    first: &'static str,
    second: &'static str,
    /// From the first half to the second.
    step: Cell,
}

impl Halves {
    fn of(site: &Site<'_>, cell: Cell) -> Option<Halves> {
        match site.block(cell).joint? {
            Joint::Door | Joint::Plant => {
                Some(Halves { key: "half", first: "lower", second: "upper", step: Cell::Y })
            }
            Joint::Bed => {
                let facing = bed_facing(site, cell);
                Some(Halves { key: "part", first: "foot", second: "head", step: facing.step() })
            }
            _ => None,
        }
    }
}

/// Where nothing says which half is which, they take turns from the first one on.
fn name_halves(site: &mut Site<'_>, cell: Cell) -> Result<(), PaletteFull> {
    let Some(halves) = Halves::of(site, cell) else { return Ok(()) };
    let own = with_facing(site, cell)?;
    if own.get(halves.key).is_some() {
        return Ok(());
    }
    let is_same = |other: &BlockState| {
        other.name() == own.name() && (halves.key == "half" || other.get("facing") == own.get("facing"))
    };
    let run = site.run(cell, halves.step, |other| is_same(other) && other.get(halves.key).is_none());
    let before = site.state(run[0] - halves.step);
    let starts_with_second = is_same(before) && before.get(halves.key) == Some(halves.first);
    for (number, cell) in run.into_iter().enumerate() {
        let is_second = (number % 2 == 1) != starts_with_second;
        let half = if is_second { halves.second } else { halves.first };
        let state = site.state(cell).clone().with(halves.key, half);
        site.put(cell, &state)?;
    }
    Ok(())
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
    let said = |state: &BlockState| state.get("facing").and_then(Facing::named);
    let of_neighbour = |side: &Facing| {
        let other = site.state(cell + side.step());
        let towards = match other.get("part") {
            Some("foot") => side.opposite(),
            _ => *side,
        };
        other.name() == own.name() && other.get("part").is_some() && said(other) == Some(towards)
    };
    let neighbour = || Facing::HORIZONTAL.into_iter().find(of_neighbour);
    let of = |side: Facing| said(site.state(cell + side.step()));
    said(own).or_else(|| neighbour().and_then(of)).unwrap_or(Facing::North)
}

fn share(site: &mut Site<'_>, cell: Cell) -> Result<(), PaletteFull> {
    let Some(halves) = Halves::of(site, cell) else { return Ok(()) };
    let Some(joint) = site.block(cell).joint else { return Ok(()) };
    let own = site.state(cell).clone();
    let is_first = own.get(halves.key) == Some(halves.first);
    let other = site.state(if is_first { cell + halves.step } else { cell - halves.step });
    let is_other = other.name() == own.name() && other.get(halves.key) != own.get(halves.key);
    let known = block::known(own.name());
    let mut full = own.clone();
    for key in joint.shared().iter().filter(|key| own.get(key).is_none()) {
        let Some(property) = known.and_then(|known| known.property(key)) else { continue };
        let given = other.get(key).filter(|_| is_other);
        full = full.with(key, given.unwrap_or(property.default));
    }
    site.put(cell, &full)
}
