use super::quads::{Quad, outside};
use crate::block::BlockState;
use crate::grid::Grid;
use crate::space::Cell;
use rustc_hash::FxHashMap;

/// A mesh and the materials that it names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ObjMesh {
    pub obj: String,
    pub mtl: String,
}

/// The outside of `grid` as a mesh, every block a cube in the colour that `color` gives it (sRGB).
/// One material per block name. `mtl_name` is what the file of the materials will be called.
pub fn encode_obj_mesh(grid: &Grid, mtl_name: &str, color: impl Fn(&BlockState) -> [u8; 3]) -> ObjMesh {
    let materials = Materials::of(grid, color);
    let quads = outside(grid.bounds(), |cell| materials.by_id[usize::from(grid.id(cell))]);
    let mut vertices = Vertices::default();
    let faces = faces(&materials, &quads, &mut vertices);
    let points = vertices.points.iter().map(|Cell { x, y, z }| format!("v {x} {y} {z}\n"));
    ObjMesh {
        obj: format!("mtllib {mtl_name}\n{}{faces}", points.collect::<String>()),
        mtl: materials.named.iter().map(|(name, color)| mtl(name, *color)).collect(),
    }
}

/// The materials in order of name, and which one each palette number has; air has none.
struct Materials {
    named: Vec<(String, [u8; 3])>,
    by_id: Vec<Option<usize>>,
}

impl Materials {
    fn of(grid: &Grid, color: impl Fn(&BlockState) -> [u8; 3]) -> Materials {
        let states = grid.palette().states();
        let mut visible: Vec<&BlockState> = states.iter().filter(|state| !is_nothing(state)).collect();
        visible.sort_unstable();
        visible.dedup_by_key(|state| state.name());
        let find =
            |state: &BlockState| visible.binary_search_by_key(&state.name(), |found| found.name()).ok();
        Materials {
            by_id: states.iter().map(|state| if is_nothing(state) { None } else { find(state) }).collect(),
            named: visible.iter().map(|state| (state.short_name().to_owned(), color(state))).collect(),
        }
    }
}

fn is_nothing(state: &BlockState) -> bool {
    ["air", "cave_air", "void_air", "structure_void"].contains(&state.short_name())
}

/// Points by number, each once.
#[derive(Default)]
struct Vertices {
    points: Vec<Cell>,
    numbers: FxHashMap<Cell, usize>,
}

impl Vertices {
    /// The number of `point`, from 1.
    fn number(&mut self, point: Cell) -> usize {
        *self.numbers.entry(point).or_insert_with(|| {
            self.points.push(point);
            self.points.len()
        })
    }
}

fn faces(materials: &Materials, quads: &[Quad], vertices: &mut Vertices) -> String {
    let mut by_material = vec![String::new(); materials.named.len()];
    for quad in quads {
        let [a, b, c, d] = quad.corners.map(|corner| vertices.number(corner));
        by_material[quad.material] += &format!("f {a} {b} {c} {d}\n");
    }
    let used = materials.named.iter().zip(by_material).filter(|(_, faces)| !faces.is_empty());
    used.map(|((name, _), faces)| format!("usemtl {name}\n{faces}")).collect()
}

fn mtl(name: &str, color: [u8; 3]) -> String {
    let [red, green, blue] = color.map(|channel| f64::from(channel) / 255.0);
    format!("newmtl {name}\nKd {red:.4} {green:.4} {blue:.4}\n")
}
