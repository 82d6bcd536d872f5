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

/// Whether all regions lie in the grid, and all blocks in regions.
fn cover(grid: &Grid) -> bool {
    let mut bounds = grid.metadata.regions.iter().map(|region| region.bounds);
    if !bounds.clone().all(|bounds| !bounds.is_empty() && grid.bounds().contains_box(&bounds)) {
        return false;
    }
    if bounds.any(|bounds| bounds == grid.bounds()) {
        return true;
    }
    let nobodys = grid.palette().find(&BlockState::structure_void());
    let mut left_out = grid.cells().mapv(|id| Some(id) != nobodys);
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
