//! The length of a grammar: how many bits it takes to say what its op graph says.
//!
//! The code is fixed, and a shared operation is paid for once:
//!
//! | | bits |
//! |---|---|
//! | operation | a primitive 2, a split, a choice, a call and nothing 3, a repeat and a turn 5, any other 6 |
//! | how many children | `natural`, where it is not fixed |
//! | a child | 1 whether it is new; if it is not, the logarithm of the number of operations |
//! | a size | `~1` 1; so many blocks 2 and `natural`; a range 3, `natural` of its low end and of how many it holds; any other 5 and its expression |
//! | weights | 1 if all are equal; else 5 more for all but one |
//! | a condition | 1 whether there is one, and its expression |
//! | a number, an axis, a block | 1; then the number, 1.6, the logarithm of how many blocks the grammar names |
//! | a parameter | 2 and `natural` of its place |
//! | any other expression | 6 for its kind, then what it holds |
//! | a number by itself | 1 and `natural` of one more if it is whole and not negative, else 2 and so in thousandths |
//! | text | 8 for each letter |
//!
//! `natural` of n is 2 floor(log n) + 1. Names, comments, what is said of attributes and the sizes of the start scope are
//! free, and so are constants that only name a block or are for those sizes alone.

use crate::grammar::ast::{BinaryOp, Function, Rule, SizeKind};
use crate::graph::{Alternative, Arg, Expr, NodeIndex, Op, OpGraph, Size, Thing};
use std::collections::BTreeSet;

/// The bits of a grammar, as the table above has it. Equal operations are made one first.
pub fn model_bits(graph: &OpGraph) -> f64 {
    let graph = graph.spelled_out().unified();
    let code = Code::of(&graph);
    let operations = graph.nodes().map(|node| code.operation(&graph, node));
    let constants = used_constants(&graph).into_iter().map(|at| &graph.constants[at].value);
    let styles = graph.styles.iter().flat_map(|style| style.values.iter().map(|(_, value)| value));
    let values = constants.chain(styles).map(|expr| code.expr(expr));
    operations.sum::<f64>() + code.references(&graph) + values.sum::<f64>()
}

/// The constants that operations and styles need, by themselves or for others.
fn used_constants(graph: &OpGraph) -> BTreeSet<usize> {
    let mut used = BTreeSet::new();
    let on_edges = graph.nodes().flat_map(|node| graph.children(node).flat_map(|(arg, _)| arg.exprs()));
    let mut open: Vec<&Expr> =
        graph.nodes().flat_map(|node| graph.op(node).exprs()).chain(on_edges).collect();
    open.extend(graph.styles.iter().flat_map(|style| style.values.iter().map(|(_, value)| value)));
    while let Some(expr) = open.pop() {
        let mut fresh = Vec::new();
        expr.for_each(&mut |part| {
            if let Expr::Constant(at) = part {
                fresh.extend(used.insert(*at).then_some(*at));
            }
        });
        open.extend(fresh.into_iter().filter_map(|at| graph.constants.get(at)).map(|known| &known.value));
    }
    used
}

/// A whole number of one or more, small ones in few bits.
fn natural(number: f64) -> f64 {
    2.0 * libm::log2(number.max(1.0)).floor() + 1.0
}

/// How many there are, where there may be none.
fn many(count: usize) -> f64 {
    natural(count as f64 + 1.0)
}

fn text(text: &str) -> f64 {
    8.0 * text.len() as f64
}

/// What the code takes from the graph as a whole.
struct Code {
    /// Saying which operation.
    operation: f64,
    /// Saying which block.
    thing: f64,
}

impl Code {
    fn of(graph: &OpGraph) -> Code {
        let mut things: BTreeSet<String> = BTreeSet::new();
        let mut add = |expr: &Expr| {
            expr.for_each(&mut |part| {
                if let Expr::Thing(thing) = part {
                    things.insert(format!("{thing:?}"));
                }
            });
        };
        for node in graph.nodes() {
            graph.op(node).exprs().for_each(&mut add);
            graph.children(node).flat_map(|(arg, _)| arg.exprs()).for_each(&mut add);
        }
        used_constants(graph).into_iter().for_each(|at| add(&graph.constants[at].value));
        Code { operation: libm::log2(graph.len() as f64), thing: libm::log2(things.len().max(2) as f64) }
    }

    /// Every operation but the root is new once.
    fn references(&self, graph: &OpGraph) -> f64 {
        let all = graph.edge_count() as f64;
        let again = all - (graph.len() as f64 - 1.0);
        all + again.max(0.0) * self.operation
    }

    /// An operation with what its edges carry.
    fn operation(&self, graph: &OpGraph, node: NodeIndex) -> f64 {
        let op = graph.op(node);
        let edges: Vec<&Arg> = graph.children(node).map(|(arg, _)| arg).collect();
        let count = match op {
            Op::All | Op::Split { .. } | Op::Choose | Op::Carve { .. } => natural(edges.len() as f64),
            _ => 0.0,
        };
        let carried = edges.iter().map(|arg| self.arg(arg)).sum::<f64>();
        self.op(op) + count + carried + self.weights(&edges)
    }

    fn op(&self, op: &Op) -> f64 {
        let own = match op {
            Op::Primitive { material: None, options, .. } if options.is_empty() => 2.0,
            Op::Split { groups, .. } => 3.0 + 8.0 * groups.len() as f64,
            Op::Nil | Op::Choose => 3.0,
            Op::Call(args) => 3.0 + many(args.len()),
            Op::Repeat { .. } | Op::RepeatN { .. } | Op::Rotate { .. } => 5.0,
            Op::Shape(label) => 6.0 + text(label),
            Op::Primitive { options, .. } => 6.0 + 2.0 * options.len() as f64,
            _ => 6.0,
        };
        own + op.exprs().map(|expr| self.expr(expr)).sum::<f64>()
    }

    fn arg(&self, arg: &Arg) -> f64 {
        match arg {
            Arg::None => 0.0,
            Arg::Size(size) => self.size(size),
            Arg::Part(selector) => text(&selector.to_string()),
            Arg::Alternative(Alternative { condition, priority, .. }) => {
                let condition = condition.as_ref().map_or(0.0, |condition| self.expr(condition));
                1.0 + condition + f64::from(priority.saturating_sub(Rule::FIRST))
            }
        }
    }

    /// Weights that differ, as shares in so many steps.
    fn weights(&self, edges: &[&Arg]) -> f64 {
        const STEPS: f64 = 5.0;
        let weights: Vec<&Expr> = edges
            .iter()
            .filter_map(|arg| match arg {
                Arg::Alternative(alternative) => Some(&alternative.weight),
                _ => None,
            })
            .collect();
        let are_plain = weights.iter().all(|weight| matches!(weight, Expr::Number(_)));
        match weights.split_first() {
            None => 0.0,
            Some((first, rest)) if rest.iter().all(|weight| weight == first) => 1.0,
            Some((_, rest)) if are_plain => 1.0 + STEPS * rest.len() as f64,
            Some(_) => 1.0 + weights.iter().map(|weight| self.expr(weight)).sum::<f64>(),
        }
    }

    fn size(&self, size: &Size) -> f64 {
        match (size.kind, &size.value) {
            (SizeKind::Floating, Expr::Number(one)) if one.0 == 1.0 => 1.0,
            (SizeKind::Absolute, Expr::Number(length)) if is_length(length.0) => 2.0 + natural(length.0),
            (SizeKind::Absolute, Expr::Call(Function::Randint, ends)) => match ends.as_slice() {
                [Expr::Number(low), Expr::Number(high)] if is_length(low.0) && high.0 >= low.0 => {
                    3.0 + natural(low.0) + natural(high.0 - low.0 + 1.0)
                }
                _ => 5.0 + self.expr(&size.value),
            },
            (_, value) => 5.0 + self.expr(value),
        }
    }

    /// An expression with all its parts.
    fn expr(&self, expr: &Expr) -> f64 {
        let mut bits = 0.0;
        expr.for_each(&mut |part| bits += self.own(part));
        bits
    }

    /// An expression without its parts.
    fn own(&self, expr: &Expr) -> f64 {
        let rest = match expr {
            Expr::Number(value) => return 1.0 + number(value.0),
            Expr::Axis(_) => return 1.0 + libm::log2(3.0),
            Expr::Param(at) => return 2.0 + many(*at),
            Expr::Thing(Thing::Mix(_) | Thing::Gradient(..)) => 16.0,
            Expr::Thing(_) => return 1.0 + self.thing,
            Expr::ScopeSize(_) => libm::log2(3.0),
            Expr::Constant(at) => many(*at),
            Expr::Unary(..) | Expr::Share(_) => 1.0,
            Expr::Binary(..) => libm::log2(BinaryOp::ALL.len() as f64),
            Expr::Call(_, args) => libm::log2(Function::ALL.len() as f64) + many(args.len()),
            Expr::Pick(parts) | Expr::Mix(parts) => many(parts.len()),
            Expr::Gradient(_, blocks) => many(blocks.len()),
            Expr::State(_, properties) => text(properties),
            Expr::Same(..) => 0.0,
            Expr::Occlusion { against, .. } => text(against.name()),
            Expr::Visible(label) => text(label),
        };
        6.0 + rest
    }
}

fn is_length(number: f64) -> bool {
    number >= 1.0 && number.fract() == 0.0
}

fn number(value: f64) -> f64 {
    match value >= 0.0 && value.fract() == 0.0 {
        true => 1.0 + natural(value + 1.0),
        false => 2.0 + natural(1000.0 * value.abs() + 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::read;
    use crate::graph::lower;

    fn bits(text: &str) -> f64 {
        model_bits(&lower(&read(text).unwrap(), None).unwrap())
    }

    #[test]
    fn one_block_is_a_primitive_and_its_name() {
        assert_eq!(bits("a --> I(stone)"), 2.0 + 1.0 + 1.0);
    }

    /// Two parts: 3 for the split and 3 for how many, 1 + log 3 for the axis; sizes of 2 + 3 and of 1; a bit for each
    /// child and 4 for each block.
    #[test]
    fn a_split_is_paid_for_part_by_part() {
        let expected = 3.0 + 3.0 + 1.0 + libm::log2(3.0) + (2.0 + 3.0) + 1.0 + 2.0 + 2.0 * 4.0;
        let found = bits("a --> split(x){ 2 : I(stone) | ~1 : I(glass) }");
        assert!((found - expected).abs() < 1e-9, "{found} for {expected}");
    }

    #[test]
    fn weights_that_differ_cost_more_than_equal_ones() {
        let equal = bits("a --> I(stone) : 0.5\na --> I(glass) : 0.5");
        assert_eq!(bits("a --> I(stone)\na --> I(glass)"), equal);
        assert_eq!(bits("a --> I(stone) : 3\na --> I(glass) : 2"), equal + 5.0);
    }

    #[test]
    fn names_are_free_and_what_is_shared_is_paid_once() {
        let nested = "a --> split(x){ 1 : split(y){ 1 : I(stone) | ~1 : nil } | ~1 : split(y){ 1 : I(stone) | ~1 : nil } }";
        let named = "wall --> split(x){ 1 : part | ~1 : part }\npart --> split(y){ 1 : I(stone) | ~1 : nil }";
        assert_eq!(bits(nested), bits(named));
        let other = "a --> split(x){ 1 : split(y){ 1 : I(stone) | ~1 : nil } | ~1 : split(y){ 2 : I(stone) | ~1 : nil } }";
        assert!(bits(other) > bits(named) + 10.0);
        assert_eq!(bits(named), bits(&format!("size(randint(3, 9), 3, 1)\n{named}")));
        let lifted = named.replace("stone", "rock");
        assert_eq!(bits(named), bits(&format!("size(3, floors, 1)\nfloors = 3\nrock = stone\n{lifted}")));
    }
}
