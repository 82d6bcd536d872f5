//! No text makes the front end or a run panic, and every error of a file is told at once.

use super::{boxes, options, syntax};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use vox::grammar::{Diagnostic, read};
use vox::graph::{lower, raise};

/// Words that make texts look like grammars.
const WORDS: [&str; 46] = [
    "a", "b", "house", "wall", "n", "x", "y", "z", "stone", "rect", "I", "nil", "split", "repeat", "repeatN",
    "T", "S", "R", "comp", "f", "side", "top", "up", "size", "scope.sx", "rand", "min", "and", "not", "-->",
    "=", "==", "<", "+", "-", "*", "(", ")", "{", "}", "}*", "|", ":", ",", "~", "'",
];

const EXAMPLE: &str = "# a house
up z
size(9, 7, 12) : 2
floor = 4
rect = minecraft:stone_bricks
plot --> split(x){ ~2 : house(floor) | ~1 : garage } : 0.5
plot --> R(z, pi/2){ plot2 }
plot2 --> comp(f){ side : repeat(x, 2){ I(\"door.schem\") } | top : I(gable, oak) }
house(n) : n > 0 and scope.sx >= 3 --> split(z){ '0.2 : I(rect) | { ~1 : wall | 1 : nil }* }
house(n) --> T(1, 0, -1){ S('1, 2, 3){ I(oak_stairs[facing=east]) } }
wall --> repeatN(y, max(1, randint(1, 3))){ nil } // the end
garage --> I(rect)
";

proptest! {
    #[test]
    fn any_text_is_taken_or_refused(text: String) {
        try_all(&text)?;
    }

    #[test]
    fn any_words_are_taken_or_refused(words in vec((0..WORDS.len(), any::<bool>()), 0..40)) {
        let text: String = words.iter().map(|&(at, ends)| format!("{}{}", WORDS[at], if ends { "\n" } else { " " })).collect();
        try_all(&text)?;
    }

    #[test]
    fn a_damaged_grammar_is_taken_or_refused(edits in vec((any::<Index>(), 0..4usize, any::<char>(), 0..WORDS.len()), 1..6)) {
        let mut text: Vec<char> = EXAMPLE.chars().collect();
        for (place, how, letter, word) in edits {
            let at = place.index(text.len().max(1));
            match how {
                0 => drop(text.drain(at..text.len().min(at + 1))),
                1 => text.insert(at.min(text.len()), letter),
                2 => drop(text.splice(at.min(text.len())..at.min(text.len()), WORDS[word].chars())),
                _ => text.truncate(at),
            }
        }
        try_all(&text.into_iter().collect::<String>())?;
    }

    #[test]
    fn any_tree_is_taken_or_refused_by_the_checks(grammar in syntax::grammars()) {
        try_all(&grammar.to_string())?;
    }

    #[test]
    fn every_error_is_told_at_once(slips in vec(0..SLIPS.len(), 1..8)) {
        let mut text = String::from("start --> I(stone)\n");
        slips.iter().enumerate().for_each(|(n, &at)| text += &format!("r{n} --> {}\n", SLIPS[at]));
        let found = read(&text).unwrap_err();
        for n in 0..slips.len() {
            let line = n + 2;
            let told = found.iter().any(|finding| line_of(&text, finding) == line && !finding.message.contains("reached"));
            prop_assert!(told, "nothing told of line {} of\n{}", line, text);
        }
    }
}

/// Slips of a rule, of the parser's and of the checks' concern.
const SLIPS: [&str; 8] = [
    "split(x){ ~1 : I(stone)",
    "split(x) ~1 : I(stone) }",
    "I(stone",
    "comp(f){ roof : nil }",
    "missing",
    "I(no_such_block)",
    "split(w){ ~1 : nil }",
    "T(~1, 0, 0){ nil }",
];

fn line_of(text: &str, finding: &Diagnostic) -> usize {
    text[..finding.span.start].matches('\n').count() + 1
}

/// Parses, checks, prints, lowers, raises and runs, as far as it goes.
fn try_all(text: &str) -> Result<(), TestCaseError> {
    match read(text) {
        Err(found) => {
            prop_assert!(!found.is_empty());
            for finding in found {
                prop_assert!(text.get(finding.span.range()).is_some(), "no such place: {:?}", finding);
            }
        }
        Ok(checked) => {
            let Ok(graph) = lower(&checked, None) else { return Ok(()) };
            drop(raise(&graph).to_string());
            drop(boxes(&graph, &options([6, 5, 7], 1)));
        }
    }
    Ok(())
}
