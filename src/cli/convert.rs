use super::batch::Batch;
use super::failure::Failure;
use super::input::{self, Reading};
use super::part::Part;
use crate::io::{Content, Scale};

/// Convert buildings from one kind of file to another
///
/// What the new kind of file has no place for is told.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox convert old.schem new.schem --schem-version 3
  vox convert *.schem 'out/{name}.obj'
  vox convert house.schem house-here.schem --anchor door --air void
  vox convert castle.schem 'parts/castle.schem' --split 48")]
pub struct Args {
    #[command(flatten)]
    batch: Batch,
    #[command(flatten)]
    part: Part,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let reading = Reading { scale: args.scale.unwrap_or_default(), ..Reading::default() };
    args.batch.each(&reading, |name, content| match content {
        Content::Grid(grid) => Ok(Content::Grid(args.part.of(name, grid)?)),
        boxes => Ok(boxes),
    })
}
