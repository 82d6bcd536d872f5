//! Which runs of a sequence are repeats.

/// Something that stands so often in a row.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Run<T> {
    pub times: u32,
    pub unit: Vec<T>,
}

/// How repeats are looked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Folding {
    /// As seed 4 does (section 6.2): the first of `A A A`, `A B A B`, `A B C A B C` that begins at a place is taken.
    Greedy,
    /// The runs whose description is shortest.
    Shortest,
}

/// What an element costs beside a run of several, in halves of an element.
const RUN: usize = 1;
const ELEMENT: usize = 2;

/// Units of more elements are not looked for.
const LONGEST: usize = 64;
const GREEDY: usize = 3;

/// A sequence as runs. What stands once is a run of one.
pub fn folded<T: Clone + PartialEq>(sequence: &[T], folding: Folding) -> Vec<Run<T>> {
    match folding {
        Folding::Greedy => greedy(sequence),
        Folding::Shortest => shortest(sequence),
    }
}

/// The same with repeats of one number of times only, those that save most; the others are written out. Repeats of a split
/// share its room in proportion to their lengths, so all come equally often.
pub fn in_step<T: Clone>(runs: Vec<Run<T>>) -> Vec<Run<T>> {
    let saved = |times: u32| {
        let own = runs.iter().filter(|run| run.times == times);
        own.map(|run| (times as usize - 1) * run.unit.len()).sum::<usize>()
    };
    let kept = runs.iter().map(|run| run.times).max_by_key(|times| (saved(*times), *times)).unwrap_or(1);
    let written = |run: Run<T>| match run.times == kept || run.times == 1 {
        true => vec![run],
        false => {
            let parts = (0..run.times).flat_map(|_| run.unit.iter().cloned());
            parts.map(|part| Run { times: 1, unit: vec![part] }).collect()
        }
    };
    runs.into_iter().flat_map(written).collect()
}

fn greedy<T: Clone + PartialEq>(sequence: &[T]) -> Vec<Run<T>> {
    let mut runs = Vec::new();
    let mut at = 0;
    while at < sequence.len() {
        let rest = &sequence[at..];
        let repeat =
            (1..=GREEDY.min(rest.len())).map(|len| (len, times(rest, len))).find(|(_, times)| *times > 1);
        let (len, times) = repeat.unwrap_or((1, 1));
        runs.push(Run { times: times as u32, unit: rest[..len].to_vec() });
        at += len * times;
    }
    runs
}

/// How often the first `len` elements stand at the beginning.
fn times<T: PartialEq>(sequence: &[T], len: usize) -> usize {
    sequence.chunks_exact(len).take_while(|chunk| *chunk == &sequence[..len]).count()
}

fn shortest<T: Clone + PartialEq>(sequence: &[T]) -> Vec<Run<T>> {
    // For each place, the least cost of all before it, and the last run: its length and how often it stands.
    let mut best: Vec<(usize, usize, usize)> = vec![(0, 0, 0)];
    best.extend((1..=sequence.len()).map(|_| (usize::MAX, 1, 1)));
    for at in 0..sequence.len() {
        let so_far = best[at].0;
        let rest = &sequence[at..];
        for len in 1..=LONGEST.min(rest.len()) {
            for times in 1..=times(rest, len) {
                if times == 1 && len > 1 {
                    continue;
                }
                let cost = so_far + ELEMENT * len + if times > 1 { RUN } else { 0 };
                let end = &mut best[at + len * times];
                if cost < end.0 {
                    *end = (cost, len, times);
                }
            }
        }
    }
    let mut runs = Vec::new();
    let mut end = sequence.len();
    while end > 0 {
        let (_, len, times) = best[end];
        let start = end - len * times;
        runs.push(Run { times: times as u32, unit: sequence[start..start + len].to_vec() });
        end = start;
    }
    runs.reverse();
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str, folding: Folding) -> String {
        let letters: Vec<char> = text.chars().collect();
        let told = |run: Run<char>| {
            let unit: String = run.unit.iter().collect();
            if run.times == 1 { unit } else { format!("{}({unit})", run.times) }
        };
        folded(&letters, folding).into_iter().map(told).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn the_patterns_of_seed_4_are_found() {
        for (text, expected) in [("AAA", "3(A)"), ("ABAB", "2(AB)"), ("ABCABC", "2(ABC)"), ("BAAA", "B 3(A)")]
        {
            assert_eq!(told(text, Folding::Greedy), expected);
            assert_eq!(told(text, Folding::Shortest), expected);
        }
    }

    #[test]
    fn what_is_greedy_first_may_cost_more() {
        assert_eq!(told("AABAAB", Folding::Greedy), "2(A) B 2(A) B");
        assert_eq!(told("AABAAB", Folding::Shortest), "2(AAB)");
    }
}
