//! Rules that cannot fill a size are kept from it.

use super::change::Change;
use super::condition::{holds, is};
use super::texts::{Edit, Program, Texts};
use super::trial::always_fails;
use crate::grammar::Span;
use crate::grammar::ast::Rule;
use crate::parse::{Laws, Parser};
use crate::run::Library;
use crate::space::{Axis, Cell};

/// Keeps the rules that a grammar starts with from a size that it does not say and at which every run fails: a further
/// alternative for that size would else stand beside some that end in an error.
pub fn bound(
    texts: &Texts,
    program: &Program,
    size: Cell,
    library: &Library,
) -> Option<(Texts, Vec<Change>)> {
    let is_said = Parser::new(&program.graph, Laws::AsWritten).starts(size);
    if is_said || !always_fails(program, size, library) {
        return None;
    }
    let label = program.checked.first_label();
    let applies = |rule: &&Rule| {
        let condition = rule.condition.as_ref();
        condition.and_then(|condition| holds(condition, size.to_array())) != Some(false)
    };
    let rules = program.checked.rules_of(label).filter(applies);
    let edits: Vec<Edit> = rules.map(|rule| other_sizes(program, rule, size)).collect();
    if edits.is_empty() {
        return None;
    }
    let change = Change::Bound { label: label.to_owned(), size: size.to_array() };
    Some((texts.edited(&edits), vec![change]))
}

/// The edit that binds a rule to other sizes.
fn other_sizes(program: &Program, rule: &Rule, size: Cell) -> Edit {
    let other = format!("not ({})", is(&Axis::ALL, size.to_array()));
    match &rule.condition {
        None => {
            let end = rule.label.span.end;
            program.edit(Span::new(end, end), format!(" : {other}"))
        }
        Some(condition) => {
            let words = program.words(condition.span);
            program.edit(condition.span, format!("({words}) and {other}"))
        }
    }
}
