use super::{Place, Side};

/// Why no grammar comes of a layout.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum FacadeError {
    #[error("the layout holds no rectangle")]
    NoAreas,
    #[error("{place}: the `{label}` has no area: its sides have to be longer than zero")]
    ZeroArea { label: String, place: Place },
    #[error("{}: the `{}` overlaps the `{}` of {}", .second.1, .second.0, .first.0, .first.1)]
    Overlap { first: (String, Place), second: (String, Place) },
    #[error(
        "nothing fills the layout from {} to {}: leaves have to tile it without a gap",
        place(.from), place(.to)
    )]
    Gap { from: [f64; 2], to: [f64; 2] },
    #[error(
        "at {} blocks per unit the lines {axis} = {} and {axis} = {} would be one: the leaves in their row need a scale \
         of {} at least", number(.scale), number(&.lines[0]), number(&.lines[1]), number(.needed)
    )]
    TooCoarse { axis: Side, scale: f64, lines: [f64; 2], needed: f64 },
    #[error("the layout would be {} blocks long, more than {}: choose a smaller scale", .blocks.round(), .most)]
    TooLarge { blocks: f64, most: f64 },
    #[error("the layout has {} lines across and {} up, more than vox compares", .lines[0], .lines[1])]
    TooManyLines { lines: [usize; 2] },
    #[error("the rectangles of the layout stand in one another more than {most} deep")]
    Deep { most: usize },
    #[error(
        "no straight line divides what lies from ({}, {}) to ({}, {}) in blocks without cutting a window, a door or the like",
        .from[0], .from[1], .to[0], .to[1]
    )]
    NoCut { from: [u32; 2], to: [u32; 2] },
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Side::X => "x",
            Side::Y => "y",
        })
    }
}

/// A coordinate with six digits at the most, as files have them.
fn number(value: &f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn place(at: &[f64; 2]) -> String {
    format!("({}, {})", number(&at[0]), number(&at[1]))
}
