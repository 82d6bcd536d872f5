use super::Scale;

/// How files are read where there is a choice.
#[derive(Clone, Default, Debug)]
pub struct Options {
    pub scale: Scale,
    pub jigsaws: Jigsaws,
    /// The only region to read, by its name; all of them where there is none.
    pub region: Option<String>,
}

/// What becomes of the jigsaw blocks of a structure, by which the game joins it to others.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Jigsaws {
    /// The blocks that they leave behind, as in the game.
    #[default]
    Final,
    Keep,
}
