use super::failure::Failure;
use super::input::{self, Program};
use super::kind::written;
use super::output::{self, Kind, Writing};
use super::progress::Progress;
use super::report;
use super::settings::Settings;
use super::size::SizeArg;
use super::summary::{self, Summary};
use super::tally::Tally;
use super::template::Template;
use super::watch::watch;
use crate::grammar::Sources;
use crate::grid::Grid;
use crate::io::{self, ObjModel, PlacedModel};
use crate::run::{self, Labels, Library, Limits, Made, MeshPlace, Observer, Options, Overrun};
use crate::space::Cell;
use clap::ValueEnum;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Where to write, for the help texts of commands that take seeds.
pub const OUTPUT: &str = concat!(
    "Where to write: ",
    written!(),
    ". {seed} and {number} stand for the seed and the number of each building"
);

/// Run a grammar: make new buildings
///
/// The same grammar, size and seed always give the same bytes.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  vox run cottage.grammar --seed 7 -o cottage.schem
  vox run tower.grammar --size 7x30x7 -o tower.png
  vox run village.grammar -n 50 -o 'out/house-{seed}.schem'
  vox run tower.grammar --set floors=5 --style spruce --report -o tower.schem
  vox run tower.grammar --watch -o tower.png
  vox run garage.grammar -n 10 --boxes -o 'garage-{number}.obj'")]
pub struct Args {
    /// The grammar file, or - for standard input
    grammar: PathBuf,
    #[arg(short, long, value_name = "FILE", help = OUTPUT)]
    output: Template,
    /// The size of the start scope along the grammar's x, y and z; otherwise one that the grammar states
    #[arg(long, value_name = "XxYxZ")]
    size: Option<SizeArg>,
    /// The seed of the first building; each further one takes the next
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How many buildings to make
    #[arg(short, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    number: u32,
    /// The rule to start from, instead of the first
    #[arg(long, value_name = "LABEL")]
    start: Option<String>,
    /// What to do where sizes do not fit their scope
    #[arg(long, value_enum, default_value = "error")]
    overrun: OverrunArg,
    /// The last priority whose rules run; what waits for a later one stays a plain mass
    #[arg(long, value_name = "N")]
    detail: Option<u32>,
    /// Write the primitives as labelled boxes, one OBJ object each, instead of blocks
    #[arg(long)]
    boxes: bool,
    /// The most operations that one building may take
    #[arg(long, value_name = "N", default_value_t = Limits::default().steps)]
    max_steps: u64,
    /// The most blocks that a start scope may hold
    #[arg(long, value_name = "N", default_value_t = Limits::default().cells)]
    max_cells: u64,
    /// Print what was made as JSON, one line a building
    #[arg(long)]
    json: bool,
    /// Tell how often each label was derived, and how many of each block stand in what was made
    #[arg(long)]
    report: bool,
    /// Go on: run again whenever the grammar, its imports or its schematics change, and tell what is different
    #[arg(long)]
    watch: bool,
    /// How often to run at the most while watching
    #[arg(long, value_name = "N", hide = true, requires = "watch")]
    rounds: Option<u32>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    writing: Writing,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum OverrunArg {
    /// Stop, and name the rule
    Error,
    /// Cut off what runs over, and warn
    Clip,
}

impl OverrunArg {
    pub fn overrun(self) -> Overrun {
        match self {
            OverrunArg::Error => Overrun::Refuse,
            OverrunArg::Clip => Overrun::Clip,
        }
    }
}

/// A grammar that is ready to run.
pub struct Ready {
    program: Program,
    library: Library,
    /// What stands for blocks in OBJ files.
    models: BTreeMap<String, ObjModel>,
}

/// Sees each building and where it goes, before it is written.
pub type Look<'l> = dyn FnMut(&Path, &Grid) + 'l;

/// What one seed made.
struct Building {
    /// Its size in the world.
    size: Cell,
    /// What it is, in a few words.
    what: String,
    tally: Tally,
    /// What was written: a path, or one for each piece.
    files: Vec<PathBuf>,
}

impl Args {
    pub fn grammar(&self) -> &Path {
        &self.grammar
    }
}

impl Ready {
    /// The schematics that the grammar names, as it names them.
    pub fn files(&self) -> Vec<&str> {
        self.program.graph.files()
    }
}

pub fn execute(args: &Args) -> Result<(), Failure> {
    match args.watch {
        true => watch(args, args.rounds),
        false => build(args, &ready(args)?, &mut |_, _| {}),
    }
}

/// Makes and writes all buildings. Each is shown to `look` before it is written.
pub fn build(args: &Args, ready: &Ready, look: &mut Look<'_>) -> Result<(), Failure> {
    let seeds: Vec<u64> = (0..u64::from(args.number)).map(|number| args.seed.wrapping_add(number)).collect();
    let paths = args.output.of_seeds(&seeds)?;
    paths.first().map_or(Ok(()), |path| writable(args, path))?;
    let progress = Progress::new(seeds.len());
    let (mut summary, mut tally) = (Summary::default(), Tally::default());
    for (seed, path) in seeds.into_iter().zip(&paths) {
        let building = make(args, ready, seed, path, look)?;
        match args.json {
            true => output::json(&as_json(args, &building, seed, path))?,
            false => {
                let files: Vec<&Path> = building.files.iter().map(PathBuf::as_path).collect();
                summary.add(&files, building.what);
            }
        }
        tally.join(building.tally);
        progress.step();
    }
    drop(progress);
    summary.tell();
    if args.report && !args.json { output::stdout(tally.text().as_bytes()) } else { Ok(()) }
}

pub fn ready(args: &Args) -> Result<Ready, Failure> {
    let program = input::program(&args.grammar, args.start.as_deref(), &args.settings)?;
    let library = input::library(&program.graph, &args.grammar)?;
    let models = input::models(&program.graph, &args.grammar)?;
    Ok(Ready { program, library, models })
}

/// Whether what the arguments ask for can be written to such a file.
fn writable(args: &Args, path: &Path) -> Result<(), Failure> {
    let kind = args.writing.kind(path)?;
    let is_obj = kind == Kind::Obj || (input::is_stdio(path) && args.writing.format.is_none());
    if args.boxes && !is_obj {
        let failure =
            Failure::of_file(&path.display().to_string(), "labelled boxes are written as .obj only");
        return Err(failure.hint("name it .obj, or leave out `--boxes`"));
    }
    if input::is_stdio(path) && (args.json || args.report) {
        let what = if args.json { "JSON" } else { "a report" };
        return Err(Failure::new(format!("standard output cannot hold both the building and {what}")));
    }
    Ok(())
}

fn as_json(args: &Args, building: &Building, seed: u64, path: &Path) -> serde_json::Value {
    let (file, size) = (path.display().to_string(), building.size.to_array());
    match args.report {
        true => json!({ "file": file, "seed": seed, "size": size, "report": building.tally.as_json() }),
        false => json!({ "file": file, "seed": seed, "size": size }),
    }
}

fn options(args: &Args, seed: u64) -> Options {
    Options {
        seed,
        size: args.size.map(|size| size.0),
        overrun: args.overrun.overrun(),
        detail: args.detail,
        limits: Limits { steps: args.max_steps, cells: args.max_cells, ..Limits::default() },
    }
}

/// Makes and writes one building.
fn make(
    args: &Args,
    ready: &Ready,
    seed: u64,
    path: &Path,
    look: &mut Look<'_>,
) -> Result<Building, Failure> {
    let mut labels = args.report.then(|| Labels::new(&ready.program.graph));
    let mut building = match args.boxes {
        true => make_boxes(args, ready, seed, path, labels.as_mut())?,
        false => make_blocks(args, ready, seed, path, (labels.as_mut(), look))?,
    };
    labels.iter().for_each(|labels| building.tally.labels(labels));
    Ok(building)
}

fn make_boxes<'g>(
    args: &Args,
    ready: &'g Ready,
    seed: u64,
    path: &Path,
    labels: Option<&mut Labels<'g>>,
) -> Result<Building, Failure> {
    let made = run::run_boxes_observed(&ready.program.graph, &options(args, seed), observer(labels));
    let boxes = told(
        &ready.program.sources,
        made.map_err(|error| input::run_failure(&ready.program.sources, &error))?,
    );
    output::write(&output::boxes(path, &boxes), &ready.program.files)?;
    let bounds = boxes.iter().map(|labelled| labelled.bounds).reduce(|all, next| all.union(&next));
    let size = bounds.map_or(Cell::ZERO, |bounds| bounds.size());
    let mut tally = Tally::default();
    tally.boxes(&boxes);
    Ok(Building { size, what: summary::boxes(boxes.len()), tally, files: vec![path.to_owned()] })
}

fn make_blocks<'g>(
    args: &Args,
    ready: &'g Ready,
    seed: u64,
    path: &Path,
    (labels, look): (Option<&mut Labels<'g>>, &mut Look<'_>),
) -> Result<Building, Failure> {
    let Ready { program, library, models } = ready;
    let made = run::run_observed(&program.graph, library, &options(args, seed), observer(labels));
    let mut grid =
        told(&program.sources, made.map_err(|error| input::run_failure(&program.sources, &error))?);
    look(path, &grid);
    let mut tally = Tally::default();
    tally.blocks(&grid);
    let (size, what) = (grid.size(), summary::building(&grid, args.writing.split));
    let meshes = match models.is_empty() || args.writing.kind(path)? != Kind::Obj {
        true => Vec::new(),
        false => meshes(args, ready, seed, &mut grid)?,
    };
    let mut outputs = args.writing.grid(path, grid)?;
    if let Some(mesh) = outputs.iter_mut().find(|output| output.path() == path) {
        mesh.append(&io::encode_obj_models(&meshes));
    }
    output::write(&outputs, &program.files)?;
    let files = args.writing.pieces(path, &outputs).into_iter().map(Path::to_owned).collect();
    Ok(Building { size, what, tally, files })
}

/// The meshes of a building, in place of the blocks that stand for them.
fn meshes<'r>(
    args: &Args,
    ready: &'r Ready,
    seed: u64,
    grid: &mut Grid,
) -> Result<Vec<PlacedModel<'r>>, Failure> {
    let places = run::run_meshes(&ready.program.graph, &options(args, seed));
    let places = places.map_err(|error| input::run_failure(&ready.program.sources, &error))?;
    let place = |place: MeshPlace| {
        grid.fill(place.bounds, 0);
        let model = ready.models.get(&place.file)?;
        let material = place.block.map_or_else(String::new, |block| block.short_name().to_owned());
        Some(PlacedModel { name: place.file, model, material, bounds: place.bounds, turn: place.turn })
    };
    Ok(places.into_iter().filter_map(place).collect())
}

fn observer<'o, 'g>(labels: Option<&'o mut Labels<'g>>) -> Option<&'o mut (dyn Observer + 'o)>
where
    'g: 'o,
{
    labels.map(|labels| labels as &mut dyn Observer)
}

/// What was made; the warnings are told.
fn told<T>(sources: &Sources, made: Made<T>) -> T {
    for warning in &made.warnings {
        let place = match &warning.error.origin {
            Some(origin) => {
                let place = sources.place(origin.span);
                format!("{}:{}", place.name, place.line_column().0)
            }
            None => sources.root().to_owned(),
        };
        let times = if warning.times == 1 { String::new() } else { format!(" ({} times)", warning.times) };
        report::warning(&format!("{place}: {}{times}", warning.error));
    }
    made.made
}
