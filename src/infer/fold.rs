//! Repeats among the parts of a split (seed 1, section 10.3: equal children of equal sizes).

/// A part: its length, and what fills it.
pub type Piece<T> = (i32, T);

/// An item of a folded split.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Folded<T> {
    One(Piece<T>),
    /// The same run of parts, `count` times one after another.
    Repeat {
        unit: Vec<Piece<T>>,
        count: i32,
    },
}

impl<T> Folded<T> {
    /// The length that the item takes along the axis.
    pub fn len(&self) -> i32 {
        match self {
            Folded::One((len, _)) => *len,
            Folded::Repeat { unit, count } => count * unit.iter().map(|(len, _)| len).sum::<i32>(),
        }
    }
}

/// Units longer than this are not looked for.
const LONGEST_UNIT: usize = 6;

/// Folds runs of equal parts into repeats, from left to right. Where several fold, the one that leaves the
/// fewest parts to write wins, then the shortest unit.
pub fn fold<T: Clone + PartialEq>(pieces: &[Piece<T>]) -> Vec<Folded<T>> {
    let mut folded = Vec::new();
    let mut at = 0;
    while at < pieces.len() {
        match best_repeat(&pieces[at..]) {
            Some((unit, count)) => {
                folded.push(Folded::Repeat { unit: pieces[at..at + unit].to_vec(), count: count as i32 });
                at += unit * count;
            }
            None => {
                folded.push(Folded::One(pieces[at].clone()));
                at += 1;
            }
        }
    }
    folded
}

/// The length of the unit and its count of the best repeat at the start of `pieces`.
fn best_repeat<T: PartialEq>(pieces: &[Piece<T>]) -> Option<(usize, usize)> {
    let repeats = (1..=LONGEST_UNIT.min(pieces.len() / 2)).filter_map(|unit| {
        let count = 1 + pieces.chunks_exact(unit).skip(1).take_while(|next| **next == pieces[..unit]).count();
        let saved = unit * (count - 1);
        // A repeat has to be shorter to write than its parts.
        (count >= 2 && saved >= 2).then_some((unit, count))
    });
    repeats.max_by_key(|(unit, count)| (unit * (count - 1), std::cmp::Reverse(*unit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rhythms_are_found() {
        let pieces: Vec<Piece<char>> = "abababa".chars().map(|c| (1, c)).collect();
        let folded = fold(&pieces);
        assert_eq!(folded[0], Folded::Repeat { unit: vec![(1, 'a'), (1, 'b')], count: 3 });
        assert_eq!(folded[1], Folded::One((1, 'a')));
    }

    proptest! {
        #[test]
        fn folding_loses_nothing(pieces in prop::collection::vec((1..3i32, 0..3u8), 0..30)) {
            let mut written = Vec::new();
            for item in fold(&pieces) {
                match item {
                    Folded::One(piece) => written.push(piece),
                    Folded::Repeat { unit, count } => (0..count).for_each(|_| written.extend(unit.clone())),
                }
            }
            prop_assert_eq!(written, pieces);
        }
    }
}
