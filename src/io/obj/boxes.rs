use super::parse::{Model, Vertex, parse};
use super::quads::{CORNERS, FACES};
use super::{ObjError, ObjProblem, Scale};
use crate::grid::{LabelledBox, LabelledBoxes};
use crate::space::{Axis, Bounds, Cell};

/// The bounding boxes of the objects of an OBJ file, in whole blocks.
pub fn decode_obj_boxes(bytes: &[u8], scale: Scale) -> Result<LabelledBoxes, ObjError> {
    let model = parse(&String::from_utf8_lossy(bytes))?;
    let mut boxes = Vec::new();
    for (index, object) in model.objects.iter().enumerate() {
        let vertices = model.vertices_of(index)?;
        // A group within an object leaves the line of the object without content.
        let Some(bounds) = bounds(&model, &vertices, scale)? else { continue };
        if let Some(axis) = Axis::ALL.into_iter().find(|&axis| bounds.len(axis) == 0) {
            let problem = ObjProblem::Flat(object.label.clone(), axis);
            return Err(ObjError { line: object.line, problem });
        }
        boxes.push(LabelledBox { label: object.label.clone(), bounds });
    }
    LabelledBoxes::new(boxes).ok_or(ObjError { line: 1, problem: ObjProblem::NoObject })
}

fn bounds(model: &Model, vertices: &[usize], scale: Scale) -> Result<Option<Bounds>, ObjError> {
    let mut bounds: Option<Bounds> = None;
    for &vertex in vertices {
        let at = snap(model, &model.vertices[vertex], scale)?;
        let corner = Bounds::new(at, at);
        bounds = Some(bounds.map_or(corner, |bounds| bounds.union(&corner)));
    }
    Ok(bounds)
}

fn snap(model: &Model, vertex: &Vertex, scale: Scale) -> Result<Cell, ObjError> {
    let all = || model.vertices.iter().flat_map(|vertex| vertex.at).collect();
    let snap = |value| scale.snap(value, all).map_err(|problem| ObjError { line: vertex.line, problem });
    let [x, y, z] = vertex.at;
    Ok(Cell::new(snap(x)?, snap(y)?, snap(z)?))
}

/// An OBJ file with one object for each box, in whole blocks.
pub fn encode_obj_boxes(boxes: &[LabelledBox]) -> String {
    boxes.iter().enumerate().map(|(index, labelled)| object(labelled, index * CORNERS.len())).collect()
}

/// `above` vertices stand above the object in its file.
fn object(labelled: &LabelledBox, above: usize) -> String {
    let Bounds { min, .. } = labelled.bounds;
    let size = labelled.bounds.size();
    let vertices = CORNERS.map(|corner| {
        let Cell { x, y, z } = min + size * corner;
        format!("v {x} {y} {z}\n")
    });
    let faces = FACES.map(|face| {
        let [a, b, c, d] = face.map(|corner| above + corner + 1);
        format!("f {a} {b} {c} {d}\n")
    });
    format!("o {}\n{}{}", word(&labelled.label), vertices.concat(), faces.concat())
}

/// A label that stays one line and no comment.
fn word(label: &str) -> String {
    let kept = |c: char| if c.is_control() || c.is_whitespace() || c == '#' { '_' } else { c };
    label.chars().map(kept).collect()
}
