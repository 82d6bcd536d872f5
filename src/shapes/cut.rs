//! Shapes cut where shapes of other planes meet them: the "post split" of the authors' program.

use super::building::{Block, Building};
use super::shape::Shape;
use crate::space::Axis;
use std::collections::BTreeSet;

/// Cuts shapes on floors, then on walls: what has blocks on both sides of the plane of a shape that it touches becomes two.
/// The blocks in the plane go with what is below a floor, and with both sides of a wall.
pub fn cut(building: &Building, shapes: Vec<Shape>) -> Vec<Shape> {
    [Axis::Y, Axis::Z, Axis::X]
        .into_iter()
        .fold(shapes, |shapes, across| cut_across(building, shapes, across))
}

fn cut_across(building: &Building, mut shapes: Vec<Shape>, across: Axis) -> Vec<Shape> {
    // Solid shapes cut as well, as if they stood in the plane of their first block.
    let is_across = |shape: &&Shape| shape.layer.seen_along() == across;
    let planes: Vec<Shape> = shapes.iter().filter(is_across).cloned().collect();
    for plane in planes {
        let around: BTreeSet<Block> =
            plane.blocks.iter().flat_map(|block| building.beside(*block, &Axis::ALL)).collect();
        let mut parts = Vec::new();
        shapes.retain(|shape| {
            let touches = *shape != plane && shape.blocks.iter().any(|block| around.contains(block));
            let cut = touches.then(|| sides(building, shape, across, &plane)).flatten();
            let is_whole = cut.is_none();
            parts.extend(cut.into_iter().flatten());
            is_whole
        });
        shapes.extend(parts);
    }
    shapes
}

/// The two sides of a shape, above and below a plane; none if it lies on one side.
fn sides(building: &Building, shape: &Shape, across: Axis, plane: &Shape) -> Option<[Shape; 2]> {
    let place = |block: &Block| across.of(building.cell(*block));
    let at = place(plane.blocks.first()?);
    let of = |side: std::cmp::Ordering| {
        shape.blocks.iter().copied().filter(move |block| place(block).cmp(&at) == side)
    };
    let [below, within, above] =
        [std::cmp::Ordering::Less, std::cmp::Ordering::Equal, std::cmp::Ordering::Greater]
            .map(|side| of(side).collect::<Vec<Block>>());
    if below.is_empty() || above.is_empty() {
        return None;
    }
    let above = if across == Axis::Y { above } else { [above, within.clone()].concat() };
    Some([above, [below, within].concat()].map(|blocks| Shape { layer: shape.layer, blocks }))
}
