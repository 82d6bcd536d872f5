//! The parser: recursive descent over tokens. An error ends its item; parsing goes on at the next one,
//! so that one run tells of every item that is wrong.

mod carving;
mod comments;
mod cursor;
mod expression;
mod item;
mod operation;
mod splitting;

use super::ast::Grammar;
use super::lex::{Kind, lex};
use super::{Code, Diagnostic, Span};
use comments::Comments;
use cursor::Parser;
use std::collections::BTreeSet;
use std::str::FromStr;

/// Parses a grammar file. Every error of the file is reported.
pub fn parse(text: &str) -> Result<Grammar, Vec<Diagnostic>> {
    let Parsed { grammar, errors, .. } = parse_items(text);
    if errors.is_empty() { Ok(grammar) } else { Err(errors) }
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

/// Parses all items of a file that can be parsed.
pub fn parse_items(text: &str) -> Parsed {
    let lexed = lex(text);
    let mut parser = Parser::new(text, &lexed.tokens);
    let mut grammar = Grammar::default();
    let mut errors = lexed.errors;
    let mut broken = BTreeSet::new();
    let mut comments = Comments { text, rest: &lexed.comments };
    grammar.preamble = comments.preamble();
    while parser.peek().kind != Kind::End {
        let start = parser.at();
        let above = comments.before(parser.peek().span.start);
        if let Err(error) = parser.item(&mut grammar, above) {
            broken.insert(parser.word_at(start).to_owned());
            // One error a place: what the lexer refused is not refused again for what is missing there.
            if !errors.iter().any(|known| known.span.start == error.span.start) {
                errors.push(*error);
            }
            parser.recover(start);
        }
        comments.skip_inside(parser.previous_end());
    }
    if grammar.rules.is_empty() && errors.is_empty() {
        let message = "a grammar needs a rule";
        let error = Diagnostic::new(Code::NoRules, Span::new(0, 0), message);
        errors.push(error.hint("for example `house --> I(stone)`"));
    }
    errors.sort_by_key(|error| error.span.start);
    Parsed { grammar, errors, broken }
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
