//! Top-down, greedily (seed 4, section 6.2): all lines across one axis at once, and the first repeat that is found.

use super::cuts::{Cutter, StructureId};
use super::fold::{Folding, folded};
use super::plan::Decision;
use super::{Region, Side};

/// All lines across the axis along which more repeats; storeys come first where both are alike.
pub fn decision(
    cutter: &Cutter,
    region: &Region,
    structure: &mut impl FnMut(&Region) -> StructureId,
) -> Decision {
    let mut gain = |axis: Side| {
        let cuts = cutter.cuts(region, axis);
        let ids: Vec<StructureId> = cutter.parts(region, axis, &cuts).map(|part| structure(&part)).collect();
        let said: usize = folded(&ids, Folding::Greedy).iter().map(|run| run.unit.len()).sum();
        (!cuts.is_empty(), ids.len() - said, cuts.len())
    };
    let (across, up) = (gain(Side::X), gain(Side::Y));
    let (axis, lines) =
        if up.0 && (!across.0 || up.1 >= across.1) { (Side::Y, up.2) } else { (Side::X, across.2) };
    Decision { axis, lines: (0..lines as u16).collect() }
}
