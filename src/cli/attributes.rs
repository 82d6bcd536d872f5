use super::failure::Failure;
use super::input;
use super::output;
use super::report;
use crate::grammar::Grammar;
use crate::grammar::ast::{Attribute, Constant, Style};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// List what a run may set: the attributes of a grammar, by group, and its styles
#[derive(clap::Args)]
#[command(after_help = "\
Example:
  vox attributes tower.grammar
  vox run tower.grammar --set floors=5 --style spruce -o tower.schem")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let (sources, checked) = input::checked(&args.grammar)?;
    let grammar = checked.grammar();
    match args.json {
        true => output::json(&as_json(grammar)),
        false if grammar.styles.is_empty() && attributes(grammar).next().is_none() => {
            report::note(&format!("{}: no attributes and no styles", sources.root()));
            Ok(())
        }
        false => output::stdout(text(grammar).as_bytes()),
    }
}

fn attributes(grammar: &Grammar) -> impl Iterator<Item = (&Constant, &Attribute)> {
    let constants = grammar.constants.iter();
    constants.filter_map(|constant| Some((constant, constant.attribute.as_ref()?)))
}

/// The groups in the order of the file; attributes without one come first.
fn groups(grammar: &Grammar) -> Vec<Option<&str>> {
    let mut groups: Vec<Option<&str>> = Vec::new();
    for (_, attribute) in attributes(grammar) {
        let group = attribute.group.as_deref();
        if !groups.contains(&group) {
            groups.push(group);
        }
    }
    groups.sort_by_key(|group| group.is_some());
    groups
}

fn text(grammar: &Grammar) -> String {
    let mut text = String::new();
    let definition = |constant: &Constant| format!("{} = {}", constant.name.name, constant.value);
    let width = attributes(grammar).map(|(constant, _)| definition(constant).chars().count()).max();
    let width = width.unwrap_or(0).min(40);
    for group in groups(grammar) {
        let _ = writeln!(text, "{}:", group.unwrap_or("attributes"));
        for (constant, attribute) in attributes(grammar).filter(|(_, it)| it.group.as_deref() == group) {
            let line = format!("  {:<width$}{}", definition(constant), told(attribute));
            let _ = writeln!(text, "{}", line.trim_end());
        }
    }
    if !grammar.styles.is_empty() {
        let _ = writeln!(text, "styles:");
    }
    grammar.styles.iter().for_each(|style| text += &format!("  {}: {}\n", style.name.name, values(style)));
    text
}

/// Its range and what it is about.
fn told(attribute: &Attribute) -> String {
    let range = attribute.range.as_ref().map(|[low, high]| format!("  {low} to {high}"));
    let about = attribute.about.as_ref().map(|about| format!("  {about}"));
    range.unwrap_or_default() + &about.unwrap_or_default()
}

fn values(style: &Style) -> String {
    let values = style.values.iter().map(|(name, value)| format!("{} = {value}", name.name));
    values.collect::<Vec<_>>().join(", ")
}

fn as_json(grammar: &Grammar) -> Value {
    let attributes = attributes(grammar).map(|(constant, attribute)| {
        json!({
            "name": constant.name.name,
            "value": constant.value.to_string(),
            "range": attribute.range.as_ref().map(|range| range.each_ref().map(ToString::to_string)),
            "group": attribute.group,
            "about": attribute.about,
        })
    });
    let styles = grammar.styles.iter().map(|style| {
        let values = style.values.iter().map(|(name, value)| (name.name.clone(), json!(value.to_string())));
        json!({ "name": style.name.name, "values": Value::Object(values.collect()) })
    });
    json!({ "attributes": attributes.collect::<Vec<_>>(), "styles": styles.collect::<Vec<_>>() })
}
