//! The items of a file: directives, constants and rules.

use super::cursor::{Parse, Parser};
use crate::grammar::Diagnostic;
use crate::grammar::ast::*;
use crate::grammar::lex::{Kind, Place};
use crate::space::Up;

impl Parser<'_> {
    pub(super) fn item(&mut self, grammar: &mut Grammar, comments: Vec<String>) -> Parse<()> {
        self.depth = 0;
        if self.at() > 0 && self.peek().place == Place::Inner && !self.is_followed_by_definition() {
            return Err(self.left_over());
        }
        let second = self.peek_after(1);
        if self.is_word("up") && second.kind == Kind::Ident {
            return self.up(grammar);
        }
        if self.is_word("data_version") && second.kind == Kind::Number {
            return self.data_version(grammar);
        }
        if self.is_word("size") && matches!(second.kind, Kind::Symbol("(")) {
            grammar.sizes.push(self.start_size(comments)?);
            return Ok(());
        }
        let name = self.ident("a rule or a constant")?;
        if self.accept("=").is_some() {
            let value = self.argument()?;
            grammar.constants.push(Constant { comments, name, value });
        } else {
            grammar.rules.push(self.rule(name, comments)?);
        }
        Ok(())
    }

    pub(super) fn up(&mut self, grammar: &mut Grammar) -> Parse<()> {
        self.next();
        let axis = self.ident("an axis after `up`")?;
        grammar.up = match axis.name.as_str() {
            "y" => Up::Y,
            "z" => Up::Z,
            _ => {
                let error = Diagnostic::error(axis.span, "only y or z can be up");
                return Err(Box::new(error.hint("write `up z` or `up y`")));
            }
        };
        Ok(())
    }

    pub(super) fn data_version(&mut self, grammar: &mut Grammar) -> Parse<()> {
        self.next();
        let number = self.next();
        grammar.data_version = self.word(number).parse().ok();
        match grammar.data_version {
            Some(_) => Ok(()),
            None => {
                let error = Diagnostic::error(number.span, "this is no data version of the game");
                Err(Box::new(error.hint("it is a whole number, as in `data_version 3465` for 1.20.1")))
            }
        }
    }

    pub(super) fn start_size(&mut self, comments: Vec<String>) -> Parse<StartSize> {
        let keyword = self.next();
        self.expect("(", "after `size`")?;
        let size = self.three(|parser| parser.expr())?;
        let end = self.expect(")", "after the three lengths")?;
        let weight = self.weight()?;
        Ok(StartSize { comments, size, weight, span: keyword.span.to(end.span) })
    }

    pub(super) fn rule(&mut self, label: Ident, comments: Vec<String>) -> Parse<Rule> {
        let params = if self.accept("(").is_some() {
            self.list(")", |parser| parser.ident("the name of a parameter"))?
        } else {
            Vec::new()
        };
        let condition = if self.accept(":").is_some() { Some(self.expr()?) } else { None };
        if self.peek().kind != Kind::Arrow {
            let hint = match self.is_symbol("-") {
                true => "the arrow has two dashes: `-->`",
                false => "a rule reads `label --> operation`, a constant `name = value`",
            };
            return Err(self.unexpected_with(&format!("expected `-->` after `{}`", label.name), hint));
        }
        self.next();
        let successor = self.successor()?;
        let weight = self.weight()?;
        Ok(Rule { comments, label, params, condition, successor, weight })
    }

    pub(super) fn weight(&mut self) -> Parse<Option<Expr>> {
        if self.accept(":").is_some() { self.expr().map(Some) } else { Ok(None) }
    }
}
