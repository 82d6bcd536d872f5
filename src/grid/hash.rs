//! What a box of a grid holds, as one number: equal boxes have equal numbers, wherever they lie.

use crate::space::{Axis, Bounds, Cell};

/// The content of a box: its size and a hash of its cells. Two boxes of different cells share one with a chance
/// of one in 2^100 or so.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Content {
    pub size: [u32; 3],
    pub hash: [u64; 2],
}

/// Sums over all boxes at the low corner, from which those of any box follow.
///
/// A box is a polynomial in three variables with its cells as coefficients, taken at two random points modulo
/// 2^61 - 1 (Karp and Rabin, 1987); a box that lies elsewhere is the same polynomial times a power.
#[derive(Clone, Debug)]
pub struct BoxHashes {
    size: Cell,
    sums: Vec<[u64; 2]>,
    /// Powers of the inverse of each variable, per axis.
    back: [Vec<[u64; 2]>; 3],
}

/// Mersenne's prime 2^61 - 1.
const PRIME: u64 = (1 << 61) - 1;

/// The points where the polynomials are taken, per axis: random numbers below the prime.
const POINTS: [[u64; 2]; 3] = [
    [0x0f3a_9d1c_77b2_64e5, 0x1b58_02fe_c6a1_9d37],
    [0x15c4_e8b3_0a96_f1d3, 0x0867_5b29_d4ce_710f],
    [0x1d92_7f06_b38e_c541, 0x12e0_a4d7_569b_3c8b],
];

impl BoxHashes {
    /// The sums of a grid of `size`, whose cells have the numbers that `cells` gives, in the order of schematic
    /// files.
    pub fn new(size: Cell, cells: impl Iterator<Item = u32>) -> BoxHashes {
        let ahead = Axis::ALL.map(|axis| powers(POINTS[axis.index()], axis.of(size)));
        let back = Axis::ALL.map(|axis| powers(POINTS[axis.index()].map(inverse), axis.of(size)));
        let mut hashes = BoxHashes { size, sums: Vec::new(), back };
        let corners = (size + Cell::ONE).as_i64vec3().element_product().max(1) as usize;
        hashes.sums = vec![[0; 2]; corners];
        let weigh = |cell: Cell, number: u32, part: usize| {
            let [x, y, z] = Axis::ALL.map(|axis| ahead[axis.index()][axis.of(cell) as usize][part]);
            times(times(x, y), times(z, spread(number)))
        };
        for (cell, number) in Bounds::of_size(size).cells().zip(cells) {
            let own = [weigh(cell, number, 0), weigh(cell, number, 1)];
            hashes.add(cell, own);
        }
        hashes
    }

    /// The content of a box, which lies inside.
    pub fn content(&self, bounds: Bounds) -> Content {
        let size = bounds.size().to_array().map(|length| length as u32);
        if bounds.is_empty() {
            return Content { size, hash: [0; 2] };
        }
        let [low, high] = [bounds.min, bounds.max];
        let [x, y, z] = Axis::ALL.map(|axis| self.back[axis.index()][axis.of(low) as usize]);
        let hash = [0, 1].map(|part| {
            let at = |x: i32, y: i32, z: i32| self.sums[self.index(Cell::new(x, y, z))][part];
            let layer = |y| {
                plus(
                    minus(minus(at(high.x, y, high.z), at(low.x, y, high.z)), at(high.x, y, low.z)),
                    at(low.x, y, low.z),
                )
            };
            let sum = minus(layer(high.y), layer(low.y));
            times(sum, times(x[part], times(y[part], z[part])))
        });
        Content { size, hash }
    }

    /// Enters a cell, behind all that are below it on any axis.
    fn add(&mut self, cell: Cell, own: [u64; 2]) {
        let [x, y, z] = cell.to_array();
        let at = |dx: i32, dy: i32, dz: i32| self.index(Cell::new(x + dx, y + dy, z + dz));
        let near =
            [at(0, 1, 1), at(1, 0, 1), at(1, 1, 0), at(0, 0, 1), at(0, 1, 0), at(1, 0, 0), at(0, 0, 0)];
        let last = at(1, 1, 1);
        for (part, own) in own.into_iter().enumerate() {
            let near = near.map(|at| self.sums[at][part]);
            let faces = plus(plus(near[0], near[1]), near[2]);
            let edges = plus(plus(near[3], near[4]), near[5]);
            self.sums[last][part] = plus(minus(faces, edges), plus(near[6], own));
        }
    }

    fn index(&self, corner: Cell) -> usize {
        let [width, depth] = [self.size.x as usize + 1, self.size.z as usize + 1];
        (corner.y as usize * depth + corner.z as usize) * width + corner.x as usize
    }
}

fn powers(base: [u64; 2], count: i32) -> Vec<[u64; 2]> {
    let next = |last: &[u64; 2]| Some([times(last[0], base[0]), times(last[1], base[1])]);
    std::iter::successors(Some([1, 1]), next).take(count.max(0) as usize + 1).collect()
}

/// A number of a cell, far from those of its like.
fn spread(number: u32) -> u64 {
    (u64::from(number) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) % PRIME
}

fn plus(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum >= PRIME { sum - PRIME } else { sum }
}

fn minus(a: u64, b: u64) -> u64 {
    if a >= b { a - b } else { a + PRIME - b }
}

fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    plus(product as u64 & PRIME, (product >> 61) as u64)
}

/// The number that gives 1 when multiplied, by Fermat's little theorem.
fn inverse(number: u64) -> u64 {
    let (mut power, mut left, mut out) = (number, PRIME - 2, 1);
    while left > 0 {
        if left % 2 == 1 {
            out = times(out, power);
        }
        power = times(power, power);
        left /= 2;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: Cell = Cell::new(5, 4, 6);

    fn boxes() -> impl Strategy<Value = Bounds> {
        let corner = || (0..=SIZE.x, 0..=SIZE.y, 0..=SIZE.z).prop_map(Cell::from);
        (corner(), corner()).prop_map(|(a, b)| Bounds::new(a.min(b), a.max(b)))
    }

    proptest! {
        #[test]
        fn contents_are_equal_where_the_cells_are(
            numbers in prop::collection::vec(0..3u32, (SIZE.x * SIZE.y * SIZE.z) as usize),
            a in boxes(),
            b in boxes(),
        ) {
            let at = |cell: Cell| numbers[((cell.y * SIZE.z + cell.z) * SIZE.x + cell.x) as usize];
            let cells = |bounds: Bounds| bounds.cells().map(at).collect::<Vec<_>>();
            let hashes = BoxHashes::new(SIZE, numbers.iter().copied());
            let (a, b) = (a, Bounds::new(b.min, (b.min + a.size()).min(SIZE)));
            let is_equal = a.size() == b.size() && cells(a) == cells(b);
            prop_assert_eq!(hashes.content(a) == hashes.content(b), is_equal);
        }
    }

    #[test]
    fn where_a_box_lies_does_not_matter() {
        let hashes = BoxHashes::new(SIZE, Bounds::of_size(SIZE).cells().map(|cell| (cell.x % 2) as u32));
        let near = Bounds::of_size(Cell::new(3, 2, 2));
        let moved = |by: Cell| hashes.content(Bounds::new(near.min + by, near.max + by));
        assert_eq!(moved(Cell::new(2, 2, 4)), moved(Cell::ZERO));
        assert_ne!(moved(Cell::X), moved(Cell::ZERO));
    }
}
