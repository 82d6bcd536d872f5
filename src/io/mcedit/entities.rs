use crate::grid::Entity;
use crate::io::ReadError;
use crate::io::entities::{Found, Frame};
use crate::io::fields::Fields;
use crate::space::Cell;
use glam::DVec3;

/// The entities of a schematic of `size`. MCEdit counts from the low corner, WorldEdit as in the world, where it says that
/// the low corner was at `WEOrigin`. Other programs keep that tag and count from the corner: so the way counts
/// that puts entities nearer to the build, and WorldEdit's where both do as well.
pub(super) fn read(root: &Fields, size: Cell) -> Result<Found, ReadError> {
    let from_corner = counted(root, Cell::ZERO)?;
    let [x, y, z] = ["WEOriginX", "WEOriginY", "WEOriginZ"].map(|name| root.find::<i32>(name));
    let (Some(x), Some(y), Some(z)) = (x?, y?, z?) else { return Ok(from_corner) };
    let in_world = counted(root, Cell::new(x, y, z))?;
    let away = |found: &Found| found.entities.iter().map(|entity| away(entity, size)).sum::<f64>();
    Ok(if away(&in_world) <= away(&from_corner) { in_world } else { from_corner })
}

fn counted(root: &Fields, low: Cell) -> Result<Found, ReadError> {
    let mut found = Found::default();
    found.add_list(&root.list("Entities")?, Frame::at(low))?;
    Ok(found)
}

/// How far an entity is from the box of the build.
fn away(entity: &Entity, size: Cell) -> f64 {
    let place = DVec3::from_array(entity.place);
    (place - place.clamp(DVec3::ZERO, size.as_dvec3())).length()
}
