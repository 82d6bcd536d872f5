//! Component splits, setbacks, offsets and letters: operations that carve named parts out of a scope. No cell is in
//! two parts, and none lies outside of what is carved.

mod component;
mod letter;
mod level;
mod offset;
mod peel;
mod selection;
mod shell;

use super::body::Body;
use crate::grammar::ast::{Carving, Selector};
use crate::graph::NodeIndex;
use crate::space::Footprint;
use selection::Selection;

/// A part that was carved out: its number, its operation, its scope and what is there of it.
pub struct Part {
    pub number: usize,
    pub child: NodeIndex,
    pub body: Body,
}

/// The named parts of a body, in the order of the text.
pub fn carve(how: Carving, args: &[i32], body: &Body, named: &[(&Selector, NodeIndex)]) -> Vec<Part> {
    let selection = Selection::new(how, body.scope.frame.turn, named.iter().map(|(selector, _)| *selector));
    let mut pieces = pieces(how, args, body, &selection);
    pieces.sort_by_key(|piece| piece.chosen);
    pieces
        .into_iter()
        .map(|piece| Part { number: piece.number, child: named[piece.chosen].1, body: piece.body })
        .collect()
}

/// A part, and the place in the text of the selector that names it.
struct Piece {
    chosen: usize,
    number: usize,
    body: Body,
}

fn pieces(how: Carving, args: &[i32], body: &Body, selection: &Selection) -> Vec<Piece> {
    let depth = args.first().copied().unwrap_or(1);
    match how {
        Carving::Faces | Carving::Setback if body.footprint.is_none() => {
            peel::peel(&body.scope, depth, selection)
        }
        Carving::Faces | Carving::Setback | Carving::Edges | Carving::Vertices => {
            shell::shell(how, depth, body, selection)
        }
        Carving::Offset => offset::offset(depth, body, selection),
        _ => letter::letter(how, args, body, selection),
    }
}

/// The connected parts of two footprints as pieces, each as high as the body they were carved from.
fn parted(body: &Body, parts: [(Selector, Footprint); 2], selection: &Selection) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut number = 0;
    for (selector, footprint) in parts {
        for part in footprint.parts(body.scope.frame) {
            if let Some(chosen) = selection.of(&selector) {
                pieces.push(Piece { chosen, number, body: Body::standing(part, body.levels(), &body.scope) });
            }
            number += 1;
        }
    }
    pieces
}
