//! Operations, sizes and lists.

use super::MAX_DEPTH;
use super::cursor::{Parse, Parser};
use crate::grammar::ast::*;
use crate::grammar::names::closest;
use crate::grammar::{Diagnostic, Span};

impl Parser<'_> {
    pub(super) fn successor(&mut self) -> Parse<Successor> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_much("operations are nested too deeply"));
        }
        let start = self.peek().span;
        let op = self.op()?;
        self.depth -= 1;
        Ok(Successor { op, span: start.to(Span::new(0, self.previous_end())) })
    }

    pub(super) fn op(&mut self) -> Parse<Op> {
        if self.starts_item() && self.is_followed_by_definition() {
            return Err(self.unexpected("expected an operation or a label"));
        }
        let label = self.ident("an operation or a label")?;
        match label.name.as_str() {
            "nil" => Ok(Op::Nil),
            "I" => self.primitive(),
            "split" => self.split(),
            "repeat" => self.repeat(),
            "repeatN" => self.repeat_n(),
            "T" => {
                let delta = self.sizes()?;
                Ok(Op::Translate { delta, body: self.body()? })
            }
            "S" => {
                let size = self.sizes()?;
                Ok(Op::Resize { size, body: self.body()? })
            }
            "R" => self.rotate(),
            "comp" => self.comp(),
            _ => {
                let args = if self.accept("(").is_some() {
                    self.list(")", |parser| parser.argument())?
                } else {
                    Vec::new()
                };
                match self.is_symbol("{") {
                    true => Err(no_operation(&label)),
                    false => Ok(Op::Call { label, args }),
                }
            }
        }
    }

    pub(super) fn primitive(&mut self) -> Parse<Op> {
        self.expect("(", "after `I`: it names a primitive, as in `I(stone)`")?;
        let name = self.argument()?;
        let material = if self.accept(",").is_some() { Some(self.argument()?) } else { None };
        self.expect(")", "after the primitive")?;
        Ok(Op::Primitive { name, material })
    }

    pub(super) fn split(&mut self) -> Parse<Op> {
        self.expect("(", "after `split`: it names an axis, as in `split(x){ ~1 : a | ~1 : b }`")?;
        let axis = self.expr()?;
        self.expect(")", "after the axis")?;
        self.expect("{", "before the parts")?;
        Ok(Op::Split { axis, items: self.items()? })
    }

    /// The items up to the closing brace.
    pub(super) fn items(&mut self) -> Parse<Vec<Item>> {
        let mut items = Vec::new();
        loop {
            items.push(self.part_or_group()?);
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a part")?;
                return Ok(items);
            }
        }
    }

    pub(super) fn part_or_group(&mut self) -> Parse<Item> {
        if let Some(open) = self.accept("{") {
            let items = self.items()?;
            let star = self.expect("*", "after a group: it is repeated as often as it fits")?;
            return Ok(Item::Group { items, span: open.span.to(star.span) });
        }
        const HINT: &str = "a part reads `size : operation`, as in `~1 : wall`";
        if self.is_symbol("}") || self.is_symbol("|") {
            return Err(self.unexpected_with("expected a part", HINT));
        }
        let size = self.size()?;
        if !self.is_symbol(":") {
            return Err(
                self.unexpected_with("expected `:` between the size of a part and its operation", HINT)
            );
        }
        self.next();
        Ok(Item::Part { size, body: self.successor()? })
    }

    pub(super) fn repeat(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeat`: it names an axis and a size, as in `repeat(x, 2){ window }`")?;
        let axis = self.expr()?;
        let size = if self.accept(",").is_some() { Some(self.expr()?) } else { None };
        self.expect(")", "after the axis and the size")?;
        self.expect("{", "before the operation to repeat")?;
        let size = match size {
            Some(size) => size,
            None => {
                let size = self.expr()?;
                self.expect(":", "after the size in `repeat(axis){ size : operation }`")?;
                size
            }
        };
        let body = Box::new(self.successor()?);
        self.expect("}", "after the operation to repeat")?;
        Ok(Op::Repeat { axis, size, body })
    }

    pub(super) fn repeat_n(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeatN`: it names an axis and a count, as in `repeatN(x, 3){ window }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the count")?;
        let count = self.expr()?;
        self.expect(")", "after the count")?;
        Ok(Op::RepeatN { axis, count, body: self.body()? })
    }

    pub(super) fn rotate(&mut self) -> Parse<Op> {
        self.expect("(", "after `R`: it names an axis and an angle, as in `R(y, pi/2){ roof }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the angle")?;
        let angle = self.expr()?;
        self.expect(")", "after the angle")?;
        Ok(Op::Rotate { axis, angle, body: self.body()? })
    }

    pub(super) fn comp(&mut self) -> Parse<Op> {
        self.expect("(", "after `comp`, as in `comp(f){ side : wall | top : roof }`")?;
        let kind = self.ident("`f`, for faces")?;
        if kind.name != "f" {
            let error = Diagnostic::error(kind.span, format!("`{}` is no kind of component", kind.name));
            return Err(Box::new(error.hint("write `comp(f)`: a scope is taken apart into its faces")));
        }
        self.expect(")", "after `f`")?;
        self.expect("{", "before the faces")?;
        let mut parts = Vec::new();
        loop {
            let face = self.face()?;
            self.expect(":", "between a face and its operation")?;
            parts.push((face, self.successor()?));
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a face")?;
                return Ok(Op::Comp { parts });
            }
        }
    }

    pub(super) fn face(&mut self) -> Parse<Face> {
        let ident = self.ident("a face")?;
        let face = Face::NAMES.iter().find(|(name, _)| *name == ident.name);
        face.map(|(_, face)| *face).ok_or_else(|| {
            let names: Vec<&str> = Face::NAMES.iter().map(|(name, _)| *name).collect();
            let error = Diagnostic::error(ident.span, format!("there is no face `{}`", ident.name));
            Box::new(error.hint(format!("the faces are {}", names.join(", "))))
        })
    }

    pub(super) fn sizes(&mut self) -> Parse<[Size; 3]> {
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
    const OPERATIONS: [&str; 7] = ["split", "repeat", "repeatN", "T", "S", "R", "comp"];
    let near = closest(&word.name, OPERATIONS.into_iter());
    let hint = near.map_or(format!("the operations with braces are {}", OPERATIONS.join(", ")), |near| {
        format!("did you mean `{near}`?")
    });
    Box::new(Diagnostic::error(word.span, format!("there is no operation `{}`", word.name)).hint(hint))
}
