use std::ops::RangeInclusive;

/// How parts are carved out of a scope.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Carving {
    Faces,
    Edges,
    Vertices,
    Setback,
    Offset,
    L,
    U,
    T,
    H,
    O,
    Round,
}

impl Carving {
    /// The words with which each begins.
    pub const NAMES: [(&'static str, Carving); 11] = [
        ("comp(f", Carving::Faces),
        ("comp(e", Carving::Edges),
        ("comp(v", Carving::Vertices),
        ("setback(", Carving::Setback),
        ("offset(", Carving::Offset),
        ("shapeL(", Carving::L),
        ("shapeU(", Carving::U),
        ("shapeT(", Carving::T),
        ("shapeH(", Carving::H),
        ("shapeO(", Carving::O),
        ("shapeRound(", Carving::Round),
    ];

    /// How it begins in the text, up to its arguments.
    pub fn head(self) -> &'static str {
        Carving::NAMES[self as usize].0
    }

    pub fn is_component(self) -> bool {
        matches!(self, Carving::Faces | Carving::Edges | Carving::Vertices)
    }

    /// How many arguments it may have, and how to write them.
    pub fn takes(self) -> (RangeInclusive<usize>, &'static str) {
        match self {
            Carving::Faces | Carving::Edges | Carving::Vertices => (0..=1, "a thickness, as in `comp(f, 2)`"),
            Carving::Setback => (1..=1, "a depth, as in `setback(3)`"),
            Carving::Offset => (1..=1, "a depth, as in `offset(2)`"),
            Carving::L => (2..=2, "two widths: `shapeL(front, left)`"),
            Carving::U => (3..=3, "three widths: `shapeU(front, right, left)`"),
            Carving::T => (2..=2, "two widths: `shapeT(front, stem)`"),
            Carving::H => (3..=3, "three widths: `shapeH(right, across, left)`"),
            Carving::O => (1..=4, "one width, or four: `shapeO(front, right, back, left)`"),
            Carving::Round => (0..=0, "no arguments"),
        }
    }
}

/// Which parts of a carved scope an operation gets.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Selector {
    /// Those on all of these faces: `front`, `top.front` for an edge.
    On(Vec<Face>),
    /// One by its number.
    Index(u32),
    /// What is left within.
    Inside,
    /// What an offset takes.
    Border,
    /// The footprint.
    Shape,
    /// What lies outside of the footprint.
    Remainder,
}

impl Selector {
    pub const NAMES: [(&'static str, Selector); 4] = [
        ("inside", Selector::Inside),
        ("border", Selector::Border),
        ("shape", Selector::Shape),
        ("remainder", Selector::Remainder),
    ];

    /// The word for a part that is no face.
    pub fn name(&self) -> &'static str {
        Selector::NAMES.iter().find(|(_, selector)| selector == self).map_or("", |(name, _)| name)
    }

    /// Whether parts of that name are carved so.
    pub fn suits(&self, how: Carving) -> bool {
        match (self, how) {
            (Selector::On(faces), Carving::Faces) => faces.len() == 1,
            (Selector::On(faces), Carving::Setback) => {
                faces.len() == 1 && !faces.iter().any(|face| matches!(face, Face::Top | Face::Bottom))
            }
            (Selector::On(faces), Carving::Edges) => faces.len() <= 2,
            (Selector::On(faces), Carving::Vertices) => faces.len() <= 3,
            (Selector::Index(_), how) => how.is_component(),
            (Selector::Inside, how) => {
                matches!(how, Carving::Setback | Carving::Offset) || how.is_component()
            }
            (Selector::Border, how) => how == Carving::Offset,
            (Selector::Shape | Selector::Remainder, how) => how >= Carving::L,
            (Selector::On(_), _) => false,
        }
    }
}

/// The faces that a component split can name. `Side` is the four upright ones, `All` all six; the directions are
/// those of the world.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Face {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    Side,
    All,
    North,
    East,
    South,
    West,
}

impl Face {
    pub const NAMES: [(&'static str, Face); 12] = [
        ("front", Face::Front),
        ("back", Face::Back),
        ("left", Face::Left),
        ("right", Face::Right),
        ("top", Face::Top),
        ("bottom", Face::Bottom),
        ("side", Face::Side),
        ("all", Face::All),
        ("north", Face::North),
        ("east", Face::East),
        ("south", Face::South),
        ("west", Face::West),
    ];

    pub fn name(self) -> &'static str {
        Face::NAMES[self as usize].0
    }
}
