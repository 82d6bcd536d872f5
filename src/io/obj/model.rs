//! Meshes of any form, which stand in place of blocks: vertices and faces, without textures and normals.

use super::parse::{coordinates, split, without_comment};
use super::{ObjError, ObjProblem};
use crate::space::{Bounds, Turn};
use std::fmt::Write;

/// A mesh that fills the unit cube: x to the right, y up, z to who looks at it.
#[derive(Clone, PartialEq, Debug)]
pub struct ObjModel {
    vertices: Vec<[f64; 3]>,
    /// Numbers of vertices, from 0.
    faces: Vec<Vec<usize>>,
}

/// A mesh stretched to a box.
#[derive(Clone, PartialEq, Debug)]
pub struct PlacedModel<'m> {
    pub name: String,
    pub model: &'m ObjModel,
    /// The material that its faces have; none where it is empty.
    pub material: String,
    pub bounds: Bounds,
    pub turn: Turn,
}

/// The mesh of an OBJ text, scaled to the unit cube; flat ones stay flat.
///
/// # Errors
///
/// Where a number or a vertex is wrong, with its line, or there is no face.
pub fn decode_obj_model(bytes: &[u8]) -> Result<ObjModel, ObjError> {
    let text = String::from_utf8_lossy(bytes);
    let mut model = ObjModel { vertices: Vec::new(), faces: Vec::new() };
    for (number, line) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
        let (keyword, rest) = split(without_comment(line));
        let at = |problem| ObjError { line: number, problem };
        match keyword {
            "v" => model.vertices.push(coordinates(rest).map_err(at)?),
            "f" => {
                let corners = rest.split_whitespace().map(|corner| vertex(corner, model.vertices.len()));
                model.faces.push(corners.collect::<Result<_, _>>().map_err(at)?);
            }
            _ => {}
        }
    }
    match model.faces.iter().any(|face| face.len() > 2) {
        true => Ok(model.scaled()),
        false => Err(ObjError { line: text.lines().count(), problem: ObjProblem::NoFace }),
    }
}

/// The number of a vertex from 0: from 1 in files, or from -1 backwards.
fn vertex(corner: &str, count: usize) -> Result<usize, ObjProblem> {
    let number = corner.split('/').next().unwrap_or_default();
    let number: i64 = number.parse().map_err(|_| ObjProblem::Number(corner.to_owned()))?;
    let at = if number > 0 { number - 1 } else { count as i64 + number };
    let found = usize::try_from(at).ok().filter(|at| *at < count && number != 0);
    found.ok_or_else(|| ObjProblem::Vertex(number.to_string(), count))
}

impl ObjModel {
    fn scaled(mut self) -> ObjModel {
        for axis in 0..3 {
            let own = || self.vertices.iter().map(|vertex| vertex[axis]);
            let (low, high) = (own().fold(f64::INFINITY, f64::min), own().fold(f64::NEG_INFINITY, f64::max));
            let length = if high > low { high - low } else { 1.0 };
            self.vertices.iter_mut().for_each(|vertex| vertex[axis] = (vertex[axis] - low) / length);
        }
        self
    }
}

impl PlacedModel<'_> {
    fn place(&self, [u, v, w]: [f64; 3]) -> [f64; 3] {
        // Where a vertex is from the low corner, as seen by the world: quarter turns are counter-clockwise.
        let (x, z) = match self.turn.count() {
            0 => (u, w),
            1 => (w, 1.0 - u),
            2 => (1.0 - u, 1.0 - w),
            _ => (1.0 - w, u),
        };
        let size = self.bounds.size();
        [
            f64::from(self.bounds.min.x) + x * f64::from(size.x),
            f64::from(self.bounds.min.y) + v * f64::from(size.y),
            f64::from(self.bounds.min.z) + z * f64::from(size.z),
        ]
    }
}

/// The text of meshes, for the end of an OBJ file: its vertices are numbered from the end, so whatever stands before does
/// not matter.
pub fn encode_obj_models(models: &[PlacedModel<'_>]) -> String {
    let mut text = String::new();
    for (number, placed) in models.iter().enumerate() {
        // Writing into a text cannot fail.
        let _ = writeln!(text, "o {}_{}", placed.name, number + 1);
        for vertex in &placed.model.vertices {
            let [x, y, z] = placed.place(*vertex);
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        if !placed.material.is_empty() {
            let _ = writeln!(text, "usemtl {}", placed.material);
        }
        let count = placed.model.vertices.len() as i64;
        for face in &placed.model.faces {
            let corners: Vec<String> = face.iter().map(|at| (*at as i64 - count).to_string()).collect();
            let _ = writeln!(text, "f {}", corners.join(" "));
        }
    }
    text
}
