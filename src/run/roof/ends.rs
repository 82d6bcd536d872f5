//! Which walls of a footprint end in a gable.

use crate::space::{Corner, Footprint, Spot, View, Wall};

/// The ends of wings: walls between two convex corners that are shorter than their neighbours, or as long and
/// facing left or right. A neighbour that another wing cuts short does not count. Of a rectangle the left and
/// the right wall are the ends, however long.
pub fn gable_ends(footprint: &Footprint, view: &View) -> Vec<Wall> {
    let walls = footprint.walls();
    let is_end = |wall: &&Wall| match footprint.is_rectangle() {
        true => faces_aside(wall, view),
        false => is_wing_end(wall, &walls, view) && has_ridge(wall, footprint),
    };
    walls.iter().filter(is_end).copied().collect()
}

/// All walls between two convex corners.
pub fn cross_gable_ends(footprint: &Footprint) -> Vec<Wall> {
    let ends = footprint.walls().into_iter().filter(|wall| wall.ends == [Corner::Convex; 2]);
    ends.filter(|wall| footprint.is_rectangle() || has_ridge(wall, footprint)).collect()
}

fn faces_aside(wall: &Wall, view: &View) -> bool {
    let [right, _] = view.directions();
    wall.outward().dot(right) != 0
}

fn is_wing_end(wall: &Wall, walls: &[Wall], view: &View) -> bool {
    let is_shorter = |other: &Wall| match wall.len().cmp(&other.len()) {
        std::cmp::Ordering::Less => true,
        std::cmp::Ordering::Equal => faces_aside(wall, view),
        std::cmp::Ordering::Greater => false,
    };
    let mut sides = [(0, -wall.right()), (1, wall.right())].into_iter();
    wall.ends == [Corner::Convex; 2]
        && sides.all(|(side, way)| {
            let neighbour = neighbour(wall, walls, way);
            neighbour.is_none_or(|other| other.ends[side] == Corner::Reflex || is_shorter(other))
        })
}

/// The wall that faces `way` at the end of another.
fn neighbour<'w>(wall: &Wall, walls: &'w [Wall], way: Spot) -> Option<&'w Wall> {
    let last = if way.max_element() > 0 { wall.cells.max - 1 } else { wall.cells.min };
    walls.iter().find(|other| other.outward() == way && other.cells.contains(last))
}

/// Whether the wing behind a wall is deep enough for the ridge of a gable as wide as the wall.
fn has_ridge(wall: &Wall, footprint: &Footprint) -> bool {
    let depths = footprint.wing_depths(wall, &[*wall], 0);
    footprint.spots().any(|spot| depths.at(spot) >= (wall.len() + 1) / 2)
}
