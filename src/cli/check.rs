use super::failure::Failure;
use super::input;
use super::output;
use super::report::{self, Source};
use crate::grammar::{self, Diagnostic, Severity};
use serde_json::json;
use std::path::PathBuf;

/// Check grammars: every error at once, each with its place
#[derive(clap::Args)]
#[command(after_help = "Example:\n  vox check village.grammar")]
pub struct Args {
    /// Grammar files, or - for standard input
    #[arg(required = true)]
    grammars: Vec<PathBuf>,
    /// Print the findings as JSON, one line a finding
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mut failed = false;
    for path in input::paths(&args.grammars)? {
        let source = input::source(&path)?;
        match args.json {
            true => failed |= print_findings(&source)?,
            false => match input::checked(&source) {
                Ok(checked) => report::note(&summary(&source.name, &checked)),
                Err(failure) => {
                    failure.report();
                    failed = true;
                }
            },
        }
    }
    if failed { Err(Failure::Told) } else { Ok(()) }
}

fn summary(name: &str, checked: &grammar::Checked) -> String {
    let rules = checked.grammar().rules.len();
    let warnings = checked.warnings.len();
    let plural = |number: usize, noun: &str| format!("{number} {noun}{}", if number == 1 { "" } else { "s" });
    format!("{name}: {}, no error, {}", plural(rules, "rule"), plural(warnings, "warning"))
}

/// Prints the findings of one file; whether there was an error among them.
fn print_findings(source: &Source) -> Result<bool, Failure> {
    let checked = grammar::read(&source.text);
    let findings = checked.map_or_else(|findings| findings, |checked| checked.warnings);
    for finding in &findings {
        output::json(&finding_json(source, finding))?;
    }
    Ok(findings.iter().any(Diagnostic::is_error))
}

fn finding_json(source: &Source, finding: &Diagnostic) -> serde_json::Value {
    let (line, column) = report::line_column(&source.text, finding.span);
    let severity = match finding.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    json!({
        "file": source.name,
        "line": line,
        "column": column,
        "severity": severity,
        "code": finding.code.id(),
        "message": finding.message,
        "hint": finding.hint,
    })
}
