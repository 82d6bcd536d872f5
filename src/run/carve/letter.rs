use super::{Body, Piece, Selection, parted};
use crate::grammar::ast::{Carving, Selector};
use crate::space::{Footprint, Frame, Rect, shape_h, shape_l, shape_o, shape_t, shape_u};

/// A body cut in the shape of a letter, and what remains of it.
pub fn letter(how: Carving, widths: &[i32], body: &Body, selection: &Selection) -> Vec<Piece> {
    let ground = body.ground();
    let area = Rect::under(&body.scope.bounds);
    let letter = drawn(how, widths, area, body.scope.frame);
    let shape = match body.footprint {
        Some(_) => Footprint::from_fn(area, |spot| letter.contains(spot) && ground.contains(spot)),
        None => letter,
    };
    let remainder = ground.without(&shape);
    parted(body, [(Selector::Shape, shape), (Selector::Remainder, remainder)], selection)
}

fn drawn(how: Carving, widths: &[i32], area: Rect, frame: Frame) -> Footprint {
    match (how, widths) {
        (Carving::L, &[front, left]) => shape_l(area, frame, front, left),
        (Carving::U, &[front, right, left]) => shape_u(area, frame, front, right, left),
        (Carving::T, &[front, stem]) => shape_t(area, frame, front, stem),
        (Carving::H, &[right, across, left]) => shape_h(area, frame, right, across, left),
        (Carving::O, &[front, ref others @ ..]) => {
            let right = others.first().copied().unwrap_or(front);
            let back = others.get(1).copied().unwrap_or(front);
            shape_o(area, frame, [front, right, back, others.get(2).copied().unwrap_or(right)])
        }
        (Carving::Round, _) => Footprint::round(area),
        _ => Footprint::full(area),
    }
}
