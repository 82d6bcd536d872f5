//! Slips in a grammar end in an error, soon.

use super::{SHORT, boxes, graph, options};
use std::time::{Duration, Instant};
use vox::grammar::{check, parse};
use vox::run::{Kind, Limits, Options};

/// Far more than any of these takes, far less than a hang.
const SOON: Duration = Duration::from_secs(20);

fn failure(text: &str, size: [i32; 3], limits: Limits) -> Kind {
    let start = Instant::now();
    let options = Options { limits, ..options(size, 0) };
    let kind = boxes(&graph(text), &options).map(|boxes| boxes.len()).unwrap_err().kind;
    assert!(start.elapsed() < SOON, "took {:?}", start.elapsed());
    kind
}

#[test]
fn recursion_without_end_is_too_deep() {
    let deep = Kind::TooDeep(SHORT.depth);
    assert_eq!(
        failure("a --> b(1)\nb(n) : n > 0 --> b(n + 1)\nb(n) : n <= 0 --> nil", [3, 3, 3], SHORT),
        deep
    );
    assert_eq!(failure("a --> S('1, '1, '1){ a }\na --> nil : 0", [3, 3, 3], SHORT), deep);
    assert_eq!(failure("a --> split(x){ ~1 : a | ~1 : a }", [30, 1, 1], SHORT), deep);
}

#[test]
fn the_default_limits_hold_without_overflow() {
    let deep = Kind::TooDeep(Limits::default().depth);
    assert_eq!(failure("a --> R(y, 90){ a }\na --> nil : 0", [3, 3, 3], Limits::default()), deep);
}

#[test]
fn growth_without_bound_takes_too_many_steps() {
    let many = Kind::TooManySteps(SHORT.steps);
    let wide = Limits { depth: u32::MAX, ..SHORT };
    assert_eq!(failure("a --> split(x){ ~1 : a | ~1 : a }", [64, 1, 1], wide), many);
    assert_eq!(failure("a --> repeat(x, 1){ R(y, 180){ a } }", [64, 1, 1], wide), many);
}

#[test]
fn huge_counts_take_too_many_steps() {
    let many = |limits: Limits| Kind::TooManySteps(limits.steps);
    let default = Limits::default();
    assert_eq!(failure("a --> repeatN(x, 1000000000000){ I(stone) }", [3, 3, 3], default), many(default));
    assert_eq!(failure("a --> repeat(x, 0.000000000001){ I(stone) }", [3, 3, 3], default), many(default));
    // Shares of no length are work as well.
    let nested = "a --> repeat(x, 1){ repeat(z, 1){ repeatN(y, 90000){ I(stone) } } }";
    assert_eq!(failure(nested, [60, 1, 60], SHORT), many(SHORT));
}

#[test]
fn numbers_out_of_range_are_errors() {
    let power = "a --> b(9999999999)\nb(n) --> b(n * n)\nb(n) --> nil : 0";
    assert_eq!(failure(power, [3, 3, 3], SHORT), Kind::NotANumber);
    assert_eq!(failure("a --> split(x){ 1/0 : nil | ~1 : nil }", [3, 3, 3], SHORT), Kind::NotANumber);
    assert_eq!(failure("a --> repeatN(x, 0/0){ nil }", [3, 3, 3], SHORT), Kind::NotANumber);
    assert!(matches!(
        failure("a --> T(1000000000000, 0, 0){ I(stone) }", [3, 3, 3], SHORT),
        Kind::OutsidePlot
    ));
    let back = "a --> T(0, 0, 0){ S(1, 1, 1){ T(-1, 0, 0){ I(stone) } } }";
    assert!(matches!(failure(back, [3, 3, 3], SHORT), Kind::OutsidePlot));
    assert!(matches!(
        failure("a --> S(1000000000000, 3, 3){ I(stone) }", [3, 3, 3], SHORT),
        Kind::OutsidePlot
    ));
    let far = "a --> T(999999999, 0, 0){ T(999999999, 0, 0){ T(999999999, 0, 0){ I(stone) } } }";
    assert!(matches!(failure(far, [3, 3, 3], SHORT), Kind::OutsidePlot));
}

#[test]
fn a_start_scope_is_not_believed_beyond_the_limit() {
    for text in
        ["size(100000, 100000, 100000)\na --> nil", "size(1/0, 1, 1)\na --> nil", "size(0, 1, 1)\na --> nil"]
    {
        let options = Options { size: None, ..options([1, 1, 1], 0) };
        assert!(boxes(&graph(text), &options).is_err(), "{text}");
    }
}

/// Texts that nest or chain as deep as they can: an error, or all the way through.
#[test]
fn deep_texts_do_not_overflow_the_stack() {
    let nested = |open: &str, close: &str, n: usize| format!("{}x{}", open.repeat(n), close.repeat(n));
    let sum = " + 1".repeat(150);
    let texts = [
        format!("a --> {}", nested("split(x){ ~1 : ", " }", 100_000)),
        format!("a : {} --> nil", nested("(", ")", 100_000)),
        format!("a : {} --> nil", nested("not ", "", 100_000)),
        format!("a : {} --> nil", nested("-", "", 100_000)),
        format!("a : {} --> nil", nested("abs(", ")", 100_000)),
        format!("a : 1{} --> nil", " + 1".repeat(100_000)),
        format!("a --> {}", nested("split(x){ {", "}* }", 100_000)),
        // Long sums inside brackets inside long sums: deeper than either alone.
        format!("a : {}1{} --> nil", "(".repeat(150), format!("{sum})").repeat(150)),
    ];
    for text in texts {
        let start = Instant::now();
        if let Ok(checked) = parse(&text).and_then(check) {
            drop(checked.grammar().to_string());
        }
        assert!(start.elapsed() < SOON);
    }
}

#[test]
fn long_chains_of_rules_are_followed() {
    let rules = |count: usize, of: &dyn Fn(usize) -> String| (0..count).map(of).collect::<String>();
    let alias = rules(20_000, &|n| format!("r{n} --> r{}\n", n + 1)) + "r20000 --> I(stone)";
    let split = rules(5_000, &|n| format!("r{n} --> split(x){{ 1 : I(stone) | ~1 : r{} }}\n", n + 1))
        + "r5000 --> I(stone)";
    for (text, length) in [(alias, 1), (split, 6_000)] {
        let start = Instant::now();
        let limits = Limits::default();
        let options = Options { limits, ..options([length, 1, 1], 0) };
        assert!(!boxes(&graph(&text), &options).unwrap().is_empty());
        assert!(start.elapsed() < SOON, "took {:?}", start.elapsed());
    }
}
