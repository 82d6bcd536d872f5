//! Names for new rules, and the names that they use.

use crate::grammar::ast::{Expr, ExprKind, Op, Rule, Successor, for_each_child_mut};
use crate::grammar::{Grammar, is_reserved};
use std::collections::{BTreeMap, BTreeSet};

/// The names that mean something in a grammar, in any of its files.
#[derive(Clone, Debug)]
pub struct Taken(BTreeSet<String>);

impl Taken {
    pub fn by(grammar: &Grammar) -> Taken {
        let rules = grammar.rules.iter().flat_map(|rule| std::iter::once(&rule.label).chain(&rule.params));
        let styles = grammar.styles.iter().map(|style| &style.name);
        let constants = grammar.constants.iter().map(|constant| &constant.name);
        let names = rules.chain(styles).chain(constants);
        // A file calls its own by the last word.
        Taken(names.flat_map(|name| name.name.split('.')).map(str::to_owned).collect())
    }

    /// The name, or that name with the first number that is free.
    fn free(&mut self, name: &str) -> String {
        let is_free = |name: &String| !self.0.contains(name) && !is_reserved(name);
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let free = std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default();
        self.0.insert(free.clone());
        free
    }
}

/// An operation and the rules that it calls, under names that are free. Blocks that a constant or a parameter would
/// hide are named whole.
pub fn renamed(mut successor: Successor, mut rules: Vec<Rule>, taken: &mut Taken) -> (Successor, Vec<Rule>) {
    let hiding = taken.clone();
    let mut names: BTreeMap<String, String> = BTreeMap::new();
    for rule in &rules {
        if !names.contains_key(&rule.label.name) {
            names.insert(rule.label.name.clone(), taken.free(&rule.label.name));
        }
    }
    for rule in &mut rules {
        if let Some(name) = names.get(&rule.label.name) {
            rule.label.name.clone_from(name);
        }
        rename(&mut rule.successor, &names, &hiding);
    }
    rename(&mut successor, &names, &hiding);
    (successor, rules)
}

fn rename(successor: &mut Successor, names: &BTreeMap<String, String>, hiding: &Taken) {
    match &mut successor.op {
        Op::Call { label, .. } => {
            if let Some(name) = names.get(&label.name) {
                label.name.clone_from(name);
            }
        }
        Op::Primitive { name, material, .. } => {
            whole(name, hiding);
            material.iter_mut().for_each(|material| whole(material, hiding));
        }
        _ => {}
    }
    for_each_child_mut(&mut successor.op, &mut |child| rename(child, names, hiding));
}

/// Names a block with its namespace, where its bare name means something else.
fn whole(expr: &mut Expr, hiding: &Taken) {
    let (ExprKind::Name(text) | ExprKind::Block(text)) = &expr.kind else { return };
    let bare = text.split('[').next().unwrap_or(text);
    if hiding.0.contains(bare) {
        expr.kind = ExprKind::Block(format!("minecraft:{text}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn new_rules_get_names_that_mean_nothing_yet() {
        let grammar: Grammar =
            "stone = oak_planks\nwall(b) --> I(b)\nwall_2 --> wall(stone)".parse().unwrap();
        let learnt: Grammar =
            "wall --> split(x){ 1 : b | ~1 : I(stone) }\nb --> I(stone_stairs)".parse().unwrap();
        let calls = learnt.rules[0].successor.clone();
        let (successor, rules) = renamed(calls, learnt.rules, &mut Taken::by(&grammar));
        assert_eq!(successor.to_string(), "split(x){ 1 : b_2 | ~1 : I(minecraft:stone) }");
        let texts: Vec<String> = rules.iter().map(Rule::to_string).collect();
        assert_eq!(texts, [format!("wall_3 --> {successor}"), "b_2 --> I(stone_stairs)".to_owned()]);
    }
}
