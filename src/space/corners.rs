use super::{Bounds, Cell};
use rstar::{AABB, RTreeObject};

/// A box as trees of boxes hold it.
///
/// Corners are real numbers: such a tree multiplies lengths, and whole numbers would overflow there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Corners(pub Bounds);

impl RTreeObject for Corners {
    type Envelope = AABB<[f64; 3]>;

    fn envelope(&self) -> Self::Envelope {
        let corner = |corner: Cell| corner.as_dvec3().to_array();
        AABB::from_corners(corner(self.0.min), corner(self.0.max))
    }
}
