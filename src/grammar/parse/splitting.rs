//! Splits and repeats.

use super::cursor::{Parse, Parser};
use crate::grammar::Code;
use crate::grammar::ast::*;

impl Parser<'_> {
    pub(super) fn split(&mut self) -> Parse<Op> {
        self.expect("(", "after `split`: it names an axis, as in `split(x){ ~1 : a | ~1 : b }`")?;
        let axis = self.expr()?;
        let snap = self.accept(",").map(|_| self.snap()).transpose()?;
        self.expect(")", "after the axis")?;
        self.expect("{", "before the parts")?;
        Ok(Op::Split { axis, snap, items: self.items()? })
    }

    /// `snap` or `snap(label)`: that the boundaries heed snap planes.
    fn snap(&mut self) -> Parse<Snap> {
        if !self.is_word("snap") {
            let hint = "as in `split(x, snap){ ... }` or `split(x, snap(ledge)){ ... }`";
            return Err(self.unexpected_with(Code::Unexpected, "expected `snap` or `snap(label)`", hint));
        }
        self.next();
        let Some(_) = self.accept("(") else { return Ok(Snap { label: None }) };
        let label = self.ident("the label of the planes")?;
        self.expect(")", "after the label")?;
        Ok(Snap { label: Some(label.name) })
    }

    /// The items up to the closing brace.
    fn items(&mut self) -> Parse<Vec<Item>> {
        let mut items = Vec::new();
        loop {
            items.push(self.part_or_group()?);
            if self.accept("|").is_none() {
                self.expect("}", "or `|` after a part")?;
                return Ok(items);
            }
        }
    }

    fn part_or_group(&mut self) -> Parse<Item> {
        if let Some(open) = self.accept("{") {
            let items = self.items()?;
            let star = self.expect("*", "after a group: it is repeated as often as it fits")?;
            return Ok(Item::Group { items, span: open.span.to(star.span) });
        }
        const HINT: &str = "a part reads `size : operation`, as in `~1 : wall`";
        if self.is_symbol("}") || self.is_symbol("|") {
            return Err(self.unexpected_with(Code::BadPart, "expected a part", HINT));
        }
        let size = self.size()?;
        if !self.is_symbol(":") {
            let expected = "expected `:` between the size of a part and its operation";
            return Err(self.unexpected_with(Code::BadPart, expected, HINT));
        }
        self.next();
        Ok(Item::Part { size, body: self.successor()? })
    }

    pub(super) fn repeat(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeat`: it names an axis and a size, as in `repeat(x, 2){ window }`")?;
        let axis = self.expr()?;
        let (mut size, mut snap) = (None, None);
        while snap.is_none() && self.accept(",").is_some() {
            match self.is_word("snap") || size.is_some() {
                true => snap = Some(self.snap()?),
                false => size = Some(self.expr()?),
            }
        }
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
        Ok(Op::Repeat { axis, size, snap, body })
    }

    pub(super) fn repeat_n(&mut self) -> Parse<Op> {
        self.expect("(", "after `repeatN`: it names an axis and a count, as in `repeatN(x, 3){ window }`")?;
        let axis = self.expr()?;
        self.expect(",", "between the axis and the count")?;
        let count = self.expr()?;
        self.expect(")", "after the count")?;
        Ok(Op::RepeatN { axis, count, body: self.body()? })
    }
}
