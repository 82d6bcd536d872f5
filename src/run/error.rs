use super::settings;
use crate::grammar::Code;
use crate::grammar::ast::Carving;
use crate::graph::{NodeIndex, OpGraph, Origin};
use crate::space::{Cell, Misfit};
use std::fmt;

/// Why a derivation stopped, and where in the grammar.
#[derive(Clone, Debug)]
pub struct RunError {
    pub kind: Kind,
    /// The operation that failed; `None` for the start.
    pub origin: Option<Origin>,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Kind {
    NoSize,
    Size {
        size: Cell,
        limit: u64,
    },
    Misfit {
        misfit: Misfit,
        axis: String,
    },
    NoRule {
        scope: Cell,
    },
    Weight(f64),
    Type {
        expected: &'static str,
        found: String,
    },
    NotANumber,
    /// A constant with a range has a value outside of it.
    OutOfRange {
        name: String,
        value: f64,
        range: [f64; 2],
    },
    Step {
        what: &'static str,
        value: f64,
    },
    Width {
        how: Carving,
        width: f64,
    },
    NoOption(String),
    OptionOfNothing(String),
    Option {
        name: String,
        expected: &'static str,
        found: String,
    },
    Angle(f64),
    NotVertical {
        up: String,
    },
    Rhythm,
    OutsidePlot,
    TooDeep(u32),
    TooManySteps(u64),
    TooWide(u64),
    TooMany(u64),
    NoThing(String),
    NoFile(String),
    NoRoomForDoor,
    PaletteFull,
}

impl Kind {
    pub fn code(&self) -> Code {
        match self {
            Kind::NoSize => Code::NoStartSize,
            Kind::Size { .. } => Code::BadStartSize,
            Kind::Misfit { misfit: Misfit::Overrun { .. }, .. } => Code::Overrun,
            Kind::Misfit { misfit: Misfit::Underrun { .. }, .. } => Code::Underrun,
            Kind::Misfit { misfit: Misfit::Negative { .. }, .. } => Code::NegativeSize,
            Kind::NoRule { .. } => Code::NoRuleApplies,
            Kind::Weight(_) => Code::BadWeight,
            Kind::Type { .. } => Code::WrongType,
            Kind::NotANumber => Code::NoValue,
            Kind::OutOfRange { .. } => Code::OutOfRange,
            Kind::Step { .. } | Kind::Width { .. } => Code::BadStep,
            Kind::NoOption(_) | Kind::OptionOfNothing(_) => Code::UnknownOption,
            Kind::Option { .. } => Code::WrongType,
            Kind::Angle(_) => Code::BadAngle,
            Kind::NotVertical { .. } => Code::FlatTurn,
            Kind::Rhythm => Code::ThinRhythm,
            Kind::OutsidePlot => Code::LeavesPlot,
            Kind::TooDeep(_) => Code::CallsTooDeep,
            Kind::TooManySteps(_) | Kind::TooMany(_) => Code::TooManySteps,
            Kind::TooWide(_) => Code::TooManyScopes,
            Kind::NoThing(_) => Code::UnknownBlock,
            Kind::NoFile(_) => Code::NoFile,
            Kind::NoRoomForDoor => Code::NoRoomForDoor,
            Kind::PaletteFull => Code::PaletteFull,
        }
    }
}

impl From<Box<Kind>> for Kind {
    fn from(kind: Box<Kind>) -> Kind {
        *kind
    }
}

impl RunError {
    pub fn anywhere(kind: Kind) -> RunError {
        RunError { kind, origin: None }
    }

    pub(super) fn at(graph: &OpGraph, node: NodeIndex, kind: Kind) -> RunError {
        RunError { kind, origin: graph.origin(node).cloned() }
    }

    /// What to do about it.
    pub fn hint(&self) -> Option<String> {
        Some(match &self.kind {
            Kind::NoSize => {
                "give one with `--size 9x7x9`, or write `size(9, 7, 9)` in the grammar".to_owned()
            }
            Kind::Misfit { misfit: Misfit::Overrun { .. }, .. } => {
                "make the scope larger or a size floating (`~1`), or cut it off with `--overrun clip`"
                    .to_owned()
            }
            Kind::Misfit { misfit: Misfit::Underrun { .. }, .. } => {
                "make one of the sizes floating (`~1`), or leave the rest free with `--overrun clip`"
                    .to_owned()
            }
            Kind::NoRule { .. } => "add a rule without a condition, or one for this case".to_owned(),
            Kind::Step { what: "count", .. } => "a count is zero or more".to_owned(),
            Kind::Step { .. } => "a size is more than zero: `max(1, ...)` keeps it so".to_owned(),
            Kind::Width { .. } => {
                "`max(0, ...)` keeps it so; what is too wide for the scope fills it".to_owned()
            }
            Kind::NoOption(_) => format!("the options are {}", settings::NAMES.join(", ")),
            Kind::OptionOfNothing(_) => {
                "roofs and solids have options, as in `I(gable, oak, pitch = 1)`".to_owned()
            }
            Kind::NotANumber => "keep the divisor from zero: `max(1, ...)`, or a condition".to_owned(),
            Kind::Angle(_) => "write pi/2, pi or 3*pi/2 (or 90, 180, 270 degrees)".to_owned(),
            Kind::NotVertical { up } => format!("write `R({up}, ...)`"),
            Kind::TooDeep(_) => {
                "let the rule end: a condition, or a scope that shrinks with every step".to_owned()
            }
            Kind::TooManySteps(_) => "raise it with `--max-steps` if so much is meant".to_owned(),
            Kind::TooWide(_) => "split the scope into a few parts first, and repeat inside them".to_owned(),
            Kind::TooMany(_) => {
                "make it in several runs, or ask fewer questions: with none, no shape has to be kept"
                    .to_owned()
            }
            Kind::OutsidePlot => {
                "keep T and S inside the start scope, or cut off with `--overrun clip`".to_owned()
            }
            Kind::NoFile(_) => "files are looked for beside the grammar".to_owned(),
            Kind::NoThing(name) => format!("say what it is made of: `{name} = stone`"),
            _ => return None,
        })
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Kind::NoSize => write!(f, "the size of the start scope is not known"),
            Kind::Size { size, limit } => write!(
                f,
                "a start scope of {}x{}x{} is out of bounds: each length is 1 or more, the volume at most {limit} blocks",
                size.x, size.y, size.z
            ),
            Kind::Misfit { misfit, axis } => write!(f, "along {axis}, {misfit}"),
            Kind::NoRule { scope } => write!(
                f,
                "no rule applies: every condition fails in a scope of {}x{}x{}",
                scope.x, scope.y, scope.z
            ),
            Kind::Weight(weight) => {
                write!(f, "the weight of a rule is {weight}: weights are zero or more, not all zero")
            }
            Kind::Type { expected, found } => write!(f, "expected {expected}, found {found}"),
            Kind::NotANumber => {
                write!(f, "an expression has no value: it divides by zero or grows without bound")
            }
            Kind::OutOfRange { name, value, range: [low, high] } => {
                write!(f, "`{name}` is {value}, and its range is from {low} to {high}")
            }
            Kind::Step { what, value } => write!(f, "the {what} of a repeat is {value}, which is too little"),
            Kind::Width { how, width } => write!(
                f,
                "`{})` takes lengths of zero blocks or more, and one of them is {width}",
                how.head()
            ),
            Kind::NoOption(name) => write!(f, "no primitive has an option `{name}`"),
            Kind::OptionOfNothing(name) => {
                write!(f, "this is no roof or solid, so it has no option `{name}`")
            }
            Kind::Option { name, expected, found } => {
                write!(f, "the option `{name}` takes {expected}, not {found}")
            }
            Kind::Angle(angle) => write!(f, "{angle} is not a multiple of a quarter turn"),
            Kind::NotVertical { up } => write!(f, "blocks only turn about the vertical, which is {up} here"),
            Kind::Rhythm => write!(
                f,
                "the parts of a rhythm group are too thin to fill the scope: they sum to almost nothing"
            ),
            Kind::OutsidePlot => write!(f, "a scope leaves the start scope"),
            Kind::TooDeep(limit) => write!(f, "rules call one another more than {limit} deep"),
            Kind::TooManySteps(limit) => write!(f, "the derivation takes more than {limit} steps"),
            Kind::TooWide(limit) => write!(f, "a repeat opens more than {limit} scopes at once"),
            Kind::TooMany(limit) => {
                write!(f, "rules that ask of other shapes keep all of them, and there are more than {limit}")
            }
            Kind::NoThing(name) => write!(f, "there is no block or primitive `{name}`"),
            Kind::NoFile(name) => write!(f, "the file \"{name}\" was not loaded"),
            Kind::NoRoomForDoor => write!(f, "a door needs a scope two blocks high: it was left out"),
            Kind::PaletteFull => write!(f, "{}", crate::block::PaletteFull),
        }
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.origin {
            Some(origin) => write!(f, "in `{}`: {}", origin.label, self.kind),
            None => self.kind.fmt(f),
        }
    }
}

impl std::error::Error for RunError {}

/// Something that a run went on after. Each kind is told once an operation, however often it happened.
#[derive(Clone, Debug)]
pub struct Warning {
    pub error: RunError,
    pub times: u64,
}
