use super::look::{Face, Look, Patch, STEPS};
use super::materials::Materials;
use super::quads::merged;
use crate::block::{BlockState, Facing, Rgba};
use crate::grid::Grid;
use crate::io::Lost;
use crate::space::Cell;
use rustc_hash::FxHashMap;
use std::fmt::Write;

/// A mesh and the materials that it names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ObjMesh {
    pub obj: String,
    pub mtl: String,
    /// What of the grid a mesh has no place for, beside the states of the blocks.
    pub lost: Vec<Lost>,
}

/// The outside of `grid` as a mesh, every block in its shape and in the colour that `color` gives it (sRGB). Faces
/// that a neighbour covers are left out; whole blocks are drawn together. One material per block name. `mtl_name` is
/// what the file of the materials will be called.
pub fn encode_obj_mesh(grid: &Grid, mtl_name: &str, color: impl Fn(&BlockState) -> Rgba) -> ObjMesh {
    let materials = Materials::of(grid, color);
    let looks = grid.palette().states().iter().map(|state| Look::of(state, &materials));
    let scene = Scene { grid, looks: looks.collect() };
    let mut mesh = Mesh::new(&materials);
    scene.draw_whole_blocks(&mut mesh);
    scene.draw_parts(&mut mesh);
    ObjMesh { obj: mesh.obj(mtl_name), mtl: materials.mtl(), lost: lost(grid) }
}

fn lost(grid: &Grid) -> Vec<Lost> {
    let lost = [
        Lost::block_entities(grid),
        Lost::entities(grid),
        Lost::biomes(grid),
        Lost::metadata(grid),
        Lost::own(grid, None),
        Lost::variants(grid),
    ];
    lost.into_iter().flatten().collect()
}

/// A grid with the looks of its palette numbers.
struct Scene<'a> {
    grid: &'a Grid,
    looks: Vec<Look>,
}

impl Scene<'_> {
    fn look(&self, cell: Cell) -> &Look {
        &self.looks[usize::from(self.grid.id(cell))]
    }

    /// Whether what the block at `cell` has on this side can be seen.
    fn is_seen(&self, cell: Cell, facing: Facing, patch: Patch, material: usize) -> bool {
        let neighbour = cell + facing.step();
        !self.grid.bounds().contains(neighbour)
            || !self.look(neighbour).hides(facing.opposite(), patch, material)
    }

    fn draw_whole_blocks(&self, mesh: &mut Mesh) {
        let face = |cell, facing| {
            let material = self.look(cell).whole?;
            self.is_seen(cell, facing, Patch::WHOLE, material).then_some(material)
        };
        for quad in merged(self.grid.bounds(), face) {
            mesh.add(quad.material, quad.corners.map(|corner| corner * STEPS));
        }
    }

    fn draw_parts(&self, mesh: &mut Mesh) {
        for cell in self.grid.bounds().cells() {
            let look = self.look(cell);
            if look.whole.is_some() {
                continue;
            }
            let seen = |face: &&Face| {
                face.patch.is_none_or(|patch| self.is_seen(cell, face.facing, patch, face.material))
            };
            for face in look.faces.iter().filter(seen) {
                mesh.add(face.material, face.corners.map(|corner| cell * STEPS + corner));
            }
        }
    }
}

/// Faces by their materials, with their corners in sixteenths of a block.
struct Mesh<'a> {
    materials: &'a Materials,
    /// Each once.
    points: Vec<Cell>,
    numbers: FxHashMap<Cell, usize>,
    faces: Vec<String>,
}

impl Mesh<'_> {
    fn new(materials: &Materials) -> Mesh<'_> {
        let faces = vec![String::new(); materials.len()];
        Mesh { materials, points: Vec::new(), numbers: FxHashMap::default(), faces }
    }

    fn add(&mut self, material: usize, corners: [Cell; 4]) {
        let [a, b, c, d] = corners.map(|corner| self.number(corner));
        // Writing into a text cannot fail.
        let _ = writeln!(self.faces[material], "f {a} {b} {c} {d}");
    }

    /// The number of `point`, from 1.
    fn number(&mut self, point: Cell) -> usize {
        *self.numbers.entry(point).or_insert_with(|| {
            self.points.push(point);
            self.points.len()
        })
    }

    fn obj(&self, mtl_name: &str) -> String {
        let mut text = format!("mtllib {mtl_name}\n");
        for point in &self.points {
            let [x, y, z] = point.to_array().map(|n| f64::from(n) / f64::from(STEPS));
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for (material, faces) in self.faces.iter().enumerate().filter(|(_, faces)| !faces.is_empty()) {
            text += &format!("usemtl {}\n{faces}", self.materials.name(material));
        }
        text
    }
}
