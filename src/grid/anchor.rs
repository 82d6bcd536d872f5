use super::Grid;
use crate::block::{BlockState, Facing, Shape, shape};
use crate::space::{Bounds, Cell};

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
        let sides = [inwards.opposite(), inwards].map(|side| door + side.step());
        let outside = Outside::of(self);
        Some(sides.into_iter().find(|&cell| outside.holds(cell)).unwrap_or(sides[0]))
    }
}

/// The cells that air comes to from beyond the grid.
struct Outside {
    bounds: Bounds,
    reached: Vec<bool>,
}

impl Outside {
    fn of(grid: &Grid) -> Outside {
        let is_open: Vec<bool> =
            grid.palette.states().iter().map(|state| shape(state) == Shape::Air).collect();
        let bounds = grid.bounds();
        let mut outside = Outside { bounds, reached: vec![false; grid.cells.len()] };
        let mut next: Vec<Cell> = border(bounds).collect();
        while let Some(cell) = next.pop() {
            let is_new = bounds.contains(cell) && is_open[usize::from(grid.id(cell))] && !outside.holds(cell);
            if is_new {
                let at = outside.index(cell);
                outside.reached[at] = true;
                next.extend(Facing::ALL.map(|side| cell + side.step()));
            }
        }
        outside
    }

    fn index(&self, cell: Cell) -> usize {
        let size = self.bounds.size();
        ((cell.y as usize * size.z as usize) + cell.z as usize) * size.x as usize + cell.x as usize
    }

    /// Beyond the grid is outside.
    fn holds(&self, cell: Cell) -> bool {
        !self.bounds.contains(cell) || self.reached[self.index(cell)]
    }
}

/// The cells of a grid's sides and top; what lies below is mostly ground.
fn border(bounds: Bounds) -> impl Iterator<Item = Cell> {
    let last = bounds.max - Cell::ONE;
    bounds.cells().filter(move |cell| {
        cell.x == 0 || cell.z == 0 || cell.x == last.x || cell.z == last.z || cell.y == last.y
    })
}

fn is_lower_half(state: &BlockState) -> bool {
    matches!(shape(state), Shape::Door(_)) && state.get("half") != Some("upper")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A room with a door in its south wall that is entered northwards.
    fn hut(facing: &str) -> Grid {
        let mut grid = Grid::new(Cell::new(5, 3, 7));
        let stone = grid.intern(&"stone".parse().unwrap()).unwrap();
        let door = grid.intern(&format!("oak_door[facing={facing},half=lower]").parse().unwrap()).unwrap();
        grid.fill(Bounds::new(Cell::ZERO, Cell::new(5, 3, 1)), stone);
        grid.fill(Bounds::new(Cell::new(0, 0, 4), Cell::new(5, 3, 5)), stone);
        grid.fill(Bounds::new(Cell::ZERO, Cell::new(1, 3, 5)), stone);
        grid.fill(Bounds::new(Cell::new(4, 0, 0), Cell::new(5, 3, 5)), stone);
        grid.fill(Bounds::new(Cell::new(0, 2, 0), Cell::new(5, 3, 5)), stone);
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
