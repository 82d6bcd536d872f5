use super::error::Kind;
use crate::graph::Group;
use crate::space::Length;
use std::ops::Range;

/// How many parts may share a block. Only every so many of them get one, but their rhythm is kept.
const THIN: usize = 16;

/// Slack in counting how often a rhythm fits, against the noise of sums.
const NOISE: f64 = 1e-6;

/// Writes out the rhythm groups of a split: the numbers of its children in order, repeated as they fit.
///
/// A group of absolute sizes is repeated as often as it fits; one with floating sizes as often as comes
/// nearest to their sizes taken as blocks, and once at least. What the parts outside the groups take is
/// set aside first, floating ones at their sizes in whole blocks; several groups share the rest.
pub fn written_out(parts: &[Length], groups: &[Group], total: i32) -> Result<Vec<usize>, Kind> {
    let mut out = Vec::new();
    let rhythm = Rhythm { parts, groups, most: THIN * (total.max(0) as usize + 1) + parts.len() };
    rhythm.write(0..parts.len(), 0, f64::from(total), &mut out)?;
    Ok(out)
}

struct Rhythm<'a> {
    parts: &'a [Length],
    groups: &'a [Group],
    /// More parts than this are a slip.
    most: usize,
}

impl Rhythm<'_> {
    /// Writes out the children of `range`; `inner` is the first group that may lie inside it.
    fn write(&self, range: Range<usize>, inner: usize, room: f64, out: &mut Vec<usize>) -> Result<(), Kind> {
        let grouped: f64 = self.direct(&range, inner).map(|(_, group)| self.natural(group)).sum();
        let free = (room - self.outside(&range, inner)).max(0.0);
        let mut at = range.start;
        for (number, group) in self.direct(&range, inner) {
            out.extend(at..group.start);
            let share = free * self.natural(group) / grouped;
            let count = self.count(group, share)?;
            for _ in 0..count {
                self.write(group.clone(), number + 1, share / count as f64, out)?;
                if out.len() > self.most {
                    return Err(Kind::Rhythm);
                }
            }
            at = group.end;
        }
        out.extend(at..range.end);
        Ok(())
    }

    /// The blocks that the parts of `range` outside its groups take.
    fn outside(&self, range: &Range<usize>, inner: usize) -> f64 {
        let is_outside = |part: &usize| !self.direct(range, inner).any(|(_, group)| group.contains(part));
        let blocks = |part: usize| match self.parts[part] {
            Length::Absolute(size) => size.max(0.0),
            Length::Floating(size) => size.max(0.0).round(),
        };
        range.clone().filter(is_outside).map(blocks).sum()
    }

    /// The groups directly inside `range`, with their numbers.
    fn direct(&self, range: &Range<usize>, inner: usize) -> impl Iterator<Item = (usize, &Range<usize>)> {
        let (mut at, end) = (range.start, range.end);
        self.groups.iter().map(|group| &group.children).enumerate().skip(inner).filter(move |(_, group)| {
            let is_direct = group.start >= at && group.end <= end;
            if is_direct {
                at = group.end;
            }
            is_direct
        })
    }

    fn count(&self, group: &Range<usize>, share: f64) -> Result<usize, Kind> {
        let natural = self.natural(group);
        if natural <= NOISE {
            return Err(Kind::Rhythm);
        }
        let floats = self.parts[group.clone()].iter().any(|part| matches!(part, Length::Floating(_)));
        let fits = share / natural;
        Ok(if floats { fits.round().max(1.0) } else { (fits + NOISE).floor() } as usize)
    }

    /// The blocks that a range takes with every group in it once and floating sizes taken as blocks.
    fn natural(&self, range: &Range<usize>) -> f64 {
        let parts = self.parts[range.clone()].iter();
        parts.map(|(Length::Absolute(size) | Length::Floating(size))| size.max(0.0)).sum()
    }
}
