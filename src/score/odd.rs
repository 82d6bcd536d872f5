//! Parts of samples that are longer or shorter than their like in the examples.

use super::parts::parts;
use crate::graph::{NodeIndex, Op, OpGraph};
use crate::parse::Derivation;
use crate::space::Axis;
use std::collections::BTreeMap;

/// Parts of one class: what stands there, and what divided the scope around it.
type Class = (NodeIndex, NodeIndex);

/// How long the parts of each class are along their own axes.
#[derive(Clone, Debug, Default)]
pub struct Lengths {
    seen: BTreeMap<Class, [(i32, i32); 3]>,
}

/// Parts may be longer or shorter than any of their class by so much.
const SLACK: i32 = 1;

impl Lengths {
    /// Those of the examples' derivations. Equal operations of `graph` should be one.
    pub fn of<'d>(graph: &OpGraph, derivations: impl IntoIterator<Item = &'d Derivation>) -> Lengths {
        let mut seen: BTreeMap<Class, [(i32, i32); 3]> = BTreeMap::new();
        for (class, lengths) in derivations.into_iter().flat_map(|derivation| classed(graph, derivation)) {
            let known = seen.entry(class).or_insert(lengths.map(|length| (length, length)));
            for ((low, high), length) in known.iter_mut().zip(lengths) {
                (*low, *high) = ((*low).min(length), (*high).max(length));
            }
        }
        Lengths { seen }
    }

    /// How many parts of a derivation are longer or shorter by more than one than any of their class. Classes that
    /// are not known have no lengths of their own, and empty parts may have any.
    pub fn odd(&self, graph: &OpGraph, derivation: &Derivation) -> usize {
        let is_odd = |(class, lengths): &(Class, [i32; 3])| {
            self.seen.get(class).is_some_and(|known| {
                let mut both = known.iter().zip(lengths);
                both.any(|((low, high), length)| *length < low - SLACK || *length > high + SLACK)
            })
        };
        classed(graph, derivation).filter(is_odd).count()
    }
}

fn classed<'d>(
    graph: &OpGraph,
    derivation: &'d Derivation,
) -> impl Iterator<Item = (Class, [i32; 3])> + use<'d> {
    let parts = parts(graph, derivation).into_iter();
    let solid: Vec<_> = parts.filter(|part| *graph.op(part.step.node) != Op::Nil).collect();
    solid.into_iter().filter_map(|part| {
        let lengths = Axis::ALL.map(|axis| part.step.scope.len(axis));
        Some(((part.around?, part.step.node), lengths))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::score::tests::{derivations, graph};

    #[test]
    fn parts_far_from_all_seen_are_odd() {
        let graph = graph("a --> split(x){ 2 : I(stone) | ~1 : I(glass) | ~1 : nil }");
        let examples = derivations(&graph, &[[8, 1, 1], [12, 1, 1]]);
        let lengths = Lengths::of(&graph, &examples);
        let odd = |x| lengths.odd(&graph, &derivations(&graph, &[[x, 1, 1]])[0]);
        assert_eq!([6, 10, 14, 18].map(odd), [0, 0, 0, 1], "glass of 2, 4, 6 and 8 where 3 to 5 are known");
    }

    #[test]
    fn turned_parts_are_measured_along_their_own_axes() {
        let graph = graph(
            "a --> split(z){ 4 : bar | ~1 : R(y, 90){ bar } }
             bar --> split(x){ ~1 : I(stone) }",
        );
        let examples = derivations(&graph, &[[9, 1, 13]]);
        assert_eq!(Lengths::of(&graph, &examples).odd(&graph, &examples[0]), 0);
    }
}
