use super::ast::{Constant, Ident};
use crate::space::Axis;

/// What a name in an expression stands for. Parameters hide constants, constants hide the rest.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Name {
    /// By its place among the rule's parameters.
    Param(usize),
    /// By its place in the file.
    Constant(usize),
    Axis(Axis),
    Number(f64),
    /// A block, a material or a primitive.
    Thing,
}

/// The names that are in scope at one place.
#[derive(Clone, Copy)]
pub struct Names<'g> {
    pub params: &'g [Ident],
    pub constants: &'g [Constant],
}

impl Names<'_> {
    pub fn resolve(&self, name: &str) -> Name {
        if let Some(at) = self.params.iter().position(|param| param.name == name) {
            return Name::Param(at);
        }
        if let Some(at) = self.constants.iter().position(|constant| constant.name.name == name) {
            return Name::Constant(at);
        }
        match name {
            "x" => Name::Axis(Axis::X),
            "y" => Name::Axis(Axis::Y),
            "z" => Name::Axis(Axis::Z),
            "pi" => Name::Number(std::f64::consts::PI),
            "true" => Name::Number(1.0),
            "false" => Name::Number(0.0),
            // What an occlusion query may find.
            "none" => Name::Number(0.0),
            "part" => Name::Number(1.0),
            "full" => Name::Number(2.0),
            _ => Name::Thing,
        }
    }
}

/// Whether a file that a grammar names is a mesh, which stands in models and not among blocks.
pub fn is_mesh(file: &str) -> bool {
    file.get(file.len().saturating_sub(4)..).is_some_and(|ending| ending.eq_ignore_ascii_case(".obj"))
}

/// The operations that have braces.
pub const OPERATIONS: [&str; 18] = [
    "split",
    "repeat",
    "repeatN",
    "T",
    "S",
    "R",
    "comp",
    "setback",
    "offset",
    "local",
    "same",
    "style",
    "shapeL",
    "shapeU",
    "shapeT",
    "shapeH",
    "shapeO",
    "shapeRound",
];

/// The words beside [`OPERATIONS`] that nothing else can be called.
const WORDS: [&str; 27] = [
    "I",
    "nil",
    "size",
    "scope",
    "x",
    "y",
    "z",
    "pi",
    "and",
    "or",
    "not",
    "true",
    "false",
    "rand",
    "randint",
    "up",
    "snap",
    "pick",
    "mix",
    "gradient",
    "occ",
    "visible",
    "gauss",
    "triangular",
    "attr",
    "import",
    "priority",
];

/// Every word that nothing else can be called. `style` is none: where it stands tells what it means.
pub fn reserved() -> impl Iterator<Item = &'static str> {
    WORDS.into_iter().chain(OPERATIONS).filter(|word| *word != "style")
}

/// Whether a name is a word of the language, which nothing else can be called.
pub fn is_reserved(name: &str) -> bool {
    reserved().any(|word| word == name)
}

/// The primitives that vox knows by name, beside blocks: solids, roofs and their pieces, doors and windows.
pub const PRIMITIVES: [&str; 23] = [
    "rect",
    "cuboid",
    "gable",
    "roof",
    "triangle",
    "right_angle_triangle",
    "corner",
    "trough",
    "hip",
    "pyramid",
    "gambrel",
    "mansard",
    "crossgable",
    "ridge",
    "shed",
    "cone",
    "dome",
    "cylinder",
    "sphere",
    "arch",
    "spiral_stair",
    "door",
    "window",
];

/// What can be said of a primitive beside its material.
pub const OPTIONS: [&str; 4] = ["pitch", "overhang", "thickness", "wall"];

/// Whether a name is one of [`PRIMITIVES`], which may carry a number: `window3`.
pub fn is_primitive(name: &str) -> bool {
    PRIMITIVES.contains(&name.trim_end_matches(|c: char| c.is_ascii_digit()))
}

/// Nobody mistypes a longer name than this.
const LONGEST_NAME: usize = 64;

/// The candidate most like `name`, if one is near enough to be a slip of the pen.
pub fn closest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let most = 1 + name.len() / 4;
    // The longer of two names costs at least the difference: no need to compare them letter by letter.
    candidates
        .filter(|candidate| name.len() <= LONGEST_NAME && name.len().abs_diff(candidate.len()) <= most)
        .map(|candidate| (strsim::damerau_levenshtein(name, candidate), candidate))
        .filter(|(distance, _)| *distance <= most)
        .min()
        .map(|(_, candidate)| candidate)
}
