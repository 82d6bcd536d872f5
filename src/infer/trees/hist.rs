//! How often each length was seen.

use crate::infer::joint::laws::{Law, law_of};

/// Lengths in cells with their counts, shortest first.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Hist(Vec<(i32, u32)>);

impl Hist {
    pub fn of(lengths: impl IntoIterator<Item = i32>) -> Hist {
        let mut all: Vec<i32> = lengths.into_iter().collect();
        all.sort_unstable();
        Hist(all.chunk_by(|a, b| a == b).map(|run| (run[0], run.len() as u32)).collect())
    }

    pub fn plus(&self, other: &Hist) -> Hist {
        let mut all: Vec<(i32, u32)> = self.0.iter().chain(&other.0).copied().collect();
        all.sort_unstable();
        let joined = all.chunk_by(|a, b| a.0 == b.0);
        Hist(joined.map(|run| (run[0].0, run.iter().map(|(_, count)| count).sum())).collect())
    }

    pub fn count(&self) -> u32 {
        self.0.iter().map(|(_, count)| count).sum()
    }

    /// The least and the greatest.
    pub fn range(&self) -> (i32, i32) {
        let len = |entry: Option<&(i32, u32)>| entry.map_or(0, |(len, _)| *len);
        (len(self.0.first()), len(self.0.last()))
    }

    pub fn entries(&self) -> &[(i32, u32)] {
        &self.0
    }

    /// The mean, in cells.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.0.iter().map(|(len, count)| f64::from(*len) * f64::from(*count)).sum();
        sum / f64::from(self.count().max(1))
    }

    /// The lengths that a quarter and three quarters are no longer than.
    pub fn quartiles(&self) -> (i32, i32) {
        (self.quantile(1), self.quantile(3))
    }

    fn quantile(&self, quarters: u32) -> i32 {
        let mut left = (self.count() * quarters).div_ceil(4).max(1);
        for (len, count) in &self.0 {
            if *count >= left {
                return *len;
            }
            left -= count;
        }
        self.range().1
    }

    pub fn law(&self) -> Law {
        law_of(self.0.iter().copied())
    }

    /// The bits of its shortest law and of drawing all lengths by it.
    pub fn bits(&self) -> f64 {
        match self.0.as_slice() {
            [] => 0.0,
            entries => {
                let law = self.law();
                law.bits() + law.chance(entries.iter().copied())
            }
        }
    }
}
