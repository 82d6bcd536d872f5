//! The choices that gave a building, as a file.

use super::failure::Failure;
use super::input;
use crate::shapes::{Application, Derivation, Enclosure, ShapeGrammar};
use serde_json::{Value, json};
use std::path::Path;

/// No file of choices is longer.
const MOST: u64 = 1 << 26;

const FORMAT: &str = "vox derivation 1";

/// A derivation as JSON. It names the shapes and rules that it was made with by a check sum.
pub fn text(grammar: &ShapeGrammar, derivation: &Derivation) -> String {
    let steps: Vec<Value> = derivation.steps.iter().map(|step| json!([step.shape, step.rule])).collect();
    let value = json!({
        "format": FORMAT,
        "grammar": grammar.checksum(),
        "start": derivation.start,
        "steps": steps,
        "removed": derivation.removed,
        "enclose": derivation.enclosure == Enclosure::Enforced,
    });
    format!("{value:#}\n")
}

/// Reads such a file, for the grammar that it was made with.
pub fn read(path: &Path, grammar: &ShapeGrammar) -> Result<Derivation, Failure> {
    let name = input::name(path);
    let bytes = input::bytes(path, MOST)?;
    let value: Value = serde_json::from_slice(&bytes)
        .map_err(|error| Failure::of_file(&name, format!("this is not JSON: {error}")))?;
    let bad = |what: &str| Failure::of_file(&name, what);
    if value["format"] != FORMAT {
        let failure = bad("this holds no choices of `vox grow`");
        return Err(
            failure.hint(format!("such a file says \"format\": \"{FORMAT}\", and is written by `--save`"))
        );
    }
    if value["grammar"] != grammar.checksum() {
        let failure = bad("these choices were made with other examples, or with other options");
        return Err(failure.hint(
            "give the same buildings in the same order, and the same `--spec`, `--alpha` and the like",
        ));
    }
    let derivation = parsed(&value).map_err(|field| bad(&format!("`{field}` is not as expected")))?;
    derivation.production(grammar).map_err(|error| bad(&error.to_string()))?;
    Ok(derivation)
}

/// The derivation, or the field that is wrong.
fn parsed(value: &Value) -> Result<Derivation, &'static str> {
    let number = |value: &Value| value.as_u64().and_then(|number| usize::try_from(number).ok());
    let step = |step: &Value| {
        let [shape, rule] = step.as_array()?.as_slice() else { return None };
        Some(Application { shape: number(shape)?, rule: number(rule)? })
    };
    let list = |field: &'static str| value[field].as_array().ok_or(field);
    let steps =
        list("steps")?.iter().map(step).collect::<Option<_>>().ok_or("steps: [[shape, rule], ...]")?;
    let removed =
        list("removed")?.iter().map(number).collect::<Option<_>>().ok_or("removed: [shape, ...]")?;
    let enclosure = match value["enclose"].as_bool().ok_or("enclose")? {
        true => Enclosure::Enforced,
        false => Enclosure::Ignored,
    };
    Ok(Derivation { start: number(&value["start"]).ok_or("start")?, steps, removed, enclosure })
}
