//! The parser's place among the tokens.

use crate::grammar::ast::{Ident, Rule};
use crate::grammar::lex::{Kind, Place, Token};
use crate::grammar::{Code, Diagnostic, Span};

pub struct Parser<'t> {
    pub(super) text: &'t str,
    tokens: &'t [Token],
    at: usize,
    /// How deep the operation or expression at hand is nested.
    pub(super) depth: usize,
    /// Brackets that are open.
    open: usize,
    /// That of the rules that follow.
    pub(super) priority: u32,
    /// Operators between two operands in the expression so far.
    pub(super) operators: usize,
}

pub type Parse<T> = Result<T, Box<Diagnostic>>;

impl<'t> Parser<'t> {
    /// At the first of `tokens`, which end with one of kind `End`.
    pub(super) fn new(text: &'t str, tokens: &'t [Token]) -> Parser<'t> {
        Parser { text, tokens, at: 0, depth: 0, open: 0, priority: Rule::FIRST, operators: 0 }
    }

    /// The number of the token at hand.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn word_at(&self, number: usize) -> &'t str {
        self.word(self.tokens[number])
    }

    pub(super) fn peek(&self) -> Token {
        self.tokens[self.at]
    }

    pub(super) fn peek_after(&self, count: usize) -> Token {
        self.tokens[(self.at + count).min(self.tokens.len() - 1)]
    }

    pub(super) fn word(&self, token: Token) -> &'t str {
        &self.text[token.span.range()]
    }

    pub(super) fn next(&mut self) -> Token {
        let token = self.peek();
        match token.kind {
            Kind::Symbol("(" | "[" | "{") => self.open += 1,
            Kind::Symbol(")" | "]" | "}") => self.open = self.open.saturating_sub(1),
            _ => {}
        }
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    pub(super) fn is_in_brackets(&self) -> bool {
        self.open > 0
    }

    /// At the start of an item, whatever the one before it left open.
    pub(super) fn start_item(&mut self) {
        (self.depth, self.open) = (0, 0);
    }

    pub(super) fn previous_end(&self) -> usize {
        self.tokens[self.at.saturating_sub(1)].span.end
    }

    pub(super) fn is_symbol(&self, symbol: &str) -> bool {
        matches!(self.peek().kind, Kind::Symbol(found) if found == symbol)
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        self.peek().kind == Kind::Ident && self.word(self.peek()) == word
    }

    pub(super) fn accept(&mut self, symbol: &str) -> Option<Token> {
        self.is_symbol(symbol).then(|| self.next())
    }

    pub(super) fn expect(&mut self, symbol: &str, why: &str) -> Parse<Token> {
        match self.accept(symbol) {
            Some(token) => Ok(token),
            None => Err(self.unexpected(&format!("expected `{symbol}` {why}"))),
        }
    }

    pub(super) fn ident(&mut self, what: &str) -> Parse<Ident> {
        let token = self.peek();
        if token.kind != Kind::Ident {
            return Err(self.unexpected(&format!("expected {what}")));
        }
        self.next();
        Ok(Ident { name: self.word(token).to_owned(), span: token.span })
    }

    /// A name that may carry the prefix of an import: `walls.brick`.
    pub(super) fn dotted(&mut self, what: &str) -> Parse<Ident> {
        let first = self.ident(what)?;
        let [dot, second] = [self.peek(), self.peek_after(1)];
        let is_joined = dot.kind == Kind::Symbol(".") && dot.span.start == first.span.end;
        if !is_joined || second.kind != Kind::Ident || second.span.start != dot.span.end {
            return Ok(first);
        }
        self.next();
        let second = self.ident(what)?;
        Ok(Ident { name: format!("{}.{}", first.name, second.name), span: first.span.to(second.span) })
    }

    /// What is missing at the end of a line is told there, not at the first word of the next.
    pub(super) fn unexpected(&self, expected: &str) -> Box<Diagnostic> {
        let token = self.peek();
        let (span, found) = match (token.kind, token.place) {
            (Kind::End, _) => (self.after_previous(), "the end of the file".to_owned()),
            (_, Place::Inner) => (token.span, format!("`{}`", self.word(token))),
            _ => (self.after_previous(), format!("`{}` on the next line", self.word(token))),
        };
        let message = format!("{expected}, found {found}");
        Box::new(Diagnostic::new(Code::Unexpected, span, message).label("here"))
    }

    /// As [`Parser::unexpected`], of a slip that has a code of its own, with what to write instead.
    pub(super) fn unexpected_with(&self, code: Code, expected: &str, hint: &str) -> Box<Diagnostic> {
        Box::new(Diagnostic { code, ..self.unexpected(expected).hint(hint) })
    }

    /// Refuses what would overflow the stack.
    pub(super) fn too_much(&self, message: &str) -> Box<Diagnostic> {
        let error = Diagnostic::new(Code::NestedTooDeeply, self.peek().span, message).label("from here on");
        Box::new(error.hint("give the inner parts rules or constants of their own"))
    }

    pub(super) fn after_previous(&self) -> Span {
        match self.at {
            0 => self.peek().span,
            _ => Span::new(self.previous_end(), self.previous_end()),
        }
    }

    /// Goes on to the next token that can start an item.
    pub(super) fn recover(&mut self, start: usize) {
        if self.at == start {
            self.next();
        }
        while self.peek().kind != Kind::End && !self.starts_item() {
            self.next();
        }
    }

    pub(super) fn is_followed_by_definition(&self) -> bool {
        matches!(self.peek_after(1).kind, Kind::Arrow | Kind::Symbol("="))
    }

    /// For what stands behind an item on its line.
    pub(super) fn left_over(&self) -> Box<Diagnostic> {
        let hint = match self.is_word("if") || self.is_word("when") {
            true => "a condition stands before the arrow: `label : condition --> operation`",
            false => "a rule ends with its line, unless one of its brackets is open",
        };
        self.unexpected_with(Code::LeftOver, "expected the next rule on a line of its own", hint)
    }

    pub(super) fn starts_item(&self) -> bool {
        let defines = self.is_followed_by_definition();
        match self.peek().place {
            _ if self.peek().kind != Kind::Ident => false,
            Place::FirstAtMargin => true,
            Place::FirstIndented => defines,
            Place::Inner => false,
        }
    }
}
