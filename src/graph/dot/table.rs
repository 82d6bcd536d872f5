//! A split as a table: how dense graphs are drawn.

use super::{arg_text, fill_colour, hex, id, is_dark, is_terminal, op_text, rhythm_mark};
use crate::graph::{Arg, Expr, Op, OpGraph};
use dot_writer::{Attributes, Scope};
use petgraph::graph::NodeIndex;

/// Draws a split as a table of its parts, with an edge from the cell of each that is no terminal.
pub fn draw(out: &mut Scope<'_, '_>, graph: &OpGraph, node: NodeIndex, params: &[String]) {
    let is_vertical =
        *graph.op(node) == Op::Split { axis: Expr::Axis(graph.up.axis()), snap: None, groups: Vec::new() };
    let cells: Vec<String> =
        graph.children(node).enumerate().map(|(at, part)| cell(graph, node, at, part, params)).collect();
    let rows = match is_vertical {
        // What is on top is drawn on top.
        true => cells.iter().rev().map(|cell| format!("<TR>{cell}</TR>")).collect(),
        false => format!("<TR>{}</TR>", cells.concat()),
    };
    let span = if is_vertical { 1 } else { cells.len() };
    let name = graph.name(node).map_or(String::new(), |name| format!("{}<BR/>", html(&name.label)));
    let title = format!("{name}{}", html(&op_text(graph, graph.op(node), params)));
    let table = format!(
        "<<TABLE BORDER=\"0\" CELLBORDER=\"1\" CELLSPACING=\"0\"><TR><TD COLSPAN=\"{span}\" BGCOLOR=\"#e1ecf4\">{title}</TD></TR>{rows}</TABLE>>"
    );
    out.node_named(id(node)).set("label", &table, false).set("shape", "plain", false).set("style", "", true);
    for (at, (_, child)) in
        graph.children(node).enumerate().filter(|(_, (_, child))| !is_terminal(graph, *child))
    {
        out.edge(format!("{}:c{at}", id(node)), id(child));
    }
}

/// A part of a split in its table: a terminal in the colour of its block, anything else as its size.
fn cell(
    graph: &OpGraph,
    node: NodeIndex,
    at: usize,
    (arg, child): (&Arg, NodeIndex),
    params: &[String],
) -> String {
    let size = html(&(arg_text(graph, arg, params, None) + rhythm_mark(graph.op(node), at)));
    if !is_terminal(graph, child) {
        return format!("<TD PORT=\"c{at}\">{size}</TD>");
    }
    let fill = fill_colour(graph, graph.op(child));
    let ink = if is_dark(fill) { "#ffffff" } else { "#222222" };
    let what = html(&op_text(graph, graph.op(child), params)).replace('[', "<BR/>[").replace(',', "<BR/>");
    format!("<TD BGCOLOR=\"{}\"><FONT COLOR=\"{ink}\">{size}<BR/>{what}</FONT></TD>", hex(fill))
}

fn html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
