//! How many blocks of each type a shape has.

use smallvec::SmallVec;

/// The number of a block type in one building.
pub type Kind = u16;

/// Block types and how many blocks there are of each, ordered by type.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Tally(SmallVec<[(Kind, u32); 4]>);

impl Tally {
    pub fn of(kinds: impl IntoIterator<Item = Kind>) -> Tally {
        let mut tally = Tally::default();
        kinds.into_iter().for_each(|kind| tally.add(kind, 1));
        tally
    }

    fn add(&mut self, kind: Kind, count: u32) {
        match self.0.binary_search_by_key(&kind, |(kind, _)| *kind) {
            Ok(at) => self.0[at].1 += count,
            Err(at) => self.0.insert(at, (kind, count)),
        }
    }

    /// The blocks of both.
    pub fn plus(&self, other: &Tally) -> Tally {
        let mut sum = self.clone();
        other.0.iter().for_each(|(kind, count)| sum.add(*kind, *count));
        sum
    }

    /// The blocks of this that are not in `part`, which lies within.
    pub fn minus(&self, part: &Tally) -> Tally {
        let left = self.0.iter().map(|&(kind, count)| (kind, count - part.count(kind)));
        Tally(left.filter(|(_, count)| *count > 0).collect())
    }

    fn count(&self, kind: Kind) -> u32 {
        self.0.binary_search_by_key(&kind, |(kind, _)| *kind).map_or(0, |at| self.0[at].1)
    }

    /// The number of block types.
    pub fn kinds(&self) -> usize {
        self.0.len()
    }

    /// The entropy of the types, in bits (seed 3, equation 3).
    pub fn entropy(&self) -> f64 {
        let total = f64::from(self.0.iter().map(|(_, count)| count).sum::<u32>());
        let shares = self.0.iter().map(|(_, count)| f64::from(*count) / total);
        // From zero: an empty sum of floats is minus zero. libm's logarithm is the same on every machine.
        shares.fold(0.0, |sum, share| sum - share * libm::log2(share))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entropy_is_that_of_the_shares() {
        assert_eq!(Tally::of([3, 3, 3]).entropy(), 0.0);
        assert_eq!(Tally::of([1, 2, 2, 1]).entropy(), 1.0);
        assert_eq!(Tally::of([1, 2, 3, 4]).entropy(), 2.0);
    }

    #[test]
    fn what_is_added_can_be_taken_away() {
        let (one, two) = (Tally::of([1, 2, 2]), Tally::of([2, 5]));
        assert_eq!(one.plus(&two).minus(&two), one);
        assert_eq!(one.plus(&two), Tally::of([1, 2, 2, 2, 5]));
    }
}
