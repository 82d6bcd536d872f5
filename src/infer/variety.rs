//! How much a learnt graph can make.

use crate::grammar::ast::Function;
use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph};

/// How many ways there are through the choices and ranges of a learnt graph, over all sizes of its start
/// scope. Two ways may give one building, so this bounds the number of buildings from above; what is
/// repeated counts once, though each repetition draws anew. `None` for graphs with rings.
pub fn variety(graph: &OpGraph) -> Option<f64> {
    let mut ways = vec![1.0; graph.len()];
    for node in graph.children_first()? {
        ways[node.index()] = ways_of(graph, node, &ways);
    }
    Some(ways[graph.root().index()])
}

fn ways_of(graph: &OpGraph, node: NodeIndex, ways: &[f64]) -> f64 {
    let children = graph.children(node).map(|(arg, child)| ways[child.index()] * ways_of_arg(arg));
    match graph.op(node) {
        Op::Choose => children.sum(),
        _ => children.product(),
    }
}

fn ways_of_arg(arg: &Arg) -> f64 {
    match arg {
        Arg::Size(size) => lengths(&size.value),
        Arg::None | Arg::Part(_) | Arg::Alternative(_) => 1.0,
    }
}

/// How many lengths a range has.
fn lengths(expr: &Expr) -> f64 {
    match expr {
        Expr::Call(Function::Randint, bounds) => match bounds.as_slice() {
            [Expr::Number(low), Expr::Number(high)] => high.0 - low.0 + 1.0,
            _ => 1.0,
        },
        Expr::Binary(_, left, right) => lengths(left) * lengths(right),
        _ => 1.0,
    }
}
