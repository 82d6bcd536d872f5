//! The rules of a shape grammar as a graph in Graphviz's language.

use super::grammar::ShapeGrammar;
use super::paint::color;
use dot_writer::{Attributes, DotWriter, Scope};
use std::collections::BTreeMap;

/// A node for each form, in the colour that pictures give it, with how many shapes have it; an edge for each two forms of which
/// rules put one beside the other, with how many rules do.
pub fn dot(grammar: &ShapeGrammar) -> String {
    let mut bytes = Vec::new();
    {
        let mut writer = DotWriter::from(&mut bytes);
        writer.set_pretty_print(true);
        let mut digraph = writer.digraph();
        digraph.node_attributes().set_font("Helvetica").set_font_size(11.0).set("shape", "box", false).set(
            "style",
            "filled,rounded",
            true,
        );
        digraph.edge_attributes().set_font("Helvetica").set_font_size(9.0).set("color", "#777777", true);
        nodes(&mut digraph, grammar);
        edges(&mut digraph, grammar);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn nodes(digraph: &mut Scope<'_, '_>, grammar: &ShapeGrammar) {
    for (form, count) in grammar.parts.counts().into_iter().enumerate() {
        let [red, green, blue] = color(form);
        let mut node = digraph.node_named(format!("s{form}"));
        node.set_label(&label(grammar, form, count));
        node.set("fillcolor", &format!("#{red:02x}{green:02x}{blue:02x}"), true);
    }
}

fn edges(digraph: &mut Scope<'_, '_>, grammar: &ShapeGrammar) {
    let mut edges: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    grammar.rules.iter().for_each(|rule| *edges.entry((rule.left, rule.right)).or_default() += 1);
    for ((left, right), rules) in edges {
        let edge = digraph.edge(format!("s{left}"), format!("s{right}"));
        if rules > 1 {
            edge.attributes().set_label(&rules.to_string());
        }
    }
}

/// A form in words: how many shapes have it, its size, and the block that it has most of.
fn label(grammar: &ShapeGrammar, form: usize, count: usize) -> String {
    let blocks = &grammar.parts.forms[form].blocks;
    let far = |far: [i32; 3], (cell, _): &([i32; 3], u32)| {
        std::array::from_fn(|axis| far[axis].max(cell[axis] + 1))
    };
    let [x, y, z] = blocks.iter().fold([0; 3], far);
    let mut kinds: BTreeMap<&str, usize> = BTreeMap::new();
    for (_, state) in blocks {
        *kinds.entry(grammar.parts.states.get(*state).short_name()).or_default() += 1;
    }
    let most = kinds.iter().rev().max_by_key(|(_, count)| **count).map_or("", |(name, _)| name);
    let times = if count > 1 { format!("{count} of ") } else { String::new() };
    let more = if kinds.len() > 1 { format!(" and {} more", kinds.len() - 1) } else { String::new() };
    format!("{times}{x} x {y} x {z}\\n{most}{more}")
}
