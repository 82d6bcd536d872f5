//! The options of a primitive, as in `I(gable, oak, pitch = 1, overhang = 1)`.

use super::brush::block_of;
use super::error::Kind;
use super::eval::Value;
use super::solid::Options;

/// The names of the options.
pub const NAMES: [&str; 4] = ["pitch", "overhang", "thickness", "wall"];

/// Reads the options of a roof or a solid; the last of a name counts.
pub fn settings(options: &[(&str, Value<'_>)]) -> Result<Options, Kind> {
    let mut settings = Options::default();
    for (name, value) in options {
        let wrong = |expected| Kind::Option { name: (*name).to_owned(), expected, found: value.describe() };
        let blocks = || blocks(*value).ok_or_else(|| wrong("a number of blocks, zero or more"));
        match *name {
            "pitch" => settings.pitch = Some(pitch(*value).ok_or_else(|| wrong("a number above zero"))?),
            "overhang" => settings.overhang = blocks()?,
            "thickness" => settings.thickness = Some(blocks()?).filter(|blocks| *blocks > 0),
            "wall" => match value {
                Value::Thing(thing) => settings.wall = Some(block_of(thing)?),
                _ => return Err(wrong("a block")),
            },
            name => return Err(Kind::NoOption(name.to_owned())),
        }
    }
    Ok(settings)
}

/// A primitive that has no options must have been given none.
pub fn none(options: &[(&str, Value<'_>)]) -> Result<(), Kind> {
    match options.first() {
        Some((name, _)) => Err(Kind::OptionOfNothing((*name).to_owned())),
        None => Ok(()),
    }
}

fn pitch(value: Value<'_>) -> Option<f64> {
    match value {
        Value::Number(number) if number.is_finite() && number > 0.0 => Some(number),
        _ => None,
    }
}

fn blocks(value: Value<'_>) -> Option<i32> {
    match value {
        Value::Number(number) if number.is_finite() && number.round() >= 0.0 => Some(number.round() as i32),
        _ => None,
    }
}
