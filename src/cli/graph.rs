use super::failure::Failure;
use super::input;
use super::output::{self, Output};
use super::settings::Settings;
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
    #[command(flatten)]
    settings: Settings,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let program = input::program(&args.grammar, args.start.as_deref(), &args.settings)?;
    let outputs = [Output::new(&args.output, dot(&program.graph))];
    output::write(&outputs, &program.files)
}
