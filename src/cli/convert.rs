use super::batch::Batch;
use super::failure::Failure;
use super::input::{self, Reading};
use super::part::Part;
use crate::io::{Jigsaws, Options, Scale};
use clap::ValueEnum;

/// Convert buildings from one kind of file to another
///
/// What the new kind of file has no place for is told.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox convert old.schematic new.schem
  vox convert *.litematic 'out/{name}.schem' --mc-version 1.20.1
  vox convert house.schem house-here.schem --anchor door --air void
  vox convert castle.schem 'data/mine/structure/castle.nbt' --split 48
  vox convert saves/world town.schem --box 100,60,-20,180,120,40
  vox convert house.schem new-world/ --at 100,64,-20")]
pub struct Args {
    #[command(flatten)]
    batch: Batch,
    #[command(flatten)]
    part: Part,
    /// What becomes of the jigsaw blocks of a structure
    #[arg(long, value_enum, default_value = "final")]
    jigsaw: JigsawArg,
    /// Blocks per unit of OBJ coordinates
    #[arg(long, value_name = "NUMBER", value_parser = input::scale)]
    scale: Option<Scale>,
}

#[derive(Clone, Copy, ValueEnum)]
enum JigsawArg {
    /// The blocks that they leave behind, as in the game
    Final,
    /// They stay
    Keep,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let jigsaws = match args.jigsaw {
        JigsawArg::Final => Jigsaws::Final,
        JigsawArg::Keep => Jigsaws::Keep,
    };
    let options = Options { scale: args.scale.unwrap_or_default(), jigsaws, ..Options::default() };
    let reading = args.part.read_by(Reading { options, ..args.batch.limit.reading() });
    args.batch.each(&reading, |_, content| Ok(content))
}
