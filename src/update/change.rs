use std::fmt::{self, Display, Formatter};

/// What an update did to a grammar.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Change {
    /// A number that may come out otherwise as well: that of a part, an argument, a constant or the start scope.
    Widened { what: String, from: String, to: String },
    /// The version of the game that the grammar is for.
    Raised { from: i32, to: i32 },
    /// A line that states a size.
    Sized([i32; 3]),
    /// A further alternative of a label, and the rules that were written for it.
    Alternative { label: String, rules: Vec<String> },
    /// The rules of a label that do not apply to a size any more, at which they never ran.
    Bound { label: String, size: [i32; 3] },
}

impl Display for Change {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Change::Widened { what, from, to } => write!(f, "widened {what}: {from} to {to}"),
            Change::Raised { from, to } => write!(f, "raised the `data_version`: {from} to {to}"),
            Change::Sized([x, y, z]) => write!(f, "added the size {x} x {y} x {z}"),
            Change::Alternative { label, rules } => {
                write!(f, "added an alternative to `{label}`{}", Rules(rules))
            }
            Change::Bound { label, size: [x, y, z] } => {
                write!(f, "kept the other rules of `{label}` from {x} x {y} x {z}, which they cannot fill")
            }
        }
    }
}

/// Rules that came with an alternative.
struct Rules<'a>(&'a [String]);

impl Display for Rules<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.0 {
            [] => Ok(()),
            [only] => write!(f, " and the rule `{only}`"),
            [first, .., last] => write!(f, " and {} rules, from `{first}` to `{last}`", self.0.len()),
        }
    }
}
