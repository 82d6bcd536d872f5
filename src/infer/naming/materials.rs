//! Constants for materials: what rules mention again and again is said once, at the head of the grammar.

use super::labels::is_name;
use super::roles::{Role, roles};
use super::rules::Rule;
use crate::graph::{Constant, Expr, Op, OpGraph, Thing};
use crate::infer::Example;
use std::collections::BTreeMap;

/// A role has constants for so many blocks: names of further ones would say less than the blocks' own.
const MOST: usize = 2;

/// Makes constants of the materials that the text of the rules mentions several times.
pub fn lift(graph: &mut OpGraph, rules: &[Rule], examples: &[Example]) {
    let grids = examples.iter().filter_map(|example| match example {
        Example::Blocks(grid) => Some(grid),
        Example::Boxes(_) => None,
    });
    let mentions = mentions(graph, rules);
    let often = |name: &String| mentions.get(name).is_some_and(|count| *count > 1);
    let mut known: Vec<(Role, u64, String)> =
        roles(grids).into_iter().map(|(name, (role, cells))| (role, cells, name)).collect();
    known.retain(|(.., name)| often(name));
    known.sort_by(|a, b| (a.0, b.1, &a.2).cmp(&(b.0, a.1, &b.2)));
    let mut constants: Vec<Constant> = Vec::new();
    for roles in known.chunk_by(|one, other| one.0 == other.0) {
        for (number, (role, _, block)) in roles.iter().take(MOST).enumerate() {
            let name = if number == 0 { role.word().to_owned() } else { format!("other_{}", role.word()) };
            let is_free = |name: &String| graph.constants.iter().all(|known| known.name != *name);
            if is_name(&name) && is_free(&name) {
                constants.push(Constant { name, value: Expr::name(block), attribute: None });
            }
        }
    }
    graph.name_blocks(constants);
}

/// How often the text mentions each block of the game, with any properties.
fn mentions(graph: &OpGraph, rules: &[Rule]) -> BTreeMap<String, usize> {
    let mut mentions = BTreeMap::new();
    for leaf in rules.iter().flat_map(|rule| &rule.leaves) {
        if let Op::Primitive { name: Expr::Thing(Thing::Name(text) | Thing::Block(text)), .. } =
            graph.op(*leaf)
        {
            let name = text.split_once('[').map_or(text.as_str(), |(name, _)| name);
            *mentions.entry(name.to_owned()).or_default() += 1;
        }
    }
    mentions
}
