use super::failure::Failure;
use super::input;
use super::output;
use super::report;
use crate::grammar::{self, Diagnostic, Loaded, Severity, Sources};
use serde_json::json;
use std::path::{Path, PathBuf};

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
        match args.json {
            true => failed |= print_findings(&path)?,
            false => match input::checked(&path) {
                Ok((sources, checked)) => report::note(&summary(sources.root(), &checked)),
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

/// Prints the findings of one grammar; whether there was an error among them.
fn print_findings(path: &Path) -> Result<bool, Failure> {
    let Loaded { sources, checked } = input::loaded(path)?;
    let findings = checked.map_or_else(|findings| findings, |checked| checked.warnings);
    for finding in &findings {
        output::json(&finding_json(&sources, finding))?;
    }
    Ok(findings.iter().any(Diagnostic::is_error))
}

fn finding_json(sources: &Sources, finding: &Diagnostic) -> serde_json::Value {
    let place = sources.place(finding.span);
    let (line, column) = place.line_column();
    let severity = match finding.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    json!({
        "file": place.name,
        "line": line,
        "column": column,
        "severity": severity,
        "code": finding.code.id(),
        "message": finding.message,
        "hint": finding.hint,
    })
}
