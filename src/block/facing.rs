use crate::space::{Axis, Cell, Turn};

/// One of the six sides of a block.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Facing {
    North,
    East,
    South,
    West,
    Up,
    Down,
}

use Facing::*;

impl Facing {
    /// The four sides that are not up or down, clockwise seen from above.
    pub const HORIZONTAL: [Facing; 4] = [North, East, South, West];
    pub const ALL: [Facing; 6] = [North, East, South, West, Up, Down];

    /// Reads a name as properties have it.
    pub fn named(name: &str) -> Option<Facing> {
        Facing::ALL.into_iter().find(|facing| facing.name() == name)
    }

    pub fn name(self) -> &'static str {
        ["north", "east", "south", "west", "up", "down"][self as usize]
    }

    /// The step to the neighbour on this side.
    pub fn step(self) -> Cell {
        match self {
            North => Cell::NEG_Z,
            East => Cell::X,
            South => Cell::Z,
            West => Cell::NEG_X,
            Up => Cell::Y,
            Down => Cell::NEG_Y,
        }
    }

    pub fn axis(self) -> Axis {
        match self {
            East | West => Axis::X,
            Up | Down => Axis::Y,
            North | South => Axis::Z,
        }
    }

    pub fn opposite(self) -> Facing {
        match self {
            North => South,
            East => West,
            South => North,
            West => East,
            Up => Down,
            Down => Up,
        }
    }

    pub fn turned(self, turn: Turn) -> Facing {
        let clockwise = usize::from(turn.inverse().count());
        Facing::HORIZONTAL
            .get(self as usize)
            .map_or(self, |_| Facing::HORIZONTAL[(self as usize + clockwise) % 4])
    }

    /// The side to the left of someone who looks this way; up and down stay.
    pub fn left(self) -> Facing {
        self.turned(Turn::quarters(1))
    }

    /// The side to the right of someone who looks this way; up and down stay.
    pub fn right(self) -> Facing {
        self.turned(Turn::quarters(-1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_a_side_turns_its_step() {
        for facing in Facing::ALL {
            for turn in Turn::ALL {
                assert_eq!(facing.turned(turn).step(), turn.apply(facing.step()));
            }
            assert_eq!(facing.opposite().step(), -facing.step());
            assert_eq!(Facing::named(facing.name()), Some(facing));
        }
        assert_eq!(East.left(), North);
        assert_eq!(Facing::named("nowhere"), None);
    }
}
