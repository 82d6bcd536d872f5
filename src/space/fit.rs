//! Fitting real sizes to whole blocks.
//!
//! Ideal boundaries are real numbers; boundaries are rounded, never lengths, so that parts always sum
//! to the whole and no error piles up. Two boundaries around parts of whole absolute sizes are rounded as
//! one, so that a door of 1 stays 1 wide wherever it lands. Where a boundary lies exactly between two
//! blocks it moves away from the middle of the scope: mirrored sizes then give mirrored parts, unless a
//! part of whole size stands in the very middle and the parity leaves it no middle to stand in; the odd
//! block then goes to the far side. Sizes that miss the scope by less than half a block miss it at both ends
//! alike.

/// The size of one part along the axis of a split.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Length {
    /// In blocks.
    Absolute(f64),
    /// A weight: floating parts share what the absolute ones leave.
    Floating(f64),
}

/// Why sizes do not fit a scope. Lengths are in blocks.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum Misfit {
    #[error("its sizes need {need} blocks, but the scope has {have}")]
    Overrun { need: f64, have: i32 },
    #[error("its sizes fill {need} of the scope's {have} blocks, and none is floating")]
    Underrun { need: f64, have: i32 },
    #[error("part {part} has a size of {size}: sizes are zero or more")]
    Negative { part: usize, size: f64 },
}

/// Differences below this are noise of floating-point sums, not sizes.
const NOISE: f64 = 1e-6;

/// The boundaries of parts of the given lengths in a scope of `total` blocks: one more than there are
/// parts, from 0 to `total`, never falling.
pub fn fit(total: i32, lengths: &[Length]) -> Result<Vec<i32>, Misfit> {
    let ideal = ideal(total, lengths)?;
    let need = *ideal.last().unwrap_or(&0.0);
    let have = total;
    match (need + 0.5 - NOISE).floor() as i64 {
        rounded if rounded > i64::from(total) => Err(Misfit::Overrun { need, have }),
        rounded if rounded < i64::from(total) => Err(Misfit::Underrun { need, have }),
        _ => Ok(round(total, &centred(ideal, total), lengths)),
    }
}

/// As [`fit`], but parts that overrun the scope are cut off at its end, and what no part fills stays free.
/// Negative sizes count as zero.
pub fn clip(total: i32, lengths: &[Length]) -> Vec<i32> {
    let lengths: Vec<Length> = lengths
        .iter()
        .map(|length| match *length {
            Length::Absolute(size) => Length::Absolute(size.max(0.0)),
            Length::Floating(weight) => Length::Floating(weight.max(0.0)),
        })
        .collect();
    let ideal = ideal(total, &lengths).unwrap_or_default();
    ideal.iter().map(|&boundary| ((boundary + 0.5).floor() as i32).clamp(0, total)).collect()
}

/// The bounds of `count` equal shares of `total` blocks, which differ by one block at most.
pub fn shares(total: i32, count: u32) -> impl Iterator<Item = (i32, i32)> {
    let (total, count) = (i64::from(total), i64::from(count));
    let boundary = move |i: i64| {
        let (whole, rest) = (i * total / count, i * total % count);
        let up = 2 * rest > count || (2 * rest == count && 2 * i > count);
        (whole + i64::from(up)) as i32
    };
    (0..count).map(move |i| (boundary(i), boundary(i + 1)))
}

fn ideal(total: i32, lengths: &[Length]) -> Result<Vec<f64>, Misfit> {
    let (mut fixed, mut weights) = (0.0, 0.0);
    for (part, length) in lengths.iter().enumerate() {
        let (Length::Absolute(size) | Length::Floating(size)) = *length;
        if size < -NOISE || size.is_nan() {
            return Err(Misfit::Negative { part: part + 1, size });
        }
        match length {
            Length::Absolute(size) => fixed += size.max(0.0),
            Length::Floating(weight) => weights += weight.max(0.0),
        }
    }
    let spare = (f64::from(total) - fixed).max(0.0);
    let mut ideal = Vec::with_capacity(lengths.len() + 1);
    let mut boundary = 0.0;
    ideal.push(boundary);
    for length in lengths {
        boundary += match length {
            Length::Absolute(size) => size.max(0.0),
            Length::Floating(weight) if weights > 0.0 => weight.max(0.0) / weights * spare,
            Length::Floating(_) => 0.0,
        };
        ideal.push(boundary);
    }
    Ok(ideal)
}

/// Boundaries that miss the total by less than half a block, shared out to both ends.
fn centred(ideal: Vec<f64>, total: i32) -> Vec<f64> {
    let shift = (f64::from(total) - ideal.last().unwrap_or(&0.0)) / 2.0;
    ideal.into_iter().map(|boundary| boundary + shift).collect()
}

fn round(total: i32, ideal: &[f64], lengths: &[Length]) -> Vec<i32> {
    let mut rounded = Vec::with_capacity(ideal.len());
    while rounded.len() < ideal.len() {
        let first = rounded.len();
        let last = first + lengths[first..].iter().take_while(|length| is_whole(length)).count();
        // Where a run lies in the very middle, its place in the list tells which half it belongs to.
        let beyond = ideal[first] + ideal[last] - f64::from(total);
        let is_past_middle = if beyond.abs() < NOISE { first + last > lengths.len() } else { beyond > 0.0 };
        let shift = round_start(ideal[first], is_past_middle) - ideal[first];
        rounded.extend(ideal[first..=last].iter().map(|b| ((b + shift).round() as i32).clamp(0, total)));
    }
    // Sizes that miss the total by less than half a block are absorbed by the last part.
    if let Some(last) = rounded.last_mut() {
        *last = total;
    }
    rounded
}

fn is_whole(length: &Length) -> bool {
    matches!(length, Length::Absolute(size) if (size - size.round()).abs() < NOISE)
}

/// Rounds the first boundary of a run of parts of whole sizes; ties move away from the middle.
fn round_start(first: f64, is_past_middle: bool) -> f64 {
    let is_tie = (first - first.floor() - 0.5).abs() < NOISE;
    match (is_tie, is_past_middle) {
        (false, _) => first.round(),
        (true, false) => first.floor(),
        (true, true) => first.floor() + 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::Length::{Absolute, Floating};
    use super::*;
    use proptest::prelude::*;

    fn sizes(boundaries: &[i32]) -> Vec<i32> {
        boundaries.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    fn fitted(total: i32, lengths: &[Length]) -> Vec<i32> {
        sizes(&fit(total, lengths).unwrap())
    }

    #[test]
    fn whole_parts_keep_their_size() {
        assert_eq!(fitted(6, &[Floating(1.0), Absolute(1.0), Floating(1.0)]), [2, 1, 3]);
        assert_eq!(fitted(7, &[Floating(1.0), Absolute(1.0), Floating(1.0)]), [3, 1, 3]);
    }

    #[test]
    fn thin_parts_round_by_their_place() {
        assert_eq!(fitted(10, &[Absolute(0.7), Floating(1.0), Absolute(0.7)]), [1, 8, 1]);
        assert_eq!(fitted(10, &[Absolute(0.2), Floating(1.0), Absolute(0.2)]), [0, 10, 0]);
    }

    #[test]
    fn what_misses_the_scope_by_a_little_is_shared_by_both_ends() {
        let sides = |side| [side, Absolute(2.0), Floating(1.0), Absolute(2.0), side];
        assert_eq!(fitted(5, &sides(Absolute(0.6))), [0, 2, 1, 2, 0]);
        assert_eq!(fitted(9, &[Absolute(1.51), Absolute(3.0), Absolute(3.0), Absolute(1.51)]), [1, 3, 3, 2]);
        assert_eq!(fitted(10, &[Absolute(3.3); 3]), [3, 4, 3]);
    }

    #[test]
    fn misfits_are_told() {
        assert!(matches!(fit(3, &[Absolute(4.0)]), Err(Misfit::Overrun { .. })));
        assert!(matches!(fit(3, &[Absolute(2.0)]), Err(Misfit::Underrun { .. })));
        assert!(matches!(fit(3, &[Floating(1.0), Absolute(-1.0)]), Err(Misfit::Negative { part: 2, .. })));
        assert_eq!(clip(3, &[Absolute(2.0), Absolute(2.0)]), [0, 2, 3]);
        assert_eq!(clip(3, &[Absolute(2.0)]), [0, 2]);
    }

    fn lengths() -> impl Strategy<Value = Vec<Length>> {
        let length = prop_oneof![
            (0..4i32).prop_map(|n| Absolute(f64::from(n))),
            (0.0..3.0).prop_map(Absolute),
            (0.1..5.0).prop_map(Floating),
            (1..4i32).prop_map(|n| Floating(f64::from(n))),
        ];
        prop::collection::vec(length, 1..8)
    }

    proptest! {
        #[test]
        fn parts_sum_to_the_scope(total in 0..60i32, lengths in lengths()) {
            if let Ok(boundaries) = fit(total, &lengths) {
                prop_assert_eq!(boundaries.len(), lengths.len() + 1);
                prop_assert_eq!((boundaries[0], *boundaries.last().unwrap()), (0, total));
                prop_assert!(boundaries.is_sorted());
            }
        }

        #[test]
        fn whole_absolute_parts_are_exact(total in 20..60i32, lengths in lengths()) {
            let mut lengths = lengths;
            lengths.push(Floating(1.0));
            if let Ok(boundaries) = fit(total, &lengths) {
                for (length, size) in lengths.iter().zip(sizes(&boundaries)) {
                    if let Absolute(n) = length && n.fract() == 0.0 {
                        prop_assert_eq!(size, *n as i32);
                    }
                }
            }
        }

        #[test]
        fn mirrored_lengths_give_mirrored_parts(total in 1..60i32, half in lengths(), floats in 0..2usize) {
            let mirrored = half.iter().rev();
            let palindrome: Vec<Length> =
                half.iter().chain([Floating(1.0)].iter().take(floats)).chain(mirrored).copied().collect();
            if let Ok(boundaries) = fit(total, &palindrome) {
                let sizes = sizes(&boundaries);
                let reversed: Vec<i32> = sizes.iter().rev().copied().collect();
                // A run of whole sizes around the very middle has no mirrored place where the parity is wrong.
                let middle_is_rigid = floats == 0 && half.last().is_none_or(is_whole);
                prop_assert!(sizes == reversed || middle_is_rigid || total % 2 == 1, "{sizes:?}");
                if floats == 1 {
                    prop_assert_eq!(sizes, reversed);
                }
            }
        }

        #[test]
        fn equal_shares_differ_by_one_at_most(total in 0..500i32, count in 1..40u32) {
            let shares: Vec<i32> = shares(total, count).map(|(low, high)| high - low).collect();
            let (least, most) = (shares.iter().min().unwrap(), shares.iter().max().unwrap());
            prop_assert!(most - least <= 1);
            prop_assert_eq!(shares.iter().sum::<i32>(), total);
            prop_assert_eq!(shares, sizes(&fit(total, &vec![Floating(1.0); count as usize]).unwrap()));
        }

        #[test]
        fn equal_floats_among_others_differ_by_one_at_most(total in 1..100i32, others in lengths(), weight in 0.5..3.0f64) {
            let lengths: Vec<Length> = others.iter().flat_map(|&other| match other {
                Absolute(_) => vec![other, Floating(weight)],
                Floating(_) => vec![Floating(weight)],
            }).collect();
            if let Ok(boundaries) = fit(total, &lengths) {
                let floats: Vec<i32> = sizes(&boundaries).into_iter().zip(&lengths)
                    .filter(|(_, length)| matches!(length, Floating(_))).map(|(size, _)| size).collect();
                if let (Some(least), Some(most)) = (floats.iter().min(), floats.iter().max()) {
                    prop_assert!(most - least <= 1, "{floats:?}");
                }
            }
        }
    }
}
