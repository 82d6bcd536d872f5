//! Writing what was made, where the command line says.

use super::failure::{Failure, io_text};
use super::input::is_stdio;
use crate::grid::LabelledBox;
use crate::io::{self, Staged};
use crate::view;
use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

pub use super::kind::Kind;
pub use super::writing::Writing;

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

    pub fn path(&self) -> &Path {
        &self.path
    }

    pub fn append(&mut self, text: &str) {
        self.bytes.extend_from_slice(text.as_bytes());
    }
}

/// Labelled boxes, one OBJ object each.
pub fn boxes(path: &Path, boxes: &[LabelledBox]) -> Vec<Output> {
    vec![Output::new(path, io::encode_obj_boxes(boxes))]
}

pub fn picture(path: &Path, picture: &image::RgbaImage) -> Result<Vec<Output>, Failure> {
    let bytes = view::png(picture).map_err(|error| Failure::of_file(&path.display().to_string(), error))?;
    Ok(vec![Output::new(path, bytes)])
}

/// Files that are read, by their real paths: none of them is overwritten.
pub struct Inputs(BTreeSet<PathBuf>);

impl Inputs {
    pub fn of(paths: &[PathBuf]) -> Inputs {
        Inputs(paths.iter().filter_map(|path| path.canonicalize().ok()).collect())
    }

    fn refuse(&self, output: &Path) -> Result<(), Failure> {
        let is_input = output.canonicalize().is_ok_and(|place| place.is_file() && self.0.contains(&place));
        if !is_input {
            return Ok(());
        }
        let name = output.display().to_string();
        let failure = Failure::of_file(&name, "this file is read, and is not overwritten");
        Err(failure.hint("choose another name for the output"))
    }
}

/// Writes all of the files or none. Folders on the way are made; none of the `inputs` is overwritten.
pub fn write(outputs: &[Output], inputs: &[PathBuf]) -> Result<(), Failure> {
    write_beside(outputs, &Inputs::of(inputs))
}

/// As [`write`], for inputs that many files are written beside.
pub fn write_beside(outputs: &[Output], inputs: &Inputs) -> Result<(), Failure> {
    let (mut staged, mut paths) = (Vec::new(), BTreeSet::new());
    for output in outputs.iter().filter(|output| !is_stdio(&output.path)) {
        inputs.refuse(&output.path)?;
        if !paths.insert(&output.path) {
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
