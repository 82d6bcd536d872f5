use super::failure::Failure;
use super::input;
use super::output::{self, Output};
use crate::graph::dot;
use std::path::PathBuf;

/// Draw the op graph of a grammar in Graphviz's dot language
#[derive(clap::Args)]
#[command(after_help = "\
Example:
  vox graph village.grammar -o village.dot && dot -Tsvg village.dot -o village.svg")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    /// Where to write; standard output if not given
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// The rule to start from, instead of the first
    #[arg(long, value_name = "LABEL")]
    start: Option<String>,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let source = input::source(&args.grammar)?;
    let graph = input::graph(&source, args.start.as_deref())?;
    let outputs = [Output::new(&args.output, dot(&graph))];
    output::write(&outputs, std::slice::from_ref(&args.grammar))
}
