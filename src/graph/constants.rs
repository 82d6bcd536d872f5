//! Blocks under names: a constant says once what many primitives place.

use super::{Constant, Expr, Op, OpGraph, Thing};

impl OpGraph {
    /// Adds constants that stand for blocks. Every primitive of such a block, with any properties, names its constant
    /// from then on.
    pub fn name_blocks(&mut self, constants: Vec<Constant>) {
        let first = self.constants.len();
        let names: Vec<Option<String>> = constants.iter().map(|known| bare_name(&known.value)).collect();
        self.constants.extend(constants);
        let constant = |name: &str| {
            let at = names.iter().position(|known| known.as_deref() == Some(name))?;
            Some(Expr::Constant(first + at))
        };
        self.change_primitives(|name| match name {
            Expr::Thing(Thing::Name(block)) => constant(block),
            Expr::Thing(Thing::Block(text)) => {
                let (block, properties) = text.strip_suffix(']')?.split_once('[')?;
                Some(Expr::State(Box::new(constant(block)?), properties.to_owned()))
            }
            _ => None,
        });
    }

    /// The same graph without the constants that only stand for a block: the blocks stand where they are named.
    pub fn spelled_out(&self) -> OpGraph {
        let mut plain = self.clone();
        let is_styled = |at| self.styles.iter().flat_map(|style| &style.values).any(|(own, _)| *own == at);
        let block = |at: usize| match &self.constants.get(at)?.value {
            Expr::Thing(thing) if !is_styled(at) => Some(thing.clone()),
            _ => None,
        };
        plain.change_primitives(|name| match name {
            Expr::Constant(at) => block(*at).map(Expr::Thing),
            Expr::State(base, properties) => match **base {
                Expr::Constant(at) => Some(Expr::Thing(block(at)?.with(properties))),
                _ => None,
            },
            _ => None,
        });
        plain
    }

    /// Puts in what `change` makes of the name of each primitive.
    fn change_primitives(&mut self, change: impl Fn(&Expr) -> Option<Expr>) {
        for op in self.graph.node_weights_mut() {
            if let Op::Primitive { name, .. } = op
                && let Some(changed) = change(name)
            {
                *name = changed;
            }
        }
    }
}

fn bare_name(value: &Expr) -> Option<String> {
    match value {
        Expr::Thing(Thing::Name(name)) => Some(name.clone()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grammar::read;
    use crate::graph::lower;

    fn graph(text: &str) -> OpGraph {
        lower(&read(text).unwrap(), None).unwrap()
    }

    #[test]
    fn blocks_are_named_and_spelled_out_again() {
        let plain =
            graph("a --> split(x){ 1 : I(oak_stairs) | 1 : I(oak_stairs[facing=east]) | ~1 : I(stone) }");
        let mut named = plain.clone();
        let stairs = Constant { name: "stairs".to_owned(), value: Expr::name("oak_stairs"), attribute: None };
        named.name_blocks(vec![stairs.clone()]);
        let text = "stairs = oak_stairs
            a --> split(x){ 1 : I(stairs) | 1 : I(stairs[facing=east]) | ~1 : I(stone) }";
        assert_eq!(named, graph(text));
        assert_eq!(named.spelled_out(), OpGraph { constants: vec![stairs], ..plain });
    }

    #[test]
    fn what_a_style_changes_stays_named() {
        let styled = graph("wood = oak_planks\nstyle dark { wood = dark_oak_planks }\na --> I(wood)");
        assert_eq!(styled.spelled_out(), styled);
    }
}
