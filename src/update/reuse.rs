//! What a grammar has rules for already is not written out again.

use crate::grammar::ast::{Op, Rule, Successor, for_each_child_mut};
use std::collections::BTreeMap;

/// The labels that always stand for one operation, by its text.
#[derive(Clone, Debug, Default)]
pub struct Known(BTreeMap<String, String>);

impl Known {
    /// Those of some rules, which are without comments, as far as they may be called.
    pub fn of(rules: &[Rule], may_be_called: impl Fn(&Rule) -> bool) -> Known {
        let mut by_text: BTreeMap<String, Vec<&str>> = BTreeMap::new();
        for rule in rules.iter().filter(|rule| is_plain(rule, rules) && may_be_called(rule)) {
            by_text.entry(rule.successor.to_string()).or_default().push(&rule.label.name);
        }
        let only = by_text.into_iter().filter_map(|(text, labels)| match labels.as_slice() {
            [only] => Some((text, (*only).to_owned())),
            _ => None,
        });
        Known(only.collect())
    }
}

fn is_plain(rule: &Rule, rules: &[Rule]) -> bool {
    let is_alone = rules.iter().filter(|other| other.label == rule.label).count() == 1;
    let is_short = matches!(rule.successor.op, Op::Nil | Op::Call { .. });
    is_alone
        && !is_short
        && rule.params.is_empty()
        && rule.condition.is_none()
        && rule.priority == Rule::FIRST
}

/// An operation and the rules that it calls, with calls of what is known instead of what is the same.
pub fn reused(mut successor: Successor, rules: Vec<Rule>, known: &Known) -> (Successor, Vec<Rule>) {
    let mut same: BTreeMap<String, String> = BTreeMap::new();
    let mut kept = Vec::new();
    for mut rule in rules.into_iter().rev() {
        call_known(&mut rule.successor, known, &same);
        match (&rule.successor.op, known.0.get(&rule.successor.to_string())) {
            (Op::Call { label, args }, _) if args.is_empty() => {
                same.insert(rule.label.name, label.name.clone());
            }
            (_, Some(label)) => {
                same.insert(rule.label.name, label.clone());
            }
            (_, None) => kept.push(rule),
        }
    }
    kept.reverse();
    // One may be called before it is known to be none of its own.
    kept.iter_mut().for_each(|rule| call_known(&mut rule.successor, known, &same));
    call_known(&mut successor, known, &same);
    (successor, kept)
}

/// Innermost first, so that what calls known labels is known as well.
fn call_known(successor: &mut Successor, known: &Known, same: &BTreeMap<String, String>) {
    if let Op::Call { label, .. } = &mut successor.op
        && let Some(name) = same.get(&label.name)
    {
        label.name.clone_from(name);
    }
    for_each_child_mut(&mut successor.op, &mut |child| call_known(child, known, same));
    if let Some(label) = known.0.get(&successor.to_string()) {
        successor.op = Op::Call { label: crate::grammar::ast::Ident::new(label), args: Vec::new() };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::Grammar;

    #[test]
    fn what_has_a_rule_is_called() {
        let grammar: Grammar = "house --> window
             window --> split(y){ 1 : planks | ~1 : I(glass) }
             planks --> I(oak_planks)
             air --> nil
             door --> I(stone) : 2
             door --> I(bricks)"
            .parse()
            .unwrap();
        let learnt: Grammar = "a --> split(x){ 1 : nil | 1 : b | 1 : I(stone) }
             b --> split(y){ 1 : I(oak_planks) | ~1 : I(glass) }"
            .parse()
            .unwrap();
        let [a, b] = [0, 1].map(|at: usize| learnt.rules[at].clone());
        let known = Known::of(&grammar.rules, |_| true);
        let (successor, rules) = reused(a.successor.clone(), vec![b.clone()], &known);
        assert_eq!(successor.to_string(), "split(x){ 1 : nil | 1 : window | 1 : I(stone) }");
        assert_eq!(rules, []);
        let known = Known::of(&grammar.rules, |rule| rule.label.name != "window");
        let (successor, rules) = reused(a.successor.clone(), vec![b], &known);
        assert_eq!(successor, a.successor);
        assert_eq!(rules[0].to_string(), "b --> split(y){ 1 : planks | ~1 : I(glass) }");
    }
}
