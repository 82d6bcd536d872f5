use super::failure::Failure;
use super::input::{self, is_stdio};
use super::output::{self, Output};
use super::report;
use crate::grammar::{self, Sources};
use std::path::{Path, PathBuf};

/// Lay out grammars anew: one layout for all, comments and their places kept
///
/// Only the layout changes: the grammar runs as before.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox fmt village.grammar
  vox fmt --check grammars/*.grammar
  vox fmt - < village.grammar")]
pub struct Args {
    /// Grammar files, or - to lay out standard input to standard output
    #[arg(required = true)]
    grammars: Vec<PathBuf>,
    /// Change nothing: name the files that are laid out differently, and exit with 1 if there are any
    #[arg(long)]
    check: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mut failed = false;
    for path in input::paths(&args.grammars)? {
        let result = match args.check {
            true => is_laid_out(&path),
            false => lay_out(&path).map(|()| true),
        };
        // One wrong file does not keep the others from their layout.
        failed |= match result {
            Ok(is_done) => !is_done,
            Err(Failure::Pipe) => return Err(Failure::Pipe),
            Err(failure) => {
                failure.report();
                true
            }
        };
    }
    if failed { Err(Failure::Told) } else { Ok(()) }
}

/// The text of a file, and what it is in the one layout.
fn formatted(path: &Path) -> Result<[String; 2], Failure> {
    let text = input::text(path)?;
    let formatted = grammar::format(&text).map_err(|findings| {
        let sources = Sources::of(input::name(path), &text);
        findings.iter().for_each(|finding| report::diagnostic(&sources, finding));
        Failure::of_file(sources.root(), "it stays as it is")
    })?;
    Ok([text, formatted])
}

fn lay_out(path: &Path) -> Result<(), Failure> {
    let [text, formatted] = formatted(path)?;
    if !is_stdio(path) && text == formatted {
        return Ok(());
    }
    output::write(&[Output::new(path, formatted)], &[])?;
    if !is_stdio(path) {
        report::note(&format!("{}: laid out", path.display()));
    }
    Ok(())
}

fn is_laid_out(path: &Path) -> Result<bool, Failure> {
    let [text, formatted] = formatted(path)?;
    if text != formatted {
        report::note(&format!("{}: not laid out", input::name(path)));
    }
    Ok(text == formatted)
}
