//! One example as an array of terminals, whose sub-boxes are compared by hash in constant time.

use crate::space::{Axis, Bounds, Cell};
use ndarray::Array3;

/// Cells of terminals with their prefix hashes.
///
/// The hash of a box is a polynomial in three variables over the field of 2^61 - 1 elements: the sum over its cells
/// of `value * X^x * Y^y * Z^z`. Prefix sums give that of any box from eight of them; the inverse powers move it to
/// the origin, so that equal boxes have equal hashes wherever they stand.
#[derive(Clone, Debug)]
pub struct Volume {
    cells: Array3<u32>,
    prefix: Array3<u64>,
    inverse: [Vec<u64>; 3],
    /// By axis: how many wholes of two blocks lie across each face to the next cell, as prefix sums.
    bonds: [Array3<u32>; 3],
}

impl Volume {
    /// Of cells indexed `[y, z, x]`; `bonds` are the cells whose other half is the next one on the axis.
    pub fn new(cells: Array3<u32>, bonds: &[(Axis, Cell)]) -> Volume {
        let (y, z, x) = cells.dim();
        let size = Cell::new(x as i32, y as i32, z as i32);
        let powers = Axis::ALL.map(|axis| powers(BASES[axis.index()], axis.of(size)));
        let weigh = |[y, z, x]: [usize; 3]| {
            let place = multiply(multiply(powers[0][x], powers[1][y]), powers[2][z]);
            multiply(value(cells[[y, z, x]]), place)
        };
        let prefix = prefix_sums(cells.dim(), weigh, add);
        let inverse = Axis::ALL.map(|axis| powers_of_inverse(BASES[axis.index()], axis.of(size)));
        let bonds = Axis::ALL.map(|axis| {
            let mut across = Array3::<u32>::zeros(cells.dim());
            let own = bonds.iter().filter(|(other, _)| *other == axis);
            own.for_each(|(_, at)| across[index(*at)] = 1);
            prefix_sums(cells.dim(), |at| across[at], u32::wrapping_add)
        });
        Volume { cells, prefix, inverse, bonds }
    }

    pub fn size(&self) -> Cell {
        let (y, z, x) = self.cells.dim();
        Cell::new(x as i32, y as i32, z as i32)
    }

    pub fn get(&self, cell: Cell) -> u32 {
        self.cells[index(cell)]
    }

    /// A hash of what is in a box, wherever it stands. It does not tell the box's size.
    pub fn hash(&self, bounds: Bounds) -> u64 {
        let sum = corners(bounds).into_iter().fold(0, |sum, (sign, corner)| {
            let own = self.prefix[index(corner)];
            if sign { add(sum, own) } else { add(sum, MODULUS - own) }
        });
        Axis::ALL
            .into_iter()
            .fold(sum, |hash, axis| multiply(hash, self.inverse[axis.index()][axis.of(bounds.min) as usize]))
    }

    /// Whether a plane across `axis` below cell `at` goes through a door, a bed or the like in the box.
    pub fn is_whole_across(&self, bounds: Bounds, axis: Axis, at: i32) -> bool {
        let layer = bounds.slab(axis, at - 1, at);
        let sums = &self.bonds[axis.index()];
        let count = corners(layer).into_iter().fold(0u32, |count, (sign, corner)| {
            let own = sums[index(corner)];
            if sign { count.wrapping_add(own) } else { count.wrapping_sub(own) }
        });
        count > 0
    }
}

fn index(cell: Cell) -> [usize; 3] {
    [cell.y as usize, cell.z as usize, cell.x as usize]
}

/// The corners of a box with the signs of their prefix sums: true adds, false takes away.
fn corners(bounds: Bounds) -> [(bool, Cell); 8] {
    let Bounds { min, max } = bounds;
    std::array::from_fn(|corner| {
        let pick = |axis: Axis, bit: usize| if corner & bit == 0 { axis.of(max) } else { axis.of(min) };
        (corner.count_ones() % 2 == 0, Cell::new(pick(Axis::X, 1), pick(Axis::Y, 2), pick(Axis::Z, 4)))
    })
}

/// The sums over all cells before a corner, one longer than the cells on each axis.
fn prefix_sums<T: Copy + Default>(
    (y, z, x): (usize, usize, usize),
    own: impl Fn([usize; 3]) -> T,
    add: impl Fn(T, T) -> T,
) -> Array3<T> {
    let mut sums = Array3::from_elem((y + 1, z + 1, x + 1), T::default());
    for at_y in 0..y {
        let mut layer = vec![T::default(); x];
        for at_z in 0..z {
            let mut row = T::default();
            for at_x in 0..x {
                row = add(row, own([at_y, at_z, at_x]));
                layer[at_x] = add(layer[at_x], row);
                sums[[at_y + 1, at_z + 1, at_x + 1]] = add(sums[[at_y, at_z + 1, at_x + 1]], layer[at_x]);
            }
        }
    }
    sums
}

const MODULUS: u64 = (1 << 61) - 1;
const BASES: [u64; 3] = [0x0d3a_f8c1_92b7_5e45, 0x1531_0be6_7f4d_a98d, 0x0917_66ca_3d08_e1f3];

fn add(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum >= MODULUS { sum - MODULUS } else { sum }
}

fn multiply(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    add((product >> 61) as u64, product as u64 & MODULUS)
}

fn powers(base: u64, len: i32) -> Vec<u64> {
    std::iter::successors(Some(1), |power| Some(multiply(*power, base))).take(len as usize + 1).collect()
}

/// By Fermat: the inverse of a number is its power of the modulus less two.
fn powers_of_inverse(base: u64, len: i32) -> Vec<u64> {
    let (mut inverse, mut square, mut exponent) = (1, base, MODULUS - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            inverse = multiply(inverse, square);
        }
        square = multiply(square, square);
        exponent >>= 1;
    }
    powers(inverse, len)
}

/// A terminal's value in the hash: far from that of its neighbours in number (the finaliser of SplitMix64).
fn value(terminal: u32) -> u64 {
    let mut bits = u64::from(terminal).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (bits ^ (bits >> 31)) % (MODULUS - 1) + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn volume(size: [i32; 3], seed: u32) -> Volume {
        let [x, y, z] = size.map(|len| len as usize);
        let number =
            |(y, z, x): (usize, usize, usize)| (x as u32 * 7 + y as u32 * 3 + z as u32 * 5 + seed) % 2;
        Volume::new(Array3::from_shape_fn((y, z, x), number), &[])
    }

    proptest! {
        #[test]
        fn boxes_have_one_hash_if_they_are_equal(a in 0..6i32, b in 0..6i32, c in 0..6i32, seed in 0..9u32) {
            let volume = volume([8, 8, 8], seed);
            let at = |min: Cell| Bounds::new(min, min + Cell::new(2, 2, 2));
            let cells = |bounds: Bounds| bounds.cells().map(|cell| volume.get(cell)).collect::<Vec<u32>>();
            let (one, two) = (at(Cell::new(a, b, c)), at(Cell::new(c, a, b)));
            prop_assert_eq!(volume.hash(one) == volume.hash(two), cells(one) == cells(two));
        }
    }

    #[test]
    fn planes_through_wholes_are_known() {
        let cells = Array3::zeros((3, 2, 2));
        let volume = Volume::new(cells, &[(Axis::Y, Cell::new(1, 0, 0))]);
        let all = Bounds::of_size(volume.size());
        assert!(volume.is_whole_across(all, Axis::Y, 1));
        assert!(!volume.is_whole_across(all, Axis::Y, 2));
        assert!(!volume.is_whole_across(all, Axis::X, 1));
        assert!(!volume.is_whole_across(all.slab(Axis::X, 0, 1), Axis::Y, 1));
    }
}
