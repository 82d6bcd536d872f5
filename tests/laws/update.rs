//! An update makes a grammar derive a house, takes nothing away, and leaves alone what it does not name.

use super::parse::{grammars, sizes};
use super::{blocks, graph, options};
use proptest::prelude::*;
use vox::grammar::{Grammar, Sources};
use vox::graph::OpGraph;
use vox::grid::Grid;
use vox::parse::{Laws, Parser};
use vox::run::Library;
use vox::update::{Change, Texts, UpdateError, Updated, update};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn an_updated_grammar_derives_the_new_house_and_the_old_ones(
        text in grammars(), other in grammars(), size in sizes(), other_size in sizes(), seed in 0..4u64,
    ) {
        let known = graph(&text);
        let olds: Vec<Grid> = (0..3).filter_map(|seed| blocks(&known, &options(size, seed)).ok()).collect();
        if let Ok(house) = blocks(&graph(&other), &options(other_size, seed)) {
            match updated(&text, &house) {
                Ok((new, changes)) => {
                    let graph = graph(&new);
                    let parser = Parser::new(&graph, Laws::AsWritten);
                    prop_assert!(parser.derives(&house), "{text}\nbecame\n{new}");
                    for old in &olds {
                        prop_assert!(parser.derives(old), "{text}\nlost a house as\n{new}");
                    }
                    prop_assert_eq!(changes.is_empty(), new == text);
                    assert_rest_stays(&text, &new, &changes)?;
                }
                Err(error) => prop_assert!(error == UpdateError::Empty, "{text}\nand\n{other}: {error}"),
            }
        }
    }

    #[test]
    fn a_house_that_is_derived_changes_no_byte(text in grammars(), size in sizes(), seed in 0..4u64) {
        let text = format!("# Ada's\n\n{}  # kept\n", text.replace(" | ", "  |  "));
        if let Ok(house) = blocks(&graph(&text), &options(size, seed)) {
            match updated(&text, &house) {
                Ok((new, changes)) => {
                    prop_assert_eq!(new, text);
                    prop_assert_eq!(changes, vec![]);
                }
                Err(error) => prop_assert_eq!(error, UpdateError::Empty),
            }
        }
    }
}

fn updated(text: &str, house: &Grid) -> Result<(String, Vec<Change>), UpdateError> {
    let texts = Texts::of(&Sources::of("a.grammar", text));
    let Updated { texts, changes, .. } = update(&texts, house, &Library::new())?;
    Ok((texts.get("a.grammar").to_owned(), changes))
}

/// Rules of labels that no change names are as they were, and comments are there.
fn assert_rest_stays(text: &str, new: &str, changes: &[Change]) -> Result<(), TestCaseError> {
    let told: String = changes.iter().map(|change| format!("{change}\n")).collect();
    let [before, after]: [Grammar; 2] = [text.parse().unwrap(), new.parse().unwrap()];
    for rule in before.rules.iter().filter(|rule| !told.contains(&format!("`{}`", rule.label.name))) {
        prop_assert!(
            after.rules.iter().any(|other| other.to_string() == rule.to_string()),
            "{rule}\nis not in\n{new}"
        );
    }
    Ok(())
}

fn after(text: &str, house: &str, size: [i32; 3]) -> (String, Vec<String>) {
    let house: OpGraph = graph(house);
    let (new, changes) = updated(text, &blocks(&house, &options(size, 0)).unwrap()).unwrap();
    (new, changes.iter().map(Change::to_string).collect())
}

#[test]
fn numbers_are_widened_where_they_stand() {
    let cases = [
        ("a --> split(x){ randint(1, 2) : I(stone) | ~1 : I(dirt) }", "randint(1, 2)", "randint(1, 3)"),
        ("a --> split(x){ 2 : I(stone) | ~1 : I(dirt) }", "2", "randint(2, 3)"),
        ("a --> split(x){ 1 : I(stone) | ~1 : I(dirt) }", "1", "pick{ 1 : 1 | 1 : 3 }"),
        ("a --> split(x){ 1 : I(stone) | 2 : I(dirt) }", "1", "~1"),
        (
            "a --> split(x){ pick{ 3 : 1 | 1 : 5 } : I(stone) | ~1 : I(dirt) }",
            " | 1 : 5 }",
            " | 1 : 5 | 1 : 3 }",
        ),
        ("a --> b(2)\nb(n) --> split(x){ n : I(stone) | ~1 : I(dirt) }", "b(2)", "b(randint(2, 3))"),
        ("n = randint(1, 2) # of stone\na --> split(x){ n : I(stone) | ~1 : I(dirt) }", "t(1, 2)", "t(1, 3)"),
        ("a --> split(x){ 1 + randint(0, 1) : I(stone) | ~1 : I(dirt) }", "t(0, 1)", "t(0, 2)"),
        ("a --> split(x){ scope.sx - 3 : I(stone) | ~1 : I(dirt) }", "3", "randint(2, 3)"),
    ];
    for (text, from, to) in cases {
        let (new, changes) = after(text, "a --> split(x){ 3 : I(stone) | ~1 : I(dirt) }", [5, 1, 1]);
        assert_eq!(new, text.replacen(from, to, 1));
        assert!(changes.len() == 1 && changes[0].starts_with("widened"), "{changes:?}");
    }
}

#[test]
fn a_range_that_an_attribute_states_is_kept() {
    let text = "attr n = randint(1, 2) range(1, 2)\na --> split(x){ n : I(stone) | ~1 : I(dirt) }";
    let (new, changes) = after(text, "a --> split(x){ 3 : I(stone) | ~1 : I(dirt) }", [5, 1, 1]);
    assert!(new.starts_with(text), "{new}");
    assert!(changes[0].starts_with("added an alternative to `a`"), "{changes:?}");
}

#[test]
fn what_has_a_rule_is_not_written_again_and_rules_do_not_run_in_rings() {
    let text = "a --> split(y){ 1 : base | ~1 : wall }\nbase --> I(cobblestone)\nwall --> I(bricks)";
    let house = "a --> split(y){ 1 : I(cobblestone) | ~1 : split(x){ 1 : I(cobblestone) | ~1 : I(bricks) } }";
    let (new, changes) = after(text, house, [4, 3, 1]);
    assert_eq!(changes, ["added an alternative to `wall`"]);
    assert_eq!(new, format!("{text}\nwall : scope.sx >= 2 --> split(x){{ 1 : base | ~1 : I(bricks) }}"));
}

#[test]
fn a_new_alternative_hides_none_of_a_later_priority() {
    let text = "a : scope.sx > 2 --> I(stone)\npriority 2\na --> I(dirt)";
    let (new, _) = after(text, "a --> I(glass)", [2, 1, 1]);
    assert_eq!(new, format!("{text}\na : scope.sx == 2 and scope.sy == 1 and scope.sz == 1 --> I(glass)"));
}

#[test]
fn lines_end_as_they_do_in_the_file() {
    let text = "a --> I(stone) # first\r\n\r\n# last\r\n";
    let (new, _) = after(text, "a --> I(glass)", [2, 1, 1]);
    let added = "a : scope.sx == 2 and scope.sy == 1 and scope.sz == 1 --> I(glass)\r\n";
    assert_eq!(new, text.replacen("first\r\n", &format!("first\r\n{added}"), 1));
}
