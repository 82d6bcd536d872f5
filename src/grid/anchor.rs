use super::Grid;
use crate::block::{BlockState, Facing, Shape, shape};
use crate::space::Cell;

/// Where the player stands who puts a build down.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    /// In the low corner.
    Corner,
    /// In the middle of the floor.
    Center,
    /// In front of the lowest door.
    Door,
}

/// A build has no door to stand in front of.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
#[error("this build has no door to stand in front of")]
pub struct NoDoor;

impl Grid {
    /// Makes `anchor` the point of copying.
    pub fn anchor(&mut self, anchor: Anchor) -> Result<(), NoDoor> {
        let player = match anchor {
            Anchor::Corner => Cell::ZERO,
            Anchor::Center => self.size().with_y(0) / 2,
            Anchor::Door => self.doorstep().ok_or(NoDoor)?,
        };
        self.metadata.offset = -player;
        Ok(())
    }

    /// The cell outside of the lowest door.
    fn doorstep(&self) -> Option<Cell> {
        let is_door: Vec<bool> = self.palette.states().iter().map(is_lower_half).collect();
        let at = self.cells.indexed_iter().find(|(_, id)| is_door[usize::from(**id)]);
        let ((y, z, x), _) = at?;
        let door = Cell::new(x as i32, y as i32, z as i32);
        let inwards = self.get(door).get("facing").and_then(Facing::named).unwrap_or(Facing::North);
        // Who puts up a door looks the way it faces, mostly from outside.
        let outwards = [inwards.opposite(), inwards].into_iter().find(|side| self.is_open(door, *side));
        Some(door + outwards.unwrap_or(inwards.opposite()).step())
    }

    /// Whether nothing stands in the way from `cell` out of the grid.
    fn is_open(&self, cell: Cell, side: Facing) -> bool {
        let way = (1..).map(|far| cell + side.step() * far).take_while(|at| self.bounds().contains(*at));
        way.into_iter().all(|at| shape(self.get(at)) == Shape::Air)
    }
}

fn is_lower_half(state: &BlockState) -> bool {
    matches!(shape(state), Shape::Door(_)) && state.get("half") != Some("upper")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Bounds;

    /// A room with a door in its south wall that is entered northwards.
    fn hut(facing: &str) -> Grid {
        let mut grid = Grid::new(Cell::new(5, 3, 7));
        let stone = grid.intern(&"stone".parse().unwrap()).unwrap();
        let door = grid.intern(&format!("oak_door[facing={facing},half=lower]").parse().unwrap()).unwrap();
        grid.fill(Bounds::new(Cell::ZERO, Cell::new(5, 3, 1)), stone);
        grid.fill(Bounds::new(Cell::new(0, 0, 4), Cell::new(5, 3, 5)), stone);
        grid.set(Cell::new(2, 1, 4), door);
        grid
    }

    #[test]
    fn the_player_stands_outside_of_the_door_whichever_way_it_was_put_up() {
        for facing in ["north", "south"] {
            let mut grid = hut(facing);
            grid.anchor(Anchor::Door).unwrap();
            assert_eq!(grid.metadata.offset, Cell::new(-2, -1, -5), "{facing}");
        }
        assert_eq!(Grid::new(Cell::ONE).anchor(Anchor::Door), Err(NoDoor));
    }

    #[test]
    fn the_middle_is_that_of_the_floor() {
        let mut grid = hut("north");
        grid.anchor(Anchor::Center).unwrap();
        assert_eq!(grid.metadata.offset, Cell::new(-2, 0, -3));
        grid.anchor(Anchor::Corner).unwrap();
        assert_eq!(grid.metadata.offset, Cell::ZERO);
    }
}
