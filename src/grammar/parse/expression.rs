//! Expressions, by precedence climbing.

use super::cursor::{Parse, Parser};
use super::{MAX_DEPTH, MAX_OPERATORS};
use crate::grammar::ast::*;
use crate::grammar::lex::{Kind, Place, Token};
use crate::grammar::{Code, Diagnostic, Span};
use crate::space::Axis;

impl Parser<'_> {
    /// An expression where a block with a namespace may stand as well.
    pub(super) fn argument(&mut self) -> Parse<Expr> {
        self.operators = 0;
        self.inner_argument()
    }

    /// As [`Parser::argument`], as part of an expression.
    fn inner_argument(&mut self) -> Parse<Expr> {
        let name = self.peek();
        match name.kind != Kind::Text && has_namespace(&self.text[name.span.start..]) {
            true => self.block(name),
            false => self.inner_expr(),
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
            let message = "the properties of this block are not closed by `]`";
            let error = Diagnostic::new(Code::OpenProperties, first.span, message);
            return Err(Box::new(error));
        };
        let span = Span::new(first.span.start, first.span.start + end);
        if rest[..end].contains('#') || rest[..end].contains("//") {
            let error = Diagnostic::new(
                Code::OpenProperties,
                span,
                "a comment cannot stand among the properties of a block",
            );
            return Err(Box::new(error.label("here").hint("write it behind the block")));
        }
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
            let message = "this number is too large";
            return Err(Box::new(Diagnostic::new(Code::NumberTooLarge, token.span, message)));
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
        if matches!(name, "scope" | "split") && after.kind == Kind::Symbol(".") {
            self.next();
            self.next();
            return if name == "scope" { self.scope_size(token.span) } else { self.share(token.span) };
        }
        let braced = after.kind == Kind::Symbol("{");
        let bracketed = after.kind == Kind::Symbol("(");
        let kind = match name {
            "pick" if braced => ExprKind::Pick(self.weighted()?),
            "mix" if braced => ExprKind::Mix(self.weighted()?),
            "gradient" if bracketed => self.gradient()?,
            "same" if bracketed => self.same()?,
            "occ" if bracketed => self.occlusion()?,
            "visible" if bracketed => self.visible()?,
            _ => return self.plain_name(),
        };
        Ok(Expr { kind, span: token.span.to(Span::new(0, self.previous_end())) })
    }

    /// A name, or a function with its arguments.
    fn plain_name(&mut self) -> Parse<Expr> {
        let ident = self.dotted("a name")?;
        let name = ident.name.as_str();
        // Only `rand` is a function without brackets; the others may be names: `floor = 4`.
        let is_called = name == Function::Rand.name() || self.is_symbol("(");
        let Some(function) = Function::of_name(name).filter(|_| is_called) else {
            return Ok(Expr { kind: ExprKind::Name(ident.name), span: ident.span });
        };
        let args = match self.accept("(") {
            Some(_) => self.list(")", |parser| parser.inner_expr())?,
            None => Vec::new(),
        };
        let span = ident.span.to(Span::new(0, self.previous_end()));
        function.takes(args.len()).map_err(|expected| {
            let plural = if args.len() == 1 { "" } else { "s" };
            let message = format!("`{name}` cannot take {} argument{plural}", args.len());
            let error = Diagnostic::new(Code::FunctionArguments, span, message);
            Box::new(error.hint(format!("it takes {expected}")))
        })?;
        Ok(Expr { kind: ExprKind::Call(function, args), span })
    }

    /// `pick{ weight : value | ... }` and `mix{ ... }`, from their first word.
    fn weighted(&mut self) -> Parse<Vec<(Expr, Expr)>> {
        self.next();
        self.expect("{", "before the values")?;
        let mut parts = Vec::new();
        loop {
            let weight = self.inner_expr()?;
            self.expect(":", "between a weight and its value, as in `mix{ 3 : stone | 1 : andesite }`")?;
            parts.push((weight, self.inner_argument()?));
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a value")?;
                return Ok(parts);
            }
        }
    }

    fn gradient(&mut self) -> Parse<ExprKind> {
        self.next();
        self.expect("(", "and an axis")?;
        let axis = self.inner_expr()?;
        self.expect(")", "after the axis")?;
        self.expect("{", "before the blocks, as in `gradient(y){ stone | andesite }`")?;
        let mut blocks = vec![self.inner_argument()?];
        while self.accept("|").is_some() {
            blocks.push(self.inner_argument()?);
        }
        self.expect("}", "or `|` after a block")?;
        Ok(ExprKind::Gradient(Box::new(axis), blocks))
    }

    fn same(&mut self) -> Parse<ExprKind> {
        self.next();
        self.expect("(", "and a key")?;
        let key = self.inner_argument()?;
        self.expect(",", "between the key and the value, as in `same(trim, rand(1, 3))`")?;
        let value = self.inner_argument()?;
        self.expect(")", "after the value")?;
        Ok(ExprKind::Same(Box::new(key), Box::new(value)))
    }

    fn occlusion(&mut self) -> Parse<ExprKind> {
        self.next();
        self.expect("(", "and what to look at")?;
        let against = self.dotted("`all`, `active`, `noparent` or a label")?;
        let distance = self.accept(",").map(|_| self.inner_expr()).transpose()?.map(Box::new);
        self.expect(")", "after the query, as in `occ(noparent, 2)`")?;
        Ok(ExprKind::Occlusion { against: Against::of_name(&against.name), distance })
    }

    fn visible(&mut self) -> Parse<ExprKind> {
        self.next();
        self.expect("(", "and a label")?;
        let label = self.dotted("the label of the shapes to be seen")?;
        self.expect(")", "after the label")?;
        Ok(ExprKind::Visible(label.name))
    }

    fn share(&mut self, start: Span) -> Parse<Expr> {
        let field = self.ident("`index` or `total` after `split.`")?;
        let share = match field.name.as_str() {
            "index" => Share::Index,
            "total" => Share::Total,
            _ => {
                let message = format!("a split has no `{}`", field.name);
                let error = Diagnostic::new(Code::UnknownField, field.span, message);
                return Err(Box::new(error.hint("it has split.index, from 0, and split.total")));
            }
        };
        Ok(Expr { kind: ExprKind::Share(share), span: start.to(field.span) })
    }

    pub(super) fn scope_size(&mut self, start: Span) -> Parse<Expr> {
        let field = self.ident("`sx`, `sy` or `sz` after `scope.`")?;
        let axis = match field.name.as_str() {
            "sx" => Axis::X,
            "sy" => Axis::Y,
            "sz" => Axis::Z,
            _ => {
                let message = format!("a scope has no `{}`", field.name);
                let error = Diagnostic::new(Code::UnknownField, field.span, message);
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
