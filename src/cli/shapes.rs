use super::failure::Failure;
use super::input::{self, Limit};
use super::output::{self, Output};
use super::progress::Progress;
use super::shaping::Shaping;
use crate::grid::Grid;
use crate::shapes::{self, Building, Part, Rest, Settings, ShapeGrammar, Spread, Statistics};
use crate::view::{self, ViewOptions};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Find the shapes that buildings are made of: walls, windows, floors that come again
///
/// Shapes of few block types are looked for, and few of them. Shapes match that are the same when one is turned and moved. The
/// method is SIGI's.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox shapes house.schem
  vox shapes house.schem -o shapes.png --exploded
  vox shapes house*.schem --spec 2d --alpha 0.75 --dot rules.dot
  vox shapes house.schem --overlap --json | jq .matching_percent")]
pub struct Args {
    #[arg(required = true, help = input::BUILDINGS)]
    files: Vec<PathBuf>,
    /// A picture of the shapes, each in its colour and matching shapes in the same: a .png
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw the shapes apart from one another
    #[arg(long, requires = "output")]
    exploded: bool,
    /// Where to write which shapes stand beside which, in Graphviz's dot language
    #[arg(long, value_name = "FILE")]
    dot: Option<PathBuf>,
    #[command(flatten)]
    shaping: Shaping,
    /// Find shapes again among the blocks that are in none: where shapes may not share blocks, those are dropped that cross
    /// larger ones
    #[arg(long)]
    whole: bool,
    /// Of searches that draw
    #[arg(long, default_value_t = 0)]
    seed: u64,
    #[command(flatten)]
    limit: Limit,
    /// Print as JSON, one line a building
    #[arg(long)]
    json: bool,
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    args.output.iter().try_for_each(|path| super::render::require_png(path))?;
    let paths = input::paths(&args.files)?;
    let rest = if args.whole { Rest::Searched } else { Rest::Left };
    let settings = args.shaping.settings(rest, args.seed);
    let progress = Progress::new(paths.len());
    let (mut grids, mut found) = (Vec::new(), Vec::new());
    for path in &paths {
        let grid = input::grid(path, &args.limit.reading())?;
        let building = Building::of(&grid);
        let shapes = shapes::search(&building, &settings);
        found.push(Found::of(&building, &shapes, &settings));
        grids.push((grid, building, shapes));
        progress.step();
    }
    let grammar = ShapeGrammar::of(&grids);
    drop(progress);
    let mut outputs = pictures(args, &paths, &grids, &grammar)?;
    outputs.extend(args.dot.iter().map(|path| Output::new(path, shapes::dot(&grammar))));
    output::write(&outputs, &paths)?;
    tell(args, &paths, &grammar, &found)
}

/// What is told of the shapes of one building.
struct Found {
    statistics: Statistics,
    cost: f64,
}

impl Found {
    fn of(building: &Building, found: &[shapes::Shape], settings: &Settings) -> Found {
        let shapes = found.iter().map(|shape| (shape.layer, shape.blocks.as_slice()));
        Found { statistics: Statistics::of(building, found), cost: shapes::cost(building, settings, shapes) }
    }
}

fn parts_of(grammar: &ShapeGrammar, example: usize) -> Vec<&Part> {
    grammar.parts.parts.iter().filter(|part| part.example == example).collect()
}

fn pictures(
    args: &Args,
    paths: &[PathBuf],
    grids: &[(Grid, Building, Vec<shapes::Shape>)],
    grammar: &ShapeGrammar,
) -> Result<Vec<Output>, Failure> {
    let Some(output) = &args.output else { return Ok(Vec::new()) };
    let spread = if args.exploded { Spread::Exploded } else { Spread::Whole };
    let colors = shapes::colors(&grammar.parts);
    let options = ViewOptions::default();
    let mut tiles = Vec::new();
    for (example, (path, (grid, ..))) in paths.iter().zip(grids).enumerate() {
        let cells = shapes::paint(&grammar.parts, &parts_of(grammar, example), spread);
        tiles.push((super::render::caption(path), view::isometric(grid, &options)));
        tiles.push(("its shapes".to_owned(), view::isometric_colors(&cells, &colors, &options)));
    }
    output::picture(output, &view::sheet(&tiles))
}

fn tell(args: &Args, paths: &[PathBuf], grammar: &ShapeGrammar, found: &[Found]) -> Result<(), Failure> {
    for (example, (path, found)) in paths.iter().zip(found).enumerate() {
        match args.json {
            true => output::json(&as_json(path, grammar, example, found))?,
            false => output::stdout(table(path, grammar, example, found).as_bytes())?,
        }
    }
    Ok(())
}

/// Shapes of an example that match another of it, turned or not.
fn matching(grammar: &ShapeGrammar, example: usize) -> usize {
    let parts = parts_of(grammar, example);
    let mut forms: Vec<usize> = parts.iter().map(|part| part.form).collect();
    forms.sort_unstable();
    forms.dedup();
    parts.len() - forms.len()
}

fn as_json(path: &Path, grammar: &ShapeGrammar, example: usize, found: &Found) -> Value {
    let Found { statistics, cost } = found;
    json!({
        "file": input::name(path),
        "shapes": statistics.shapes,
        "mean_size": statistics.mean_size,
        "median_size": statistics.median_size,
        "largest": statistics.largest,
        "smallest": statistics.smallest,
        "complexity": statistics.complexity,
        "redundant": statistics.redundant,
        "matching_percent": statistics.matching_percent(),
        "matching_turned": matching(grammar, example),
        "uncovered": statistics.uncovered,
        "cost": cost,
        "rules": grammar.rules.len(),
    })
}

fn table(path: &Path, grammar: &ShapeGrammar, example: usize, found: &Found) -> String {
    let Found { statistics, cost } = found;
    let mut text = format!("{}\n", input::name(path));
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "  {name:<16}{value}");
    };
    line("shapes", statistics.shapes.to_string());
    line(
        "blocks of each",
        format!(
            "{:.1} on average, {} in the middle, {} to {}",
            statistics.mean_size, statistics.median_size, statistics.smallest, statistics.largest
        ),
    );
    line(
        "alike",
        format!("{} as one before them ({:.0} %)", statistics.redundant, statistics.matching_percent()),
    );
    line("matching", format!("{} as one before them, turned or not", matching(grammar, example)));
    line("complexity", format!("{:.3} block types a block", statistics.complexity));
    line("cost", format!("{cost:.2}"));
    if statistics.uncovered > 0 {
        line("in no shape", format!("{} blocks: `--whole` finds shapes for them", statistics.uncovered));
    }
    line("rules", format!("{}, of all buildings", grammar.rules.len()));
    text
}
