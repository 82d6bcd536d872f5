//! Writing what was made, where the command line says.

use super::failure::{Failure, io_text};
use super::input::is_stdio;
use super::report;
use crate::block;
use crate::grid::{Grid, LabelledBox};
use crate::io::{self, Lost, SchemVersion, Staged};
use crate::view;
use clap::ValueEnum;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What kinds of files are written, told by their endings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Kind {
    /// Sponge schematic
    Schem,
    /// Wavefront OBJ
    Obj,
    /// Picture
    Png,
}

/// How a building is written.
#[derive(Clone, Debug, clap::Args)]
pub struct Writing {
    /// The kind of file, where its ending does not tell
    #[arg(long, value_enum)]
    pub format: Option<Kind>,
    /// The version of .schem files: 2 opens everywhere, 3 in WorldEdit 7.3 and later
    #[arg(long, value_name = "N", default_value = "2", value_parser = schem_version)]
    pub schem_version: SchemVersion,
}

fn schem_version(text: &str) -> Result<SchemVersion, String> {
    match text {
        "2" => Ok(SchemVersion::V2),
        "3" => Ok(SchemVersion::V3),
        _ => Err("vox writes version 2 or 3".to_owned()),
    }
}

impl Writing {
    /// The kind of a file by what was asked for, or by its ending.
    pub fn kind(&self, path: &Path) -> Result<Kind, Failure> {
        if let Some(kind) = self.format {
            return Ok(kind);
        }
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("").to_ascii_lowercase();
        match ending.as_str() {
            "schem" => Ok(Kind::Schem),
            "obj" => Ok(Kind::Obj),
            "png" => Ok(Kind::Png),
            "" if is_stdio(path) => Ok(Kind::Schem),
            _ => {
                let failure =
                    Failure::of_file(&path.display().to_string(), "vox cannot write this kind of file");
                Err(failure.hint("name it .schem, .obj or .png, or say `--format schem`"))
            }
        }
    }

    /// The files of a grid.
    pub fn grid(&self, path: &Path, grid: &Grid) -> Result<Vec<Output>, Failure> {
        let name = path.display().to_string();
        match self.kind(path)? {
            Kind::Schem => {
                let encoded = io::encode_schem(grid, self.schem_version);
                let encoded = encoded.map_err(|error| Failure::write(&name, &error))?;
                tell_lost(&name, &encoded.lost);
                Ok(vec![Output::new(path, encoded.bytes)])
            }
            Kind::Obj => Ok(mesh(path, grid)),
            Kind::Png => picture(path, &view::isometric(grid, &view::ViewOptions::default())),
        }
    }
}

/// Tells in one line what a file has no place for.
fn tell_lost(name: &str, lost: &[Lost]) {
    let lost: Vec<String> = lost.iter().map(Lost::to_string).collect();
    if !lost.is_empty() {
        report::warning(&format!("{name}: this kind of file has no place for {}", lost.join(", ")));
    }
}

/// A file to write.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    bytes: Vec<u8>,
}

impl Output {
    pub fn new(path: &Path, bytes: impl Into<Vec<u8>>) -> Output {
        Output { path: path.to_owned(), bytes: bytes.into() }
    }
}

/// A mesh, with its materials in a file beside it; on standard output there is nothing beside it.
fn mesh(path: &Path, grid: &Grid) -> Vec<Output> {
    let materials = path.with_extension("mtl");
    let name = materials.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mesh = io::encode_obj_mesh(grid, &name, |state| {
        let [r, g, b, _] = block::color(state).0;
        [r, g, b]
    });
    if is_stdio(path) {
        let alone =
            mesh.obj.lines().filter(|line| !line.starts_with("mtllib ")).map(|line| format!("{line}\n"));
        return vec![Output::new(path, alone.collect::<String>())];
    }
    vec![Output::new(&materials, mesh.mtl), Output::new(path, mesh.obj)]
}

/// Labelled boxes, one OBJ object each.
pub fn boxes(path: &Path, boxes: &[LabelledBox]) -> Vec<Output> {
    vec![Output::new(path, io::encode_obj_boxes(boxes))]
}

pub fn picture(path: &Path, picture: &image::RgbaImage) -> Result<Vec<Output>, Failure> {
    let bytes = view::png(picture).map_err(|error| Failure::of_file(&path.display().to_string(), error))?;
    Ok(vec![Output::new(path, bytes)])
}

/// Writes all of the files or none. Folders on the way are made; none of the `inputs` is overwritten.
pub fn write(outputs: &[Output], inputs: &[PathBuf]) -> Result<(), Failure> {
    let mut staged = Vec::new();
    for (at, output) in outputs.iter().enumerate().filter(|(_, output)| !is_stdio(&output.path)) {
        refuse_inputs(&output.path, inputs)?;
        if outputs[..at].iter().any(|other| other.path == output.path) {
            let name = output.path.display().to_string();
            return Err(Failure::of_file(&name, "two outputs cannot have one name"));
        }
        let folder = output.path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let made = folder.map_or(Ok(()), std::fs::create_dir_all);
        let file = made.and_then(|()| Staged::new(&output.path, &output.bytes));
        staged.push((file.map_err(|error| unwritable(&output.path, &error))?, &output.path));
    }
    for (file, path) in staged {
        file.commit().map_err(|error| unwritable(path, &error))?;
    }
    outputs.iter().filter(|output| is_stdio(&output.path)).try_for_each(|output| stdout(&output.bytes))
}

fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    Failure::of_file(&path.display().to_string(), io_text(error))
}

fn refuse_inputs(path: &Path, inputs: &[PathBuf]) -> Result<(), Failure> {
    let Ok(place) = path.canonicalize() else { return Ok(()) };
    let is_input = |input: &PathBuf| input.canonicalize().is_ok_and(|input| input == place);
    match place.is_file() && inputs.iter().any(is_input) {
        true => {
            let failure =
                Failure::of_file(&path.display().to_string(), "this file is read, and is not overwritten");
            Err(failure.hint("choose another name for the output"))
        }
        false => Ok(()),
    }
}

pub fn stdout(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Err(Failure::Pipe),
        result => result.map_err(|error| Failure::of_file("standard output", error)),
    }
}

/// A value for scripts, as one line of JSON.
pub fn json(value: &serde_json::Value) -> Result<(), Failure> {
    stdout(format!("{value}\n").as_bytes())
}

/// A path with places for a seed and a number, as in `out/house-{seed}.schem`.
#[derive(Clone, Debug)]
pub struct Template(String);

impl Template {
    /// The paths for these seeds, which must all differ.
    pub fn paths(&self, seeds: &[u64]) -> Result<Vec<PathBuf>, Failure> {
        if seeds.len() > 1 && !self.0.contains("{seed}") && !self.0.contains("{number}") {
            let failure =
                Failure::of_file(&self.0, format!("{} files cannot all have this name", seeds.len()));
            return Err(
                failure.hint("write {seed} or {number} where they differ: -o 'out/house-{seed}.schem'")
            );
        }
        let path = |(number, seed): (usize, &u64)| {
            let width = seeds.len().to_string().len();
            let number = format!("{:0width$}", number + 1);
            PathBuf::from(self.0.replace("{seed}", &seed.to_string()).replace("{number}", &number))
        };
        Ok(seeds.iter().enumerate().map(path).collect())
    }
}

impl From<&str> for Template {
    fn from(text: &str) -> Template {
        Template(text.to_owned())
    }
}
