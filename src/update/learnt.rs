//! What is learnt from a part of a house.

use super::fills::{Fills, fills};
use crate::block::Palette;
use crate::grammar::ast::{Op, Rule, Successor};
use crate::graph::raise;
use crate::grid::Grid;
use crate::infer::{Example, Freedom, Method, infer};
use crate::space::{Axis, Scope, Up};

/// An operation that gives a part of a house, and the rules that it calls.
#[derive(Clone, Debug)]
pub struct Learnt {
    pub successor: Successor,
    pub rules: Vec<Rule>,
    pub fills: [Fills; 3],
}

/// Learns from what a house has in a scope, seen from there. `None` where upright is another axis than the game's, or
/// nothing can be learnt.
pub fn learn(house: &Grid, scope: &Scope) -> Option<Learnt> {
    if scope.frame.up != Up::Y {
        return None;
    }
    let part = house.cropped(scope.bounds).turned(scope.frame.turn.inverse());
    if part.cells().iter().all(|id| *id == Palette::AIR) {
        return Some(Learnt {
            successor: Successor::new(Op::Nil),
            rules: Vec::new(),
            fills: [Fills::ALL; 3],
        });
    }
    let learnt = infer(&[Example::Blocks(part)], Method::Boxes, Freedom::Seen).ok()?;
    let size = Axis::ALL.map(|axis| scope.len(axis));
    let fills = fills(&learnt.graph, size);
    // Materials are written out: the grammar that takes the rules in has constants of its own.
    let mut rules = raise(&learnt.graph.spelled_out()).rules.into_iter();
    let first = rules.next()?;
    Some(Learnt { successor: first.successor, rules: rules.collect(), fills })
}
