use super::{Axis, Cell, Turn};
use std::fmt;

/// Which axis of a grammar points up. In the game it is y; seed grammars in the z-up convention say `up z`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub enum Up {
    #[default]
    Y,
    Z,
}

impl Up {
    pub fn axis(self) -> Axis {
        match self {
            Up::Y => Axis::Y,
            Up::Z => Axis::Z,
        }
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.axis().fmt(f)
    }
}

/// How the axes that a rule names lie in the world: which one is up, then turned about the vertical.
///
/// Both conventions are right-handed, so a z-up grammar keeps its shape: x is east, z is the game's up,
/// and y runs north, away from someone who looks at the front. The front of a scope is its south side.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Frame {
    pub up: Up,
    pub turn: Turn,
}

impl Frame {
    /// The direction in the world of a local axis: a vector of length one.
    pub fn direction(self, axis: Axis) -> Cell {
        self.turn.apply(match (self.up, axis) {
            (Up::Y, axis) => axis.unit(),
            (Up::Z, Axis::X) => Cell::X,
            (Up::Z, Axis::Y) => Cell::NEG_Z,
            (Up::Z, Axis::Z) => Cell::Y,
        })
    }

    /// The world axis that a local axis lies on.
    pub fn world_axis(self, axis: Axis) -> Axis {
        let direction = self.direction(axis).abs();
        if direction.x == 1 {
            Axis::X
        } else if direction.y == 1 {
            Axis::Y
        } else {
            Axis::Z
        }
    }

    /// The plan's two directions in the world: to the right, and away from the front.
    pub fn plan(self) -> [Cell; 2] {
        let away = match self.up {
            Up::Y => -self.direction(Axis::Z),
            Up::Z => self.direction(Axis::Y),
        };
        [self.direction(Axis::X), away]
    }

    pub fn turned(self, turn: Turn) -> Frame {
        Frame { turn: self.turn + turn, ..self }
    }
}
