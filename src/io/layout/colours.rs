//! Which colour of a picture is which label: lines such as `#a0b1c2 = window`.

/// The labels of colours.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Colours {
    list: Vec<([u8; 3], String)>,
}

/// Why a text on colours cannot be read.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct ColoursError {
    /// From 1.
    pub line: usize,
    pub problem: ColoursProblem,
}

#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum ColoursProblem {
    #[error("expected a line such as `#a0b1c2 = window`")]
    NoLine,
    #[error("`{0}` is no colour: expected six hexadecimal digits, as in `#a0b1c2`")]
    NoColour(String),
    #[error("the colour {0} is `{1}` already")]
    Twice(String, String),
}

impl std::str::FromStr for Colours {
    type Err = ColoursError;

    fn from_str(text: &str) -> Result<Colours, ColoursError> {
        let mut colours = Colours::default();
        for (number, line) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
            let line = line.trim();
            // Colours begin with the sign that begins comments elsewhere.
            if line.is_empty() || line.starts_with("//") {
                continue;
            }
            let at = |problem| ColoursError { line: number, problem };
            let (colour, label) = entry(line).map_err(at)?;
            if let Some(known) = colours.label(colour) {
                return Err(at(ColoursProblem::Twice(hex(colour), known.to_owned())));
            }
            colours.list.push((colour, label));
        }
        Ok(colours)
    }
}

fn entry(line: &str) -> Result<([u8; 3], String), ColoursProblem> {
    let (colour, label) = line.split_once('=').ok_or(ColoursProblem::NoLine)?;
    let (colour, label) = (colour.trim(), label.trim().trim_matches('"'));
    if label.is_empty() {
        return Err(ColoursProblem::NoLine);
    }
    let digits = colour.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii());
    let byte = |at: usize| digits.and_then(|digits| u8::from_str_radix(&digits[at..at + 2], 16).ok());
    match [byte(0), byte(2), byte(4)] {
        [Some(red), Some(green), Some(blue)] => Ok(([red, green, blue], label.to_owned())),
        _ => Err(ColoursProblem::NoColour(colour.to_owned())),
    }
}

/// A colour as texts have it.
pub(super) fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

impl Colours {
    pub fn label(&self, colour: [u8; 3]) -> Option<&str> {
        self.list.iter().find(|(known, _)| *known == colour).map(|(_, label)| label.as_str())
    }

    /// The label of the colour that is nearest, and that colour.
    pub(super) fn nearest(&self, colour: [u8; 3]) -> Option<(String, String)> {
        let off = |known: &[u8; 3]| {
            known.iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>()
        };
        let nearest = self.list.iter().min_by_key(|(known, _)| off(known));
        nearest.map(|(known, label)| (hex(*known), label.clone()))
    }
}
