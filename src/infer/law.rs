//! Laws of sizes: how the parts of one kind of split are as long as they are.

use crate::space::{Length, fit};

/// The size of a part over all places where one kind of split was seen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Law {
    Const(i32),
    /// Shares with the other floating parts what the rest leaves.
    Float,
    /// Any of these lengths, each a multiple of `step`; both bounds are included.
    Range {
        low: i32,
        high: i32,
        step: i32,
    },
}

/// The lengths of the parts of one split that was seen.
pub type Lengths = Vec<i32>;

/// The laws that give back every one of `seen` with nothing left to chance, if there are any.
///
/// One part floats at least, so that the split can be written without its total: the longest part, and
/// those that are always as long.
pub fn certain(seen: &[&Lengths]) -> Option<Vec<Law>> {
    let count = seen.first()?.len();
    let varies = |part: usize| seen.iter().any(|lengths| lengths[part] != seen[0][part]);
    let varying: Vec<usize> = (0..count).filter(|part| varies(*part)).collect();
    let floating = match varying.as_slice() {
        [] => longest(seen[0]),
        _ => varying,
    };
    let laws: Vec<Law> = (0..count)
        .map(|part| if floating.contains(&part) { Law::Float } else { Law::Const(seen[0][part]) })
        .collect();
    seen.iter().all(|lengths| gives(&laws, lengths)).then_some(laws)
}

fn longest(lengths: &Lengths) -> Vec<usize> {
    let most = lengths.iter().max().copied().unwrap_or(0);
    (0..lengths.len()).filter(|part| lengths[*part] == most).collect()
}

/// What a part can do where lengths are left to chance.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stretch {
    /// Is empty space.
    Empty,
    /// Can be as long as any length between those seen.
    Elastic,
    /// Can only be multiples of this length.
    Multiple(i32),
    /// Can only be as long as it was seen.
    Rigid,
}

/// Laws that may give each of `seen`, and lengths between (seed 1, section 10.3): one part floats, the
/// others that vary are drawn from the range of their lengths. Empty space floats before an elastic part,
/// then what varies most.
///
/// `None` where a draw could ask too much: of a part that cannot stretch so far, or of a scope as short as
/// the shortest seen.
pub fn ranges(seen: &[&Lengths], stretch: &[Stretch]) -> Option<Vec<Law>> {
    let range = |part: usize| {
        let lengths = seen.iter().map(|lengths| lengths[part]);
        (lengths.clone().min().unwrap_or(0), lengths.max().unwrap_or(0))
    };
    let varies = |part: &usize| range(*part).0 < range(*part).1;
    let spread = |part: &usize| range(*part).1 - range(*part).0;
    let parts = 0..stretch.len();
    let is_empty = |part: &usize| stretch[*part] == Stretch::Empty;
    let can_float = |part: &usize| varies(part) && (is_empty(part) || stretch[*part] == Stretch::Elastic);
    let floating = parts.clone().rev().filter(can_float).max_by_key(|part| (is_empty(part), spread(part)))?;
    let law = |part: usize| match (range(part), stretch[part]) {
        _ if part == floating => Some(Law::Float),
        ((low, high), _) if low == high => Some(Law::Const(low)),
        ((low, high), Stretch::Empty | Stretch::Elastic) => Some(Law::Range { low, high, step: 1 }),
        ((low, high), Stretch::Multiple(step)) => Some(Law::Range { low, high, step }),
        (_, Stretch::Rigid) => None,
    };
    let shortest: i32 = seen.iter().map(|lengths| lengths.iter().sum()).min()?;
    let most: i32 = parts.clone().filter(|part| *part != floating).map(|part| range(part).1).sum();
    let fits = shortest - most >= range(floating).0;
    parts.map(law).collect::<Option<Vec<Law>>>().filter(|_| fits)
}

/// Whether laws without ranges give these lengths, by the fitting that a run uses.
fn gives(laws: &[Law], lengths: &Lengths) -> bool {
    let sizes: Vec<Length> = laws
        .iter()
        .map(|law| match law {
            Law::Const(length) => Length::Absolute(f64::from(*length)),
            Law::Float | Law::Range { .. } => Length::Floating(1.0),
        })
        .collect();
    let fitted = fit(lengths.iter().sum(), &sizes);
    fitted.is_ok_and(|bounds| bounds.windows(2).map(|pair| pair[1] - pair[0]).eq(lengths.iter().copied()))
}
