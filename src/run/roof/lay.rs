//! From the tops of columns to blocks.

use super::Site;
use super::cap::{Cover, Tops, slab};
use crate::block::{BlockState, Family};
use crate::run::solid::Options;
use crate::space::{Cell, Footprint, SIDES, Spot};
use std::ops::Range;

/// Calls `put` with every block of a roof.
pub fn lay(
    site: &Site,
    tops: &Tops,
    family: &Family,
    options: &Options,
    put: &mut dyn FnMut(Cell, &BlockState),
) {
    let end = options.wall.as_ref().unwrap_or(&family.full);
    for spot in site.footprint.spots() {
        let column = Column::of(spot, site, tops, options);
        for level in column.end {
            put(site.cell(spot, level), end);
        }
        for level in column.body {
            put(site.cell(spot, level), &family.full);
        }
        put(site.cell(spot, tops.at(spot).level), &tops.block(spot, family));
    }
    for spot in site.reach.spots().filter(|&spot| !site.footprint.contains(spot)) {
        let top = tops.at(spot).level;
        for level in shut_from(spot, tops, &site.reach).min(top)..top {
            put(site.cell(spot, level), &family.full);
        }
        put(site.cell(spot, top), &eave(spot, tops, family));
    }
}

/// The level from which on a column has to be filled so that nothing is open between it and lower ones beside it.
fn shut_from(spot: Spot, tops: &Tops, among: &Footprint) -> i32 {
    let beside = SIDES.into_iter().filter(|&side| among.contains(spot + side));
    beside.map(|side| tops.open_from(spot + side, -side)).min().unwrap_or(i32::MAX)
}

/// Where a level eave could be a full block it is the upper half of one.
fn eave(spot: Spot, tops: &Tops, family: &Family) -> BlockState {
    match (tops.at(spot).cover, &family.slab) {
        (Cover::Full, Some(_)) => slab(family).with("type", "top"),
        _ => tops.block(spot, family),
    }
}

/// A column of the footprint below its top, level by level.
struct Column {
    /// The wall under a gable.
    end: Range<i32>,
    /// The roof itself.
    body: Range<i32>,
}

impl Column {
    fn of(spot: Spot, site: &Site, tops: &Tops, options: &Options) -> Column {
        let top = tops.at(spot).level;
        let is_edge = SIDES.iter().any(|side| !site.footprint.contains(spot + side));
        // At the edge it reaches down to where the slope goes on outside.
        let outside = SIDES.iter().map(|&side| tops.at(spot + side).level + 1).min().filter(|_| is_edge);
        let shut = shut_from(spot, tops, &site.footprint).min(outside.unwrap_or(i32::MAX));
        let thickness = options.thickness.unwrap_or(1).max(1);
        let bottom = shut.min(top.saturating_sub(thickness - 1)).clamp(0, top);
        match (is_edge, options.thickness) {
            (true, _) => Column { end: 0..bottom, body: bottom..top },
            (false, Some(thickness)) if thickness > 0 => Column { end: 0..0, body: bottom..top },
            (false, _) => Column { end: 0..0, body: 0..top },
        }
    }
}
