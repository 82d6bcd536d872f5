use super::facade;
use super::failure::Failure;
use super::input::{self, Limit};
use super::output;
use super::progress::Progress;
use super::settings::Settings;
use super::size::SizeArg;
use crate::facade::{Drawing, Meanings, is_wall};
use crate::io::{self, Colours};
use crate::run;
use crate::space::Cell;
use crate::view::{self, Corner, ViewOptions};
use clap::ValueEnum;
use image::RgbaImage;
use std::path::{Path, PathBuf};

/// Draw buildings: an isometric picture, or a labelled sheet of several
///
/// Layouts of facades are drawn flat. A grammar is run and what it makes is drawn, at each size.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox render cottage.schem -o cottage.png
  vox render out/*.schem -o sheet.png --corner south-west
  vox render layout.xml facade.grammar --size 18x12x2 --size 72x50x2 -o sheet.png")]
pub struct Args {
    #[arg(required = true, help = input::DRAWN)]
    files: Vec<PathBuf>,
    /// A further size to draw grammars at, besides their own. May be given several times
    #[arg(long = "size", value_name = "XxYxZ")]
    sizes: Vec<SizeArg>,
    /// A text that names the colours of a PNG of a layout, a line each: #a0b1c2 = window
    #[arg(long, value_name = "FILE")]
    colours: Option<PathBuf>,
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
        for (caption, picture) in pictures(args, path, &options)? {
            pixels += u64::from(picture.width()) * u64::from(picture.height());
            if !tiles.is_empty() && pixels > MOST_PIXELS {
                let failure = Failure::new("so many pictures of this size make no sheet");
                return Err(failure.hint("draw fewer at a time, or smaller ones: `--block 8`"));
            }
            tiles.push((caption, picture));
        }
        progress.step();
    }
    let outputs = match tiles.as_slice() {
        [(_, only)] => output::picture(&args.output, only)?,
        tiles => output::picture(&args.output, &view::sheet(tiles))?,
    };
    output::write(&outputs, &paths)
}

/// What is drawn of a file, with captions.
fn pictures(args: &Args, path: &Path, options: &ViewOptions) -> Result<Vec<(String, RgbaImage)>, Failure> {
    if path.extension().is_some_and(|ending| ending == "grammar") {
        return made(args, path, options);
    }
    let limits = args.limit.reading().limits;
    let picture = match input::layout(path, limits.max_bytes)? {
        Some(bytes) => view::drawing(&drawing(args, path, &bytes)?),
        None => view::isometric(&input::grid(path, &args.limit.reading())?, options),
    };
    Ok(vec![(caption(path), picture)])
}

/// What a grammar makes at its own size and at those that were asked for.
fn made(args: &Args, path: &Path, options: &ViewOptions) -> Result<Vec<(String, RgbaImage)>, Failure> {
    let program = input::program(path, None, &Settings::default())?;
    let library = input::library(&program.graph, path)?;
    let sizes = std::iter::once(None).chain(args.sizes.iter().map(|size| Some(size.0)));
    let draw = |size: Option<Cell>| {
        let run = run::run(&program.graph, &library, &run::Options { size, ..run::Options::default() });
        let grid = run.map_err(|error| input::run_failure(&program.sources, &error))?.made;
        let [x, y, z] = grid.size().to_array();
        Ok((format!("{} {x}x{y}x{z}", caption(path)), view::isometric(&grid, options)))
    };
    sizes.map(draw).collect()
}

fn drawing(args: &Args, path: &Path, bytes: &[u8]) -> Result<Drawing, Failure> {
    let colours: Option<Colours> = args.colours.as_deref().map(input::said).transpose()?;
    let is_wall = |label: &str| is_wall(label, &Meanings::default());
    let drawing = io::decode_layout(bytes, colours.as_ref(), &is_wall, &args.limit.reading().limits);
    drawing.map_err(|error| facade::unread(path, &error))
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
