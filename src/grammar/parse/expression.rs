//! Expressions, by precedence climbing.

use super::cursor::{Parse, Parser};
use super::{MAX_DEPTH, MAX_OPERATORS};
use crate::grammar::ast::*;
use crate::grammar::lex::{Kind, Place, Token};
use crate::grammar::{Diagnostic, Span};
use crate::space::Axis;

impl Parser<'_> {
    /// An expression where a block with a namespace may stand as well.
    pub(super) fn argument(&mut self) -> Parse<Expr> {
        let name = self.peek();
        match name.kind != Kind::Text && has_namespace(&self.text[name.span.start..]) {
            true => self.block(name),
            false => self.expr(),
        }
    }

    /// A block state from its first token: a name, its namespace, path and properties, without gaps.
    pub(super) fn block(&mut self, first: Token) -> Parse<Expr> {
        let rest = &self.text[first.span.start..];
        let name_end =
            rest.find(|c: char| !(c.is_ascii_alphanumeric() || "_:/.-".contains(c))).unwrap_or(rest.len());
        let end = match rest[name_end..].starts_with('[') {
            true => rest.find(']').map(|end| end + 1),
            false => Some(name_end),
        };
        let Some(end) = end else {
            let error = Diagnostic::error(first.span, "the properties of this block are not closed by `]`");
            return Err(Box::new(error));
        };
        let span = Span::new(first.span.start, first.span.start + end);
        while self.peek().kind != Kind::End && self.peek().span.start < span.end {
            self.next();
        }
        let text: String = self.text[span.range()].chars().filter(|c| !c.is_whitespace()).collect();
        Ok(Expr { kind: ExprKind::Block(text), span })
    }

    pub(super) fn expr(&mut self) -> Parse<Expr> {
        self.operators = 0;
        self.inner_expr()
    }

    /// An expression that is part of another.
    pub(super) fn inner_expr(&mut self) -> Parse<Expr> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("an expression is nested too deeply"));
        }
        let expr = self.binary(0);
        self.depth -= 1;
        expr
    }

    /// Operators that bind at least as tightly as `least`, by precedence climbing.
    pub(super) fn binary(&mut self, least: u8) -> Parse<Expr> {
        let mut left = self.unary()?;
        while let Some(op) = self.binary_op().filter(|op| op.binding() >= least) {
            self.operators += 1;
            if self.operators > MAX_OPERATORS {
                return Err(self.too_much("an expression has too many operators"));
            }
            self.next();
            let right = self.binary(op.binding() + 1)?;
            let span = left.span.to(right.span);
            left = Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), span };
        }
        Ok(left)
    }

    pub(super) fn binary_op(&self) -> Option<BinaryOp> {
        let token = self.peek();
        // A new line that starts with a name is the next item, never the rest of an expression.
        let text = match token.kind {
            Kind::Symbol(symbol) => symbol,
            Kind::Ident if token.place == Place::Inner => self.word(token),
            _ => return None,
        };
        BinaryOp::ALL.into_iter().find(|op| op.symbol() == text)
    }

    pub(super) fn unary(&mut self) -> Parse<Expr> {
        let start = self.peek().span;
        let (op, binding) = if self.accept("-").is_some() {
            (UnaryOp::Negate, 6)
        } else if self.is_word("not") {
            self.next();
            (UnaryOp::Not, 2)
        } else {
            return self.primary();
        };
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("an expression is nested too deeply"));
        }
        let operand = self.binary(binding)?;
        self.depth -= 1;
        let span = start.to(operand.span);
        Ok(Expr { kind: ExprKind::Unary(op, Box::new(operand)), span })
    }

    pub(super) fn primary(&mut self) -> Parse<Expr> {
        let token = self.peek();
        match token.kind {
            Kind::Number => self.number(),
            Kind::Text => {
                self.next();
                let name = self.word(token).trim_matches('"').to_owned();
                Ok(Expr { kind: ExprKind::File(name), span: token.span })
            }
            Kind::Symbol("(") => {
                self.next();
                let inner = self.inner_expr()?;
                let close = self.expect(")", "to close the bracket")?;
                Ok(Expr { span: token.span.to(close.span), ..inner })
            }
            Kind::Ident => self.named(),
            _ => Err(self.unexpected("expected a number, a name or an expression")),
        }
    }

    pub(super) fn number(&mut self) -> Parse<Expr> {
        let token = self.next();
        let value = self.word(token).parse().unwrap_or(f64::INFINITY);
        if !f64::is_finite(value) {
            return Err(Box::new(Diagnostic::error(token.span, "this number is too large")));
        }
        Ok(Expr { kind: ExprKind::Number(value), span: token.span })
    }

    pub(super) fn named(&mut self) -> Parse<Expr> {
        let token = self.peek();
        let name = self.word(token);
        let after = self.peek_after(1);
        if after.kind == Kind::Symbol("[") && after.span.start == token.span.end {
            return self.block(token);
        }
        self.next();
        if name == "scope" && self.accept(".").is_some() {
            return self.scope_size(token.span);
        }
        // Only `rand` is a function without brackets; the others may be names: `floor = 4`.
        let is_called = name == Function::Rand.name() || self.is_symbol("(");
        let Some(function) = Function::of_name(name).filter(|_| is_called) else {
            return Ok(Expr { kind: ExprKind::Name(name.to_owned()), span: token.span });
        };
        let args = match self.accept("(") {
            Some(_) => self.list(")", |parser| parser.inner_expr())?,
            None => Vec::new(),
        };
        let span = token.span.to(Span::new(0, self.previous_end()));
        function.takes(args.len()).map_err(|expected| {
            let plural = if args.len() == 1 { "" } else { "s" };
            let message = format!("`{name}` cannot take {} argument{plural}", args.len());
            Box::new(Diagnostic::error(span, message).hint(format!("it takes {expected}")))
        })?;
        Ok(Expr { kind: ExprKind::Call(function, args), span })
    }

    pub(super) fn scope_size(&mut self, start: Span) -> Parse<Expr> {
        let field = self.ident("`sx`, `sy` or `sz` after `scope.`")?;
        let axis = match field.name.as_str() {
            "sx" => Axis::X,
            "sy" => Axis::Y,
            "sz" => Axis::Z,
            _ => {
                let error = Diagnostic::error(field.span, format!("a scope has no `{}`", field.name));
                return Err(Box::new(error.hint("it has scope.sx, scope.sy and scope.sz: its lengths")));
            }
        };
        Ok(Expr { kind: ExprKind::ScopeSize(axis), span: start.to(field.span) })
    }
}
/// Whether a text begins with a name in a namespace, as in `create:brass_casing`.
fn has_namespace(text: &str) -> bool {
    let rest = text.trim_start_matches(is_block_char);
    rest.strip_prefix(':').is_some_and(|path| path.starts_with(is_block_char))
}

fn is_block_char(c: char) -> bool {
    c.is_ascii_alphanumeric() || "_/.-".contains(c)
}
