use super::{Axis, Bounds, Cell, Frame, Turn};

/// Where a rule runs: a half-open box in the world, and how the rule's own axes lie in it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Scope {
    pub bounds: Bounds,
    pub frame: Frame,
}

impl Scope {
    /// The start scope of `size` in the grammar's own axes, with its low corner at the world's origin.
    pub fn start(size: Cell, frame: Frame) -> Scope {
        let mut world = Cell::ZERO;
        for axis in Axis::ALL {
            world[frame.world_axis(axis).index()] = axis.of(size);
        }
        Scope { bounds: Bounds::of_size(world), frame }
    }

    /// The length along a local axis.
    pub fn len(&self, axis: Axis) -> i32 {
        self.bounds.len(self.frame.world_axis(axis))
    }

    pub fn is_empty(&self) -> bool {
        self.bounds.is_empty()
    }

    /// The part from `low` to `high` along a local axis, counted from the scope's low end on that axis.
    pub fn part(&self, axis: Axis, low: i32, high: i32) -> Scope {
        let world = self.frame.world_axis(axis);
        let (start, end) = (world.of(self.bounds.min), world.of(self.bounds.max));
        let bounds = if world.of(self.frame.direction(axis)) > 0 {
            self.bounds.slab(world, start + low, start + high)
        } else {
            self.bounds.slab(world, end - high, end - low)
        };
        Scope { bounds, ..*self }
    }

    /// How far along a local axis the middle of a cell lies, from 0 at the low end to 1 at the high one.
    pub fn along(&self, axis: Axis, cell: Cell) -> f64 {
        let world = self.frame.world_axis(axis);
        let from_low = f64::from(world.of(cell) - world.of(self.bounds.min)) + 0.5;
        let share = from_low / f64::from(self.bounds.len(world).max(1));
        if world.of(self.frame.direction(axis)) > 0 { share } else { 1.0 - share }
    }

    /// The same box with its axes turned.
    pub fn turned(&self, turn: Turn) -> Scope {
        Scope { frame: self.frame.turned(turn), ..*self }
    }

    /// The scope moved by `delta` along its own axes.
    pub fn moved(&self, delta: Cell) -> Scope {
        let shift = Axis::ALL.iter().map(|&axis| self.frame.direction(axis) * axis.of(delta)).sum::<Cell>();
        Scope { bounds: Bounds::new(self.bounds.min + shift, self.bounds.max + shift), ..*self }
    }

    /// The scope with its lengths set to `size`; its low corner stays.
    pub fn resized(&self, size: Cell) -> Scope {
        Axis::ALL.iter().fold(*self, |scope, &axis| scope.part(axis, 0, axis.of(size)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Up;
    use proptest::prelude::*;

    fn frames() -> impl Strategy<Value = Frame> {
        (prop_oneof![Just(Up::Y), Just(Up::Z)], 0..4)
            .prop_map(|(up, turn)| Frame { up, turn: Turn::quarters(turn) })
    }

    proptest! {
        #[test]
        fn frames_are_right_handed(frame in frames()) {
            let [x, y, z] = Axis::ALL.map(|axis| frame.direction(axis));
            prop_assert_eq!(x.cross(y), z);
        }

        #[test]
        fn two_parts_tile_the_scope(frame in frames(), size in [1..9i32, 1..9, 1..9], cut in 0..9i32, axis in 0..3usize) {
            let scope = Scope::start(Cell::from(size), frame);
            let axis = Axis::ALL[axis];
            let cut = cut.min(scope.len(axis));
            let (low, high) = (scope.part(axis, 0, cut), scope.part(axis, cut, scope.len(axis)));
            prop_assert_eq!(low.bounds.volume() + high.bounds.volume(), scope.bounds.volume());
            prop_assert_eq!(low.bounds.union(&high.bounds), scope.bounds);
            prop_assert!(low.bounds.intersect(&high.bounds).is_empty());
        }

        #[test]
        fn lengths_are_those_of_the_start(frame in frames(), size in [1..9i32, 1..9, 1..9]) {
            let scope = Scope::start(Cell::from(size), frame);
            prop_assert_eq!(Axis::ALL.map(|axis| scope.len(axis)), size);
            prop_assert_eq!(scope.resized(Cell::from(size)), scope);
        }
    }

    #[test]
    fn the_low_end_of_a_z_up_grammars_y_is_its_front() {
        let scope = Scope::start(Cell::new(5, 4, 3), Frame { up: Up::Z, turn: Turn::NONE });
        assert_eq!(scope.bounds.max, Cell::new(5, 3, 4));
        assert_eq!(scope.part(Axis::Y, 0, 1).bounds, Bounds::new(Cell::new(0, 0, 3), Cell::new(5, 3, 4)));
    }
}
