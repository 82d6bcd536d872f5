/// Why a MagicaVoxel model cannot be read.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum MagicaError {
    #[error("`{chunk}` takes {needed} bytes more than the {left} that are left")]
    CutOff { chunk: String, needed: u64, left: usize },
    #[error("expected a chunk `MAIN`, found `{0}`")]
    NoMain(String),
    #[error("there is no model: expected `SIZE` and `XYZI`")]
    NoModel,
    #[error("model {model} is {} x {} x {}: expected 1 to 256 voxels along each axis", .size[0], .size[1], .size[2])]
    Size { model: usize, size: [u32; 3] },
    #[error("the scene has no node {0}, which another one holds")]
    NoNode(u32),
    #[error("the scene has a model {0}, but there are {1}")]
    SceneModel(u32, usize),
    #[error("the scene has more than {0} parts, or holds itself")]
    LongScene(usize),
    #[error("`{0}` is no place: expected three whole numbers")]
    Translation(String),
    #[error("`{0}` is no rotation: expected a number as MagicaVoxel writes it")]
    Rotation(String),
    #[error("the models of the scene lie too far apart")]
    TooFar,
}
