//! Cells that hang together.

use ndarray::Array3;

/// A place in an array of cells: `[y, z, x]`.
type Place = [usize; 3];

/// Which cells hang together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Neighbours {
    /// Those that share a face.
    Faces,
    /// Those that share a face or an edge.
    Edges,
    /// Those that share a face, an edge or a corner.
    Corners,
    /// Those of one layer that share a face.
    Layer,
}

impl Neighbours {
    fn steps(self) -> Vec<[isize; 3]> {
        let all = (-1..=1).flat_map(|y| (-1..=1).flat_map(move |z| (-1..=1).map(move |x| [y, z, x])));
        all.filter(|step: &[isize; 3]| {
            let moved = step.iter().filter(|n| **n != 0).count();
            match self {
                Neighbours::Faces => moved == 1,
                Neighbours::Edges => moved == 1 || moved == 2,
                Neighbours::Corners => moved > 0,
                Neighbours::Layer => moved == 1 && step[0] == 0,
            }
        })
        .collect()
    }
}

/// The number of the piece that each cell is of, from 1; 0 where there is none.
pub fn components(is_there: &Array3<bool>, neighbours: Neighbours) -> Array3<u32> {
    let mut pieces = Array3::zeros(is_there.dim());
    let steps = neighbours.steps();
    let mut count = 0;
    for ((y, z, x), there) in is_there.indexed_iter() {
        if *there && pieces[[y, z, x]] == 0 {
            count += 1;
            fill(&mut pieces, is_there, &steps, vec![[y, z, x]], count);
        }
    }
    pieces
}

/// The pieces that do not rest on the lowest layer with cells that are there. Cells that share a face or an edge hold
/// each other.
pub fn floating(is_there: &Array3<bool>) -> usize {
    let pieces = components(is_there, Neighbours::Edges);
    let lowest = pieces.indexed_iter().filter(|(_, piece)| **piece > 0).map(|((y, ..), _)| y).min();
    let mut rests = vec![false; pieces.iter().max().map_or(0, |last| *last as usize) + 1];
    // No piece has the number 0.
    rests[0] = true;
    for ((y, ..), piece) in pieces.indexed_iter() {
        rests[*piece as usize] |= Some(y) == lowest;
    }
    rests.iter().filter(|rests| !**rests).count()
}

/// Which cells can be reached from the border of the array, its floor left out.
pub fn reached_from_outside(is_open: &Array3<bool>, neighbours: Neighbours) -> Array3<bool> {
    let (ys, zs, xs) = is_open.dim();
    let is_border = |[y, z, x]: Place| {
        let top = neighbours != Neighbours::Layer && y + 1 == ys;
        top || z == 0 || z + 1 == zs || x == 0 || x + 1 == xs
    };
    let open = is_open.indexed_iter().filter(|(_, open)| **open).map(|((y, z, x), _)| [y, z, x]);
    let starts = open.filter(|place| is_border(*place)).collect();
    let mut reached = Array3::zeros(is_open.dim());
    fill(&mut reached, is_open, &neighbours.steps(), starts, 1);
    reached.mapv(|piece| piece == 1)
}

/// Gives all that hangs together with `starts` the number `piece`.
fn fill(
    pieces: &mut Array3<u32>,
    is_there: &Array3<bool>,
    steps: &[[isize; 3]],
    starts: Vec<Place>,
    piece: u32,
) {
    let mut open = starts;
    open.iter().for_each(|place| pieces[*place] = piece);
    while let Some(place) = open.pop() {
        for step in steps {
            let next: Place = std::array::from_fn(|axis| place[axis].wrapping_add_signed(step[axis]));
            if is_there.get(next) == Some(&true) && pieces[next] == 0 {
                pieces[next] = piece;
                open.push(next);
            }
        }
    }
}
