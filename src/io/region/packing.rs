//! Numbers of a few bits each in longs, low bits first.

/// Whether a number may begin in one long and end in the next.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Layout {
    /// Since 1.16: what does not fit into a long begins in the next one.
    Whole,
    /// From 1.13 to 1.15.
    Across,
}

/// `count` numbers of at least `bits` bits; `None` where no packing of so many takes so many longs.
///
/// The length tells the layouts apart: it is never the same for both but where they are the same. It also
/// tells the bits of the older one, which some programs wrote with more than were needed.
pub(super) fn unpack(longs: &[i64], bits: usize, count: usize) -> Option<Vec<u32>> {
    let (layout, bits) = if bits <= 32 && longs.len() == length(bits, count) {
        (Layout::Whole, bits)
    } else {
        let across = longs.len() * 64 / count;
        let fits = (bits..=32).contains(&across) && (across * count).div_ceil(64) == longs.len();
        (Layout::Across, fits.then_some(across)?)
    };
    Some((0..count).map(|at| number(longs, bits, at, layout)).collect())
}

fn number(longs: &[i64], bits: usize, at: usize, layout: Layout) -> u32 {
    let (long, shift) = match layout {
        Layout::Whole => (at / (64 / bits), at % (64 / bits) * bits),
        Layout::Across => (at * bits / 64, at * bits % 64),
    };
    let low = longs[long].cast_unsigned() >> shift;
    let value = match shift + bits > 64 {
        true => low | longs[long + 1].cast_unsigned() << (64 - shift),
        false => low,
    };
    (value & ((1 << bits) - 1)) as u32
}

/// How many longs `count` numbers of `bits` take, each whole in its long.
fn length(bits: usize, count: usize) -> usize {
    count.div_ceil(64 / bits)
}

/// `numbers` of `bits` each, whole in their longs.
pub(super) fn pack(numbers: &[u16], bits: usize) -> Vec<i64> {
    let join = |long: i64, &number: &u16| long << bits | i64::from(number);
    numbers.chunks(64 / bits).map(|numbers| numbers.iter().rev().fold(0, join)).collect()
}

/// The bits that numbers below `count` take.
pub(super) fn bits(count: usize) -> usize {
    (usize::BITS - count.saturating_sub(1).leading_zeros()) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn pack_across(numbers: &[u16], bits: usize) -> Vec<i64> {
        let mut longs = vec![0_i64; (numbers.len() * bits).div_ceil(64)];
        for (at, &number) in numbers.iter().enumerate() {
            for bit in 0..bits {
                let place = at * bits + bit;
                longs[place / 64] |= i64::from(number >> bit & 1) << (place % 64);
            }
        }
        longs
    }

    proptest! {
        #[test]
        fn both_packings_are_told_apart_and_read(
            numbers in prop::collection::vec(0..4096_u16, 4096),
            bits in 4..=12_usize,
        ) {
            let numbers: Vec<u16> = numbers.into_iter().map(|n| n & ((1 << bits) - 1)).collect();
            let wide: Vec<u32> = numbers.iter().map(|&n| n.into()).collect();
            prop_assert_eq!(unpack(&pack(&numbers, bits), bits, 4096), Some(wide.clone()));
            prop_assert_eq!(unpack(&pack_across(&numbers, bits), bits, 4096), Some(wide));
        }

        #[test]
        fn any_length_is_read_or_refused(len in 0..2000_usize, bits in 1..40_usize) {
            let _ = unpack(&vec![-1; len], bits, 4096);
        }
    }

    #[test]
    fn numbers_take_as_many_bits_as_the_last_one() {
        for (count, expected) in [(0, 0), (1, 0), (2, 1), (3, 2), (16, 4), (17, 5), (4096, 12)] {
            assert_eq!(bits(count), expected, "{count}");
        }
    }
}
