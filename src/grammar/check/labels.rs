//! How labels lead to one another.

use super::Checker;
use crate::grammar::Code;
use crate::grammar::ast::*;
use std::collections::BTreeSet;

impl<'g> Checker<'g> {
    /// Labels whose only rule is another label, and so on in a ring, never do anything.
    pub(super) fn aliases(&mut self) {
        let labels: Vec<&str> = self.rules.keys().copied().collect();
        let mut known: BTreeSet<&str> = BTreeSet::new();
        for start in labels {
            let mut chain = Vec::new();
            let mut next = Some(start);
            while let Some(label) = next.filter(|label| known.insert(label)) {
                chain.push(label);
                next = self.alias(label);
            }
            let ring = chain.iter().position(|label| Some(*label) == next);
            ring.into_iter().for_each(|first| self.ring(&chain[first..]));
        }
    }

    fn ring(&mut self, labels: &[&'g str]) {
        for label in labels {
            let message = format!("`{label}` only leads back to itself");
            let hint = "give one of the rules in the ring an operation".to_owned();
            self.tell(Code::NamesInARing, self.rules[label][0].label.span, message, "never ends", hint);
        }
    }

    /// The label that a label is only another name of.
    pub(super) fn alias(&self, label: &str) -> Option<&'g str> {
        match self.rules.get(label)?.as_slice() {
            [Rule { successor: Successor { op: Op::Call { label, args }, .. }, .. }] if args.is_empty() => {
                Some(&label.name)
            }
            _ => None,
        }
    }

    pub(super) fn unreachable(&mut self) {
        let Some(first) = self.grammar.rules.first() else { return };
        if !first.params.is_empty() {
            let message = format!("the first rule, `{}`, takes parameters", first.label.name);
            let hint = "put a rule without parameters first, or start from one with `--start`".to_owned();
            let label = "nothing can start from it";
            self.tell(Code::StartTakesParameters, first.label.span, message, label, hint);
        }
        let mut reached = BTreeSet::from([first.label.name.as_str()]);
        let mut open = vec![first.label.name.as_str()];
        while let Some(label) = open.pop() {
            for rule in self.rules.get(label).into_iter().flatten() {
                for_each_call(&rule.successor, &mut |called| {
                    if reached.insert(called) {
                        open.push(called);
                    }
                });
            }
        }
        let mut told = BTreeSet::new();
        for rule in &self.grammar.rules {
            let label = rule.label.name.as_str();
            if !reached.contains(label) && !self.grammar.imported.contains(label) && told.insert(label) {
                let message = format!("`{label}` cannot be reached from `{}`", first.label.name);
                let hint = "call it, delete it, or start from it with `--start`".to_owned();
                self.tell(Code::Unreachable, rule.label.span, message, "never runs", hint);
            }
        }
    }
}
