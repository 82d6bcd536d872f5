//! The parser: recursive descent over tokens. An error ends its item; parsing goes on at the next one,
//! so that one run tells of every item that is wrong.

mod carving;
mod comments;
mod cursor;
mod expression;
mod item;
mod operation;
mod splitting;

use super::ast::{Expr, Grammar};
use super::lex::{Kind, lex};
use super::{Code, Diagnostic, Span};
use comments::{Comments, counts};
use cursor::Parser;
use std::collections::BTreeSet;
use std::str::FromStr;

/// Parses a grammar file. Every error of the file is reported.
pub fn parse(text: &str) -> Result<Grammar, Vec<Diagnostic>> {
    let Parsed { grammar, mut errors, .. } = parse_items_at(text, 0);
    if grammar.rules.is_empty() && errors.is_empty() {
        errors.push(no_rule());
    }
    if errors.is_empty() { Ok(grammar) } else { Err(errors) }
}

/// For a grammar that derives nothing.
pub fn no_rule() -> Diagnostic {
    Diagnostic::new(Code::NoRules, Span::new(0, 0), "a grammar needs a rule")
        .hint("for example `house --> I(stone)`")
}

/// What could be read of a file.
pub struct Parsed {
    /// The items without errors.
    pub grammar: Grammar,
    /// In the order of their places.
    pub errors: Vec<Diagnostic>,
    /// The first word of each item with an error: the label or constant that it would define.
    pub broken: BTreeSet<String>,
}

/// Parses all items of the file that `text` holds from `start` on.
pub fn parse_items_at(text: &str, start: usize) -> Parsed {
    let lexed = lex(text, start);
    let mut parser = Parser::new(text, &lexed.tokens);
    let mut grammar = Grammar::default();
    let mut errors = lexed.errors;
    let mut broken = BTreeSet::new();
    let mut comments = Comments::new(text, &lexed.comments);
    grammar.preamble = comments.preamble(start);
    while parser.peek().kind != Kind::End {
        let start = parser.at();
        let above = comments.above(parser.peek().span.start);
        let before = counts(&grammar);
        if let Err(error) = parser.item(&mut grammar, above.clone()) {
            broken.insert(parser.word_at(start).to_owned());
            // One error a place: what the lexer refused is not refused again for what is missing there.
            if !errors.iter().any(|known| known.span.start == error.span.start) {
                errors.push(*error);
            }
            parser.recover(start);
        }
        comments.inside(&mut grammar, before, above, parser.previous_end());
    }
    grammar.epilogue = comments.above(usize::MAX);
    errors.sort_by_key(|error| error.span.start);
    Parsed { grammar, errors, broken }
}

/// Parses a text that is one value, as that of a constant.
pub fn parse_value(text: &str) -> Result<Expr, Box<Diagnostic>> {
    let lexed = lex(text, 0);
    if let Some(error) = lexed.errors.into_iter().next() {
        return Err(Box::new(error));
    }
    let mut parser = Parser::new(text, &lexed.tokens);
    let value = parser.argument()?;
    match parser.peek().kind {
        Kind::End => Ok(value),
        _ => Err(parser.unexpected("expected nothing behind the value")),
    }
}

impl FromStr for Grammar {
    type Err = Vec<Diagnostic>;

    fn from_str(text: &str) -> Result<Grammar, Vec<Diagnostic>> {
        parse(text)
    }
}

/// Operations and brackets nested deeper than this are refused, so that no text overflows the stack.
const MAX_DEPTH: usize = 200;

/// Expressions with more operators than this are refused: each may lie below the one before it in the tree,
/// and the sums in nested brackets add up.
const MAX_OPERATORS: usize = 200;
