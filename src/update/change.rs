use std::fmt::{self, Display, Formatter};

/// What an update did to a grammar.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Change {
    /// A number that may come out otherwise as well: that of a part, an argument, a constant or the start scope.
    Widened { what: String, from: String, to: String },
    /// A line that states a size.
    Sized([i32; 3]),
    /// A further alternative of a label, and the rules that were written for it.
    Alternative { label: String, rules: Vec<String> },
}

impl Display for Change {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Change::Widened { what, from, to } => write!(f, "widened `{what}`: {from} to {to}"),
            Change::Sized([x, y, z]) => write!(f, "added the size {x} x {y} x {z}"),
            Change::Alternative { label, rules } => {
                write!(f, "added an alternative to `{label}`")?;
                match rules.len() {
                    0 => Ok(()),
                    1 => write!(f, ", and the rule `{}`", rules[0]),
                    _ => write!(f, ", and the rules `{}`", rules.join("`, `")),
                }
            }
        }
    }
}
