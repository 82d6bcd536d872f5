use super::{Body, Piece, Selection, parted};
use crate::grammar::ast::Selector;
use crate::space::{Footprint, Rect};

/// The border of a body, `depth` blocks wide, in one piece, and what is left within. Corners are mitred.
pub fn offset(depth: i32, body: &Body, selection: &Selection) -> Vec<Piece> {
    let ground = body.ground();
    let inside = match &body.footprint {
        Some(footprint) => footprint.eroded(depth),
        None => Footprint::full(Rect::under(&body.scope.bounds).grown(-depth)),
    };
    let border = ground.without(&inside);
    parted(body, [(Selector::Border, border), (Selector::Inside, inside)], selection)
}
