use super::Cell;
use std::ops::Add;

/// A number of quarter turns about the vertical, counter-clockwise seen from above:
/// one turn takes east (+x) to north (-z). Turns add up like numbers modulo four.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct Turn(u8);

impl Turn {
    pub const NONE: Turn = Turn(0);
    pub const ALL: [Turn; 4] = [Turn(0), Turn(1), Turn(2), Turn(3)];

    /// `quarters` may be negative or above three.
    pub fn quarters(quarters: i32) -> Turn {
        Turn(quarters.rem_euclid(4) as u8)
    }

    pub fn count(self) -> u8 {
        self.0
    }

    pub fn inverse(self) -> Turn {
        Turn::quarters(-i32::from(self.0))
    }

    /// Turns a vector about the origin.
    pub fn apply(self, v: Cell) -> Cell {
        match self.0 {
            0 => v,
            1 => Cell::new(v.z, v.y, -v.x),
            2 => Cell::new(-v.x, v.y, -v.z),
            _ => Cell::new(-v.z, v.y, v.x),
        }
    }
}

impl Add for Turn {
    type Output = Turn;

    fn add(self, other: Turn) -> Turn {
        Turn((self.0 + other.0) % 4)
    }
}
