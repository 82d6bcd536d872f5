//! How the lengths of parts go with those of their scopes.

use super::lengths::{parts, plain_axis};
use crate::grammar::ast::{ExprKind, Op, Size, SizeKind, Successor};
use crate::space::Axis;

/// How the length of a part goes with that of what is around it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Growth {
    /// It is always the same.
    Fixed,
    /// It is a block longer where that is.
    Along,
    Unknown,
}

impl Growth {
    /// How it goes for a part of the part.
    pub fn then(self, inner: Growth) -> Growth {
        match (self, inner) {
            (_, Growth::Fixed) | (Growth::Fixed, Growth::Along) => Growth::Fixed,
            (Growth::Along, Growth::Along) => Growth::Along,
            _ => Growth::Unknown,
        }
    }
}

/// How an operation's length along an axis goes with that of the one that it stands in.
pub fn growth(outer: &Successor, inner: &Successor, along: Axis) -> Growth {
    match &outer.op {
        Op::Split { axis, items, .. } => match plain_axis(axis) {
            Some(axis) if axis == along => part_growth(&parts(items), inner),
            Some(_) => Growth::Along,
            None => Growth::Unknown,
        },
        Op::All(_) => Growth::Along,
        _ => Growth::Unknown,
    }
}

fn part_growth(parts: &[(&Size, &Successor)], inner: &Successor) -> Growth {
    let is_plain = |size: &Size| matches!(size.value.kind, ExprKind::Number(_));
    let place = |body: &Successor| (body.span.start, body.span.end);
    let part = parts.iter().find(|(_, body)| place(body) == place(inner));
    let floating = parts.iter().filter(|(size, _)| size.kind == SizeKind::Floating).count();
    match part.map(|(size, _)| size) {
        Some(size) if size.kind == SizeKind::Absolute && is_plain(size) => Growth::Fixed,
        Some(size) if size.kind == SizeKind::Floating && floating == 1 => {
            match parts.iter().all(|(size, _)| is_plain(size) && size.kind != SizeKind::Relative) {
                true => Growth::Along,
                false => Growth::Unknown,
            }
        }
        _ => Growth::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::Grammar;

    #[test]
    fn one_floating_part_grows_with_its_scope() {
        let of = |text: &str, part: usize| {
            let grammar: Grammar = format!("a --> {text}").parse().unwrap();
            let outer = &grammar.rules[0].successor;
            let Op::Split { items, .. } = &outer.op else { panic!("{text}") };
            Axis::ALL.map(|axis| growth(outer, parts(items)[part].1, axis))
        };
        use Growth::{Along, Fixed, Unknown};
        assert_eq!(of("split(x){ 2 : nil | ~1 : I(stone) }", 0), [Fixed, Along, Along]);
        assert_eq!(of("split(x){ 2 : nil | ~1 : I(stone) }", 1), [Along; 3]);
        assert_eq!(of("split(y){ ~1 : nil | ~1 : I(stone) }", 1), [Along, Unknown, Along]);
        assert_eq!(of("split(z){ randint(1, 2) : nil | ~1 : I(stone) }", 1), [Along, Along, Unknown]);
        assert_eq!(Along.then(Fixed).then(Along), Fixed);
        assert_eq!(Unknown.then(Along), Unknown);
    }
}
