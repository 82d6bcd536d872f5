//! What a facade becomes: one wall, or the four sides of a building under a roof.

use super::Depth;
use super::emit::Emitted;
use crate::grammar::ast::{BinaryOp, Carving, Function, Selector};
use crate::graph::{Arg, Expr, NodeIndex, Number, Op, OpGraph, Size, Thing};
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
    Flat,
    Gable,
    Hip,
    Mansard,
    Pyramid,
}

impl Roof {
    fn name(self) -> &'static str {
        match self {
            Roof::Flat => "flat",
            Roof::Gable => "gable",
            Roof::Hip => "hip",
            Roof::Mansard => "mansard",
            Roof::Pyramid => "pyramid",
        }
    }
}

/// The graph of a facade of this size in a form.
pub fn formed(emitted: Emitted, form: Form, size: [u32; 3], depth: Depth) -> OpGraph {
    let root = emitted.root;
    match form {
        Form::Wall => emitted.finish(root, size),
        Form::Building(roof) => building(emitted, roof, size, depth),
    }
}

/// A parapet of one block and a floor behind it.
const FLAT: u32 = 2;

/// All four sides show the facade at its own width: the left and the right stand between the others.
fn building(mut emitted: Emitted, roof: Roof, [width, height, thick]: [u32; 3], depth: Depth) -> OpGraph {
    let facade = emitted.root;
    let out = depth.before;
    let size = [width + 2 * out, height, width + 2 * thick];
    let rise = match roof {
        Roof::Flat => FLAT,
        _ => (size[0].min(size[2]) - 2 * out).div_ceil(4) + 1,
    };
    let walls = walls(&mut emitted, facade, out, thick);
    let roof_node = roof_of(&mut emitted, roof, out);
    let builder = &mut emitted.builder;
    let parts = vec![(Size::floating(1.0), walls), (absolute(rise), roof_node)];
    let root = builder.split(Expr::Axis(Axis::Y), parts);
    let names = [(root, "building"), (walls, "walls"), (roof_node, "roof")];
    emitted.names.splice(0..0, names.map(|(node, name)| (node, name.to_owned(), Vec::new())));
    emitted.finish(root, [size[0], size[1] + rise, size[2]])
}

/// What stands out of the front and the back would stand out of the sides as well: there it is left off.
fn walls(emitted: &mut Emitted, facade: NodeIndex, out: u32, thick: u32) -> NodeIndex {
    let builder = &mut emitted.builder;
    let nil = builder.nil();
    let across = match out {
        0 => facade,
        _ => builder.split(
            Expr::Axis(Axis::X),
            vec![(absolute(out), nil), (Size::floating(1.0), facade), (absolute(out), nil)],
        ),
    };
    let floor = builder.primitive(Expr::name("oak_planks"));
    use crate::grammar::ast::Face;
    let parts = vec![
        (Arg::Part(Selector::On(vec![Face::Front])), across),
        (Arg::Part(Selector::On(vec![Face::Back])), across),
        (Arg::Part(Selector::On(vec![Face::Side])), facade),
    ];
    let _ = floor;
    builder.node(Op::Carve { how: Carving::Faces, args: vec![Expr::number(f64::from(thick))] }, parts)
}

fn roof_of(emitted: &mut Emitted, roof: Roof, out: u32) -> NodeIndex {
    let builder = &mut emitted.builder;
    let own = match roof {
        Roof::Flat => {
            let floor = builder.primitive(Expr::name("smooth_stone"));
            let parapet = builder.node(
                Op::Carve { how: Carving::Offset, args: vec![Expr::number(1.0)] },
                vec![(Arg::Part(Selector::Border), floor)],
            );
            builder.split(Expr::Axis(Axis::Y), vec![(absolute(1), floor), (Size::floating(1.0), parapet)])
        }
        _ => {
            let name = Expr::name(roof.name());
            let material = Some(Expr::Thing(Thing::Name("deepslate_tile".to_owned())));
            builder.node(Op::Primitive { name, material, options: Vec::new() }, Vec::new())
        }
    };
    let _ = (BinaryOp::Add, Function::Min, Number(0.0));
    match out {
        0 => own,
        _ => {
            let args = vec![Expr::number(f64::from(out))];
            builder.node(Op::Carve { how: Carving::Offset, args }, vec![(Arg::Part(Selector::Inside), own)])
        }
    }
}

fn absolute(blocks: u32) -> Size {
    Size::absolute(Expr::number(f64::from(blocks)))
}
