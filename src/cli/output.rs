//! Writing what was made, where the command line says.

use super::failure::{Failure, io_text};
use super::input::is_stdio;
use super::part::CellArg;
use super::report;
use crate::block::{self, BlockState, Version};
use crate::grid::{Anchor, Grid, LabelledBox, NotIn};
use crate::io::{self, Encoded, EncodedRegions, LitematicVersion, Lost, SchemVersion, Staged, WriteError};
use crate::space::Cell;
use crate::view;
use clap::ValueEnum;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What kinds of files are written, told by their endings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Kind {
    /// Sponge schematic
    Schem,
    /// Litematica schematic
    Litematic,
    /// Structure of the game
    #[value(name = "nbt")]
    Structure,
    /// MagicaVoxel model, coloured voxels only
    Vox,
    /// Region files of a world; the output is its folder
    Mca,
    /// Wavefront OBJ
    Obj,
    /// Picture
    Png,
}

impl Kind {
    /// The kind of a file by the ending of its name.
    fn of_ending(ending: &str) -> Option<Kind> {
        match ending {
            "schem" => Some(Kind::Schem),
            "litematic" => Some(Kind::Litematic),
            "nbt" => Some(Kind::Structure),
            "vox" => Some(Kind::Vox),
            "obj" => Some(Kind::Obj),
            "png" => Some(Kind::Png),
            _ => None,
        }
    }
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
    /// The version of .litematic files: 6 opens since Minecraft 1.18, 7 since 1.20.5
    #[arg(long, value_name = "N", default_value = "6", value_parser = litematic_version)]
    pub litematic_version: LitematicVersion,
    /// The version of the game to write blocks for, as in 1.20.1; if not given, that of the input
    #[arg(long, value_name = "VERSION", value_parser = game_version)]
    pub mc_version: Option<Version>,
    /// Where in the world the low corner of the building goes, for region files
    #[arg(long, value_name = "X,Y,Z", default_value = "0,64,0", allow_hyphen_values = true)]
    pub at: CellArg,
    /// What air does to the world where the building is pasted
    #[arg(long, value_enum, default_value = "keep")]
    pub air: Air,
    /// Where you stand when you paste the building; if not given, as the input has it
    #[arg(long, value_enum)]
    pub anchor: Option<Stand>,
    /// Write pieces of at most N blocks along each axis, their numbers in their names: house_x0_y0_z1.schem
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub split: Option<u16>,
}

/// What air does to the world.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Air {
    /// It takes away what is there
    Keep,
    /// It leaves alone what is there: air becomes structure_void
    Void,
}

/// Where the player stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Stand {
    /// Where the input has it, however far away
    Keep,
    /// In the low corner
    Corner,
    /// In the middle of the floor
    Center,
    /// In front of the lowest door
    Door,
}

fn schem_version(text: &str) -> Result<SchemVersion, String> {
    match text {
        "2" => Ok(SchemVersion::V2),
        "3" => Ok(SchemVersion::V3),
        _ => Err("vox writes version 2 or 3".to_owned()),
    }
}

fn litematic_version(text: &str) -> Result<LitematicVersion, String> {
    match text {
        "6" => Ok(LitematicVersion::V6),
        "7" => Ok(LitematicVersion::V7),
        _ => Err("vox writes version 6 or 7".to_owned()),
    }
}

fn game_version(text: &str) -> Result<Version, String> {
    Version::named(text).ok_or_else(|| {
        let like: Vec<String> = Version::like(text).iter().map(Version::to_string).collect();
        let (oldest, newest) = (Version::oldest(), Version::newest());
        format!("expected a version from {oldest} to {newest}; did you mean {}?", like.join(", "))
    })
}

impl Writing {
    /// The kind of a file by what was asked for, or by its ending.
    pub fn kind(&self, path: &Path) -> Result<Kind, Failure> {
        if let Some(kind) = self.format {
            return Ok(kind);
        }
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("").to_ascii_lowercase();
        match Kind::of_ending(&ending) {
            Some(kind) => Ok(kind),
            None if is_stdio(path) => Ok(Kind::Schem),
            None if path.is_dir() || path.to_string_lossy().ends_with('/') => Ok(Kind::Mca),
            None => Err(unknown_kind(path, &ending)),
        }
    }

    /// Whether what is written says a version of the game, and none is asked for.
    pub fn says_version(&self, path: &Path) -> Result<bool, Failure> {
        let is_of_game = !matches!(self.kind(path)?, Kind::Vox | Kind::Obj | Kind::Png);
        Ok(is_of_game && self.mc_version.is_none())
    }

    /// The files of a grid.
    pub fn grid(&self, path: &Path, grid: Grid) -> Result<Vec<Output>, Failure> {
        let (kind, name) = (self.kind(path)?, path.display().to_string());
        let grid = self.prepared(&name, grid)?;
        let Some(edge) = self.split else {
            let (outputs, lost) = self.encoded(kind, path, &grid)?;
            tell_lost(&name, &lost);
            return Ok(outputs);
        };
        let (mut outputs, mut all_lost) = (Vec::new(), Vec::new());
        for (number, piece) in grid.pieces(edge) {
            let (piece, lost) = self.encoded(kind, &piece_path(path, number)?, &piece)?;
            outputs.extend(piece);
            all_lost.extend(lost.into_iter().filter_map(|lost| of_whole(lost, &grid)));
        }
        tell_lost(&name, &Lost::of_pieces(all_lost));
        Ok(outputs)
    }

    /// The grid as it is written.
    fn prepared(&self, name: &str, mut grid: Grid) -> Result<Grid, Failure> {
        let failed = |error: &dyn std::fmt::Display| Failure::of_file(name, error);
        match self.anchor {
            None => forget_world(name, &mut grid),
            Some(Stand::Keep) => {}
            Some(Stand::Corner) => grid.anchor(Anchor::Corner).map_err(|error| failed(&error))?,
            Some(Stand::Center) => grid.anchor(Anchor::Center).map_err(|error| failed(&error))?,
            Some(Stand::Door) => grid
                .anchor(Anchor::Door)
                .map_err(|error| failed(&error).hint("`--anchor center` stands you in the middle"))?,
        }
        if let Some(version) = self.mc_version {
            to_version(name, &mut grid, version)?;
        }
        if self.air == Air::Void {
            let void = BlockState::structure_void();
            let change = |old: &BlockState| if old.is_nothing() { void.clone() } else { old.clone() };
            grid.map_states(change).map_err(|error| failed(&error))?;
        }
        Ok(grid)
    }

    /// The files of a grid as it is, and what they have no place for.
    fn encoded(&self, kind: Kind, path: &Path, grid: &Grid) -> Result<(Vec<Output>, Vec<Lost>), Failure> {
        let one = |encoded: Result<Encoded, WriteError>| match encoded {
            Ok(Encoded { bytes, lost }) => Ok((vec![Output::new(path, bytes)], lost)),
            Err(error) => Err(Failure::write(&path.display().to_string(), &error)),
        };
        match kind {
            Kind::Schem => one(io::encode_schem(grid, self.schem_version)),
            Kind::Litematic => one(io::encode_litematic(grid, self.litematic_version)),
            Kind::Structure => one(io::encode_structure(grid)),
            Kind::Vox => one(io::encode_vox(grid, block::color)),
            Kind::Mca => regions(path, grid, self.at.0),
            Kind::Obj => Ok(mesh(path, grid)),
            Kind::Png => {
                let drawn = view::isometric(grid, &view::ViewOptions::default());
                Ok((picture(path, &drawn)?, Vec::new()))
            }
        }
    }
}

fn unknown_kind(path: &Path, ending: &str) -> Failure {
    let name = path.display().to_string();
    match ending {
        "mca" => Failure::of_file(&name, "region files are written into the folder of a world")
            .hint("name its folder with a `/` at the end, and say where: new-world/ --at 100,64,-20"),
        _ => Failure::of_file(&name, "vox cannot write this kind of file")
            .hint("name it .schem, .litematic, .nbt, .vox, .obj or .png, or say `--format schem`"),
    }
}

/// Some programs write places in their world where the offset belongs. Who pastes such a file finds nothing, so
/// what is farther away than anybody copies from is left out.
fn forget_world(name: &str, grid: &mut Grid) {
    const FAR: i64 = 1000;
    let (low, size) = (grid.metadata.offset.as_i64vec3(), grid.size().as_i64vec3());
    let beyond = low.max(-(low + size));
    if beyond.x > FAR || beyond.z > FAR {
        report::warning(&format!(
            "{name}: the offset ({}, {}, {}) looks like a place in a world and is left out: `--anchor keep` keeps it",
            low.x, low.y, low.z
        ));
        grid.metadata.offset = Cell::ZERO;
    }
}

/// What of the whole build is lost where `lost` is of one of its pieces: where a piece lies is in its name.
fn of_whole(lost: Lost, grid: &Grid) -> Option<Lost> {
    let offset = grid.metadata.offset;
    match lost {
        Lost::Offset(_) => (offset != Cell::ZERO).then_some(Lost::Offset(offset)),
        other => Some(other),
    }
}

/// Brings a grid to another version of the game. What keeps the form of its own version is told.
fn to_version(name: &str, grid: &mut Grid, to: Version) -> Result<(), Failure> {
    let from = grid.version();
    let kept = grid.bring_to(to).map_err(|error| match &error {
        NotIn::Blocks { .. } => {
            Failure::of_file(name, error).hint("put others in their place with `vox replace`")
        }
        _ => Failure::of_file(name, error),
    })?;
    if !kept.is_none() {
        report::warning(&format!(
            "{name}: these keep the form of Minecraft {from}, which {to} may not understand: {kept}"
        ));
    }
    Ok(())
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

/// `house.schem` becomes `house_x0_y0_z1.schem`.
fn piece_path(path: &Path, number: Cell) -> Result<PathBuf, Failure> {
    if is_stdio(path) {
        let failure = Failure::new("standard output cannot hold the pieces of a building");
        return Err(failure.hint("name a file, or leave out `--split`"));
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let numbers = format!("_x{}_y{}_z{}", number.x, number.y, number.z);
    let ending = path.extension().map_or(String::new(), |ending| format!(".{}", ending.to_string_lossy()));
    Ok(path.with_file_name(format!("{stem}{numbers}{ending}")))
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
