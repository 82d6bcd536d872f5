//! Operations, sizes and lists.

use super::MAX_DEPTH;
use super::cursor::{Parse, Parser};
use crate::grammar::ast::*;
use crate::grammar::lex::{Kind, Place};
use crate::grammar::names::{OPERATIONS, closest};
use crate::grammar::{Code, Diagnostic, Span};

impl Parser<'_> {
    /// One operation, or several side by side that share a scope.
    pub(super) fn successor(&mut self) -> Parse<Successor> {
        self.nested(|parser| {
            let first = parser.single()?;
            if !parser.goes_on() {
                return Ok(first);
            }
            let start = first.span;
            let mut ops = vec![first];
            while parser.goes_on() {
                ops.push(parser.single()?);
            }
            Ok(Successor::at(Op::All(ops), start.to(Span::new(0, parser.previous_end()))))
        })
    }

    fn nested(&mut self, parse: impl FnOnce(&mut Self) -> Parse<Successor>) -> Parse<Successor> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("operations are nested too deeply"));
        }
        let successor = parse(self)?;
        self.depth -= 1;
        Ok(successor)
    }

    /// Whether another operation follows in the same scope: on the same line, or inside open brackets.
    fn goes_on(&self) -> bool {
        let token = self.peek();
        let is_op = token.kind == Kind::Ident || self.is_symbol("[");
        let is_inside = token.place == Place::Inner || self.is_in_brackets();
        let is_slip = self.is_word("if") || self.is_word("when");
        is_op && is_inside && !is_slip && !(self.starts_item() && self.is_followed_by_definition())
    }

    fn single(&mut self) -> Parse<Successor> {
        let start = self.peek().span;
        if self.accept("[").is_some() {
            let inner = self.successor()?;
            let close = self.expect("]", "after the operations in brackets")?;
            return Ok(Successor { span: start.to(close.span), ..inner });
        }
        let op = self.op()?;
        Ok(Successor::at(op, start.to(Span::new(0, self.previous_end()))))
    }

    fn op(&mut self) -> Parse<Op> {
        if self.starts_item() && self.is_followed_by_definition() {
            return Err(self.unexpected("expected an operation or a label"));
        }
        let label = self.dotted("an operation or a label")?;
        match label.name.as_str() {
            "nil" => Ok(Op::Nil),
            "I" => self.primitive(),
            "split" => self.split(),
            "repeat" => self.repeat(),
            "repeatN" => self.repeat_n(),
            "snap" => self.snap_mark(),
            "comp" => self.component(),
            "T" => {
                let delta = self.sizes()?;
                self.within(Change::Translate(delta))
            }
            "S" => {
                let size = self.sizes()?;
                self.within(Change::Resize(size))
            }
            "R" => {
                let change = self.rotation()?;
                self.within(change)
            }
            "local" if self.is_symbol("{") => self.within(Change::Local),
            "same" if self.is_symbol("(") => {
                self.next();
                let key = self.argument()?;
                self.expect(")", "after the key")?;
                self.within(Change::Same(key))
            }
            "style" if self.is_symbol("(") => {
                self.next();
                let name = self.dotted("the name of a style")?;
                self.expect(")", "after the name of the style")?;
                self.within(Change::Style(name))
            }
            word => match Carving::NAMES.iter().find(|(head, _)| head.strip_suffix('(') == Some(word)) {
                Some((_, how)) => self.carve(*how),
                None => self.call(label),
            },
        }
    }

    fn call(&mut self, label: Ident) -> Parse<Op> {
        let args = match self.accept("(") {
            Some(_) => self.list(")", |parser| parser.argument())?,
            None => Vec::new(),
        };
        match self.is_symbol("{") {
            true => Err(no_operation(&label)),
            false => Ok(Op::Call { label, args }),
        }
    }

    /// What a change of scope acts on: the operations in its braces, else all that follow it.
    fn within(&mut self, change: Change) -> Parse<Op> {
        let body = match self.is_symbol("{") {
            true => self.body()?,
            false if self.goes_on() => Box::new(self.successor()?),
            false => {
                let expected = "expected `{`, or an operation for the changed scope";
                let hint = "as in `T(0, 4, 0){ roof }`, or with what is changed behind it: `T(0, 4, 0) roof`";
                return Err(self.unexpected_with(Code::Unexpected, expected, hint));
            }
        };
        Ok(Op::Within { change, body })
    }

    fn primitive(&mut self) -> Parse<Op> {
        self.expect("(", "after `I`: it names a primitive, as in `I(stone)`")?;
        let name = self.argument()?;
        let (mut material, mut options) = (None, Vec::new());
        while self.accept(",").is_some() {
            let is_option = self.peek().kind == Kind::Ident && self.peek_after(1).kind == Kind::Symbol("=");
            if is_option {
                let option = self.ident("an option")?;
                self.next();
                options.push((option, self.argument()?));
            } else if material.is_none() && options.is_empty() {
                material = Some(self.argument()?);
            } else {
                return Err(self.unexpected("expected an option, as in `pitch = 1`"));
            }
        }
        if self.is_symbol("{") {
            let hint = "blocks to choose from read `mix{ 3 : stone | 1 : dirt }`, `pick{ 1 : oak | 1 : birch }` or \
                        `gradient(y){ stone | dirt }`";
            return Err(self.unexpected_with(Code::Unexpected, "expected `)` after the primitive", hint));
        }
        self.expect(")", "after the primitive")?;
        Ok(Op::Primitive { name, material, options })
    }

    fn rotation(&mut self) -> Parse<Change> {
        self.expect("(", "after `R`: it names an axis and an angle, as in `R(y, pi/2){ roof }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the angle")?;
        let angle = self.expr()?;
        self.expect(")", "after the angle")?;
        Ok(Change::Rotate { axis, angle })
    }

    fn snap_mark(&mut self) -> Parse<Op> {
        self.expect("(", "after `snap`: it names an axis, as in `snap(y)` or `snap(x, entrance)`")?;
        let axis = self.expr()?;
        let label = self.accept(",").map(|_| self.ident("the label of the planes")).transpose()?;
        self.expect(")", "after the axis")?;
        Ok(Op::Snap { axis, label })
    }

    fn sizes(&mut self) -> Parse<[Size; 3]> {
        self.expect("(", "and three lengths")?;
        let sizes = self.three(|parser| parser.size())?;
        self.expect(")", "after the three lengths")?;
        Ok(sizes)
    }

    pub(super) fn body(&mut self) -> Parse<Box<Successor>> {
        self.expect("{", "before the operation")?;
        let body = self.successor()?;
        self.expect("}", "after the operation")?;
        Ok(Box::new(body))
    }

    pub(super) fn size(&mut self) -> Parse<Size> {
        let kind = if self.accept("~").is_some() {
            SizeKind::Floating
        } else if self.accept("'").is_some() {
            SizeKind::Relative
        } else {
            SizeKind::Absolute
        };
        Ok(Size { kind, value: self.expr()? })
    }

    pub(super) fn three<T>(&mut self, mut element: impl FnMut(&mut Self) -> Parse<T>) -> Parse<[T; 3]> {
        let x = element(self)?;
        self.expect(",", "between the lengths: there are three")?;
        let y = element(self)?;
        self.expect(",", "between the lengths: there are three")?;
        Ok([x, y, element(self)?])
    }

    /// A list with commas up to `close`, which may be empty.
    pub(super) fn list<T>(
        &mut self,
        close: &str,
        mut element: impl FnMut(&mut Self) -> Parse<T>,
    ) -> Parse<Vec<T>> {
        let mut list = Vec::new();
        if self.accept(close).is_some() {
            return Ok(list);
        }
        loop {
            list.push(element(self)?);
            if self.accept(",").is_none() {
                self.expect(close, "or `,`")?;
                return Ok(list);
            }
        }
    }
}

/// For a word with braces behind it that is none of the operations.
fn no_operation(word: &Ident) -> Box<Diagnostic> {
    let near = closest(&word.name, OPERATIONS.into_iter());
    let hint = near.map_or(format!("the operations with braces are {}", OPERATIONS.join(", ")), |near| {
        format!("did you mean `{near}`?")
    });
    let message = format!("there is no operation `{}`", word.name);
    Box::new(Diagnostic::new(Code::UnknownOperation, word.span, message).hint(hint))
}
