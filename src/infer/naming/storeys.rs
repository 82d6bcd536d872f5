//! The number of storeys, where houses differ in it: a constant that the start size is told by.

use crate::grammar::ast::{BinaryOp, SizeKind};
use crate::graph::{Arg, Constant, Expr, NodeIndex, Op, OpGraph, Size};
use crate::infer::Example;
use crate::space::Axis;
use std::collections::BTreeSet;

/// How the height of an operation goes with the storeys in it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Rise {
    /// It fills any height.
    Any,
    /// So many blocks, and so many more for each storey.
    Storeys { fixed: i32, each: i32 },
    /// It says nothing of storeys.
    Other,
}

impl Rise {
    fn and(self, other: Rise) -> Rise {
        match (self, other) {
            (Rise::Any, rise) | (rise, Rise::Any) => rise,
            (one, other) if one == other => one,
            _ => Rise::Other,
        }
    }
}

/// Makes a constant of the number of storeys, and tells the height of the start size by it.
pub fn lift(graph: &mut OpGraph, examples: &[Example]) {
    let (Rise::Storeys { fixed, each }, [start]) = (rise_of_root(graph), graph.sizes.as_slice()) else {
        return;
    };
    let Some(value) = storeys(examples, fixed, each) else { return };
    let mut start = start.clone();
    let number = |value: i32| Expr::number(f64::from(value));
    let binary = |op, left, right| Expr::Binary(op, Box::new(left), Box::new(right));
    let of_storeys = binary(BinaryOp::Multiply, number(each), Expr::Constant(graph.constants.len()));
    start.size[Axis::Y.index()] = match fixed {
        0 => of_storeys,
        fixed => binary(BinaryOp::Add, number(fixed), of_storeys),
    };
    graph.sizes = vec![start];
    graph.constants.push(Constant { name: NAME.to_owned(), value, attribute: None });
}

/// The name of the constant.
pub const NAME: &str = "storeys";

/// The numbers of storeys between those of the examples; `None` where a height is no whole number of them, or where there
/// are only steps of several storeys.
fn storeys(examples: &[Example], fixed: i32, each: i32) -> Option<Expr> {
    let storeys = |example: &Example| {
        let rest = Axis::Y.of(example.bounds().size()) - fixed;
        (rest > 0 && rest % each == 0).then_some(rest / each)
    };
    let all: BTreeSet<i32> = examples.iter().map(storeys).collect::<Option<_>>()?;
    let has_single_steps = all.len() == 1 || all.iter().any(|storeys| all.contains(&(storeys + 1)));
    has_single_steps.then_some(Expr::between(*all.first()?, *all.last()?))
}

fn rise_of_root(graph: &OpGraph) -> Rise {
    let mut rises = vec![Rise::Other; graph.len()];
    for node in graph.inner_first() {
        rises[node.index()] = rise(graph, node, &rises);
    }
    rises[graph.root().index()]
}

/// The rise of an operation, from those of its children.
fn rise(graph: &OpGraph, node: NodeIndex, rises: &[Rise]) -> Rise {
    match graph.op(node) {
        Op::Primitive { .. } | Op::Nil => Rise::Any,
        Op::Split { axis: Expr::Axis(Axis::Y), .. } => stacked(graph, node, rises),
        Op::Repeat { axis: Expr::Axis(Axis::Y), size: Expr::Number(each), .. } if each.0.fract() == 0.0 => {
            Rise::Storeys { fixed: 0, each: each.0 as i32 }
        }
        Op::Split { .. } | Op::Choose | Op::Call(_) => {
            graph.children(node).map(|(_, child)| rises[child.index()]).fold(Rise::Any, Rise::and)
        }
        _ => Rise::Other,
    }
}

/// The rise of parts over one another, of which one takes what the others leave.
fn stacked(graph: &OpGraph, node: NodeIndex, rises: &[Rise]) -> Rise {
    let mut fixed = 0;
    let mut open = Rise::Other;
    for (arg, child) in graph.children(node) {
        match arg {
            Arg::Size(Size { kind: SizeKind::Absolute, value: Expr::Number(len) }) => fixed += len.0 as i32,
            Arg::Size(Size { kind: SizeKind::Floating, .. }) if open == Rise::Other => {
                open = rises[child.index()]
            }
            _ => return Rise::Other,
        }
    }
    match open {
        Rise::Storeys { fixed: own, each } => Rise::Storeys { fixed: fixed + own, each },
        _ => Rise::Other,
    }
}
