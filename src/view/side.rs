use crate::space::Cell;
use glam::Vec3;

/// One of the three sides of a box that the camera sees from the south-east.
///
/// Each has its own axes `u` and `v`: `u` runs to the right of the picture, `v` down.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Side {
    Top,
    Left,
    Right,
}

impl Side {
    pub const ALL: [Side; 3] = [Side::Top, Side::Left, Side::Right];

    /// The step out of this side.
    pub fn normal(self) -> Cell {
        match self {
            Side::Top => Cell::Y,
            Side::Left => Cell::Z,
            Side::Right => Cell::X,
        }
    }

    /// The steps along `u` and `v`.
    pub fn axes(self) -> [Cell; 2] {
        match self {
            Side::Top => [Cell::X, Cell::Z],
            Side::Left => [Cell::X, Cell::NEG_Y],
            Side::Right => [Cell::NEG_Z, Cell::NEG_Y],
        }
    }

    /// Where `u` and `v` are zero on this side of a cell, in the plane through `inner`.
    pub fn origin(self, inner: Vec3) -> Vec3 {
        match self {
            Side::Top => Vec3::new(0.0, inner.y, 0.0),
            Side::Left => Vec3::new(0.0, 1.0, inner.z),
            Side::Right => Vec3::new(inner.x, 1.0, 1.0),
        }
    }

    /// The range of `u` and of `v` that a box covers, as `[[u, v]; 2]`, low then high.
    pub fn extent(self, low: Vec3, high: Vec3) -> [[f32; 2]; 2] {
        match self {
            Side::Top => [[low.x, low.z], [high.x, high.z]],
            Side::Left => [[low.x, 1.0 - high.y], [high.x, 1.0 - low.y]],
            Side::Right => [[1.0 - high.z, 1.0 - high.y], [1.0 - low.z, 1.0 - low.y]],
        }
    }

    /// The light that falls on this side, for red, green and blue: the sun is warm, the shade is cool.
    pub fn light(self) -> Vec3 {
        match self {
            Side::Top => Vec3::new(1.04, 1.03, 1.0),
            Side::Left => Vec3::new(0.84, 0.83, 0.83),
            Side::Right => Vec3::new(0.62, 0.63, 0.67),
        }
    }
}
