//! The rules of a shape grammar as a graph in Graphviz's language.

use super::grammar::ShapeGrammar;
use std::collections::BTreeMap;
use std::fmt::Write;

/// A node for each form, in the colour that pictures give it, with how many shapes have it; an edge for each two forms of which
/// rules put one beside the other, with how many rules do.
pub fn dot(grammar: &ShapeGrammar, color: impl Fn(usize) -> [u8; 3]) -> String {
    let counts = grammar.parts.counts();
    let mut text = String::from("digraph shapes {\n  node [shape=box style=filled fontname=\"sans-serif\"]\n");
    for (form, count) in counts.iter().enumerate() {
        let [red, green, blue] = color(form);
        let label = label(grammar, form, *count);
        let _ = writeln!(text, "  s{form} [label=\"{label}\" fillcolor=\"#{red:02x}{green:02x}{blue:02x}\"]");
    }
    let mut edges: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    grammar.rules.iter().for_each(|rule| *edges.entry((rule.left, rule.right)).or_default() += 1);
    for ((left, right), rules) in edges {
        let label = if rules > 1 { format!(" [label=\"{rules}\"]") } else { String::new() };
        let _ = writeln!(text, "  s{left} -> s{right}{label}");
    }
    text + "}\n"
}

/// A form in words: how many shapes have it, its size, and the block that it has most of.
fn label(grammar: &ShapeGrammar, form: usize, count: usize) -> String {
    let blocks = &grammar.parts.forms[form].blocks;
    let size = blocks.iter().fold([0; 3], |size: [i32; 3], (cell, _)| std::array::from_fn(|axis| size[axis].max(cell[axis] + 1)));
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for (_, state) in blocks {
        *kinds.entry(grammar.parts.states.get(*state).short_name()).or_default() += 1;
    }
    let most = kinds.iter().rev().max_by_key(|(_, count)| **count).map_or("", |(name, _)| name);
    let times = if count > 1 { format!("{count} x ") } else { String::new() };
    let more = if kinds.len() > 1 { format!(" and {} more", kinds.len() - 1) } else { String::new() };
    format!("{times}{}x{}x{}\\n{most}{more}", size[0], size[1], size[2])
}
