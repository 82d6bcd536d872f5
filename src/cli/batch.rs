//! What commands share that read buildings and write each again.

use super::failure::Failure;
use super::input::{self, Limit, Reading};
use super::kind::written;
use super::output::{self, Inputs, Kind, Output, Writing};
use super::progress::Progress;
use super::report;
use super::summary::{self, Summary};
use super::template::Template;
use crate::grid::Grid;
use crate::io::{Content, Format};
use std::path::{Path, PathBuf};

/// What an output may be, for help texts.
pub const OUTPUT: &str = concat!(
    "What to write: ",
    written!(),
    ", or - for standard output. {name} and {number} stand for the name of each input without its ending, and for its number"
);

/// What a building was written as.
struct Written {
    outputs: Vec<Output>,
    what: String,
}

/// Files to read, and what to write.
#[derive(clap::Args)]
pub struct Batch {
    #[arg(required = true, help = input::FILES)]
    pub inputs: Vec<PathBuf>,
    #[arg(help = OUTPUT)]
    pub output: Template,
    #[command(flatten)]
    pub limit: Limit,
    #[command(flatten)]
    pub writing: Writing,
}

impl Batch {
    /// Reads each input, and writes what `work` makes of it and of its name. Of several inputs, those that fail are
    /// told, and the others go on.
    pub fn each(
        &self,
        reading: &Reading,
        work: impl Fn(&str, Content) -> Result<Content, Failure>,
    ) -> Result<(), Failure> {
        let inputs = input::paths(&self.inputs)?;
        let outputs = self.output.of_inputs(&inputs)?;
        outputs.iter().take(1).try_for_each(|output| self.writing.kind(output).map(drop))?;
        let read = Inputs::of(&inputs);
        let progress = Progress::new(inputs.len());
        let (mut summary, mut failures) = (Summary::default(), Vec::new());
        for (input, output) in inputs.iter().zip(&outputs) {
            let made = self.content(input, output, reading);
            let made = made.and_then(|content| work(&input::name(input), content));
            match made.and_then(|made| self.write(input, output, made, &read)) {
                Ok(Written { outputs, what }) => {
                    summary.add(&self.writing.pieces(output, &outputs), what);
                }
                Err(Failure::Pipe) => return Err(Failure::Pipe),
                Err(failure) => failures.push(failure),
            }
            progress.step();
        }
        drop(progress);
        summary.tell();
        told(failures, inputs.len())
    }

    /// As [`Batch::each`], for work that needs blocks.
    pub fn each_grid(&self, work: impl Fn(&str, Grid) -> Result<Grid, Failure>) -> Result<(), Failure> {
        self.each(&self.limit.reading(), |name, content| {
            work(name, input::require_grid(name, content)?).map(Content::Grid)
        })
    }

    /// What is in `input`. Which version of the game is written for blocks that say none is told.
    fn content(&self, input: &Path, output: &Path, reading: &Reading) -> Result<Content, Failure> {
        let decoded = input::told(input, reading)?;
        if let Content::Grid(grid) = &decoded.content
            && grid.metadata.data_version.is_none()
            && decoded.about.format != Format::MagicaVoxel
            && self.writing.says_version(output)?
        {
            let version = grid.version();
            report::warning(&format!(
                "{}: the file does not say which version of Minecraft it is of, and counts as {version}",
                input::name(input)
            ));
        }
        Ok(decoded.content)
    }

    /// Writes one building; gives back what it is in a few words.
    fn write(&self, input: &Path, output: &Path, made: Content, inputs: &Inputs) -> Result<Written, Failure> {
        let (outputs, what) = match made {
            Content::Grid(grid) => {
                let what = summary::building(&grid, self.writing.split);
                (self.writing.grid(output, grid)?, what)
            }
            Content::Boxes(boxes) if self.writing.kind(output)? == Kind::Obj => {
                (output::boxes(output, &boxes.boxes), summary::boxes(boxes.boxes.len()))
            }
            Content::Boxes(_) => {
                let name = input::name(input);
                let failure =
                    Failure::of_file(&name, "labelled boxes have no blocks, and can only become .obj");
                return Err(failure.hint("learn a grammar from them with `vox infer`, then run it"));
            }
        };
        output::write_beside(&outputs, inputs)?;
        Ok(Written { outputs, what })
    }
}

/// One failure is that of the command; of several files each is told.
fn told(mut failures: Vec<Failure>, files: usize) -> Result<(), Failure> {
    if files <= 1 {
        return failures.pop().map_or(Ok(()), Err);
    }
    let failed = failures.len();
    for failure in failures {
        failure.report();
    }
    match failed {
        0 => Ok(()),
        _ => Err(Failure::new(format!("{failed} of {files} files failed, the others are written"))),
    }
}
