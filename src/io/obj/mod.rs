//! Wavefront OBJ: labelled boxes both ways, and grids as coloured meshes out.

mod boxes;
mod error;
mod look;
mod materials;
mod mesh;
mod model;
mod parse;
mod quads;
mod scale;

pub use boxes::{decode_obj_boxes, encode_obj_boxes};
pub use error::{ObjError, ObjProblem};
pub use mesh::{ObjMesh, encode_obj_mesh};
pub use model::{ObjModel, PlacedModel, decode_obj_model, encode_obj_models};
pub use scale::Scale;
