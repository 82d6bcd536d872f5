//! What there is to see of a block state, and what of its neighbours it hides.

use super::materials::Materials;
use super::quads::{Quad, outside};
use crate::block::{BlockState, Cuboid, Facing, boxes};
use crate::space::{Axis, Bounds, Cell};

/// Sixteenths along a block.
pub(super) const STEPS: i32 = 16;

pub(super) struct Look {
    /// The material of a block that fills its cell, which is drawn together with others.
    pub whole: Option<usize>,
    pub faces: Vec<Face>,
    /// What opaque parts cover of each side, by [`Facing`].
    opaque: [Patch; 6],
    /// The same of the parts that can be seen through, and their material.
    clear: [Patch; 6],
    clear_material: Option<usize>,
}

/// A rectangle of the outside, in sixteenths from the low corner of the cell.
pub(super) struct Face {
    pub material: usize,
    pub facing: Facing,
    pub corners: [Cell; 4],
    /// What it takes of the side of the cell; `None` within the cell.
    pub patch: Option<Patch>,
}

/// Some of the 16 x 16 squares of a side, as rows of bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Patch([u16; 16]);

impl Patch {
    pub const WHOLE: Patch = Patch([u16::MAX; 16]);

    /// What lies between two corners, seen along `axis`.
    fn between(low: Cell, high: Cell, axis: Axis) -> Patch {
        let [across, up] = axis.others();
        let bits = (across.of(low)..across.of(high)).fold(0, |bits, at| bits | 1 << at);
        let mut rows = [0; 16];
        rows[up.of(low) as usize..up.of(high) as usize].fill(bits);
        Patch(rows)
    }

    fn and(self, other: Patch) -> Patch {
        Patch(std::array::from_fn(|row| self.0[row] | other.0[row]))
    }

    fn contains(self, other: Patch) -> bool {
        self.and(other) == self
    }
}

impl Look {
    pub fn of(state: &BlockState, materials: &Materials) -> Look {
        let parts = boxes(state);
        let parts: Vec<(Cuboid, usize)> =
            parts.into_iter().map(|part| (part, materials.number(state, &part))).collect();
        let covered = |opaque: bool| {
            let parts = parts.iter().filter(|&&(_, material)| materials.is_opaque(material) == opaque);
            Facing::ALL
                .map(|side| parts.clone().fold(Patch::default(), |all, (b, _)| all.and(patch(b, side))))
        };
        let clear = |&&(_, material): &&(Cuboid, usize)| !materials.is_opaque(material);
        Look {
            whole: parts.first().filter(|(part, _)| fills_its_cell(part)).map(|&(_, material)| material),
            faces: faces(&parts),
            opaque: covered(true),
            clear: covered(false),
            clear_material: parts.iter().find(clear).map(|&(_, material)| material),
        }
    }

    /// Whether nothing is to be seen of what a neighbour of `material` has at `side`. What can be seen through hides
    /// only its like.
    pub fn hides(&self, side: Facing, patch: Patch, material: usize) -> bool {
        let at = side as usize;
        match self.clear_material == Some(material) {
            true => self.opaque[at].and(self.clear[at]).contains(patch),
            false => self.opaque[at].contains(patch),
        }
    }
}

fn fills_its_cell(part: &Cuboid) -> bool {
    (part.low, part.high) == (Cuboid::FULL.low, Cuboid::FULL.high)
}

fn corner(corner: [u8; 3]) -> Cell {
    Cell::from_array(corner.map(i32::from))
}

/// What a part covers of a side of its cell.
fn patch(part: &Cuboid, side: Facing) -> Patch {
    let (low, high) = (corner(part.low), corner(part.high));
    let axis = side.axis();
    let touches = if side.step().max_element() > 0 { axis.of(high) == STEPS } else { axis.of(low) == 0 };
    if touches { Patch::between(low, high, axis) } else { Patch::default() }
}

/// The outside of the parts together, where those that come first count where two overlap.
fn faces(parts: &[(Cuboid, usize)]) -> Vec<Face> {
    let cuts = Axis::ALL.map(|axis| cuts(parts, axis));
    let bounds = Bounds::of_size(Cell::from_array([0, 1, 2].map(|i| cuts[i].len().saturating_sub(1) as i32)));
    let place = |cell: Cell| Cell::from_array([0, 1, 2].map(|i| cuts[i][cell[i] as usize]));
    let material = |cell| {
        let low = place(cell);
        let found =
            parts.iter().find(|(part, _)| Bounds::new(corner(part.low), corner(part.high)).contains(low));
        found.map(|&(_, material)| material)
    };
    outside(bounds, material).into_iter().map(|quad| face(quad, place)).collect()
}

/// Where parts begin and end along an axis, each place once.
fn cuts(parts: &[(Cuboid, usize)], axis: Axis) -> Vec<i32> {
    let ends = parts.iter().flat_map(|(part, _)| [part.low, part.high]);
    let mut cuts: Vec<i32> = ends.map(|end| axis.of(corner(end))).collect();
    cuts.sort_unstable();
    cuts.dedup();
    cuts
}

fn face(quad: Quad, place: impl Fn(Cell) -> Cell) -> Face {
    let Quad { material, facing, corners } = quad;
    let corners = corners.map(place);
    let [low, high] = [Cell::min, Cell::max].map(|pick| corners.into_iter().fold(corners[0], pick));
    let axis = facing.axis();
    let end = if facing.step().max_element() > 0 { STEPS } else { 0 };
    let patch = (axis.of(low) == end).then(|| Patch::between(low, high, axis));
    Face { material, facing, corners, patch }
}
