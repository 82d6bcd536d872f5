//! Sequences with their longest repeat written once.

use super::corpus::Skeleton;

/// A piece of a folded sequence.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Token {
    One(Skeleton),
    /// The next so many pieces stand several times one after another; how often is not said.
    Repeat(u32),
}

/// The sequence with its best repeat written once: the one that saves most, of the shortest unit.
pub fn folded(sequence: &[Skeleton]) -> Vec<Token> {
    let one = |skeleton: &Skeleton| Token::One(*skeleton);
    let Some((start, unit, count)) = best(sequence) else { return sequence.iter().map(one).collect() };
    let (before, rest) = sequence.split_at(start);
    let after = &rest[unit * count..];
    let repeat = std::iter::once(Token::Repeat(unit as u32)).chain(rest[..unit].iter().map(one));
    before.iter().map(one).chain(repeat).chain(after.iter().map(one)).collect()
}

/// Start, length of the unit and count of the repeat that saves most: two pieces at least.
fn best(sequence: &[Skeleton]) -> Option<(usize, usize, usize)> {
    let mut best = None;
    let mut most = 1;
    for unit in 1..=sequence.len() / 2 {
        let mut equal = 0;
        for at in unit..sequence.len() {
            equal = if sequence[at] == sequence[at - unit] { equal + 1 } else { 0 };
            let saved = equal / unit * unit;
            if saved > most {
                most = saved;
                best = Some((at + 1 - equal - unit, unit, saved / unit + 1));
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repeats_are_written_once() {
        let cases =
            [("abc", "abc"), ("ababab", "2ab"), ("xababay", "x2abay"), ("aab", "aab"), ("abcabcabc", "3abc")];
        for (text, expected) in cases {
            let sequence: Vec<Skeleton> = text.bytes().map(|byte| Skeleton(u32::from(byte))).collect();
            let shown = |token: Token| match token {
                Token::One(Skeleton(byte)) => char::from(byte as u8).to_string(),
                Token::Repeat(unit) => unit.to_string(),
            };
            assert_eq!(folded(&sequence).into_iter().map(shown).collect::<String>(), expected, "{text}");
        }
    }
}
