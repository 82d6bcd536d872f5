//! What the checks foretell is what runs do.

use super::{boxes, options};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;
use vox::grammar::{Code, read};
use vox::graph::lower;
use vox::run::{Library, Options, run};

/// What is told of a grammar, and what stops its run, if anything does.
fn foretold(text: &str) -> (BTreeSet<Code>, Option<Code>) {
    let checked = read(text).unwrap_or_else(|found| panic!("{}in\n{text}", super::messages(&found)));
    let codes = checked.warnings.iter().map(|warning| warning.code).collect();
    let made = run(&lower(&checked, None).unwrap(), &Library::new(), &Options::default());
    (codes, made.err().map(|error| error.kind.code()))
}

/// One of the sizes that a part may have.
fn size() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => (0..6u32).prop_map(|blocks| blocks.to_string()),
        1 => (0..30u32).prop_map(|tenths| format!("{}.{}", tenths / 10, tenths % 10)),
        1 => (0..12u32).prop_map(|tenths| format!("'{}.{}", tenths / 10, tenths % 10)),
        1 => (1..4u32).prop_map(|share| format!("~{share}")),
    ]
}

/// A comparison of one of two lengths with a number, or several of them. Of scopes without a length, which only
/// carving makes, they tell nothing.
fn condition() -> impl Strategy<Value = String> {
    let signs = prop::sample::select(vec!["<", "<=", ">", ">=", "==", "!="]);
    let comparison = (prop::sample::select(vec!["scope.sx", "scope.sy"]), signs, 2..6u32)
        .prop_map(|(length, sign, number)| format!("{length} {sign} {number}"));
    comparison.prop_recursive(2, 4, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} and {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} or {b})")),
            inner.prop_map(|a| format!("not ({a})")),
        ]
    })
}

proptest! {
    #[test]
    fn a_split_never_fits_where_a_run_says_so(length in 1..12u32, sizes in vec(size(), 1..5)) {
        let parts: Vec<String> = sizes.iter().map(|size| format!("{size} : I(stone)")).collect();
        let text = format!("size({length}, 1, 1)\nrow --> split(x){{ {} }}\n", parts.join(" | "));
        let (told, stopped) = foretold(&text);
        prop_assert_eq!(told.contains(&Code::NeverFits), stopped == Some(Code::Overrun), "{}", text);
        prop_assert_eq!(told.contains(&Code::NeverFills), stopped == Some(Code::Underrun), "{}", text);
    }

    #[test]
    fn splits_of_parts_never_fit_only_where_a_run_says_so(
        length in 1..12u32,
        outer in vec(size(), 1..4),
        inner in vec(size(), 1..4),
    ) {
        let parts = |sizes: &[String], body: &str| {
            sizes.iter().map(|size| format!("{size} : {body}")).collect::<Vec<_>>().join(" | ")
        };
        let text = format!(
            "size({length}, 1, 1)\nrow --> split(x){{ {} }}\npart --> split(x){{ {} }}\n",
            parts(&outer, "part"),
            parts(&inner, "I(stone)"),
        );
        let (told, stopped) = foretold(&text);
        if stopped.is_none() {
            // A part without a block does not run: then nothing may be told of what stands in it.
            let runs = outer.iter().any(|size| !matches!(size.as_str(), "0" | "0.0" | "'0.0"));
            prop_assert!(!runs || !told.contains(&Code::NeverFits) && !told.contains(&Code::NeverFills), "{}", text);
        }
    }

    #[test]
    fn a_gap_is_told_where_a_run_falls_into_it(length in 1..8u32, cuts in vec((0..8u32, 0..6usize), 1..4)) {
        let signs = ["<", "<=", ">", ">=", "==", "!="];
        let rules: String = cuts
            .iter()
            .map(|(cut, sign)| format!("wall : scope.sx {} {cut} --> I(stone)\n", signs[*sign]))
            .collect();
        let text = format!("size({length}, 1, 1)\n{rules}");
        let (told, stopped) = foretold(&text);
        prop_assert_eq!(told.contains(&Code::Gap), stopped == Some(Code::NoRuleApplies), "{}", text);
    }

    #[test]
    fn a_condition_that_can_never_hold_never_holds(condition in condition()) {
        let text = format!("wall : {condition} --> I(stone)\npriority 2\nwall --> nil\n");
        let checked = read(&text).unwrap();
        let is_told = checked.warnings.iter().any(|warning| warning.code == Code::NeverHolds);
        let graph = lower(&checked, None).unwrap();
        let sizes = (1..7).flat_map(|x| (1..7).map(move |y| [x, y, 1]));
        let holds = sizes.into_iter().any(|size| !boxes(&graph, &options(size, 0)).unwrap().is_empty());
        prop_assert_eq!(is_told, !holds, "{}", text);
    }
}
