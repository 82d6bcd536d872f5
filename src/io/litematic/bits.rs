//! Numbers of a fixed width in bits, packed without gaps into words of 64, low bits first.
//!
//! 64 numbers fill as many words as they are wide. With the width known when this is compiled, every place
//! within such a run is, too.

const RUN: usize = 64;

/// Calls `$function` for the width `$width`, 2 to 16.
macro_rules! of_width {
    ($width:expr, $function:ident, $($argument:expr),*) => {
        match $width {
            2 => $function::<2>($($argument),*),
            3 => $function::<3>($($argument),*),
            4 => $function::<4>($($argument),*),
            5 => $function::<5>($($argument),*),
            6 => $function::<6>($($argument),*),
            7 => $function::<7>($($argument),*),
            8 => $function::<8>($($argument),*),
            9 => $function::<9>($($argument),*),
            10 => $function::<10>($($argument),*),
            11 => $function::<11>($($argument),*),
            12 => $function::<12>($($argument),*),
            13 => $function::<13>($($argument),*),
            14 => $function::<14>($($argument),*),
            15 => $function::<15>($($argument),*),
            _ => $function::<16>($($argument),*),
        }
    };
}

/// The most entries of a palette whose indices fit.
pub(super) const ENTRIES: usize = 1 << 16;

/// The bits that the indices of a palette of so many entries take.
pub(super) fn width(entries: usize) -> u32 {
    entries.saturating_sub(1).checked_ilog2().map_or(0, |highest| highest + 1).max(2)
}

/// The words that `count` numbers take.
pub(super) fn words(count: u64, width: u32) -> u64 {
    (u128::from(count) * u128::from(width)).div_ceil(64).try_into().unwrap_or(u64::MAX)
}

/// The first `count` numbers of `words`, which hold as many.
pub(super) fn unpack(words: &[i64], width: u32, count: usize) -> Vec<u16> {
    of_width!(width, unpack_words, words, count)
}

/// The number `at` so many others.
pub(super) fn number(words: &[i64], width: u32, at: usize) -> u16 {
    let (word, shift) = (at * width as usize / 64, at * width as usize % 64);
    let pair =
        [words[word], words.get(word + 1).copied().unwrap_or(0)].map(|word| u128::from(word.cast_unsigned()));
    ((pair[0] | pair[1] << 64) >> shift & ((1 << width) - 1)) as u16
}

/// `numbers` that are all less than 2 to the `width`.
pub(super) fn pack(numbers: &[u16], width: u32) -> Vec<i64> {
    of_width!(width, pack_numbers, numbers)
}

fn unpack_words<const WIDTH: usize>(words: &[i64], count: usize) -> Vec<u16> {
    let mut numbers = Vec::with_capacity(count.next_multiple_of(RUN));
    let (runs, rest) = words.as_chunks::<WIDTH>();
    for run in runs {
        numbers.extend_from_slice(&unpack_run(run));
    }
    if !rest.is_empty() {
        numbers.extend_from_slice(&unpack_run(&filled::<_, WIDTH>(rest)));
    }
    numbers.truncate(count);
    numbers
}

fn pack_numbers<const WIDTH: usize>(numbers: &[u16]) -> Vec<i64> {
    let (runs, rest) = numbers.as_chunks::<RUN>();
    let mut words = Vec::with_capacity((runs.len() + 1) * WIDTH);
    for run in runs {
        words.extend_from_slice(&pack_run::<WIDTH>(run));
    }
    let last = (rest.len() * WIDTH).div_ceil(64);
    words.extend_from_slice(&pack_run::<WIDTH>(&filled(rest))[..last]);
    words
}

#[inline]
fn unpack_run<const WIDTH: usize>(words: &[i64; WIDTH]) -> [u16; RUN] {
    std::array::from_fn(|at| {
        let (word, shift) = (at * WIDTH / 64, at * WIDTH % 64);
        let low = words[word].cast_unsigned() >> shift;
        let high = if shift + WIDTH > 64 { words[word + 1].cast_unsigned() << (64 - shift) } else { 0 };
        ((low | high) & ((1 << WIDTH) - 1)) as u16
    })
}

#[inline]
fn pack_run<const WIDTH: usize>(numbers: &[u16; RUN]) -> [i64; WIDTH] {
    let mut words = [0u64; WIDTH];
    for (at, &number) in numbers.iter().enumerate() {
        let (word, shift) = (at * WIDTH / 64, at * WIDTH % 64);
        words[word] |= u64::from(number) << shift;
        if shift + WIDTH > 64 {
            words[word + 1] |= u64::from(number) >> (64 - shift);
        }
    }
    words.map(u64::cast_signed)
}

/// `start` with zeros behind it.
fn filled<T: Copy + Default, const N: usize>(start: &[T]) -> [T; N] {
    let mut all = [T::default(); N];
    all[..start.len()].copy_from_slice(start);
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn widths_of_palettes() {
        let cases = [(0, 2), (1, 2), (2, 2), (4, 2), (5, 3), (8, 3), (9, 4), (16, 4), (17, 5), (65_536, 16)];
        for (entries, bits) in cases {
            assert_eq!(width(entries), bits, "{entries} entries");
        }
    }

    #[test]
    fn numbers_cross_the_borders_of_words() {
        let numbers: Vec<u16> = (0..22).map(|n| n % 8).collect();
        // The 22nd number of three bits starts at bit 63: 5 is 101, of which the low 1 is the last bit.
        assert_eq!(numbers[21], 5);
        let words = pack(&numbers, 3);
        assert_eq!((words.len(), words[0] < 0, words[1]), (2, true, 0b10));
        assert_eq!(words[0] & 0o77_777_777, 0o76_543_210);
    }

    proptest! {
        #[test]
        fn numbers_come_back(width in 2..=16u32, numbers in prop::collection::vec(0..=u16::MAX, 0..300)) {
            let numbers: Vec<u16> = numbers.into_iter().map(|n| n & ((1u32 << width) - 1) as u16).collect();
            let packed = pack(&numbers, width);
            prop_assert_eq!(packed.len() as u64, words(numbers.len() as u64, width));
            for (at, &expected) in numbers.iter().enumerate() {
                prop_assert_eq!(number(&packed, width, at), expected);
            }
            prop_assert_eq!(unpack(&packed, width, numbers.len()), numbers);
        }
    }
}
