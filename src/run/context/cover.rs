use crate::space::{Axis, Bounds};

/// Whether the boxes together hold every cell of `whole`.
pub fn covers(mut boxes: Vec<Bounds>, whole: &Bounds) -> bool {
    boxes.iter_mut().for_each(|bounds| *bounds = bounds.intersect(whole));
    boxes.retain(|bounds| !bounds.is_empty());
    let volume = boxes.iter().fold(0u64, |sum, bounds| sum.saturating_add(bounds.volume()));
    if volume < whole.volume() {
        return false;
    }
    // Large boxes first: what they leave is small.
    boxes.sort_by_key(|bounds| std::cmp::Reverse(bounds.volume()));
    is_covered(whole, &boxes)
}

/// Takes the first box that meets `piece` out of it, and asks the rest of the boxes for what is left.
fn is_covered(piece: &Bounds, boxes: &[Bounds]) -> bool {
    let mut left = vec![(*piece, 0)];
    while let Some((piece, first)) = left.pop() {
        if piece.is_empty() {
            continue;
        }
        let Some(at) = (first..boxes.len()).find(|&at| !boxes[at].intersect(&piece).is_empty()) else {
            return false;
        };
        left.extend(outside(&piece, &boxes[at]).map(|piece| (piece, at + 1)));
    }
    true
}

/// What of `piece` lies outside of a box that meets it, as boxes that share no cell.
fn outside(piece: &Bounds, bounds: &Bounds) -> impl Iterator<Item = Bounds> {
    let hole = bounds.intersect(piece);
    let mut core = *piece;
    Axis::ALL.into_iter().flat_map(move |axis| {
        let (low, high) = (axis.of(hole.min), axis.of(hole.max));
        let ends = [core.slab(axis, axis.of(core.min), low), core.slab(axis, high, axis.of(core.max))];
        core = core.slab(axis, low, high);
        ends
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Cell;
    use proptest::prelude::*;

    fn bounds() -> impl Strategy<Value = Bounds> {
        ([0..5i32, 0..5, 0..5], [0..6i32, 0..6, 0..6])
            .prop_map(|(min, size)| Bounds::new(Cell::from(min), Cell::from(min) + Cell::from(size)))
    }

    proptest! {
        #[test]
        fn what_is_covered_has_every_cell_in_a_box(boxes in prop::collection::vec(bounds(), 0..12), whole in bounds()) {
            let expected = whole.cells().all(|cell| boxes.iter().any(|bounds| bounds.contains(cell)));
            prop_assert_eq!(covers(boxes, &whole), expected);
        }
    }
}
