//! Which lengths what was learnt can fill.

use crate::grammar::ast::SizeKind;
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph, Size};
use crate::space::Axis;

/// Lengths that an operation can fill along an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fills {
    /// Those from one on.
    From(i32),
    Only(i32),
}

impl Fills {
    pub const ALL: Fills = Fills::From(1);

    pub fn contains(self, length: i32) -> bool {
        match self {
            Fills::From(least) => length >= least,
            Fills::Only(one) => length == one,
        }
    }
}

/// The lengths that the root of a graph can fill, axis by axis. `seen` is the size that it was seen to fill: it is all
/// that is told of operations whose lengths are not plain.
pub fn fills(graph: &OpGraph, seen: [i32; 3]) -> [Fills; 3] {
    let order = graph.children_first().unwrap_or_default();
    Axis::ALL.map(|along| {
        let mut known: Vec<Option<Fills>> = vec![None; graph.len()];
        for node in &order {
            known[node.index()] = fills_of(graph, &known, *node, along);
        }
        known[graph.root().index()].unwrap_or(Fills::Only(seen[along.index()]))
    })
}

fn fills_of(graph: &OpGraph, known: &[Option<Fills>], node: NodeIndex, along: Axis) -> Option<Fills> {
    let mut children = graph.children(node).map(|(arg, child)| (arg, known[child.index()]));
    match graph.op(node) {
        Op::Primitive { .. } | Op::Nil => Some(Fills::ALL),
        Op::Split { axis: Expr::Axis(axis), groups, .. } if *axis == along => {
            let parts = children.collect::<Vec<_>>();
            if groups.is_empty() { sum(&parts) } else { None }
        }
        Op::Split { axis: Expr::Axis(_), .. } | Op::Repeat { axis: Expr::Axis(_), .. }
            if axis_of(graph.op(node)) != Some(along) =>
        {
            children.try_fold(Fills::ALL, |all, (_, child)| both(all, child?))
        }
        _ => None,
    }
}

fn axis_of(op: &Op) -> Option<Axis> {
    match op {
        Op::Split { axis: Expr::Axis(axis), .. } | Op::Repeat { axis: Expr::Axis(axis), .. } => Some(*axis),
        _ => None,
    }
}

/// What parts in a row fill. Several may float where they are as long as one another.
fn sum(parts: &[(&Arg, Option<Fills>)]) -> Option<Fills> {
    let mut total = 0;
    let mut floating: Vec<Fills> = Vec::new();
    for (arg, child) in parts {
        let Arg::Size(Size { kind, value: Expr::Number(size) }) = arg else { return None };
        match kind {
            SizeKind::Absolute if child.is_some_and(|child| child.contains(size.0 as i32)) => {
                total += size.0 as i32;
            }
            SizeKind::Floating if size.0 == 1.0 => floating.push((*child)?),
            _ => return None,
        }
    }
    match floating.as_slice() {
        [] => Some(Fills::Only(total)),
        [Fills::Only(one)] => Some(Fills::Only(total + one)),
        floating => {
            let least = floating.iter().map(|fills| match fills {
                Fills::From(least) => Some(*least),
                Fills::Only(_) => None,
            });
            let least = least.collect::<Option<Vec<i32>>>()?.into_iter().max()?;
            Some(Fills::From(total + least * floating.len() as i32))
        }
    }
}

/// What both can fill.
fn both(one: Fills, other: Fills) -> Option<Fills> {
    match (one, other) {
        (Fills::From(one), Fills::From(other)) => Some(Fills::From(one.max(other))),
        (Fills::Only(length), other) | (other, Fills::Only(length)) => {
            other.contains(length).then_some(Fills::Only(length))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::read;
    use crate::graph::lower;

    fn of(text: &str) -> [Fills; 3] {
        fills(&lower(&read(text).unwrap(), None).unwrap(), [9, 9, 9])
    }

    #[test]
    fn parts_sum_to_what_their_split_can_fill() {
        let all = Fills::ALL;
        assert_eq!(of("a --> I(stone)"), [all; 3]);
        assert_eq!(of("a --> split(x){ 2 : I(stone) | 3 : nil }"), [Fills::Only(5), all, all]);
        assert_eq!(of("a --> split(x){ 2 : I(stone) | ~1 : nil }"), [Fills::From(3), all, all]);
        assert_eq!(of("a --> split(y){ ~1 : nil | 1 : I(stone) | ~1 : nil }"), [all, Fills::From(3), all]);
        let nested = "a --> split(x){ 1 : b | ~1 : I(stone) }\nb --> split(z){ 1 : nil | 1 : I(stone) }";
        assert_eq!(of(nested), [Fills::From(2), all, Fills::Only(2)]);
    }

    #[test]
    fn what_is_not_plain_fills_what_was_seen() {
        assert_eq!(of("a --> repeat(x, 2){ I(stone) }")[0], Fills::Only(9));
        assert_eq!(of("a --> split(x){ randint(1, 2) : I(stone) | ~1 : nil }")[0], Fills::Only(9));
    }
}
