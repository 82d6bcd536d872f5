//! How far the blocks of samples stand otherwise beside one another than those of the examples.

use super::patterns::Patterns;
use std::cmp::Ordering;

/// What is added to every count, so that no pattern is impossible.
const EPSILON: f64 = 1e-6;

/// The mean of the Kullback-Leibler divergences both ways between two distributions of patterns, in nats. Each
/// pattern of either has `EPSILON` added to its count.
///
/// Zero of equal distributions; copying every example is at no distance, so it is to be read beside novelty.
pub fn distance<const SIDE: usize, const N: usize>(
    one: &Patterns<SIDE, N>,
    other: &Patterns<SIDE, N>,
) -> f64 {
    let counts = joined(one, other);
    let kinds = counts.len() as f64;
    let share = |count: u64, total: u64| (count as f64 + EPSILON) / (total as f64 + EPSILON * kinds);
    let shares = counts.iter().map(|(a, b)| (share(*a, one.total()), share(*b, other.total())));
    // Both ways in one sum: p ln(p / q) + q ln(q / p).
    shares.map(|(p, q)| (p - q) * (libm::log(p) - libm::log(q))).sum::<f64>() / 2.0
}

/// The counts in both of every pattern that stands in either.
fn joined<const SIDE: usize, const N: usize>(
    one: &Patterns<SIDE, N>,
    other: &Patterns<SIDE, N>,
) -> Vec<(u64, u64)> {
    let (mut ones, mut others) = (one.counts(), other.counts());
    let mut counts = Vec::new();
    loop {
        let order = match (ones.first(), others.first()) {
            (Some(a), Some(b)) => a.0.cmp(&b.0),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) => return counts,
        };
        let next = |list: &mut &[(_, u64)], is_here: bool| match list.split_first() {
            Some((first, rest)) if is_here => {
                *list = rest;
                first.1
            }
            _ => 0,
        };
        counts.push((next(&mut ones, order.is_le()), next(&mut others, order.is_ge())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::score::{Cells, Seams};
    use ndarray::Array3;
    use proptest::prelude::*;

    fn buildings() -> impl Strategy<Value = Cells> {
        ((1..4usize), (1..4usize), (1..4usize)).prop_flat_map(|dim| {
            prop::collection::vec(0..4u32, dim.0 * dim.1 * dim.2)
                .prop_map(move |cells| Array3::from_shape_vec(dim, cells).unwrap())
        })
    }

    proptest! {
        #[test]
        fn a_copy_is_at_no_distance(cells in buildings()) {
            let seams = Seams::of([&cells]);
            prop_assert_eq!(distance(&seams, &seams), 0.0);
            prop_assert_eq!(distance(&seams, &Seams::of([&cells, &cells])).abs() < 1e-3, true);
        }

        #[test]
        fn it_is_as_far_there_as_back(one in buildings(), other in buildings()) {
            let (one, other) = (Seams::of([&one]), Seams::of([&other]));
            let there = distance(&one, &other);
            prop_assert!((there - distance(&other, &one)).abs() < 1e-9);
            prop_assert_eq!(there > 1e-9, one != other);
        }
    }

    #[test]
    fn all_that_is_new_is_far() {
        let cells = |state| Array3::from_elem((3, 3, 3), state);
        let (one, other) = (Seams::of([&cells(1)]), Seams::of([&cells(2)]));
        assert!(distance(&one, &other) > 10.0);
    }
}
