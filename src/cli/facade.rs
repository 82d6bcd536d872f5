//! `vox infer` of layouts: drawings of facades with labelled rectangles.

use super::failure::Failure;
use super::infer::{count, preamble, read_back};
use super::input::{self, Limit};
use super::output::{self, Output};
use super::report;
use crate::facade::{
    self, Drawing, Facade, Form, InferError, Learnt, Meanings, Method, Near, Options, Roof, VARIETY, Variety,
    facade_label, is_wall,
};
use crate::grammar;
use crate::graph::{dot, lower, raise};
use crate::io::{self, Colours};
use crate::run::Library;
use clap::ValueEnum;
use serde_json::json;
use std::path::{Path, PathBuf};

/// What only layouts are asked.
#[derive(clap::Args)]
#[command(next_help_heading = "Layouts of facades")]
pub struct LayoutArgs {
    /// The width of the facade in blocks, instead of a scale. Without either, the thinnest part is one block
    #[arg(long, value_name = "BLOCKS", conflicts_with = "scale", value_parser = clap::value_parser!(u32).range(1..=30_000))]
    width: Option<u32>,
    /// A text on what labels stand for, a line each: window = glass, back 1
    #[arg(long, value_name = "FILE")]
    labels: Option<PathBuf>,
    /// A text that names the colours of a PNG, a line each: #a0b1c2 = window
    #[arg(long, value_name = "FILE")]
    colours: Option<PathBuf>,
    /// The blocks from the front to the back; as the labels need if not given
    #[arg(long, value_name = "BLOCKS", value_parser = clap::value_parser!(u32).range(1..=1_000))]
    depth: Option<u32>,
    /// How rules are looked for
    #[arg(long, value_enum)]
    search: Option<Search>,
    /// What becomes of lines less than a block apart
    #[arg(long, value_enum)]
    lines: Option<Lines>,
    /// Make a building with the facade on all four sides, under such a roof
    #[arg(long, value_name = "ROOF", value_enum)]
    building: Option<RoofArg>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Search {
    /// The shortest rules that a search by cost finds
    Cost,
    /// All lines at once, and the first repeat
    Greedy,
}

#[derive(Clone, Copy, ValueEnum)]
enum Lines {
    /// They meet where nothing stands between them
    Meet,
    /// No two meet
    Apart,
}

#[derive(Clone, Copy, ValueEnum)]
enum RoofArg {
    Flat,
    Gable,
    Hip,
    Mansard,
    Pyramid,
}

impl LayoutArgs {
    /// Whether any of it was asked for.
    pub fn is_any(&self) -> bool {
        let LayoutArgs { width, labels, colours, depth, search, lines, building } = self;
        width.is_some()
            || labels.is_some()
            || colours.is_some()
            || depth.is_some()
            || search.is_some()
            || lines.is_some()
            || building.is_some()
    }

    fn form(&self) -> Form {
        let roof = |roof: RoofArg| match roof {
            RoofArg::Flat => Roof::Flat,
            RoofArg::Gable => Roof::Gable,
            RoofArg::Hip => Roof::Hip,
            RoofArg::Mansard => Roof::Mansard,
            RoofArg::Pyramid => Roof::Pyramid,
        };
        self.building.map_or(Form::Wall, |building| Form::Building(roof(building)))
    }

    fn options(&self, task: &Task<'_>) -> Result<Options, Failure> {
        let meanings = self.labels.as_ref().map_or(Ok(Meanings::default()), |path| input::said(path))?;
        Ok(Options {
            scale: match (self.width, task.scale) {
                (Some(width), _) => facade::Scale::Width(width),
                (None, Some(scale)) => facade::Scale::PerUnit(scale.blocks_per_unit()),
                (None, None) => facade::Scale::Fitting,
            },
            near: match self.lines {
                Some(Lines::Apart) => Near::Apart,
                Some(Lines::Meet) | None => Near::Meet,
            },
            method: match self.search {
                Some(Search::Greedy) => Method::Greedy,
                Some(Search::Cost) | None => Method::Searched,
            },
            variety: task.variety,
            meanings,
            depth: self.depth,
            form: self.form(),
        })
    }
}

/// What is asked of layouts and buildings alike.
pub struct Task<'a> {
    pub paths: &'a [PathBuf],
    pub output: &'a Path,
    pub dot: Option<&'a Path>,
    pub scale: Option<io::Scale>,
    pub variety: Variety,
    pub limit: Limit,
    pub json: bool,
}

/// Learns a grammar of layouts, proves that it gives them and writes it; `None` where the files are no layouts.
pub fn learn(args: &LayoutArgs, task: &Task<'_>) -> Result<Option<()>, Failure> {
    let limits = task.limit.reading().limits;
    let files =
        task.paths.iter().map(|path| input::layout(path, limits.max_bytes)).collect::<Result<Vec<_>, _>>()?;
    let Some(layout) = files.iter().position(Option::is_some) else {
        return match args.is_any() {
            true => Err(Failure::new("no input is the layout of a facade, which the options are about")),
            false => Ok(None),
        };
    };
    if let Some(other) = files.iter().position(Option::is_none) {
        let names = [other, layout].map(|number| input::name(&task.paths[number]));
        let [other, layout] = names;
        return Err(Failure::new(format!("{other} is a building and {layout} the layout of a facade"))
            .hint("learn from one kind at a time"));
    }
    let options = args.options(task)?;
    let colours: Option<Colours> = args.colours.as_ref().map(|path| input::said(path)).transpose()?;
    let mut drawings: Vec<Drawing> = Vec::with_capacity(files.len());
    for (path, bytes) in task.paths.iter().zip(files.into_iter().flatten()) {
        let is_wall = |label: &str| is_wall(label, &options.meanings);
        let drawing = io::decode_layout(&bytes, colours.as_ref(), &is_wall, &limits);
        drawings.push(drawing.map_err(|error| unread(path, &error))?);
    }
    let mut learnt = facade::infer(&drawings, &options).map_err(|error| failure(args, task, &error))?;
    learnt.graph.preamble = preamble(task.paths, ["one layout:", "layouts:"]);
    write(task, &learnt).map(Some)
}

/// Why a layout could not be read, and what to do about it.
pub fn unread(path: &Path, error: &io::LayoutError) -> Failure {
    let failure = Failure::of_file(&input::name(path), error);
    match error {
        io::LayoutError::NoColours => failure.hint("name a text with lines such as `#a0b1c2 = window`: `--colours colours.txt`"),
        io::LayoutError::NoRectangle { label, .. } => failure.hint(format!(
            "only walls reach around others: if it is one, say so with `--labels`: `{label} = bricks, stretch`"
        )),
        _ => failure,
    }
}

fn failure(args: &LayoutArgs, task: &Task<'_>, error: &InferError) -> Failure {
    match error {
        InferError::Facade { layout, error } => Failure::of_file(&input::name(&task.paths[*layout]), error),
        InferError::Labels(error) => {
            let name = args.labels.as_deref().map_or_else(String::new, input::name);
            Failure::of_file(&name, error)
        }
    }
}

/// Nothing is written unless every leaf of every layout is reproduced.
fn write(task: &Task<'_>, learnt: &Learnt) -> Result<(), Failure> {
    let text = raise(&learnt.graph).to_string();
    let graph = read_back(&text)?;
    let library = input::library(&graph, task.output)?;
    for number in 0..learnt.facades.len() {
        prove(task, learnt, number, &text, &library)?;
    }
    let mut outputs = vec![Output::new(task.output, text)];
    outputs.extend(task.dot.map(|path| Output::new(path, dot(&graph))));
    output::write(&outputs, task.paths)?;
    tell(task, learnt)
}

fn prove(
    task: &Task<'_>,
    learnt: &Learnt,
    number: usize,
    text: &str,
    library: &Library,
) -> Result<(), Failure> {
    let fault = |problem: String| {
        Failure::of_file(
            &input::name(&task.paths[number]),
            format!("the learnt grammar {problem}, which is a fault of vox"),
        )
    };
    let checked = grammar::read(text).map_err(|_| fault("does not read back".to_owned()))?;
    let label = facade_label(number);
    let mut graph =
        lower(&checked, Some(&label)).map_err(|error| fault(format!("has no `{label}`: {error}")))?;
    if graph.constants.iter().any(|constant| constant.name == VARIETY) {
        graph.set_constant(VARIETY, "0").map_err(|error| fault(error.to_string()))?;
    }
    let leaves = learnt.facades[number].layout.leaves().len();
    match learnt.reproduced(number, &graph, library) {
        Ok(reproduced) if reproduced == leaves => Ok(()),
        Ok(reproduced) => Err(fault(format!("gives {reproduced} of {leaves} leaves"))),
        Err(error) => Err(fault(format!("does not run: {error}"))),
    }
}

fn tell(task: &Task<'_>, learnt: &Learnt) -> Result<(), Failure> {
    let rules = raise(&learnt.graph).rules.len();
    if task.json {
        let facade = |facade: &Facade| {
            json!({
                "leaves": facade.layout.leaves().len(),
                "reproduced": facade.layout.leaves().len(),
                "size": facade.layout.size(),
                "blocks_per_unit": facade.blocks_per_unit,
                "structures": facade.counts.structures,
                "groups": facade.counts.groups,
                "splits": facade.rules.list.len(),
                "length": facade.rules.length(),
            })
        };
        let facades: Vec<serde_json::Value> = learnt.facades.iter().map(facade).collect();
        return output::json(&json!({ "rules": rules, "facades": facades }));
    }
    for (path, facade) in task.paths.iter().zip(&learnt.facades) {
        let leaves = facade.layout.leaves().len();
        let [width, height] = facade.layout.size();
        report::note(&format!(
            "{}: {leaves} of {leaves} leaves reproduced at {width} x {height} blocks, {:.2} blocks per unit",
            input::name(path),
            facade.blocks_per_unit
        ));
        if facade.met > 0 {
            report::note(&format!(
                "{} lines fell together with others, with nothing between them; `--lines apart` keeps them apart",
                facade.met
            ));
        }
        report::note(&format!(
            "{} structures in {} groups; {} of {:.0} bits",
            facade.counts.structures,
            facade.counts.groups,
            count(facade.rules.list.len() as f64, "split"),
            facade.rules.length()
        ));
    }
    let deep = count(f64::from(learnt.depth.total()), "block");
    report::note(&format!("{}, {deep} deep", count(rules as f64, "rule")));
    if task.variety == Variety::Exchanged
        && learnt.graph.constants.iter().all(|constant| constant.name != VARIETY)
    {
        report::note("no two parts of one size differ, so runs at the layout's size are all alike");
    }
    tell_guesses(learnt);
    Ok(())
}

/// Labels that nothing explains stand for blocks that can be told apart.
fn tell_guesses(learnt: &Learnt) {
    let labels = learnt.facades.first().map_or([].as_slice(), |facade| facade.layout.labels());
    let guessed: Vec<String> =
        learnt.meant.guessed.iter().map(|label| format!("`{}`", labels[*label])).collect();
    if !guessed.is_empty() {
        report::note(&format!(
            "what {} may be their names do not tell: they are concrete, which `--labels` changes",
            guessed.join(", ")
        ));
    }
}
