//! Footprints in the shape of letters, seen from the front of a scope. A wing that is wider than the scope fills it;
//! one of no width is not there.

use super::Footprint;
use crate::space::{Frame, Rect, Spot, View};

/// A wing along the front, and one along the left side.
pub fn shape_l(area: Rect, frame: Frame, front: i32, left: i32) -> Footprint {
    seen(area, frame, |at, _| at.y < front || at.x < left)
}

/// A wing along the front, one along the right side and one along the left.
pub fn shape_u(area: Rect, frame: Frame, front: i32, right: i32, left: i32) -> Footprint {
    seen(area, frame, |at, size| at.y < front || at.x >= size.x - right || at.x < left)
}

/// Wings along the front, the right, the back and the left: a court is left open inside.
pub fn shape_o(area: Rect, frame: Frame, [front, right, back, left]: [i32; 4]) -> Footprint {
    seen(area, frame, |at, size| {
        at.y < front || at.x >= size.x - right || at.y >= size.y - back || at.x < left
    })
}

/// A wing along the front, and one from its middle to the back.
pub fn shape_t(area: Rect, frame: Frame, front: i32, stem: i32) -> Footprint {
    seen(area, frame, |at, size| at.y < front || is_middle(at.x, size.x, stem))
}

/// A wing along the right side and one along the left, and one across the middle between them.
pub fn shape_h(area: Rect, frame: Frame, right: i32, across: i32, left: i32) -> Footprint {
    seen(area, frame, |at, size| at.x >= size.x - right || at.x < left || is_middle(at.y, size.y, across))
}

/// Whether a cell is in the middle part of a length. A middle that cannot be even is nearer to the low end.
fn is_middle(at: i32, length: i32, middle: i32) -> bool {
    let start = (length - middle).div_euclid(2);
    (start..start + middle).contains(&at)
}

/// The cells that `holds` says are in, of each its place counted to the right and away from the front, and the
/// lengths that way.
fn seen(area: Rect, frame: Frame, holds: impl Fn(Spot, Spot) -> bool) -> Footprint {
    let view = View::of(area, frame);
    Footprint::from_fn(area, |spot| holds(view.place(spot), view.lengths()))
}

#[cfg(test)]
mod tests {
    use super::super::tests::drawing;
    use super::*;
    use crate::space::{Turn, Up};

    const AREA: Rect = Rect { min: Spot::ZERO, max: Spot::new(6, 5) };
    const FRAME: Frame = Frame { up: Up::Y, turn: Turn::NONE };

    #[test]
    fn letters_are_seen_from_the_front() {
        // The front is in the south, at the foot of the drawing.
        let drawn = |footprint| drawing(&footprint);
        assert_eq!(drawn(shape_l(AREA, FRAME, 2, 1)), ["#.....", "#.....", "#.....", "######", "######"]);
        assert_eq!(drawn(shape_u(AREA, FRAME, 1, 1, 2)), ["##...#", "##...#", "##...#", "##...#", "######"]);
        assert_eq!(
            drawn(shape_o(AREA, FRAME, [2, 1, 1, 2])),
            ["######", "##...#", "##...#", "######", "######"]
        );
        assert_eq!(drawn(shape_t(AREA, FRAME, 2, 2)), ["..##..", "..##..", "..##..", "######", "######"]);
        assert_eq!(drawn(shape_h(AREA, FRAME, 1, 1, 2)), ["##...#", "##...#", "######", "##...#", "##...#"]);
    }

    #[test]
    fn letters_turn_with_their_frame() {
        let turned = shape_l(AREA, FRAME.turned(Turn::quarters(1)), 1, 2);
        assert_eq!(drawing(&turned), [".....#", ".....#", ".....#", "######", "######"]);
        let z_up = shape_l(AREA, Frame { up: Up::Z, turn: Turn::NONE }, 2, 1);
        assert_eq!(z_up, shape_l(AREA, FRAME, 2, 1));
    }

    #[test]
    fn wide_wings_fill_and_thin_ones_are_not_there() {
        assert_eq!(shape_l(AREA, FRAME, 9, 1), Footprint::full(AREA));
        assert!(shape_u(AREA, FRAME, 0, -1, 0).is_empty());
    }
}
