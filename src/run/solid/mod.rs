//! Solids that fill their scope: cylinders, balls, arches and spiral stairs.

mod arch;
mod round;
mod spiral;

use crate::block::{BlockState, Family};
use crate::space::{Cell, Footprint, Scope};
use glam::Vec3Swizzles;

/// What a primitive leaves open.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Options {
    /// Blocks up a block on; without it the scope's height decides.
    pub pitch: Option<f64>,
    /// How many blocks the eaves of a roof reach out.
    pub overhang: i32,
    /// How many blocks thick the shell is; without it all is solid.
    pub thickness: Option<i32>,
    /// What the walls below a gable are made of, where not of the roof's blocks.
    pub wall: Option<BlockState>,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    /// Round, upright.
    Cylinder,
    Sphere,
    /// An opening under a half circle, from left to right.
    Arch,
    /// Steps around a post.
    SpiralStair,
}

/// Calls `put` with every cell of a solid in `scope` and the block that goes there.
pub fn build(
    kind: Kind,
    family: &Family,
    options: &Options,
    (scope, footprint): (&Scope, Option<&Footprint>),
    put: &mut dyn FnMut(Cell, &BlockState),
) {
    let widest = scope.bounds.size().max_element();
    let thickness =
        options.thickness.filter(|&thickness| thickness > 0).map(|thickness| thickness.min(widest));
    let mut inside = |cell: Cell, state: &BlockState| {
        if footprint.is_none_or(|footprint| footprint.contains(cell.xz())) {
            put(cell, state);
        }
    };
    match kind {
        Kind::Cylinder => round::cylinder(thickness, scope, |cell| inside(cell, &family.full)),
        Kind::Sphere => round::sphere(thickness, scope, |cell| inside(cell, &family.full)),
        Kind::Arch => arch::arch(thickness.unwrap_or(1), family, scope, &mut inside),
        Kind::SpiralStair => spiral::spiral_stair(family, scope, &mut inside),
    }
}

#[cfg(test)]
mod tests;
