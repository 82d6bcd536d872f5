//! How much of the examples a grammar has only learnt by heart.

use super::parts::{parts, uses};
use crate::graph::{Op, OpGraph};
use crate::parse::Derivation;

/// The share of the blocks that are put by operations which run only once in all derivations: such an operation
/// describes one place of one building. `None` where there are no blocks.
///
/// Equal operations of `graph` should be one.
pub fn template_share(graph: &OpGraph, derivations: &[&Derivation]) -> Option<f64> {
    let uses = uses(derivations.iter().copied());
    let (mut verbatim, mut all) = (0, 0);
    for part in derivations.iter().flat_map(|derivation| parts(graph, derivation)) {
        if let Op::Primitive { .. } = graph.op(part.step.node) {
            let blocks = part.step.scope.bounds.volume();
            let is_once = part.around.is_none_or(|around| uses.get(&around) == Some(&1));
            all += blocks;
            verbatim += if is_once { blocks } else { 0 };
        }
    }
    (all > 0).then(|| verbatim as f64 / all as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::score::tests::{derivations, graph};

    fn share(text: &str, sizes: &[[i32; 3]]) -> Option<f64> {
        let graph = graph(text);
        let derivations = derivations(&graph, sizes);
        template_share(&graph, &derivations.iter().collect::<Vec<_>>())
    }

    const WALL: &str = "a --> split(x){ 1 : I(stone) | ~1 : I(glass) }";

    #[test]
    fn one_building_is_all_template_two_are_not() {
        assert_eq!(share(WALL, &[[3, 1, 1]]), Some(1.0));
        assert_eq!(share(WALL, &[[3, 1, 1], [4, 1, 1]]), Some(0.0));
    }

    #[test]
    fn of_nothing_there_is_no_share() {
        assert_eq!(share(WALL, &[]), None);
    }

    #[test]
    fn what_is_repeated_is_no_template() {
        let text = "a --> repeat(x, 2){ split(x){ 1 : I(stone) | 1 : I(glass) } }";
        assert_eq!(share(text, &[[6, 1, 1]]), Some(0.0));
    }

    #[test]
    fn an_alternative_of_one_building_is_a_template() {
        let text = "a : scope.sx > 4 --> split(x){ 1 : I(stone) | ~1 : I(dirt) }
                    a : scope.sx <= 4 --> split(x){ 1 : I(stone) | ~1 : I(glass) }";
        assert_eq!(share(text, &[[3, 1, 1], [4, 1, 1], [13, 1, 1]]), Some(13.0 / 20.0));
    }
}
