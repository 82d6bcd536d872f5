//! The files that a building becomes, by their kinds.

use super::failure::Failure;
use super::input::is_stdio;
use super::kind::Kind;
use super::output::{self, Output};
use super::writing::Writing;
use crate::block;
use crate::grid::Grid;
use crate::io::{self, Encoded, EncodedRegions, Lost, WriteError};
use crate::space::Cell;
use crate::view;
use std::path::Path;

/// The files of a grid as it is, and what they have no place for.
pub fn encoded(
    writing: &Writing,
    kind: Kind,
    path: &Path,
    grid: &Grid,
) -> Result<(Vec<Output>, Vec<Lost>), Failure> {
    let one = |encoded: Result<Encoded, WriteError>| match encoded {
        Ok(Encoded { bytes, lost }) => Ok((vec![Output::new(path, bytes)], lost)),
        Err(error) => Err(Failure::write(&path.display().to_string(), &error)),
    };
    match kind {
        Kind::Schem => one(io::encode_schem(grid, writing.schem_version)),
        Kind::Litematic => one(io::encode_litematic(grid, writing.litematic_version)),
        Kind::Structure => one(io::encode_structure(grid)),
        Kind::Vox => one(io::encode_vox(grid, block::color)),
        Kind::Mca => regions(path, grid, writing.at.0),
        Kind::Obj => Ok(mesh(path, grid)),
        Kind::Png => {
            let drawn = view::isometric(grid, &view::ViewOptions::default());
            Ok((output::picture(path, &drawn)?, Vec::new()))
        }
    }
}

/// The region files of a grid in the folder of a world. Those that are there hold other chunks, and stay.
fn regions(folder: &Path, grid: &Grid, at: Cell) -> Result<(Vec<Output>, Vec<Lost>), Failure> {
    let encoded = io::encode_regions(grid, at);
    let EncodedRegions { files, lost } =
        encoded.map_err(|error| Failure::write(&folder.display().to_string(), &error))?;
    let mut outputs = Vec::new();
    for (name, bytes) in files {
        let path = folder.join(name);
        if path.exists() {
            let name = path.display().to_string();
            let failure = Failure::of_file(&name, "this part of the world is there, and is not overwritten");
            return Err(failure.hint("choose a new folder, or another place with `--at`"));
        }
        outputs.push(Output::new(&path, bytes));
    }
    Ok((outputs, lost))
}

/// A mesh, with its materials in a file beside it; on standard output there is nothing beside it.
fn mesh(path: &Path, grid: &Grid) -> (Vec<Output>, Vec<Lost>) {
    let materials = path.with_extension("mtl");
    let name = materials.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mesh = io::encode_obj_mesh(grid, &name, block::color);
    if is_stdio(path) {
        let alone =
            mesh.obj.lines().filter(|line| !line.starts_with("mtllib ")).map(|line| format!("{line}\n"));
        return (vec![Output::new(path, alone.collect::<String>())], mesh.lost);
    }
    (vec![Output::new(&materials, mesh.mtl), Output::new(path, mesh.obj)], mesh.lost)
}
