use super::batch::Batch;
use super::failure::Failure;
use crate::block::Mirror;
use crate::space::Turn;
use clap::ValueEnum;

/// Turn buildings about the vertical, or mirror them
///
/// Blocks, what is in them, entities and biomes go along. The building is mirrored first.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox turn house.schem house-east.schem --by 90
  vox turn *.schem 'out/{name}-mirrored.schem' --mirror x")]
#[group(required = true, multiple = true, args = ["by", "mirror"])]
pub struct Args {
    #[command(flatten)]
    batch: Batch,
    /// The angle in degrees, clockwise seen from above
    #[arg(long, value_name = "DEGREES", value_parser = clockwise, allow_hyphen_values = true)]
    by: Option<Turn>,
    /// The axis along which the building is mirrored: x exchanges east and west, z north and south
    #[arg(long, value_enum)]
    mirror: Option<MirrorArg>,
}

#[derive(Clone, Copy, ValueEnum)]
enum MirrorArg {
    X,
    Z,
}

fn clockwise(text: &str) -> Result<Turn, String> {
    match text.parse() {
        Ok(degrees @ (90 | 180 | 270 | -90)) => Ok(Turn::quarters(-(degrees / 90))),
        _ => Err("expected 90, 180 or 270".to_owned()),
    }
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let mirror = args.mirror.map(|mirror| match mirror {
        MirrorArg::X => Mirror::X,
        MirrorArg::Z => Mirror::Z,
    });
    args.batch.each_grid(|_, grid| {
        let mirrored = mirror.map(|mirror| grid.mirrored(mirror)).unwrap_or(grid);
        Ok(args.by.map(|turn| mirrored.turned(turn)).unwrap_or(mirrored))
    })
}
