//! What a facade becomes: one wall, or the four sides of a building under a roof.

use super::Depth;
use super::emit::Emitted;
use crate::grammar::ast::{Carving, Face, Selector};
use crate::graph::{Arg, Builder, Expr, NodeIndex, Op, OpGraph, Size, StartSize, Thing};
use crate::space::Axis;

/// What is made of a facade.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Form {
    #[default]
    Wall,
    /// The facade on all four sides.
    Building(Roof),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Roof {
    /// A floor with a parapet.
    Flat,
    Gable,
    Hip,
    Mansard,
    Pyramid,
}

impl Roof {
    /// The primitive that lays it.
    fn primitive(self) -> Option<&'static str> {
        match self {
            Roof::Flat => None,
            Roof::Gable => Some("gable"),
            Roof::Hip => Some("hip"),
            Roof::Mansard => Some("mansard"),
            Roof::Pyramid => Some("pyramid"),
        }
    }

    /// How many blocks it rises over a plan.
    fn rise(self, width: u32, length: u32) -> u32 {
        match self {
            Roof::Flat => 2,
            // A wide roof as steep as stairs would be higher than its house.
            _ => (width.min(length).div_ceil(2)).min(STEEP + width.min(length) / 6),
        }
    }
}

/// Roofs over narrow houses are as steep as stairs.
const STEEP: u32 = 6;

/// What roofs are made of, and floors and ceilings.
const TILES: &str = "deepslate_tile";
const FLOOR: &str = "smooth_stone";

/// The graph of facades in a form, for start scopes of their sizes.
pub fn formed(emitted: Emitted, form: Form, sizes: &[[u32; 3]], depth: Depth) -> OpGraph {
    let (mut graph, sizes) = match form {
        Form::Wall => {
            let root = emitted.root;
            (emitted.finish(root), sizes.to_vec())
        }
        Form::Building(roof) => building(emitted, roof, sizes, depth),
    };
    let start = |size: &[u32; 3]| StartSize {
        size: size.map(|length| Expr::number(f64::from(length))),
        weight: Expr::number(1.0),
    };
    graph.sizes = sizes.iter().map(start).collect();
    graph
}

/// All four sides show the facade at its own width: the left and the right stand between the others.
fn building(mut emitted: Emitted, roof: Roof, sizes: &[[u32; 3]], depth: Depth) -> (OpGraph, Vec<[u32; 3]>) {
    let (facade, out) = (emitted.root, depth.before);
    let thick = sizes.first().map_or(1, |size| size[2]);
    let plans = sizes.iter().map(|[width, height, _]| [width + 2 * out, *height, width + 2 * thick]);
    let plans: Vec<[u32; 3]> = plans.collect();
    let rises: Vec<u32> =
        plans.iter().map(|[width, _, length]| roof.rise(width - 2 * out, length - 2 * out)).collect();
    let rise = rises.iter().copied().max().unwrap_or(0);
    let walls = walls(&mut emitted.builder, facade, out, thick);
    let top = roof_over(&mut emitted.builder, roof, out);
    let parts = vec![(Size::floating(1.0), walls), (absolute(rise), top)];
    let root = emitted.builder.split(Expr::Axis(Axis::Y), parts);
    let names = [(root, "building"), (walls, "walls"), (top, "roof")];
    emitted.names.splice(0..0, names.map(|(node, name)| (node, name.to_owned(), Vec::new())));
    let sizes = plans.into_iter().map(|[width, height, length]| [width, height + rise, length]).collect();
    (emitted.finish(root), sizes)
}

/// The sides with a floor and a ceiling between them. What stands out of the front and the back would stand out at the
/// sides as well, and is left off there.
fn walls(builder: &mut Builder, facade: NodeIndex, out: u32, thick: u32) -> NodeIndex {
    let nil = builder.nil();
    let between = vec![(absolute(out), nil), (Size::floating(1.0), facade), (absolute(out), nil)];
    let across = if out == 0 { facade } else { builder.split(Expr::Axis(Axis::X), between) };
    let floor = builder.primitive(Expr::name(FLOOR));
    let inside = builder.split(
        Expr::Axis(Axis::Y),
        vec![(absolute(1), floor), (Size::floating(1.0), nil), (absolute(1), floor)],
    );
    let part = |face: Face, node: NodeIndex| (Arg::Part(Selector::On(vec![face])), node);
    let parts = vec![
        part(Face::Front, across),
        part(Face::Back, across),
        part(Face::Side, facade),
        (Arg::Part(Selector::Inside), inside),
    ];
    builder.node(Op::Carve { how: Carving::Faces, args: vec![Expr::number(f64::from(thick))] }, parts)
}

fn roof_over(builder: &mut Builder, roof: Roof, out: u32) -> NodeIndex {
    let own = match roof.primitive() {
        Some(name) => {
            let material = Some(Expr::Thing(Thing::Name(TILES.to_owned())));
            builder.node(Op::Primitive { name: Expr::name(name), material, options: Vec::new() }, Vec::new())
        }
        None => {
            let floor = builder.primitive(Expr::name(FLOOR));
            let border = vec![(Arg::Part(Selector::Border), floor)];
            let parapet =
                builder.node(Op::Carve { how: Carving::Offset, args: vec![Expr::number(1.0)] }, border);
            builder.split(Expr::Axis(Axis::Y), vec![(absolute(1), floor), (Size::floating(1.0), parapet)])
        }
    };
    if out == 0 {
        return own;
    }
    let inside = vec![(Arg::Part(Selector::Inside), own)];
    builder.node(Op::Carve { how: Carving::Offset, args: vec![Expr::number(f64::from(out))] }, inside)
}

fn absolute(blocks: u32) -> Size {
    Size::absolute(Expr::number(f64::from(blocks)))
}
