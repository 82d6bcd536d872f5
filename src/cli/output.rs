//! Writing what was made, where the command line says.

use super::failure::{Failure, io_text};
use super::input::is_stdio;
use super::report;
use crate::block;
use crate::grid::{Grid, LabelledBox};
use crate::io::{self, SchemVersion};
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

    /// Writes a grid.
    pub fn grid(&self, path: &Path, grid: &Grid) -> Result<(), Failure> {
        let name = path.display().to_string();
        match self.kind(path)? {
            Kind::Schem => {
                for lost in io::lost_in_schem(grid, self.schem_version) {
                    report::warning(&format!(
                        "{name}: {lost} have no place in this version and are left out"
                    ));
                }
                let bytes = io::encode_schem(grid, self.schem_version);
                write(path, &bytes.map_err(|error| Failure::write(&name, &error))?)
            }
            Kind::Obj => mesh(path, grid),
            Kind::Png => picture(path, &view::isometric(grid, &view::ViewOptions::default())),
        }
    }
}

/// A mesh, with its materials in a file beside it.
fn mesh(path: &Path, grid: &Grid) -> Result<(), Failure> {
    let materials = path.with_extension("mtl");
    let name = materials.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mesh = io::encode_obj_mesh(grid, &name, |state| {
        let [r, g, b, _] = block::color(state).0;
        [r, g, b]
    });
    if !is_stdio(path) {
        write(&materials, mesh.mtl.as_bytes())?;
    }
    write(path, mesh.obj.as_bytes())
}

/// Labelled boxes, one OBJ object each.
pub fn boxes(path: &Path, boxes: &[LabelledBox]) -> Result<(), Failure> {
    write(path, io::encode_obj_boxes(boxes).as_bytes())
}

pub fn picture(path: &Path, picture: &image::RgbaImage) -> Result<(), Failure> {
    let bytes = view::png(picture).map_err(|error| Failure::of_file(&path.display().to_string(), error))?;
    write(path, &bytes)
}

/// Writes a file whole or not at all, or to standard output. Folders on the way are made.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if is_stdio(path) {
        return stdout(bytes);
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let made = folder.map_or(Ok(()), std::fs::create_dir_all);
    made.and_then(|()| io::write_atomic(path, bytes))
        .map_err(|error| Failure::of_file(&path.display().to_string(), io_text(&error)))
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
