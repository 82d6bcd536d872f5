//! Phrases for an operation, the best first: its noun, and before it where it stands, what it is made of, what it holds.

use super::sights::Sight;
use super::words::{self, Noun, Says};
use crate::infer::emit::identifier;
use std::collections::BTreeMap;

/// So many words stand before a noun at the most.
const MOST_BEFORE: usize = 2;

/// By noun, how many operations are called by it, and how many of these each word is true of.
#[derive(Debug, Default)]
pub struct Common(BTreeMap<&'static str, (usize, BTreeMap<String, usize>)>);

impl Common {
    pub fn note(&mut self, noun: Noun, sight: &Sight) {
        let (count, words) = self.0.entry(noun.word).or_default();
        *count += 1;
        for word in contents(sight) {
            *words.entry(word).or_default() += 1;
        }
    }

    /// The words for what an operation holds that tell it from others of its noun, the rarest first.
    fn telling(&self, noun: Noun, sight: &Sight) -> Vec<String> {
        let Some((count, known)) = self.0.get(noun.word) else { return Vec::new() };
        let rarity = |word: &String| known.get(word).copied().unwrap_or(0);
        let mut words = contents(sight);
        // The first material is what people see first.
        let first = words.first().filter(|word| 2 * rarity(word) <= *count).cloned();
        words.retain(|word| rarity(word) < *count && Some(word) != first.as_ref());
        words.sort_by_key(rarity);
        first.into_iter().chain(words).collect()
    }
}

/// Words for what an operation holds: its materials, those of most cells first, and its features.
fn contents(sight: &Sight) -> Vec<String> {
    let materials = sight.materials().into_iter().map(identifier);
    materials.chain(words::features(sight).into_iter().map(str::to_owned)).collect()
}

/// Phrases for an operation of that noun.
pub fn phrases(sight: &Sight, noun: Noun, common: &Common) -> Vec<String> {
    let word = |word: Option<&str>| word.map(str::to_owned).into_iter().collect::<Vec<_>>();
    let bare = vec![String::new()];
    let [sides, seconds, heights] =
        [words::side(sight), words::second_side(sight), words::height(sight)].map(word);
    let telling = common.telling(noun, sight);
    let first: Vec<String> = telling.iter().take(1).cloned().collect();
    let best = match noun.says {
        Says::All => [&bare, &sides, &first],
        Says::Kind => [&sides, &bare, &first],
        Says::Form => [&first, &sides, &bare],
    };
    let best = best.into_iter().flatten().cloned();
    // Houses that nothing tells from one another are counted.
    let counted = match noun.word {
        "house" if telling.is_empty() => vec!["main".to_owned(), "other".to_owned()],
        _ => Vec::new(),
    };
    let more = [
        counted,
        pairs(&sides, &first),
        heights.clone(),
        telling.clone(),
        pairs(&heights, &sides),
        pairs(&heights, &first),
        pairs(&sides, &seconds),
        pairs(&sides, &telling),
        contents(sight),
    ];
    let before = best.chain(more.into_iter().flatten());
    before.filter_map(|before| phrase(&before, noun.word)).collect()
}

fn pairs(left: &[String], right: &[String]) -> Vec<String> {
    left.iter().flat_map(|one| right.iter().map(move |other| format!("{one}_{other}"))).collect()
}

/// The noun with words before it, unless it has one of them itself or they are too many.
fn phrase(before: &str, noun: &str) -> Option<String> {
    let words: Vec<&str> = before.split('_').filter(|word| !word.is_empty()).collect();
    let is_said = words.iter().any(|word| noun.split('_').any(|own| own == *word));
    let is_short = words.len() <= MOST_BEFORE;
    (!is_said && is_short).then(|| words.into_iter().chain(noun.split('_')).collect::<Vec<_>>().join("_"))
}
