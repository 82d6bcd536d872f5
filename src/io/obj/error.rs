/// Why an OBJ text cannot be read, and where.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct ObjError {
    /// The first line is 1.
    pub line: usize,
    pub problem: ObjProblem,
}

#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum ObjProblem {
    #[error("a vertex takes three numbers, as in `v 0 1.5 2`, but this has {0}")]
    Coordinates(usize),
    #[error("`{0}` is not a number")]
    Number(String),
    #[error("`{0}` is not a vertex of the {1} in this file")]
    Vertex(String, usize),
    #[error("{value} is {scaled} at {scale} blocks per unit, which is no whole number of blocks; {}", advice(.fitting))]
    OffGrid { value: f64, scaled: f64, scale: f64, fitting: Option<u32> },
    #[error("{0} is too far away: coordinates go up to 30,000,000 blocks")]
    TooFar(f64),
    #[error("the object `{0}` has no thickness along {1}: vox needs boxes")]
    Flat(String, crate::space::Axis),
    #[error("there is no face: a model needs vertices and faces between them")]
    NoFace,
    #[error("there is no labelled object: vox needs lines `o name`, each with vertices below it")]
    NoObject,
}

fn advice(fitting: &Option<u32>) -> String {
    match fitting {
        Some(scale) => format!("try --scale {scale}"),
        None => "say how many blocks a unit is with --scale".to_owned(),
    }
}
