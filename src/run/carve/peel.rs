//! The faces of a plain box, taken off one after the other.

use super::component::{Level, Sides, UPRIGHT};
use super::{Body, Piece, Selection};
use crate::grammar::ast::Selector;
use crate::space::{Axis, Scope, Turn, Up};

/// The named faces of a scope, `depth` blocks thick, and what is left within.
pub fn peel(scope: &Scope, depth: i32, selection: &Selection) -> Vec<Piece> {
    let mut left = *scope;
    let mut pieces = Vec::with_capacity(7);
    let faces = faces(scope, selection);
    let count = faces.len();
    for (number, sides) in faces.into_iter().enumerate() {
        if let Some(chosen) = selection.chosen(number, &sides)
            && (depth == 0 || !left.is_empty())
        {
            let (slab, rest) = cut(&left, &sides, depth);
            let slab = Scope { frame: selection.frame(&sides, scope.frame), ..slab };
            pieces.push(Piece { chosen, number, body: Body::whole(slab) });
            left = rest;
        }
    }
    if let Some(chosen) = selection.of(&Selector::Inside)
        && !left.is_empty()
    {
        pieces.push(Piece { chosen, number: count, body: Body::whole(left) });
    }
    pieces
}

/// The faces in the order in which they take cells.
fn faces(scope: &Scope, selection: &Selection) -> Vec<Sides> {
    let upright = UPRIGHT.map(|quarters| Sides::wall(scope.frame.turn + Turn::quarters(quarters)));
    let levels = [Level::Top, Level::Bottom].map(Sides::level);
    levels.into_iter().filter(|_| selection.has_levels()).chain(upright).collect()
}

/// The slab of a face, and what is left of the scope.
fn cut(scope: &Scope, sides: &Sides, depth: i32) -> (Scope, Scope) {
    let up = scope.frame.up.axis();
    let (axis, is_low) = match sides.level {
        Some(level) => (up, level == Level::Bottom),
        None => upright(scope, sides),
    };
    let length = scope.len(axis);
    let depth = depth.min(length);
    match is_low {
        true => (scope.part(axis, 0, depth), scope.part(axis, depth, length)),
        false => (scope.part(axis, length - depth, length), scope.part(axis, 0, length - depth)),
    }
}

/// The axis that an upright face cuts, and whether it is at its low end.
fn upright(scope: &Scope, sides: &Sides) -> (Axis, bool) {
    // The front is where the plan's second direction comes from: the high end of z, or the low end of y.
    let (depth, front_is_low) = match scope.frame.up {
        Up::Y => (Axis::Z, false),
        Up::Z => (Axis::Y, true),
    };
    let turn = sides.walls.first().map_or(0, |turn| (*turn + scope.frame.turn.inverse()).count());
    match turn {
        0 => (depth, front_is_low),
        1 => (Axis::X, false),
        2 => (depth, !front_is_low),
        _ => (Axis::X, true),
    }
}
