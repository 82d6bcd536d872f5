use super::site::{Answer, Site};
use crate::block::{Facing, Half, Shape};
use crate::space::Cell;

/// The corner that stairs make: outwards with stairs behind them, inwards with stairs before them, in the same
/// half and across. A row of stairs that goes on past the corner stays straight.
pub fn corner(site: &Site<'_>, cell: Cell) -> Answer {
    let Some(own) = stairs(site, cell) else { return Answer::new() };
    let (facing, _) = own;
    let across = |side: Facing| {
        let (other, half) = stairs(site, cell + side.step())?;
        (half == own.1 && other.axis() != facing.axis()).then_some(other)
    };
    let goes_on = |side: Facing| stairs(site, cell + side.step()) == Some(own);
    let outer = across(facing).filter(|other| !goes_on(other.opposite()));
    let inner = across(facing.opposite()).filter(|other| !goes_on(*other));
    let shape = match (outer, inner) {
        (Some(other), _) if other == facing.left() => "outer_left",
        (Some(_), _) => "outer_right",
        (None, Some(other)) if other == facing.left() => "inner_left",
        (None, Some(_)) => "inner_right",
        (None, None) => "straight",
    };
    Answer::from_iter([("shape", shape)])
}

fn stairs(site: &Site<'_>, cell: Cell) -> Option<(Facing, Half)> {
    match site.block(cell).shape {
        Shape::Stairs { facing, half, .. } => Some((facing, half)),
        _ => None,
    }
}
