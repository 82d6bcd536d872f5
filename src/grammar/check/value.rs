//! Values that do not stand in a grammar's text.

use super::expressions::constant_type;
use super::{Checker, Expected};
use crate::grammar::ast::*;
use crate::grammar::parse::parse_value;
use crate::grammar::{Diagnostic, Grammar};
use std::collections::{BTreeMap, BTreeSet};

/// Parses and checks another value for the constant of that place. It has to be of the type that the constant shows,
/// and may use the constants above it. The places of findings are those in `text`.
pub fn value(text: &str, constants: &[Constant], at: usize) -> Result<Expr, Vec<Diagnostic>> {
    let expr = parse_value(text).map_err(|error| vec![*error])?;
    let expected = constants.get(at).map_or(Expected::Any, |constant| constant_type(&constant.value));
    let grammar = Grammar { constants: constants.to_vec(), ..Grammar::default() };
    let broken = BTreeSet::new();
    let mut checker =
        Checker { grammar: &grammar, rules: BTreeMap::new(), broken: &broken, found: Vec::new() };
    checker.constant_value(&expr, at);
    if checker.found.is_empty() {
        checker.expr(&expr, &[], expected);
    }
    let found = checker.found;
    match found.iter().any(Diagnostic::is_error) {
        true => Err(found),
        false => Ok(expr),
    }
}
