use super::failure::Failure;
use super::input::{self, Reading};
use super::output::{self, Kind, Writing};
use crate::io::{Content, Scale};
use std::path::PathBuf;

/// Convert a building from one kind of file to another
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox convert old.schem new.schem --schem-version 3
  vox convert cottage.schem cottage.obj")]
pub struct Args {
    /// What to read, or - for standard input. Its content tells what it is, not its name
    input: PathBuf,
    /// What to write: .schem, .obj or .png, or - for standard output
    output: PathBuf,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
    #[command(flatten)]
    writing: Writing,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let kind = args.writing.kind(&args.output)?;
    let reading = Reading { scale: args.scale.unwrap_or_default(), ..Reading::default() };
    let outputs = match input::content(&args.input, &reading)? {
        Content::Grid(grid) => args.writing.grid(&args.output, &grid)?,
        Content::Boxes(boxes) if kind == Kind::Obj => output::boxes(&args.output, &boxes.boxes),
        Content::Boxes(_) => {
            let name = input::name(&args.input);
            let failure = Failure::of_file(&name, "labelled boxes have no blocks, and can only become .obj");
            return Err(failure.hint("learn a grammar from them with `vox infer`, then run it"));
        }
    };
    output::write(&outputs, std::slice::from_ref(&args.input))
}
