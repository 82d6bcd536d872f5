//! What of its surroundings an operation, and all below it, can see.

use crate::graph::{Arg, Expr, NodeIndex, Op, OpGraph};
use fixedbitset::FixedBitSet;

/// What a node's derivations depend on, besides its scope.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Needs {
    pub params: bool,
    /// Its place among the shares of a split.
    pub share: bool,
    /// By their numbers, in whatever style.
    pub constants: FixedBitSet,
}

impl Needs {
    fn none(graph: &OpGraph) -> Needs {
        Needs { params: false, share: false, constants: FixedBitSet::with_capacity(graph.constants.len()) }
    }

    /// Whether its derivations are the same wherever it stands.
    pub fn is_none(&self) -> bool {
        !self.params && !self.share && self.constants.is_clear()
    }

    fn add(&mut self, expr: &Expr) {
        expr.for_each(&mut |part| match part {
            Expr::Param(_) => self.params = true,
            Expr::Share(_) => self.share = true,
            Expr::Constant(at) => self.constants.grow_and_insert(*at),
            _ => {}
        });
    }
}

/// The needs of each node, by its index.
pub fn needs(graph: &OpGraph) -> Vec<Needs> {
    let mut needs: Vec<Needs> = graph.nodes().map(|node| own(graph, node)).collect();
    // Rules may call one another in rings: go on until nothing new comes up.
    let mut grew = true;
    while grew {
        grew = false;
        for node in (0..graph.len()).rev().map(NodeIndex::new) {
            let mut sum = needs[node.index()].clone();
            for (_, child) in graph.children(node) {
                let below = &needs[child.index()];
                sum.params |= below.params && !matches!(graph.op(node), Op::Call(_));
                sum.share |= below.share && !shares_out(graph.op(node));
                sum.constants.union_with(&below.constants);
            }
            grew |= sum != needs[node.index()];
            needs[node.index()] = sum;
        }
    }
    needs
}

fn own(graph: &OpGraph, node: NodeIndex) -> Needs {
    let mut needs = Needs::none(graph);
    graph.op(node).exprs().for_each(|expr| needs.add(expr));
    graph.children(node).flat_map(|(arg, _)| Arg::exprs(arg)).for_each(|expr| needs.add(expr));
    needs
}

/// Whether an operation gives its children a new place among shares.
fn shares_out(op: &Op) -> bool {
    matches!(op, Op::Split { .. } | Op::Repeat { .. } | Op::RepeatN { .. })
}
