//! The regions that a grid is written as.

use crate::block::BlockState;
use crate::grid::Grid;
use crate::io::Lost;
use crate::nbt::{Compound, Tag};
use crate::space::Bounds;
use ndarray::{SliceInfo, SliceInfoElem, s};
use std::borrow::Cow;
use std::collections::BTreeSet;

pub(super) struct Piece<'a> {
    /// No other piece has it.
    pub name: Cow<'a, str>,
    pub bounds: Bounds,
    pub tags: Option<&'a Compound>,
}

/// One for every region of the grid, or one around everything where they leave blocks out.
pub(super) fn of(grid: &Grid) -> (Vec<Piece<'_>>, Option<Lost>) {
    let regions = &grid.metadata.regions;
    if regions.is_empty() || !cover(grid) {
        let lost = (!regions.is_empty()).then(|| Lost::all_regions(grid));
        return (vec![whole(grid)], lost);
    }
    let mut names = BTreeSet::new();
    let pieces = regions.iter().map(|region| Piece {
        name: unused(&region.name, &mut names),
        bounds: region.bounds,
        tags: Some(&region.tags),
    });
    (pieces.collect(), None)
}

/// Whether all regions lie in the grid and reach to its ends, and all blocks and their data lie in regions.
fn cover(grid: &Grid) -> bool {
    let mut bounds = grid.metadata.regions.iter().map(|region| region.bounds);
    if !bounds.clone().all(|bounds| !bounds.is_empty() && grid.bounds().contains_box(&bounds)) {
        return false;
    }
    if bounds.any(|bounds| bounds == grid.bounds()) {
        return true;
    }
    reach_the_ends(grid) && hold_the_blocks(grid)
}

/// Whether the box around all regions is the grid: that is all that a file says of its size.
fn reach_the_ends(grid: &Grid) -> bool {
    let bounds = grid.metadata.regions.iter().map(|region| region.bounds);
    bounds.reduce(|all, next| all.union(&next)) == Some(grid.bounds())
}

fn hold_the_blocks(grid: &Grid) -> bool {
    let nobodys = grid.palette().find(&BlockState::structure_void());
    let mut left_out = grid.cells().mapv(|id| Some(id) != nobodys);
    for [x, y, z] in grid.block_entities.keys().map(|place| place.map(|n| n as usize)) {
        if let Some(left_out) = left_out.get_mut([y, z, x]) {
            *left_out = true;
        }
    }
    for region in &grid.metadata.regions {
        left_out.slice_mut(slice(region.bounds)).fill(false);
    }
    !left_out.iter().any(|&is_left_out| is_left_out)
}

/// `bounds` in an array of the cells of a grid.
pub(super) fn slice(bounds: Bounds) -> SliceInfo<[SliceInfoElem; 3], ndarray::Ix3, ndarray::Ix3> {
    let [x0, y0, z0] = bounds.min.to_array().map(|n| n as usize);
    let [x1, y1, z1] = bounds.max.to_array().map(|n| n as usize);
    s![y0..y1, z0..z1, x0..x1]
}

fn whole(grid: &Grid) -> Piece<'_> {
    let name = match grid.metadata.tags.get("Name") {
        Some(Tag::String(name)) if !name.is_empty() => name,
        _ => "vox",
    };
    Piece { name: name.into(), bounds: grid.bounds(), tags: None }
}

/// `name`, or `name (2)` and so on where it is taken.
fn unused<'a>(name: &'a str, taken: &mut BTreeSet<String>) -> Cow<'a, str> {
    let numbered = (2..).map(|n| Cow::Owned(format!("{name} ({n})")));
    let mut names = std::iter::once(Cow::Borrowed(name)).chain(numbered);
    let unused = names.find(|name| !taken.contains(name.as_ref())).expect("numbers do not end");
    taken.insert(unused.clone().into_owned());
    unused
}
