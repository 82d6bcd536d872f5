//! The `vox` command: one file per subcommand. The only place with arguments, paths and colours.

mod attributes;
mod batch;
mod check;
mod completions;
mod convert;
mod crop;
mod derivation_file;
mod diff;
mod encoding;
mod explain;
mod facade;
mod failure;
mod fix;
mod fmt;
mod graph;
mod grow;
mod infer;
mod info;
mod input;
mod kind;
mod materials;
mod output;
mod parse;
mod part;
mod picture;
mod progress;
mod render;
mod replace;
mod report;
mod run;
mod score;
mod session;
mod settings;
mod shapes;
mod shaping;
mod size;
mod summary;
mod tally;
mod template;
mod turn;
mod update;
mod watch;
mod why;
mod writing;

use clap::{Parser, Subcommand};
use std::ffi::OsString;
use std::process::ExitCode;

/// Learn a split grammar from Minecraft houses, and grow new ones in the same style.
#[derive(Parser)]
#[command(version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  vox infer house*.schem -o village.grammar --dot village.dot   examples -> readable rules
  vox run village.grammar -n 50 -o 'out/house-{seed}.schem'     rules -> new houses
  vox render out/*.schem -o sheet.png                           look before importing

Exit codes: 0 done, 1 something is wrong with the input, 2 the command line is wrong.
NO_COLOR turns colours off. `-` stands for standard input or output.";

#[derive(Subcommand)]
enum Command {
    Run(run::Args),
    Why(why::Args),
    Infer(infer::Args),
    Score(score::Args),
    Shapes(shapes::Args),
    Grow(grow::Args),
    Parse(parse::Args),
    Graph(graph::Args),
    Check(check::Args),
    Explain(explain::Args),
    Fmt(fmt::Args),
    Attributes(attributes::Args),
    Info(info::Args),
    Render(render::Args),
    Convert(convert::Args),
    Diff(diff::Args),
    Turn(turn::Args),
    Crop(crop::Args),
    Replace(replace::Args),
    Materials(materials::Args),
    Fix(fix::Args),
    Completions(completions::Args),
}

/// Runs the command line of the process.
pub fn main() -> ExitCode {
    run_from(std::env::args_os())
}

/// Runs a command line: the program's name, then its arguments. A wrong one ends the process with code 2.
pub fn run_from(args: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> ExitCode {
    let result = match Cli::parse_from(args).command {
        Command::Run(args) => run::execute(&args),
        Command::Why(args) => why::execute(&args),
        Command::Infer(args) => infer::execute(&args),
        Command::Score(args) => score::execute(&args),
        Command::Shapes(args) => shapes::execute(&args),
        Command::Grow(args) => grow::execute(&args),
        Command::Parse(args) => parse::execute(&args),
        Command::Graph(args) => graph::execute(&args),
        Command::Check(args) => check::execute(&args),
        Command::Explain(args) => explain::execute(&args),
        Command::Fmt(args) => fmt::execute(&args),
        Command::Attributes(args) => attributes::execute(&args),
        Command::Info(args) => info::execute(&args),
        Command::Render(args) => render::execute(&args),
        Command::Convert(args) => convert::execute(&args),
        Command::Diff(args) => return diff::execute(&args),
        Command::Turn(args) => turn::execute(&args),
        Command::Crop(args) => crop::execute(&args),
        Command::Replace(args) => replace::execute(args),
        Command::Materials(args) => materials::execute(&args),
        Command::Fix(args) => fix::execute(&args),
        Command::Completions(args) => completions::execute(&args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
