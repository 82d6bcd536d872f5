//! Component splits: a scope's faces, which tile its shell.

use crate::grammar::ast::{Carving, Face, Selector};
use crate::graph::NodeIndex;
use crate::space::{Axis, Scope, Turn, Up};

/// A part that was carved out: its number, its operation and its scope.
pub struct Part {
    pub number: usize,
    pub child: NodeIndex,
    pub scope: Scope,
}

/// The named parts of a scope.
pub fn carve(how: Carving, _args: &[i32], scope: &Scope, named: &[(&Selector, NodeIndex)]) -> Vec<Part> {
    let _ = how;
    let faces = named.iter().filter_map(|(selector, child)| match selector {
        Selector::On(faces) => Some((*faces.first()?, *child)),
        _ => None,
    });
    shell(scope, &faces.collect::<Vec<_>>())
}

/// The faces in the order in which they take cells. A cell that lies on several of the named faces belongs
/// to the first of them, so that together they tile the shell once.
const ORDER: [Face; 6] = [Face::Top, Face::Bottom, Face::Front, Face::Back, Face::Left, Face::Right];

/// The named faces of a scope: the number of each, its operation and its scope.
fn shell(scope: &Scope, named: &[(Face, NodeIndex)]) -> Vec<Part> {
    let mut rest = *scope;
    let mut faces = Vec::new();
    for (number, face) in ORDER.into_iter().enumerate() {
        if let Some(child) = named_face(named, face)
            && !rest.is_empty()
        {
            let (slab, inner) = peel(&rest, face);
            faces.push(Part { number, child, scope: slab });
            rest = inner;
        }
    }
    faces
}

/// The operation for a face: the one that names it, else that for all sides, else that for all faces.
fn named_face(parts: &[(Face, NodeIndex)], face: Face) -> Option<NodeIndex> {
    let is_upright = !matches!(face, Face::Top | Face::Bottom);
    let names = [Some(face), is_upright.then_some(Face::Side), Some(Face::All)];
    let mut found =
        names.into_iter().flatten().filter_map(|name| parts.iter().find(|(known, _)| *known == name));
    found.next().map(|(_, child)| *child)
}

/// The slab of a face, with its own axes (x along the face from left to right as seen from outside), and
/// what is left of the scope.
fn peel(scope: &Scope, face: Face) -> (Scope, Scope) {
    // The front is where the plan's second direction comes from: the high end of z, or the low end of y.
    let (depth, front_is_low) = match scope.frame.up {
        Up::Y => (Axis::Z, false),
        Up::Z => (Axis::Y, true),
    };
    let up = scope.frame.up.axis();
    let (axis, is_low, turn) = match face {
        Face::Top => (up, false, 0),
        Face::Bottom => (up, true, 0),
        Face::Back => (depth, !front_is_low, 2),
        Face::Left => (Axis::X, true, 3),
        Face::Right => (Axis::X, false, 1),
        _ => (depth, front_is_low, 0),
    };
    let length = scope.len(axis);
    let (shell, rest) = match is_low {
        true => (scope.part(axis, 0, 1), scope.part(axis, 1, length)),
        false => (scope.part(axis, length - 1, length), scope.part(axis, 0, length - 1)),
    };
    (shell.turned(Turn::quarters(turn)), rest)
}
