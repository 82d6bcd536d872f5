//! The rooms of a building: whether one gets in through doors, and whether there is a roof above.

use super::cells::settled;
use crate::block::{Shape, shape};
use crate::grid::{Grid, Neighbours, components, reached_from_outside};
use ndarray::Array3;

/// The rooms of a building. A room is air behind closed doors, with room to stand in it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rooms {
    pub rooms: usize,
    /// Those that can be reached from outside where doors, gates and trapdoors stand open.
    pub reachable: usize,
    /// Columns in which air two cells high has walls all round in its layers.
    pub columns: usize,
    /// Those of them with nothing above the highest such air.
    pub roofless: usize,
    /// Cells of rooms.
    pub inside: usize,
}

impl Rooms {
    pub fn of(grid: &Grid) -> Rooms {
        let grid = settled(grid);
        let passages: Vec<Passage> =
            grid.palette().states().iter().map(|state| passage(shape(state))).collect();
        let passages: Array3<Passage> = grid.cells().mapv(|id| passages[usize::from(id)]);
        let rooms = rooms(&passages);
        let walled = walled(&passages);
        Rooms {
            columns: walled.len(),
            roofless: walled.iter().filter(|roofless| **roofless).count(),
            ..rooms
        }
    }

    /// The sum of several buildings.
    pub fn sum(all: impl IntoIterator<Item = Rooms>) -> Rooms {
        all.into_iter().fold(Rooms::default(), |sum, next| Rooms {
            rooms: sum.rooms + next.rooms,
            reachable: sum.reachable + next.reachable,
            columns: sum.columns + next.columns,
            roofless: sum.roofless + next.roofless,
            inside: sum.inside + next.inside,
        })
    }
}

/// Whether one can walk through a cell.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Passage {
    Open,
    /// Can be opened.
    Door,
    Closed,
}

fn passage(shape: Shape) -> Passage {
    match shape {
        Shape::Air
        | Shape::Ladder(_)
        | Shape::WallSign(_)
        | Shape::Faces(_)
        | Shape::Torch(_)
        | Shape::Button(_)
        | Shape::Rail(_)
        | Shape::Plant(_)
        | Shape::Fluid(_) => Passage::Open,
        Shape::Door(_) | Shape::Trapdoor(_) | Shape::Gate { .. } => Passage::Door,
        _ => Passage::Closed,
    }
}

fn rooms(passages: &Array3<Passage>) -> Rooms {
    let is_open = passages.mapv(|passage| passage == Passage::Open);
    let outside = reached_from_outside(&is_open, Neighbours::Faces);
    let can_be_open = passages.mapv(|passage| passage != Passage::Closed);
    let reached = reached_from_outside(&can_be_open, Neighbours::Faces);
    let mut inside = is_open;
    inside.zip_mut_with(&outside, |open, outside| *open &= !outside);
    let pieces = components(&inside, Neighbours::Faces);
    let count = pieces.iter().max().map_or(0, |last| *last as usize);
    let (mut is_room, mut is_reached) = (vec![false; count + 1], vec![false; count + 1]);
    for ((y, z, x), piece) in pieces.indexed_iter().filter(|(_, piece)| **piece > 0) {
        is_room[*piece as usize] |= pieces.get([y + 1, z, x]) == Some(piece);
        is_reached[*piece as usize] |= reached[[y, z, x]];
    }
    Rooms {
        rooms: is_room.iter().filter(|is| **is).count(),
        reachable: is_room.iter().zip(&is_reached).filter(|(room, reached)| **room && **reached).count(),
        inside: pieces.iter().filter(|piece| is_room[**piece as usize]).count(),
        ..Rooms::default()
    }
}

/// For every column that has air two cells high with walls all round, whether there is no roof above.
fn walled(passages: &Array3<Passage>) -> Vec<bool> {
    let is_open = passages.mapv(|passage| passage == Passage::Open);
    let outside = reached_from_outside(&is_open, Neighbours::Layer);
    let (ys, zs, xs) = passages.dim();
    let columns = (0..zs).flat_map(|z| (0..xs).map(move |x| (z, x)));
    columns
        .filter_map(|(z, x)| {
            let is_walled = |y: usize| is_open[[y, z, x]] && !outside[[y, z, x]];
            let top = (1..ys).rev().find(|y| is_walled(*y) && is_walled(*y - 1))?;
            Some((top..ys).all(|y| passages[[y, z, x]] != Passage::Closed))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Bounds, Cell};

    /// A hollow box of stone, five blocks a side.
    fn hut() -> Grid {
        let mut grid = Grid::new(Cell::splat(5));
        let stone = grid.intern(&"stone".parse().unwrap()).unwrap();
        grid.fill(grid.bounds(), stone);
        grid.fill(Bounds::new(Cell::ONE, Cell::splat(4)), 0);
        grid
    }

    fn put(grid: &mut Grid, cell: [i32; 3], name: &str) {
        let id = grid.intern(&name.parse().unwrap()).unwrap();
        grid.set(Cell::from(cell), id);
    }

    #[test]
    fn a_room_needs_a_door() {
        let mut hut = hut();
        let sealed = Rooms { rooms: 1, reachable: 0, columns: 9, roofless: 0, inside: 27 };
        assert_eq!(Rooms::of(&hut), sealed);
        put(&mut hut, [2, 1, 4], "oak_door[half=lower,facing=north]");
        put(&mut hut, [2, 2, 4], "oak_door[half=upper,facing=north]");
        assert_eq!(Rooms::of(&hut), Rooms { reachable: 1, ..sealed });
    }

    #[test]
    fn a_hole_in_the_wall_leaves_no_room_but_columns() {
        let mut hut = hut();
        put(&mut hut, [2, 1, 4], "air");
        assert_eq!(Rooms::of(&hut), Rooms { rooms: 0, reachable: 0, columns: 9, roofless: 0, inside: 0 });
    }

    #[test]
    fn a_hole_in_the_roof_is_seen() {
        let mut hut = hut();
        put(&mut hut, [2, 4, 2], "air");
        let found = Rooms::of(&hut);
        assert_eq!((found.rooms, found.columns, found.roofless), (0, 9, 1));
    }

    #[test]
    fn a_gap_of_one_cell_is_no_room() {
        let mut hut = hut();
        let stone = hut.intern(&"stone".parse().unwrap()).unwrap();
        hut.fill(Bounds::new(Cell::new(0, 2, 0), Cell::splat(5)), stone);
        assert_eq!(Rooms::of(&hut), Rooms::default());
    }
}
