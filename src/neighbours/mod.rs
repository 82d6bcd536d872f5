//! What blocks take from their neighbours: the sides of fences, the corners of stairs, the halves of doors.
//! Knows the rules of the game for them, and nothing of files or grammars.
//!
//! A state that carries none of these properties is open: it takes them from its neighbours. One that carries
//! them stays as it is written. Cells outside of the grid and those left alone count as air.

mod chests;
mod follow;
mod halves;
mod joint;
mod mend;
mod redstone;
mod sides;
mod site;
mod stairs;
mod unsettle;
mod walls;

use crate::block::{self, PaletteFull, Version};
use crate::grid::Grid;
use crate::space::Cell;
use joint::Joint;
use site::{Answer, Site};

pub use follow::follow;
pub use joint::{bare, decided, opened};
pub use mend::{Mended, Mending, Places, mend};
pub use unsettle::unsettle;

/// Gives every open state of the grid and its variants what its neighbours ask for, and every other absent
/// property its default, as far as the grid's version of the game has them. States that become equal are one in the
/// palette.
pub fn settle(grid: &mut Grid) -> Result<(), PaletteFull> {
    settle_in(grid, grid.version())
}

/// Settles a grid whose states are of `version`.
fn settle_in(grid: &mut Grid, version: Version) -> Result<(), PaletteFull> {
    grid.variants.iter_mut().try_for_each(|variant| settle_in(variant, version))?;
    ask(grid, version)?;
    complete(grid, version)
}

/// Gives every open state of the grid what its neighbours ask for, and nothing else.
fn ask(grid: &mut Grid, version: Version) -> Result<(), PaletteFull> {
    if grid.palette().states().iter().any(joint::is_open) {
        let mut site = Site::new(grid, version);
        halves::settle(&mut site)?;
        chests::settle(&mut site)?;
        // What is fixed to stairs depends on their corners, and walls on what stands on them.
        site.each(&[Joint::Stairs], stairs::corner)?;
        site.each(&JOINED, joined)?;
        site.each(&[Joint::Wall], walls::arms_and_post)?;
    }
    Ok(())
}

/// Blocks whose answers do not depend on each other's.
const JOINED: [Joint; 8] = [
    Joint::Fence,
    Joint::Pane,
    Joint::Gate,
    Joint::Wire,
    Joint::Tripwire,
    Joint::Vine,
    Joint::Chorus,
    Joint::Snowy,
];

fn joined(site: &Site<'_>, cell: Cell) -> Answer {
    match site.block(cell).joint {
        Some(Joint::Fence) => sides::fence(site, cell),
        Some(Joint::Pane) => sides::pane(site, cell),
        Some(Joint::Gate) => sides::gate(site, cell),
        Some(Joint::Chorus) => sides::chorus(site, cell),
        Some(Joint::Vine) => sides::vine(site, cell),
        Some(Joint::Snowy) => sides::snowy(site, cell),
        Some(Joint::Wire) => redstone::wire(site, cell),
        Some(Joint::Tripwire) => redstone::tripwire(site, cell),
        _ => Answer::new(),
    }
}

fn complete(grid: &mut Grid, version: Version) -> Result<(), PaletteFull> {
    match grid.palette().states().iter().all(block::is_complete) {
        true => Ok(()),
        false => grid.map_states(|state| block::complete_in(state, version)),
    }
}
