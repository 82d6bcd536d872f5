//! The op graph as a Graphviz diagram, for people.

mod table;

use super::raise::raise_expr;
use super::{Arg, Expr, Op, OpGraph, Size};
use crate::block::{self, BlockState};
use crate::grammar::ast::{Rule, SizeKind, Snap};
use dot_writer::{Attributes, DotWriter, Scope};
use petgraph::graph::NodeIndex;
use std::collections::{BTreeMap, BTreeSet};

/// The graph in the dot language: the operation and its parameters in each node, under the rule's name;
/// sizes, faces and weights on the edges; terminals in the colour of their block. Equal operations are
/// one node, and edges between the same two nodes are drawn as one.
///
/// A graph of more than [`CROWDED`] operations shows a split as a row of cells with their sizes, or a pile of
/// them where it splits the vertical: terminals as coloured cells, everything else as an edge from its cell.
/// Drawn apart, a hundred splits that share a dozen blocks are a tangle that nobody reads.
pub fn dot(graph: &OpGraph) -> String {
    let graph = graph.unified();
    let params = params_in_scope(&graph);
    let is_table: Vec<bool> = graph
        .nodes()
        .map(|node| graph.len() > CROWDED && matches!(graph.op(node), Op::Split { .. }))
        .collect();
    let drawn = drawn_nodes(&graph, &is_table);
    let mut bytes = Vec::new();
    {
        let mut writer = DotWriter::from(&mut bytes);
        writer.set_pretty_print(true);
        let mut digraph = writer.digraph();
        digraph.graph_attributes().set("ordering", "out", false).set("ranksep", "0.6", false);
        digraph.node_attributes().set_font("Helvetica").set_font_size(11.0).set(
            "style",
            "filled,rounded",
            true,
        );
        digraph.edge_attributes().set_font("Helvetica").set_font_size(9.0).set("color", "#777777", true);
        for node in drawn {
            let params = &params[node.index()];
            if is_table[node.index()] {
                table::draw(&mut digraph, &graph, node, params);
            } else {
                draw_node(&mut digraph, &graph, node, params);
                draw_edges(&mut digraph, &graph, node, params);
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Graphs with more operations than this are drawn densely.
pub const CROWDED: usize = 60;

fn is_terminal(graph: &OpGraph, node: NodeIndex) -> bool {
    matches!(graph.op(node), Op::Primitive { .. } | Op::Nil)
}

/// The nodes that are drawn: all but the terminals that only stand in tables.
fn drawn_nodes(graph: &OpGraph, is_table: &[bool]) -> BTreeSet<NodeIndex> {
    let mut drawn = BTreeSet::from([graph.root()]);
    let mut open = vec![graph.root()];
    while let Some(node) = open.pop() {
        let children = graph.children(node).map(|(_, child)| child);
        let shown = children.filter(|child| !is_table[node.index()] || !is_terminal(graph, *child));
        open.extend(shown.filter(|child| drawn.insert(*child)));
    }
    drawn
}

fn id(node: NodeIndex) -> String {
    format!("n{}", node.index())
}

fn draw_node(out: &mut Scope<'_, '_>, graph: &OpGraph, node: NodeIndex, params: &[String]) {
    let mut label = escaped(&op_text(graph, graph.op(node), params));
    if let Some(name) = graph.name(node) {
        let args =
            if name.params.is_empty() { String::new() } else { format!("({})", name.params.join(", ")) };
        label = format!("{}\\n{label}", escaped(&format!("{}{args}", name.label)));
    }
    let fill = fill_colour(graph, graph.op(node));
    let ink = if is_dark(fill) { "#ffffff" } else { "#222222" };
    let mut drawn = out.node_named(id(node));
    drawn.set("label", &label, true).set("fillcolor", &hex(fill), true).set("fontcolor", ink, true).set(
        "shape",
        if *graph.op(node) == Op::Choose { "ellipse" } else { "box" },
        false,
    );
    if node == graph.root() {
        drawn.set_pen_width(2.5);
    }
}

fn draw_edges(out: &mut Scope<'_, '_>, graph: &OpGraph, node: NodeIndex, params: &[String]) {
    let mut drawn: Vec<(NodeIndex, Vec<String>)> = Vec::new();
    let total = total_weight(graph, node);
    for (at, (arg, child)) in graph.children(node).enumerate() {
        let text = arg_text(graph, arg, params, total) + rhythm_mark(graph.op(node), at);
        match drawn.iter_mut().find(|(known, _)| *known == child) {
            Some((_, texts)) => texts.push(text),
            None => drawn.push((child, vec![text])),
        }
    }
    for (child, texts) in drawn {
        let label = escaped(&joined(&texts));
        let mut edge = out.edge(id(node), id(child)).attributes();
        edge.set("label", &label, true);
        // Empty space is everywhere; its edges should not hide the others.
        if *graph.op(child) == Op::Nil {
            edge.set("color", "#d5d5d5", true).set("fontcolor", "#999999", true).set(
                "arrowhead",
                "none",
                false,
            );
        }
    }
}

/// A text as a quoted label has it.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"")
}

/// The labels of parallel edges: equal ones with their number, many in short.
fn joined(texts: &[String]) -> String {
    const SHOWN: usize = 4;
    let mut counted: Vec<(&str, usize)> = Vec::new();
    for text in texts.iter().filter(|text| !text.is_empty()) {
        match counted.iter_mut().find(|(known, _)| known == text) {
            Some((_, count)) => *count += 1,
            None => counted.push((text, 1)),
        }
    }
    let mut parts: Vec<String> = counted
        .iter()
        .take(SHOWN)
        .map(|(text, count)| if *count > 1 { format!("{text} ×{count}") } else { (*text).to_owned() })
        .collect();
    if counted.len() > SHOWN {
        parts.push(format!("… {} more", counted.len() - SHOWN));
    }
    parts.join(", ")
}

fn op_text(graph: &OpGraph, op: &Op, params: &[String]) -> String {
    let text = |expr: &Expr| raise_expr(graph, expr, params).to_string();
    let list = |sizes: &[Size; 3]| {
        sizes.iter().map(|size| size_text(graph, size, params)).collect::<Vec<_>>().join(", ")
    };
    match op {
        Op::Primitive { name, material, options } => {
            let made_of = material.as_ref().map(|material| match material {
                Expr::Constant(at) => text(&graph.constants[*at].value),
                material => text(material),
            });
            let made_of = made_of.map_or(String::new(), |material| format!(" of {material}"));
            let options = options.iter().map(|(option, value)| format!(", {option} {}", text(value)));
            format!("{}{made_of}{}", text(name), options.collect::<String>())
        }
        Op::Nil => "nil".to_owned(),
        Op::All => "all".to_owned(),
        Op::Split { axis, snap, .. } => format!("split {}{}", text(axis), snaps(snap)),
        Op::Repeat { axis, size, snap } => {
            format!("repeat {} every {}{}", text(axis), text(size), snaps(snap))
        }
        Op::RepeatN { axis, count } => format!("repeat {} {} times", text(axis), text(count)),
        Op::Carve { how, args } => {
            let args: Vec<String> = args.iter().map(text).collect();
            format!("{} {}", how.head().replace('(', " "), args.join(", ")).trim_end().to_owned()
        }
        Op::Translate(delta) => format!("T {}", list(delta)),
        Op::Resize(size) => format!("S {}", list(size)),
        Op::Rotate { axis, angle } => format!("R {} {}", text(axis), text(angle)),
        Op::Local => "local".to_owned(),
        Op::Same(key) => format!("same {}", text(key)),
        Op::Style(at) => format!("style {}", graph.styles.get(*at).map_or("", |style| &style.name)),
        Op::Snap { axis, label } => {
            format!("snap {} {}", text(axis), label.as_deref().unwrap_or("")).trim_end().to_owned()
        }
        Op::Shape(label) => format!("shape {label}"),
        Op::Choose => "choose".to_owned(),
        Op::Call(args) => format!("call ({})", args.iter().map(text).collect::<Vec<_>>().join(", ")),
    }
}

fn snaps(snap: &Option<Snap>) -> String {
    match snap {
        None => String::new(),
        Some(Snap { label: None }) => " to planes".to_owned(),
        Some(Snap { label: Some(label) }) => format!(" to {label}"),
    }
}

fn size_text(graph: &OpGraph, size: &Size, params: &[String]) -> String {
    let sign = match size.kind {
        SizeKind::Absolute => "",
        SizeKind::Floating => "~",
        SizeKind::Relative => "'",
    };
    format!("{sign}{}", raise_expr(graph, &size.value, params))
}

fn arg_text(graph: &OpGraph, arg: &Arg, params: &[String], total: Option<f64>) -> String {
    match arg {
        Arg::None => String::new(),
        Arg::Size(size) => size_text(graph, size, params),
        Arg::Part(selector) => selector.to_string(),
        Arg::Alternative(alternative) => {
            let weight = match (&alternative.weight, total) {
                (Expr::Number(weight), Some(total)) => format!("{:.0} %", 100.0 * weight.0 / total),
                (weight, _) => raise_expr(graph, weight, params).to_string(),
            };
            let level = match alternative.priority {
                Rule::FIRST => String::new(),
                priority => format!(" at {priority}"),
            };
            let condition = alternative.condition.as_ref();
            let condition = condition
                .map_or(String::new(), |condition| format!(" if {}", raise_expr(graph, condition, params)));
            format!("{weight}{condition}{level}")
        }
    }
}

/// The sum of the weights of a choice, where they are numbers and nothing else decides.
fn total_weight(graph: &OpGraph, node: NodeIndex) -> Option<f64> {
    graph
        .children(node)
        .map(|(arg, _)| match arg {
            Arg::Alternative(alternative) if alternative.condition.is_none() => match alternative.weight {
                Expr::Number(weight) => Some(weight.0),
                _ => None,
            },
            _ => None,
        })
        .sum::<Option<f64>>()
        .filter(|total| *total > 0.0)
}

fn rhythm_mark(op: &Op, at: usize) -> &'static str {
    match op {
        Op::Split { groups, .. } if groups.iter().any(|group| group.children.contains(&at)) => "*",
        _ => "",
    }
}

/// The names of the parameters that each node's expressions can use.
fn params_in_scope(graph: &OpGraph) -> Vec<Vec<String>> {
    let mut params: Vec<Vec<String>> = vec![Vec::new(); graph.len()];
    let named: BTreeMap<NodeIndex, Vec<String>> = graph
        .nodes()
        .filter_map(|node| Some((node, graph.name(node)?.params.clone())))
        .filter(|(_, params)| !params.is_empty())
        .collect();
    for (start, names) in named {
        let mut todo = vec![start];
        while let Some(node) = todo.pop() {
            if params[node.index()].is_empty() {
                params[node.index()] = names.clone();
                let is_call = matches!(graph.op(node), Op::Call(_));
                todo.extend(graph.children(node).map(|(_, child)| child).filter(|_| !is_call));
            }
        }
    }
    params
}

type Rgb = [u8; 3];

fn fill_colour(graph: &OpGraph, op: &Op) -> Rgb {
    match op {
        Op::Primitive { name, material, .. } => {
            let made_of = material.as_ref().unwrap_or(name);
            let [r, g, b, _] =
                block_of(graph, made_of).map_or([200, 200, 200, 255], |state| block::color(&state).0);
            [r, g, b]
        }
        Op::Nil => [255, 255, 255],
        Op::Choose => [255, 236, 179],
        Op::Split { .. } => [225, 236, 244],
        Op::Repeat { .. } | Op::RepeatN { .. } => [220, 240, 222],
        _ => [238, 232, 245],
    }
}

/// The block that a primitive is made of, where the text alone tells.
fn block_of(graph: &OpGraph, expr: &Expr) -> Option<BlockState> {
    match expr {
        Expr::Constant(at) => block_of(graph, &graph.constants.get(*at)?.value),
        Expr::Thing(thing) => thing.block(),
        Expr::State(base, _) => block_of(graph, base),
        _ => None,
    }
}

fn is_dark([r, g, b]: Rgb) -> bool {
    u32::from(r) * 299 + u32::from(g) * 587 + u32::from(b) * 114 < 128_000
}

fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
