//! How buildings are written: the arguments that say so, and what is done to a building before.

use super::encoding;
use super::failure::Failure;
use super::input::is_stdio;
use super::kind::Kind;
use super::output::Output;
use super::part::CellArg;
use super::report;
use crate::block::{BlockState, Version};
use crate::grid::{Anchor, Grid, NotIn};
use crate::io::{LitematicVersion, Lost, SchemVersion};
use crate::space::Cell;
use clap::ValueEnum;
use std::path::{Path, PathBuf};

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

impl Writing {
    /// The kind of a file by what was asked for, or by its ending.
    pub fn kind(&self, path: &Path) -> Result<Kind, Failure> {
        self.format.map_or_else(|| Kind::of_path(path), Ok)
    }

    /// Whether what is written says a version of the game, and none is asked for.
    pub fn says_version(&self, path: &Path) -> Result<bool, Failure> {
        Ok(self.mc_version.is_none() && self.kind(path)?.says_version())
    }

    /// The files among `outputs` that a user would call what is written at `path`: its pieces, where there are such.
    pub fn pieces<'a>(&self, path: &'a Path, outputs: &'a [Output]) -> Vec<&'a Path> {
        let is_piece = |output: &&Path| output.extension() == path.extension();
        let pieces: Vec<&Path> = outputs.iter().map(Output::path).filter(is_piece).collect();
        match self.split.is_some() && !pieces.is_empty() {
            true => pieces,
            false => vec![path],
        }
    }

    /// The files of a grid.
    pub fn grid(&self, path: &Path, grid: Grid) -> Result<Vec<Output>, Failure> {
        let (kind, name) = (self.kind(path)?, path.display().to_string());
        let mut grid = self.prepared(&name, grid)?;
        let Some(edge) = self.split else {
            let (outputs, lost) = encoding::encoded(self, kind, path, &grid)?;
            tell_lost(&name, &lost);
            return Ok(outputs);
        };
        // All pieces say the version of the whole.
        grid.metadata.data_version = Some(grid.data_version());
        let (mut outputs, mut all_lost) = (Vec::new(), Vec::new());
        for (number, piece) in grid.pieces(edge) {
            let (piece, lost) = encoding::encoded(self, kind, &piece_path(path, number)?, &piece)?;
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
