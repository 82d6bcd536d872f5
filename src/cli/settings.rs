//! What the command line sets before a grammar runs.

use super::failure::Failure;
use super::report;
use crate::grammar::{Diagnostic, Sources};
use crate::graph::{BadSetting, OpGraph};

/// Other values for constants and attributes. Those that are named go before those of the style.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Settings {
    /// What a constant or an attribute is, whatever the grammar says: floors=5, 'wall=pick{ 1 : oak | 2 : birch }'. May be given several times
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    values: Vec<(String, String)>,
    /// The style of the grammar to build in
    #[arg(long, value_name = "NAME")]
    style: Option<String>,
}

fn setting(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok((name.trim().to_owned(), value.to_owned()))
        }
        _ => Err("expected a name and a value, as in floors=5".to_owned()),
    }
}

impl Settings {
    /// Sets the graph of the grammar `name`.
    pub fn apply(&self, graph: &mut OpGraph, name: &str) -> Result<(), Failure> {
        if let Some(style) = &self.style {
            graph.set_style(style).map_err(|bad| failure(name, bad))?;
        }
        for (constant, value) in &self.values {
            graph.set_constant(constant, value).map_err(|bad| match bad {
                BadSetting::Value(findings) => told(constant, value, &findings),
                bad => failure(name, bad),
            })?;
        }
        Ok(())
    }
}

fn failure(name: &str, bad: BadSetting) -> Failure {
    let failure = Failure::of_file(name, &bad);
    match bad {
        BadSetting::NoConstant { hint, .. } | BadSetting::NoStyle { hint, .. } => failure.hint(hint),
        BadSetting::Value(_) => failure,
    }
}

/// Tells what is wrong with a value at its place on the command line.
fn told(constant: &str, value: &str, findings: &[Diagnostic]) -> Failure {
    let sources = Sources::of(format!("--set {constant}"), value);
    findings.iter().for_each(|finding| report::diagnostic(&sources, finding));
    Failure::Told
}
