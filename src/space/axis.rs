use glam::IVec3;
use std::fmt;

/// One of the three axes of the game: x is east, y is up, z is south.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    pub fn index(self) -> usize {
        self as usize
    }

    /// The component of `v` along this axis.
    pub fn of(self, v: IVec3) -> i32 {
        v[self.index()]
    }

    /// The vector of length one along this axis.
    pub fn unit(self) -> IVec3 {
        IVec3::AXES[self.index()]
    }

    /// The two other axes, in order.
    pub fn others(self) -> [Axis; 2] {
        match self {
            Axis::X => [Axis::Y, Axis::Z],
            Axis::Y => [Axis::X, Axis::Z],
            Axis::Z => [Axis::X, Axis::Y],
        }
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["x", "y", "z"][self.index()])
    }
}
