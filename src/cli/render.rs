use super::failure::Failure;
use super::input::{self, Reading};
use super::output;
use super::progress::Progress;
use crate::view::{self, Corner, ViewOptions};
use clap::ValueEnum;
use std::path::{Path, PathBuf};

/// Draw buildings: an isometric picture, or a labelled sheet of several
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox render cottage.schem -o cottage.png
  vox render out/*.schem -o sheet.png --corner south-west")]
pub struct Args {
    /// Schematics, or - for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// The PNG file to write, or - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// The corner of the building that is nearest to the eye
    #[arg(long, value_enum, default_value = "south-east")]
    corner: CornerArg,
    /// The width of one block in pixels; as fits if not given
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u16).range(1..=512))]
    block: Option<u16>,
    /// Leave the background clear
    #[arg(long)]
    clear: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum CornerArg {
    SouthEast,
    SouthWest,
    NorthWest,
    NorthEast,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    let paths = input::paths(&args.files)?;
    let options = options(args);
    let progress = Progress::new(paths.len());
    let mut tiles = Vec::with_capacity(paths.len());
    for path in &paths {
        let grid = input::grid(path, &Reading::default())?;
        tiles.push((caption(path), view::isometric(&grid, &options)));
        progress.step();
    }
    match tiles.as_slice() {
        [(_, only)] => output::picture(&args.output, only),
        tiles => output::picture(&args.output, &view::sheet(tiles)),
    }
}

fn caption(path: &Path) -> String {
    path.file_stem().map_or_else(|| input::name(path), |stem| stem.to_string_lossy().into_owned())
}

fn options(args: &Args) -> ViewOptions {
    ViewOptions {
        corner: match args.corner {
            CornerArg::SouthEast => Corner::SouthEast,
            CornerArg::SouthWest => Corner::SouthWest,
            CornerArg::NorthWest => Corner::NorthWest,
            CornerArg::NorthEast => Corner::NorthEast,
        },
        scale: args.block.map_or(view::Scale::Fit, view::Scale::BlockWidth),
        background: if args.clear { ViewOptions::CLEAR } else { ViewOptions::PAPER },
    }
}
