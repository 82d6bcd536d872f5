//! The version of the game that a grammar is for.

use super::change::Change;
use super::texts::{Edit, Program, Texts};
use crate::block::Version;
use crate::grammar::Span;
use crate::grid::Grid;

/// A grammar for a version that has all blocks of a house, if the one that it states has not: the game brings older
/// blocks up to date, never newer ones down.
pub fn raised(texts: &Texts, program: &Program, house: &Grid) -> Option<(Texts, Change)> {
    let stated = program.checked.grammar().data_version?;
    let least = Version::of_data(stated)?;
    let needed = house.least_version(least);
    if needed == least {
        return None;
    }
    let (from, to) = (stated.to_string(), needed.data_version().to_string());
    let (file, start) = program.sources.texts().find_map(|(name, text)| Some((name, place(text, &from)?)))?;
    let edit = Edit { file: file.to_owned(), span: Span::new(start, start + from.len()), text: to };
    let change = Change::Raised { from: stated, to: needed.data_version() };
    Some((texts.edited(&[edit]), change))
}

/// Where a text states the version.
fn place(text: &str, number: &str) -> Option<usize> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let words = line.trim_start().strip_prefix("data_version").unwrap_or("");
        if words.trim_start().starts_with(number) {
            return Some(start + line.find(number)?);
        }
        start += line.len();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::Sources;

    #[test]
    fn newer_blocks_ask_for_a_newer_version() {
        let text = "# data_version 3465\ndata_version 3465 # 1.20.1\na --> I(stone)";
        let texts = Texts::of(&Sources::of("a.grammar", text));
        let raised_by = |name: &str| {
            let mut house = Grid::new(crate::space::Cell::ONE);
            let id = house.intern(&name.parse().unwrap()).unwrap();
            house.set(crate::space::Cell::ZERO, id);
            raised(&texts, &texts.read().unwrap(), &house)
        };
        assert!(raised_by("stone").is_none());
        let (raised, change) = raised_by("pale_oak_planks").unwrap();
        assert_eq!(change.to_string(), "raised the `data_version`: 3465 to 4080");
        assert_eq!(raised.get("a.grammar"), text.replace("\ndata_version 3465", "\ndata_version 4080"));
    }
}
