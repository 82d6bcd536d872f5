//! What a run sets: other values for constants, before anything is drawn.

use super::OpGraph;
use super::lower::resolve;
use super::raise::raised_constants;
use crate::grammar::{self, Diagnostic, Names, closest};

/// Why a graph cannot be set so.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum BadSetting {
    #[error("there is no constant or attribute `{name}`")]
    NoConstant { name: String, hint: String },
    #[error("there is no style `{name}`")]
    NoStyle { name: String, hint: String },
    /// With places in the text of the value.
    #[error("this is no value for it")]
    Value(Vec<Diagnostic>),
}

impl OpGraph {
    /// Gives a constant the value that a text says. Whether it lies in its range is seen where it is drawn.
    pub fn set_constant(&mut self, name: &str, text: &str) -> Result<(), BadSetting> {
        let Some(at) = self.constants.iter().position(|constant| constant.name == name) else {
            let known = self.constants.iter().map(|constant| constant.name.as_str());
            return Err(BadSetting::NoConstant { name: name.to_owned(), hint: like(name, known) });
        };
        let constants = raised_constants(self);
        let value = grammar::value(text, &constants, at).map_err(BadSetting::Value)?;
        self.constants[at].value = resolve(&value, Names { params: &[], constants: &constants });
        Ok(())
    }

    /// Gives the constants the values that they have in a style.
    pub fn set_style(&mut self, name: &str) -> Result<(), BadSetting> {
        let Some(style) = self.styles.iter().find(|style| style.name == name) else {
            let known = self.styles.iter().map(|style| style.name.as_str());
            return Err(BadSetting::NoStyle { name: name.to_owned(), hint: like(name, known) });
        };
        for (at, value) in &style.values {
            self.constants[*at].value = value.clone();
        }
        Ok(())
    }
}

/// What is there, for someone who asked for what is not.
fn like<'a>(name: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    let all: Vec<&str> = known.clone().collect();
    match closest(name, known) {
        Some(near) => format!("did you mean `{near}`?"),
        None if all.is_empty() => "the grammar has none".to_owned(),
        None => format!("the grammar has {}", all.join(", ")),
    }
}
