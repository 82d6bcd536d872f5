use super::failure::Failure;
use super::input::{self, Limit};
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
    #[arg(required = true, help = input::BUILDINGS)]
    files: Vec<PathBuf>,
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
    #[command(flatten)]
    limit: Limit,
}

#[derive(Clone, Copy, ValueEnum)]
enum CornerArg {
    SouthEast,
    SouthWest,
    NorthWest,
    NorthEast,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    require_png(&args.output)?;
    let paths = input::paths(&args.files)?;
    let options = options(args);
    let progress = Progress::new(paths.len());
    let mut tiles = Vec::with_capacity(paths.len());
    let mut pixels = 0;
    for path in &paths {
        let grid = input::grid(path, &args.limit.reading())?;
        let picture = view::isometric(&grid, &options);
        pixels += u64::from(picture.width()) * u64::from(picture.height());
        if paths.len() > 1 && pixels > MOST_PIXELS {
            let failure = Failure::new(format!("{} pictures of this size make no sheet", paths.len()));
            return Err(failure.hint("draw fewer at a time, or smaller ones: `--block 8`"));
        }
        tiles.push((caption(path), picture));
        progress.step();
    }
    let outputs = match tiles.as_slice() {
        [(_, only)] => output::picture(&args.output, only)?,
        tiles => output::picture(&args.output, &view::sheet(tiles))?,
    };
    output::write(&outputs, &paths)
}

/// The pixels of all pictures of a sheet: 600 MB of memory.
const MOST_PIXELS: u64 = 150_000_000;

pub fn require_png(path: &Path) -> Result<(), Failure> {
    let is_png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    match is_png || input::is_stdio(path) {
        true => Ok(()),
        false => {
            let failure = Failure::of_file(&path.display().to_string(), "pictures are written as .png");
            Err(failure.hint("name it .png"))
        }
    }
}

pub fn caption(path: &Path) -> String {
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
